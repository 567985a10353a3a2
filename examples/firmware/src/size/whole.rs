//! The code that both probes named `everything` share: every stage of the pipeline once, on a canvas with a depth
//! buffer.
//!
//! The stages are a camera, time and a light; points, lines, and triangles that are flat, Gouraud shaded, textured and
//! lit; clipping, depth and perspective. There is one canvas and one projection. Other combinations of type parameters
//! need other code, and a program links this code only if it uses them (`shades` uses more).

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
