//! Shared by the probes `everything`: every stage of the pipeline once, on one canvas with a depth buffer.
//!
//! These are a camera, time and a light; points, lines, and triangles that are flat, Gouraud shaded, textured and lit;
//! clipping, depth and perspective. There are one canvas and one projection: other combinations of type parameters need
//! other code, which a program links only if it uses them (`shades` has more).

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mode::Mode;
use fixel::prelude::*;

use super::probe::{HEIGHT, MODEL, PLACE, SKIN, WIDTH, projection};

/// Draws everything in a mode.
#[inline]
pub fn draw(
    pixels: &mut [Rgb565],
    depths: &mut [u16],
    now_ms: u64,
    mode: impl Mode,
) -> Result<(), Error> {
    let camera = Camera::look_at(vec3!(0, 0.5, 0), PLACE, Vec3::Y)?;
    let spin = Transform::translate(PLACE) * Transform::rotate_y(Rate::rpm(10).angle_at(now_ms));
    let mvp = projection()? * camera * spin;
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
    let options = DrawOptions::new().with_mode(mode);
    let mut canvas = Canvas::new(pixels, WIDTH, HEIGHT)?.with_depth(depths)?;
    canvas.clear(Rgb565::BLACK);
    canvas.draw_with(&options, &MODEL, &mvp, &Flat::new(Rgb565::BLUE));
    canvas.draw_with(&options, &MODEL, &mvp, &Gouraud::new());
    canvas.draw_with(&options, &MODEL, &mvp, &Textured::new(&SKIN).lit(sun));
    canvas.draw_with(
        &options,
        MODEL.edges(LineStyle::HAIRLINE),
        &mvp,
        &Flat::new(Rgb565::GREEN),
    );
    canvas.draw_with(
        &options,
        MODEL.points(PointStyle::PIXEL),
        &mvp,
        &Flat::new(Rgb565::WHITE),
    );
    Ok(())
}
