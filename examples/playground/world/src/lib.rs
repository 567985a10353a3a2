//! The little world in a browser: a module of its own. The page opens with it, and then loads the other modules.
//!
//! It has only the default mode. The other modes would add a third to the module, and so to the time until the first
//! picture, and look alike here: the triangles are small.
#![cfg_attr(target_arch = "wasm32", no_std)]

#[path = "../../../common/world/mod.rs"]
mod world;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mode::Newton;
use fixel::prelude::*;
use spin::Mutex;

const PIXELS: usize = 640 * 480;

/// Memory for a band's colors and depths, and for the band as the page shows it: in bytes of red, green, blue and
/// opacity.
struct Memory {
    colors: [Rgb565; PIXELS],
    depths: [u16; PIXELS],
    shown: [u32; PIXELS],
}

/// A browser calls one function at a time, so no one waits for the lock.
static MEMORY: Mutex<Memory> = Mutex::new(Memory {
    colors: [Rgb565::BLACK; PIXELS],
    depths: [0; PIXELS],
    shown: [0; PIXELS],
});

/// Draws a band of the picture at a moment of the walk, a fraction of 2^32. Returns the band; null if a number is out of
/// range.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn draw(
    width: u32,
    height: u32,
    first_row: u32,
    rows: u32,
    moment: u32,
) -> *const u16 {
    let Memory { colors, depths, .. } = &mut *MEMORY.lock();
    let pixels = width.saturating_mul(rows) as usize;
    // The canvas refuses memory that is too short.
    let band = colors.get_mut(..pixels).unwrap_or_default();
    let depths = depths.get_mut(..pixels).unwrap_or_default();
    let drawn = Canvas::band(band, width, height, first_row).and_then(|canvas| {
        let canvas = &mut canvas.with_depth(depths)?;
        world::draw(canvas, Newton::default(), Angle::from_bits(moment))
    });
    match drawn {
        Ok(()) => colors.as_ptr().cast(),
        Err(_) => core::ptr::null(),
    }
}

/// Converts the first pixels of the band that was drawn last, for the page to show. Returns all pixels.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn show(pixels: usize) -> *const u32 {
    let Memory { colors, shown, .. } = &mut *MEMORY.lock();
    for (&color, shown) in colors.iter().zip(shown.iter_mut()).take(pixels) {
        let color = Rgb888::from(color);
        *shown = u32::from_le_bytes([color.r(), color.g(), color.b(), 255]);
    }
    shown.as_ptr()
}

#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
