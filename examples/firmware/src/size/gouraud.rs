//! Size probe: triangles with interpolated colors.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod probe;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;
use probe::{HEIGHT, MODEL, PLACE, WIDTH, projection};

fn draw(pixels: &mut [Rgb565], _: &mut [u16], now_ms: u64) -> Result<(), Error> {
    let spin = Transform::translate(PLACE) * Transform::rotate_y(probe::angle(now_ms));
    let mvp = projection()? * spin;
    let mut canvas = Canvas::new(pixels, WIDTH, HEIGHT)?;
    canvas.clear(Rgb565::BLACK);
    canvas.draw(&MODEL, &mvp, &Gouraud::new());
    Ok(())
}

#[cfg(not(target_os = "none"))]
fn main() {
    probe::host();
}
