//! A windmill: its body is turned on a lathe, its cap is a cone, and its sails are a sprite that turns.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

/// Distances from the axis and heights, from the top to the bottom. A point that is repeated makes an edge.
const PROFILE: &[(Scalar, Scalar)] = &[
    (fx!(0.6), fx!(2.6)),
    (fx!(0.8), fx!(1.2)),
    (fx!(0.8), fx!(1.2)),
    (fx!(1.2), fx!(1.1)),
    (fx!(1.2), fx!(1.1)),
    (fx!(1.2), fx!(0.95)),
    (fx!(0.85), fx!(0.95)),
    (fx!(0.85), fx!(0.95)),
    (fx!(1.1), fx!(0)),
];
static BODY: Mesh = shape!(lathe(24, PROFILE));
static CAP: Mesh = shape!(cone(24));
static HILL: Mesh = shape!(disc(48));
static SAILS: [[Rgb565; 64]; 64] = sails();

/// Four spars with a lattice on the right of each. All other texels are magenta.
const fn sails() -> [[Rgb565; 64]; 64] {
    let mut texels = [[Rgb565::MAGENTA; 64]; 64];
    let mut at = 0_usize;
    while at < 4 * 64 * 32 {
        let (sail, x, y) = (at / (64 * 32), at % 64, at / 64 % 32);
        let [column, row] = [[x, y], [63 - y, x], [63 - x, 63 - y], [y, 63 - x]][sail];
        if x == 31 || x == 32 {
            texels[row][column] = Rgb565::new(12, 17, 6);
        } else if x > 32 && x < 44 && y < 26 {
            let is_lath = x % 5 == 3 || y % 5 == 0;
            let [r, g, b] = if is_lath { [14, 21, 8] } else { [30, 58, 25] };
            texels[row][column] = Rgb565::new(r, g, b);
        }
        at += 1;
    }
    texels
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(38), canvas.frame_size(), fx!(1), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(2.2, 1.7, 8), vec3!(0, 2.1, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 3, 2), fx!(0.35), fx!(0.65))?;
    let of = |r, g, b| Flat::rgb(Rgb888::new(r, g, b)).lit(sun);
    canvas.clear(Rgb565::new(17, 44, 29));
    let hill = Transform::scale_axes(vec3!(5, 1, 5));
    canvas.draw(&HILL, &(view * hill), &of(110, 160, 70));
    canvas.draw(&BODY, &view, &of(235, 225, 205));
    let cap = Transform::translate(vec3!(0, 3, 0)) * Transform::scale_axes(vec3!(0.75, 0.4, 0.75));
    canvas.draw(&CAP, &(view * cap), &of(150, 70, 50));
    // The sails turn about their middle, in front of the cap.
    let (place, angles) = ([vec3!(0.4, 2.65, 1.4)], [Rate::rpm(12).angle_at(5_300)]);
    let sails = Sprites::new(&place, (fx!(3.3), fx!(3.3)))?.with_angles(&angles)?;
    let wood = Textured::new(&SAILS).clamped().cut_out(Rgb565::MAGENTA);
    canvas.draw(&sails, &view, &wood);
    Ok(())
}
