//! Firs, cut out of a texture, that turn about their trunks to face the viewer; and snow.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;

static FLOOR: Mesh = shape!(plane(1, 1));
static FIR: [[Rgb565; 32]; 32] = fir();

/// Three tiers of snowy branches, and a trunk. All other texels are magenta.
const fn fir() -> [[Rgb565; 32]; 32] {
    let mut texels = [[Rgb565::MAGENTA; 32]; 32];
    let mut at = 0_usize;
    while at < 32 * 32 {
        let (x, y) = (at % 32, at / 32);
        let (aside, noise) = ((2 * x).abs_diff(31) / 2, (x * 7 + y * 13 + x * y) % 5);
        let light = (noise + (31 - x) / 5) as u8;
        if y < 28 && aside <= y / 4 + y % 9 {
            let is_white = y % 9 + noise / 2 < 3;
            let [r, g, b] = if is_white { [20, 42, 23] } else { [2, 14, 5] };
            texels[y][x] = Rgb565::new(r + light / 2, g + 2 * light, b + light / 3);
        } else if y >= 28 && aside < 2 {
            texels[y][x] = Rgb565::new(9, 13, 4);
        }
        at += 1;
    }
    texels
}

/// Points that fill a box of this size evenly, sorted from front to back.
fn scattered<const N: usize>(size: Vec3) -> [Vec3; N] {
    core::array::from_fn(|i| {
        // Multiples of irrational numbers, modulo 1.
        let part = |steps: usize| Scalar::from_bits(i32::from(steps as u16));
        let [x, y, z] = [part(40_503 * i), part(27_146 * i * i), part(65_536 * i / N)];
        Vec3::new((x - fx!(0.5)) * size.x, y * size.y, z * -size.z)
    })
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(0.5), fx!(100))?;
    let view = projection * Camera::look_at(vec3!(0, 1.8, 4), vec3!(0, 1.9, -8), Vec3::Y)?;
    let (haze, options) = (Rgb565::new(20, 43, 24), DrawOptions::new());
    let fog = Fog::linear(haze, fx!(3), fx!(34))?;
    canvas.clear(haze);
    let snow = Flat::new(Rgb565::new(29, 60, 31)).in_fog(fog);
    canvas.draw(&FLOOR, &(view * Transform::scale(fx!(60))), &snow);
    // The firs stand on the floor. The snow faces the viewer.
    let places = scattered::<120>(vec3!(44, 0, 40));
    let firs = Sprites::new(&places, (fx!(2.4), fx!(3.2)))?.with_axis(Vec3::Y)?;
    let firs = firs.with_anchor(vec2!(0.5, 1));
    let needles = Textured::new(&FIR).clamped().cut_out(Rgb565::MAGENTA);
    canvas.draw_with(&options, &firs, &view, &needles.in_fog(fog));
    let (places, white) = (scattered::<400>(vec3!(24, 9, 16)), Flat::new(Rgb565::WHITE));
    let flakes = Sprites::new(&places, (fx!(0.06), fx!(0.06)))?;
    canvas.draw_with(&options, &flakes, &view, &white);
    Ok(())
}
