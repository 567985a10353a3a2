//! The window, if the build has one. SDL2 is a library of the system, and neither building nor testing should need
//! it. So it is behind the feature `sdl`, which is used only here.

#[cfg(feature = "sdl")]
mod sdl {
    use embedded_graphics::draw_target::DrawTarget;
    use embedded_graphics::geometry::{Dimensions, Size};
    use embedded_graphics::pixelcolor::Rgb888;
    use embedded_graphics_simulator::{
        OutputSettingsBuilder, SimulatorDisplay, SimulatorEvent, Window,
    };
    use image::RgbImage;

    /// Opens a window of a picture's size, enlarged if the picture is small.
    pub struct Screen {
        window: Window,
        display: SimulatorDisplay<Rgb888>,
    }

    impl Screen {
        pub fn open((width, height): (u32, u32)) -> Self {
            let scale = (640 / width).clamp(1, 8);
            let settings = OutputSettingsBuilder::new().scale(scale).build();
            Self {
                window: Window::new("fixel", &settings),
                display: SimulatorDisplay::new(Size::new(width, height)),
            }
        }

        /// Shows the picture; returns whether the window is still open.
        pub fn show(&mut self, picture: &RgbImage) -> bool {
            let colors = picture
                .pixels()
                .map(|&image::Rgb([r, g, b])| Rgb888::new(r, g, b));
            let area = self.display.bounding_box();
            let Ok(()) = self.display.fill_contiguous(&area, colors);
            self.window.update(&self.display);
            !self
                .window
                .events()
                .any(|event| event == SimulatorEvent::Quit)
        }
    }
}

#[cfg(feature = "sdl")]
pub use sdl::Screen;

/// A window that cannot exist.
#[cfg(not(feature = "sdl"))]
pub enum Screen {}

#[cfg(not(feature = "sdl"))]
impl Screen {
    pub fn show(&mut self, _: &image::RgbImage) -> bool {
        match *self {}
    }
}

/// Opens a window for pictures of `size`.
///
/// # Errors
///
/// The build cannot open windows.
#[allow(clippy::unnecessary_wraps)] // can fail in the build without windows
pub fn open(size: (u32, u32)) -> super::Result<Screen> {
    #[cfg(feature = "sdl")]
    return Ok(Screen::open(size));
    #[cfg(not(feature = "sdl"))]
    {
        let _ = size;
        Err(
            "--window: this build has no window; install SDL2's development files and use \
             `cargo run --release -p simulator --features sdl`, or write a file with --out"
                .into(),
        )
    }
}
