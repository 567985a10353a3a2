//! The code that the probes of the modes share: textured triangles with a depth buffer.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mode::Mode;
use fixel::prelude::*;

use super::probe::{HEIGHT, MODEL, PLACE, SKIN, WIDTH, angle, projection};

/// Draws the triangles in a mode.
#[inline]
pub fn draw(
    pixels: &mut [Rgb565],
    depths: &mut [u16],
    now_ms: u64,
    mode: impl Mode,
) -> Result<(), Error> {
    let spin = Transform::translate(PLACE) * Transform::rotate_y(angle(now_ms));
    let mvp = projection()? * spin;
    let mut canvas = Canvas::new(pixels, WIDTH, HEIGHT)?.with_depth(depths)?;
    canvas.clear(Rgb565::BLACK);
    let options = DrawOptions::new().with_mode(mode);
    canvas.draw_with(&options, &MODEL, &mvp, &Textured::new(&SKIN));
    Ok(())
}
