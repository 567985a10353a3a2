//! Size probe: everything except drawing. The cost of drawing is the size of another probe minus the size of this
//! probe.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod probe;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::Error;

/// Draws nothing.
#[allow(clippy::unnecessary_wraps)] // the same signature as in the other probes
fn draw(_: &mut [Rgb565], _: &mut [u16], _: u64) -> Result<(), Error> {
    Ok(())
}

#[cfg(not(target_os = "none"))]
fn main() {
    probe::host();
}
