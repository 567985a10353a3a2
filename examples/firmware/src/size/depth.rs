//! Size probe: textured triangles with a depth buffer, in the default mode.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod probe;
mod with_depth;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::mode::Newton;
use fixel::prelude::*;

fn draw(pixels: &mut [Rgb565], depths: &mut [u16], now_ms: u64) -> Result<(), Error> {
    with_depth::draw(pixels, depths, now_ms, Newton::default())
}

#[cfg(not(target_os = "none"))]
fn main() {
    probe::host();
}
