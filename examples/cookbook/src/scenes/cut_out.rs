//! Holes in textures: a fence with an alpha bit, and leaves with a key color.

use core::array::from_fn;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::texture::Argb1555;

static SQUARE: Mesh = shape!(plane(1, 1));
static BALL: Mesh = shape!(sphere(24, 16));
static TRUNK: Mesh = shape!(cylinder(12));

/// A picket with its part of the two rails. A texel has a color or is a hole.
fn picket(row: usize, column: usize) -> Argb1555 {
    let aside = (2 * column).abs_diff(7); // from the picket's middle, in half texels
    match row % 14 {
        _ if aside < 5 && row >= aside => Argb1555::new(31, 30, 28),
        8..12 => Argb1555::new(25, 24, 22),
        _ => Argb1555::HOLE,
    }
}

/// Leaves in several greens. All other texels are magenta, and are left out.
fn leaf(row: usize, column: usize) -> Rgb565 {
    match ((column * 31 + row * 17) ^ (column * row)) % 13 {
        noise @ 0..9 => Rgb565::new(3 + noise as u8 / 2, 24 + 2 * noise as u8, 4),
        _ => Rgb565::MAGENTA,
    }
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(45), canvas.frame_size(), fx!(0.5), fx!(80))?;
    let view = projection * Camera::look_at(vec3!(-3, 2, 8), vec3!(0, 1.5, 0), Vec3::Y)?;
    let at = |place, size| view * Transform::translate(place) * Transform::scale_axes(size);
    canvas.clear(Rgb565::new(17, 46, 31));
    let grass = Flat::new(Rgb565::new(12, 40, 8));
    canvas.draw(&SQUARE, &at(Vec3::ZERO, vec3!(60, 1, 60)), &grass);

    // Through the holes between the near leaves, you see the far leaves from inside.
    let both_sides = DrawOptions::new().with_cull(Cull::Nothing);
    let sun = Light::new(vec3!(-2, 3, 2), fx!(0.35), fx!(0.65))?;
    let bark = Flat::rgb(Rgb888::new(130, 90, 60)).lit(sun);
    let leaves: [[Rgb565; 64]; 32] = from_fn(|y| from_fn(|x| leaf(y, x)));
    let leaves = Textured::new(&leaves).cut_out(Rgb565::MAGENTA).lit(sun);
    for place in [vec3!(-3, 1, -2), vec3!(0.5, 1, -2), vec3!(4, 1, -2)] {
        canvas.draw(&TRUNK, &at(place, vec3!(0.2, 1, 0.2)), &bark);
        let crown = at(place + vec3!(0, 2, 0), vec3!(1.5, 1.5, 1.5));
        canvas.draw_with(&both_sides, &BALL, &crown, &leaves);
    }
    let fence: [[Argb1555; 8]; 32] = from_fn(|y| from_fn(|x| picket(y, x)));
    for step in -16..=20 {
        let place = vec3!(0, 0.8, 1) + vec3!(0.5, 0, 0) * step;
        let upright = at(place, vec3!(0.25, 0.8, 1)) * Transform::rotate_x(deg!(90));
        canvas.draw(&SQUARE, &upright, &Textured::new(&fence).clamped());
    }
    Ok(())
}
