//! A planet in a ring of thousands of discs, in front of stars: points with a size.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

static PLANET: Mesh = shape!(sphere(48, 32));
const ROCKS: usize = 2400;
const STARS: usize = 160;

/// Numbers from 0 to 1 that look random.
fn noise(at: usize) -> Scalar {
    let mixed = (at as u32).wrapping_mul(0x9e37_79b9);
    let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca6b);
    Scalar::from_bits(((mixed ^ mixed >> 13) >> 16).cast_signed())
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(40), size, fx!(0.5), fx!(50))?;
    let tilt = Transform::rotate_x(deg!(16)) * Transform::rotate_z(deg!(14));
    let mvp = projection * Transform::translate(vec3!(0, 0, -7)) * tilt;
    canvas.clear(Rgb565::new(1, 2, 3));

    // The stars are squares with a size in pixels, which is the same at any distance.
    let stars: [Vec3; STARS] = core::array::from_fn(|at| {
        let across = |at| (noise(at) - fx!(0.5)) * 40;
        Vec3::new(across(2 * at), across(2 * at + 1), fx!(-30))
    });
    let (some, others) = stars.split_at(STARS / 6);
    let pixel = Scalar::try_from(size.height)? / 240; // the same size on any display
    for (stars, side) in [(some, pixel * 2), (others, pixel)] {
        let (stars, square) = (Mesh::new(stars, &[])?, PointStyle::square(side)?);
        let white = Flat::new(Rgb565::new(24, 50, 27));
        canvas.draw(stars.points(square), &projection, &white);
    }

    let sun = Light::new(vec3!(-3, 2, 2), fx!(0.08), fx!(0.92))?;
    let gas = Flat::rgb(Rgb888::new(235, 190, 130)).lit(sun);
    canvas.draw(&PLANET, &mvp, &gas);

    // The rocks are discs with a size in world units and a color each. The planet hides the discs behind it.
    let mut colors = [Rgb888::BLACK; ROCKS];
    let rocks: [Vec3; ROCKS] = core::array::from_fn(|at| {
        let [turn, out, up] = [0, ROCKS, 2 * ROCKS].map(|from| noise(from + at));
        let angle = Angle::from_turns(turn);
        let gap = if out > fx!(0.7) { fx!(0.2) } else { fx!(0) };
        let [x, z] =
            [angle.cos(), angle.sin()].map(|part| (fx!(1.4) + out * fx!(0.9) + gap) * part);
        let shade = (noise(3 * ROCKS + at) * 110).floor().cast_unsigned() as u8;
        colors[at] = Rgb888::new(130 + shade, 115 + shade, 90 + shade);
        Vec3::new(x, (up - fx!(0.5)) * fx!(0.04), z)
    });
    let rocks = Mesh::new(&rocks, &[])?.with_colors(&colors, None)?;
    let disc = PointStyle::round(fx!(0.05))?.attenuated();
    canvas.draw(rocks.points(disc), &mvp, &Gouraud::new());
    Ok(())
}
