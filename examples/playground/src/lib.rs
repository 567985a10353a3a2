//! The crate in a browser: the plain functions and the linear memory that examples/playground/page uses.
//!
//! `cargo build --release -p playground --lib --target wasm32-unknown-unknown` builds it, and
//! `cargo run --release -p playground` serves it with the page.
//!
//! | file | contents |
//! |---|---|
//! | `app` | the memory of the module, and what it does for the page |
//! | `view` | what the page asks for: scene, mode, size, camera |
//! | `scene` | the scenes' draw calls |
//! | `record` | the texel under each pixel, for the page's measurement of errors |
//! | `model` | the user's own model |
//! | `formats` | the picture in a display's colors |
//! | `main`, `server` | the program that serves the page, or writes it |
//! | `../tests` | the page and its module under Node and in Chromium, and the programs that it prints: see `.ci/playground` |
#![cfg_attr(target_arch = "wasm32", no_std)]

mod app;
#[path = "../../common/mod.rs"]
mod common;
mod formats;
mod model;
mod record;
mod scene;
mod view;

use spin::Mutex;

use app::App;

/// A browser calls one function at a time, so no one waits for the lock.
static APP: Mutex<App> = Mutex::new(App::new());

/// Declares the functions that the page calls. The only use of `unsafe` is the promise that no other symbol has these
/// names.
macro_rules! exports {
    ($($(#[$doc:meta])+ fn $name:ident($app:ident $(, $argument:ident: $Type:ty)*) -> $Result:ty $body:block)+) => {$(
        $(#[$doc])+
        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        pub extern "C" fn $name($($argument: $Type),*) -> $Result {
            let $app = &mut *APP.lock();
            $body
        }
    )+};
}

exports! {
    /// The settings of the picture to draw next: the fields of a `View`.
    fn view(app) -> *mut view::View { &raw mut app.view }
    /// Where the page writes a model's text or a texture's pixels: `input_size` bytes.
    fn input(app) -> *mut u8 { app.input.as_mut_ptr() }
    /// Room for input in bytes.
    fn input_size(app) -> usize { app.input.len() }
    /// The last error, in UTF-8.
    fn message(app) -> *const u8 { app.message.as_ptr() }
    /// Length of the message in bytes.
    fn message_size(app) -> usize { app.message.len() }
    /// Draws the background and clears depths; false leaves a message.
    fn clear(app, slot: usize) -> bool { app.clear(slot) }
    /// Draws the view; false leaves a message.
    fn draw(app, slot: usize) -> bool { app.draw(slot) }
    /// Writes the text over the scene; false leaves a message.
    fn overlay(app, slot: usize) -> bool { app.overlay(slot) }
    /// Counts of the last drawing: triangles in, drawn, and clipped; pixels drawn.
    fn counts(app) -> *const u32 { app.counts.as_ptr() }
    /// Counts the pixels that the view draws; false leaves a message.
    fn count(app, slot: usize) -> bool { app.count(slot) }
    /// Writes the triangles that the view draws and the texel under each pixel; false leaves a message.
    fn record(app, slot: usize) -> bool { app.record(slot) }
    /// The recorded pixels: triangle plus 1, or 0 for none; column and row of the texture in units of 2^-16 texel.
    fn pixels(app) -> *const [i32; 3] { app.pixels.as_ptr().cast() }
    /// The recorded triangles: size of the texture; position, u and v of each corner.
    fn triangles(app) -> *const [i32; 17] { app.triangles.as_ptr().cast() }
    /// Converts the picture to a display's format, for the page as bytes of red, green, blue and opacity.
    fn show(app, slot: usize, format: usize) -> *const u32 { app.show(slot, format) }
    /// The picture as it was drawn, in Rgb565.
    fn picture(app, slot: usize) -> *const u16 { app.colors(slot).as_ptr().cast() }
    /// Reads an OBJ text from the input; false leaves a message.
    fn read_model(app, bytes: usize) -> bool { app.read_model(bytes) }
    /// The center of the model's box, and the distance of the farthest position from it.
    fn bounds(app) -> *const [i32; 4] { app.bounds() }
    /// Reads a texture's pixels (red, green, blue, opacity) from the input; false leaves a message.
    fn read_texture(app, width: u32, height: u32) -> bool { app.read_texture(width, height) }
    /// Counts of instructions from tests/instructions.csv.
    fn costs(_app) -> *const u8 { app::COSTS.as_ptr() }
    /// Length of the counts in bytes.
    fn costs_size(_app) -> usize { app::COSTS.len() }
}

#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
