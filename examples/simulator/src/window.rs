//! The window, if the build supports windows. SDL2 is a system library, and neither building nor testing should need
//! it. Therefore it is behind the feature `sdl`, which only this file uses.

use fixel::prelude::*;

use super::view::View;

/// How the user has turned the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Orbit {
    /// The angle about the direction that is up.
    yaw: Angle,
    /// The angle about the direction that points right in the picture.
    pitch: Angle,
    zoom: Scalar,
}

/// The largest factor by which the user can enlarge a model.
pub const MOST_ZOOM: i32 = 4;

impl Default for Orbit {
    fn default() -> Self {
        Self {
            yaw: Angle::ZERO,
            pitch: Angle::ZERO,
            zoom: fx!(1),
        }
    }
}

impl Orbit {
    /// Returns `pose` with the user's turn about the origin, where the middle of the model is drawn.
    pub fn turned(&self, pose: Transform, view: &View) -> Transform {
        if *self == Self::default() {
            return pose;
        }
        let right = view.camera.pose().direction(Vec3::X);
        // The axes are not zero, because no camera can be made with a zero axis.
        let turn = |axis, angle| Transform::rotate(axis, angle).unwrap_or(Transform::IDENTITY);
        Transform::scale(self.zoom) * turn(right, self.pitch) * turn(view.up, self.yaw) * pose
    }
}

#[cfg(feature = "sdl")]
mod sdl {
    use embedded_graphics::draw_target::DrawTarget;
    use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
    use embedded_graphics::pixelcolor::Rgb888;
    use embedded_graphics_simulator::sdl2::{Keycode, MouseButton, MouseWheelDirection};
    use embedded_graphics_simulator::{
        OutputSettingsBuilder, SimulatorDisplay, SimulatorEvent, Window,
    };
    use fixel::prelude::*;

    use super::{MOST_ZOOM, Orbit};

    /// The angle by which a key turns the model, in degrees.
    const STEP: i32 = 5;

    /// A window with the size of a picture, enlarged if the picture is small.
    pub struct Screen {
        window: Window,
        display: SimulatorDisplay<Rgb888>,
        orbit: Orbit,
        /// The last position of the mouse while its button is down.
        dragged: Option<Point>,
    }

    impl Screen {
        pub fn open((width, height): (u32, u32)) -> Self {
            let scale = (640 / width).clamp(1, 8);
            let settings = OutputSettingsBuilder::new().scale(scale).build();
            Self {
                window: Window::new("fixel", &settings),
                display: SimulatorDisplay::new(Size::new(width, height)),
                orbit: Orbit::default(),
                dragged: None,
            }
        }

        /// Shows the picture. Returns how the user has turned the model, or `None` if the user closed the window.
        pub fn show(&mut self, colors: &[Rgb888]) -> Option<Orbit> {
            let area = self.display.bounding_box();
            let Ok(()) = self.display.fill_contiguous(&area, colors.iter().copied());
            self.window.update(&self.display);
            let events: Vec<SimulatorEvent> = self.window.events().collect();
            for event in events {
                match event {
                    SimulatorEvent::Quit
                    | SimulatorEvent::KeyDown {
                        keycode: Keycode::Escape,
                        ..
                    } => return None,
                    SimulatorEvent::KeyDown { keycode, .. } => self.key(keycode),
                    SimulatorEvent::MouseButtonDown {
                        mouse_btn: MouseButton::Left,
                        point,
                    } => self.dragged = Some(point),
                    SimulatorEvent::MouseButtonUp { .. } => self.dragged = None,
                    SimulatorEvent::MouseMove { point } => self.drag(point),
                    SimulatorEvent::MouseWheel {
                        scroll_delta,
                        direction,
                    } => {
                        let is_flipped = direction == MouseWheelDirection::Flipped;
                        self.zoom((scroll_delta.y > 0) != is_flipped);
                    }
                    _ => {}
                }
            }
            Some(self.orbit)
        }

        fn key(&mut self, key: Keycode) {
            let step = Angle::from_degrees(STEP);
            let orbit = &mut self.orbit;
            match key {
                Keycode::Left => orbit.yaw -= step,
                Keycode::Right => orbit.yaw += step,
                Keycode::Up => orbit.pitch -= step,
                Keycode::Down => orbit.pitch += step,
                Keycode::Plus | Keycode::Equals | Keycode::KpPlus => self.zoom(true),
                Keycode::Minus | Keycode::KpMinus => self.zoom(false),
                Keycode::Space => *orbit = Orbit::default(),
                _ => {}
            }
        }

        fn drag(&mut self, point: Point) {
            let Some(before) = self.dragged.replace(point) else {
                self.dragged = None;
                return;
            };
            let width = self.display.size().width.cast_signed();
            let moved = point - before;
            let angle = |pixels: i32| {
                // Dragging across the whole picture turns by half a turn. Whole turns have no effect.
                let bits = (i64::from(pixels) << 31) / i64::from(width);
                Angle::from_bits((bits as i32).cast_unsigned())
            };
            self.orbit.yaw += angle(moved.x);
            self.orbit.pitch += angle(moved.y);
        }

        /// Enlarges the model by an eighth, or reduces it by the same factor. The zoom stays between 1/4 and
        /// [`MOST_ZOOM`].
        fn zoom(&mut self, closer: bool) {
            let zoom = self.orbit.zoom;
            let zoom = if closer {
                zoom + zoom / 8
            } else {
                zoom - zoom / 9
            };
            self.orbit.zoom = zoom.clamp(fx!(0.25), Scalar::try_from(MOST_ZOOM).unwrap());
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
    pub fn show(&mut self, _: &[embedded_graphics::pixelcolor::Rgb888]) -> Option<Orbit> {
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
