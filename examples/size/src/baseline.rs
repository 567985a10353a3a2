//! Size probe: no drawing, all of the rest. What other probes have beyond it is what drawing takes.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod probe;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::Error;

/// Draws nothing.
#[allow(clippy::unnecessary_wraps)] // as those that draw
fn draw(_: &mut [Rgb565], _: &mut [u16], _: u64) -> Result<(), Error> {
    Ok(())
}

#[cfg(not(target_os = "none"))]
fn main() {
    probe::host();
}
