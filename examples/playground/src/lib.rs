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
//! | `record` | the texel under each pixel, as a mode interpolates it |
//! | `exact` | the exact texel there, and the colors of errors |
//! | `cost` | instructions on a microcontroller |
//! | `model` | the user's own model |
//! | `program` | the program that draws the picture, as text |
//! | `formats` | the picture in a display's colors |
//! | `main`, `server` | the program that serves the page, or writes it |
//! | `../tests` | the page and its module under Node and in Chromium, and the printed programs: see `.ci/playground` |
#![cfg_attr(target_arch = "wasm32", no_std)]

mod app;
#[path = "../../common/mod.rs"]
mod common;
mod cost;
mod exact;
mod formats;
mod model;
mod program;
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
    /// The settings of the picture to draw next, in the order of `names`.
    fn fields(app) -> *mut f64 { app.fields.as_mut_ptr() }
    /// Writes the settings' names to the text.
    fn names(app) -> bool { app.text.clear(); app.text.push_str(view::NAMES).is_ok() }
    /// Writes the settings of a scene's start.
    fn home(app, scene: usize) -> () { app.home(scene); }
    /// Where the page writes a model's text or a texture's pixels: `input_size` bytes.
    fn input(app) -> *mut u8 { app.input.as_mut_ptr() }
    /// Room for input in bytes.
    fn input_size(app) -> usize { app.input.len() }
    /// What the last call wrote, in UTF-8; after one that returned false, an error's message.
    fn text(app) -> *const u8 { app.text.as_ptr() }
    /// Length of the text in bytes.
    fn text_size(app) -> usize { app.text.len() }
    /// Draws the background and clears depths.
    fn clear(app, slot: usize) -> bool { let done = app.clear(slot); app.tell(done) }
    /// Draws the view.
    fn draw(app, slot: usize) -> bool { let done = app.draw(slot); app.tell(done) }
    /// Writes the text over the scene.
    fn overlay(app, slot: usize) -> bool { let done = app.overlay(slot); app.tell(done) }
    /// Converts the picture to the display's format.
    fn show(app, slot: usize) -> bool { let done = app.show(slot); app.tell(done) }
    /// Counts triangles and pixels, and estimates instructions. Spoils the picture.
    fn measure(app, slot: usize) -> bool { let done = app.measure(slot); app.tell(done) }
    /// Compares with the exact texels, and shows errors as colors. Spoils the picture.
    fn errors(app, slot: usize) -> bool { let done = app.errors(slot); app.tell(done) }
    /// What was measured: see `App::results`.
    fn results(app) -> *const f64 { app.results.as_ptr() }
    /// The pixels to show, in bytes of red, green, blue and opacity.
    fn shown(app, slot: usize) -> *const u32 { app.shown(slot) }
    /// The picture as it was drawn, in Rgb565.
    fn picture(app, slot: usize) -> *const u16 { app.picture(slot) }
    /// CRC-32 of the picture's pixels, as the firmware computes it.
    fn checksum(app, slot: usize) -> u32 { app.checksum(slot) }
    /// Writes the program that draws the view to the text.
    fn program(app) -> bool { let done = app.program(); app.tell(done) }
    /// Reads an OBJ text from the input.
    fn read_model(app, bytes: usize) -> bool { let done = app.read_model(bytes); app.tell(done) }
    /// Reads a texture's pixels (red, green, blue, opacity) from the input.
    fn read_texture(app, width: u32, height: u32) -> bool {
        let done = app.read_texture(width, height);
        app.tell(done)
    }
}

#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
