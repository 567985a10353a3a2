//! The crate in a browser: the plain functions and the linear memory that examples/playground/page uses.
//!
//! `main` tells how to build it; `cargo run --release -p playground` serves it with the page.
//!
//! | file | contents |
//! |---|---|
//! | `app` | the memory of the module, and what it does for the page |
//! | `modes` | the modes by their numbers |
//! | `view` | what the page asks for: scene, mode, size, camera |
//! | `scene` | the scenes' draw calls |
//! | `record` | the texel under each pixel, as a mode interpolates it |
//! | `exact` | the exact texel there, and the colors of errors |
//! | `cost` | instructions on a microcontroller |
//! | `model` | the user's own model |
//! | `program` | the program that draws the picture, as text |
//! | `formats` | the picture in a display's colors |
//! | `../reader` | a module of its own, which reads the user's files |
//! | `../world` | another one, which draws the little world |
//! | `../gif` | another one, which writes an animated GIF |
//! | `../display` | another one, which draws what a board's display shows |
//! | `main`, `server` | the program that serves the page, or writes it |
//! | `../tests` | the page and its module under Node and in Chromium, and the printed programs: see `.ci/playground` |
#![cfg_attr(target_arch = "wasm32", no_std)]

#[macro_use]
mod modes;

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

/// Declares functions that the page calls: addresses and sizes, then what `App` does. The only use of `unsafe` is the
/// promise that no other symbol has these names.
macro_rules! exports {
    (
        $($(#[$doc:meta])+ fn $name:ident($app:ident $(, $slot:ident)?) -> $Result:ty { $value:expr })+
        do $($action:ident)+
    ) => {
        $(
            $(#[$doc])+
            #[allow(unsafe_code)]
            #[unsafe(no_mangle)]
            pub extern "C" fn $name($($slot: usize)?) -> $Result {
                let $app = &mut *APP.lock();
                $value
            }
        )+
        $(
            /// See the method of this name. Returns false if it failed; the text then tells why.
            #[allow(unsafe_code)]
            #[unsafe(no_mangle)]
            pub extern "C" fn $action(number: usize) -> bool {
                let app = &mut *APP.lock();
                let done = app.$action(number);
                app.tell(done)
            }
        )+
    };
}

exports! {
    /// The settings of the picture to draw next, and results: see `view::NAMES`.
    fn fields(app) -> *mut f64 { app.fields.as_mut_ptr() }
    /// Where the page writes a model's lists or a texture's pixels.
    fn input(app) -> *mut u8 { app.input.as_mut_ptr() }
    /// What the last call wrote, in UTF-8.
    fn text(app) -> *const u8 { app.text.as_ptr() }
    /// Length of the text in bytes.
    fn text_size(app) -> usize { app.text.len() }
    /// The pixels to show, in bytes of red, green, blue and opacity.
    fn shown(app, slot) -> *const u32 { app.shown(slot) }
    /// The picture as it was drawn, in Rgb565.
    fn picture(app, slot) -> *const u16 { app.picture(slot) }
    do names home clear draw show measure errors checksum program read_model read_texture foreshorten
}

#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
