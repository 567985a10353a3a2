//! Size probe: textured triangles with a depth buffer, in mode `Exact`.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod probe;
mod with_depth;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::mode::Exact;
use fixel::prelude::*;

fn draw(pixels: &mut [Rgb565], depths: &mut [u16], now_ms: u64) -> Result<(), Error> {
    with_depth::draw(pixels, depths, now_ms, Exact)
}

#[cfg(not(target_os = "none"))]
fn main() {
    probe::host();
}
