//! What the display of a board shows, drawn in a browser by the code that draws it on the board. It is a module of its
//! own, which the page loads when someone runs a board.
#![cfg_attr(target_arch = "wasm32", no_std)]

// A board also asks whether there is a model, and reports a panic.
#[allow(dead_code)]
#[path = "../../../boards/src/model.rs"]
mod model;
#[allow(dead_code)]
#[path = "../../../boards/src/report.rs"]
mod report;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use flash_model::Module;
use spin::Mutex;

use model::Scene;

/// The most pixels of a display.
const PIXELS: usize = 480 * 320;
/// The most words of a model: the flash of a Pico 2 has fewer.
const WORDS: usize = 1 << 20;

/// Memory for a model, and for a picture of it.
struct Memory {
    words: [u32; WORDS],
    colors: [Rgb565; PIXELS],
    depths: [u16; PIXELS],
    /// In bytes of red, green, blue and opacity.
    shown: [u32; PIXELS],
}

/// A browser calls one function at a time, so no one waits for the lock.
static MEMORY: Mutex<Memory> = Mutex::new(Memory {
    words: [0; WORDS],
    colors: [Rgb565::BLACK; PIXELS],
    depths: [0; PIXELS],
    shown: [0; PIXELS],
});

/// Returns where the page writes the words of a model.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn words() -> *mut u32 {
    MEMORY.lock().words.as_mut_ptr()
}

/// Returns the columns of the display that the model names.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn width() -> u32 {
    Module::wanted(&MEMORY.lock().words).size().0
}

/// Returns the rows of the display.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn height() -> u32 {
    Module::wanted(&MEMORY.lock().words).size().1
}

/// Draws the frame that a board begins `now_ms` milliseconds after its start. Returns the pixels in bytes of red, green,
/// blue and opacity; null if the display is too large.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn draw(now_ms: u32) -> *const u32 {
    let memory = &mut *MEMORY.lock();
    let drawn = Scene::new(&memory.words).and_then(|scene| {
        let (width, height) = scene.size();
        let pixels = width.saturating_mul(height) as usize;
        // The canvas refuses memory that is too short.
        let colors = memory.colors.get_mut(..pixels).unwrap_or_default();
        let depths = memory.depths.get_mut(..pixels).unwrap_or_default();
        let mut canvas = Canvas::new(colors, width, height)?.with_depth(depths)?;
        scene.draw(now_ms.into(), &mut canvas);
        Ok(())
    });
    if drawn.is_err() {
        return core::ptr::null();
    }
    for (&color, shown) in memory.colors.iter().zip(&mut memory.shown) {
        let color = Rgb888::from(color);
        *shown = u32::from_le_bytes([color.r(), color.g(), color.b(), 255]);
    }
    memory.shown.as_ptr()
}

#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
