//! The little world in a browser: a module of its own, which the page loads when someone wants to see it.
#![cfg_attr(target_arch = "wasm32", no_std)]

#[macro_use]
#[path = "../../src/modes.rs"]
mod modes;
#[path = "../../../common/world/mod.rs"]
mod world;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;
use spin::Mutex;

const PIXELS: usize = 640 * 480;

/// Memory for a band's colors and depths.
struct Memory {
    colors: [Rgb565; PIXELS],
    depths: [u16; PIXELS],
}

/// A browser calls one function at a time, so no one waits for the lock.
static MEMORY: Mutex<Memory> = Mutex::new(Memory {
    colors: [Rgb565::BLACK; PIXELS],
    depths: [0; PIXELS],
});

/// Draws a band of the picture in a mode, `Fast` within a tolerance in texels, at a moment of the walk, a fraction of
/// 2^32. Returns the band; null if a number is out of range.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn draw(
    mode: u32,
    tolerance: f64,
    width: u32,
    height: u32,
    first_row: u32,
    rows: u32,
    moment: u32,
) -> *const u16 {
    let Memory { colors, depths } = &mut *MEMORY.lock();
    let pixels = width.saturating_mul(rows) as usize;
    // The canvas refuses memory that is too short.
    let band = colors.get_mut(..pixels).unwrap_or_default();
    let depths = depths.get_mut(..pixels).unwrap_or_default();
    let drawn = Scalar::try_from(tolerance).and_then(|tolerance| {
        let canvas = Canvas::band(band, width, height, first_row)?;
        let canvas = &mut canvas.with_depth(depths)?;
        let moment = Angle::from_bits(moment);
        in_mode!(mode, tolerance, |mode| world::draw(canvas, mode, moment))
    });
    match drawn {
        Ok(()) => colors.as_ptr().cast(),
        Err(_) => core::ptr::null(),
    }
}

#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
