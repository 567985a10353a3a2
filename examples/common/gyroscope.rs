//! The scene of the program `oled`: a cube inside two rings, and a caption with the frame number. Each part turns at
//! its own rate. The panel has 128x64 pixels in 16 grays.
//!
//! `no_std`: the board draws the scene in bands, the host as a whole frame.

use core::fmt::Write;

use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii};
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics::text::Text;
use fixel::Prepared;
use fixel::canvas::{DepthBuffer, Storage};
use fixel::prelude::*;
use fixel::shade::Light;

/// The width of the panel in pixels.
pub const WIDTH: u32 = 128;
/// The height of the panel in pixels.
pub const HEIGHT: u32 = 64;

/// Milliseconds from one frame to the next. The picture depends only on the frame number, so it is the same on every
/// computer, however fast it is drawn.
pub const FRAME_MS: u32 = 30;
/// The number of frames: one turn of the outer ring, and then on to a pose that shows all three parts.
pub const FRAMES: u32 = 211;
/// Turns per minute of the outer ring. The inner ring turns twice as fast, the cube three times as fast.
const RPM: i32 = 10;

static RING: Mesh = shape!(torus(fx!(0.12), 32, 8));
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));

/// Memory for the visible triangles of a frame: 19 KiB.
pub struct Lists {
    outer: DrawList<280, 280>,
    inner: DrawList<280, 280>,
    cube: DrawList<6, 12>,
}

impl Lists {
    pub const fn new() -> Self {
        Self {
            outer: DrawList::new(),
            inner: DrawList::new(),
            cube: DrawList::new(),
        }
    }

    /// Transforms the parts of a frame once for all bands of the frame.
    ///
    /// # Errors
    ///
    /// None: the numbers are constant, and every frame fits.
    pub fn prepare(&mut self, frame: u32) -> Result<Gyroscope<'_>, Error> {
        let half = Viewport::new(i32::try_from(WIDTH / 2).unwrap_or(0), 0, WIDTH / 2, HEIGHT)?;
        let options: DrawOptions = DrawOptions::new().with_viewport(half);
        let projection = Projection::perspective(
            Angle::from_degrees(40),
            (WIDTH / 2, HEIGHT),
            fx!(1),
            fx!(10),
        )?;
        let camera = Camera::look_at(vec3!(0, 1.2, 3.2), Vec3::ZERO, Vec3::Y)?;

        let now_ms = u64::from(frame) * u64::from(FRAME_MS);
        let turned = |rpm: i32| Rate::rpm(rpm).angle_at(now_ms);
        // The axis of a ring is y. The outer ring is turned upright, and the inner ring is at right angles to the outer
        // ring.
        let upright = Transform::rotate_x(Angle::from_degrees(90));
        let outer = Transform::rotate_y(turned(RPM)) * upright;
        let inner =
            outer * Transform::rotate_x(turned(2 * RPM)) * upright * Transform::scale(fx!(0.74));
        let cube = inner * Transform::rotate_z(turned(-3 * RPM)) * Transform::scale(fx!(0.34));

        let (size, view) = ((WIDTH, HEIGHT), projection * camera);
        Ok(Gyroscope {
            frame,
            sun: Light::new(vec3!(-2, 4, 3), fx!(0.2), fx!(0.8))?,
            parts: [
                (
                    self.outer.prepare(&options, size, &RING, &(view * outer))?,
                    15,
                ),
                (
                    self.inner.prepare(&options, size, &RING, &(view * inner))?,
                    9,
                ),
                (
                    self.cube.prepare(&options, size, &CUBE, &(view * cube))?,
                    15,
                ),
            ],
        })
    }
}

/// A frame, ready to be drawn.
pub struct Gyroscope<'l> {
    frame: u32,
    sun: Light,
    /// The prepared parts, each with its gray.
    parts: [(Prepared<'l>, u8); 3],
}

impl Gyroscope<'_> {
    /// Draws the part of the frame that the canvas holds. The model is in the right half of the frame, the caption in
    /// the left half.
    pub fn draw<O, D>(&self, canvas: &mut Canvas<'_, Gray4, O, D>) -> Result<(), Error>
    where
        O: Storage<Gray4>,
        D: DepthBuffer,
    {
        canvas.clear(Gray4::BLACK);
        for (part, gray) in &self.parts {
            canvas.draw_prepared(part, &Flat::<Gray4>::rgb(Gray4::new(*gray)).lit(self.sun))?;
        }
        caption(canvas, self.frame);
        Ok(())
    }
}

fn caption<O, D>(canvas: &mut Canvas<'_, Gray4, O, D>, frame: u32)
where
    O: Storage<Gray4>,
    D: DepthBuffer,
{
    // A number has at most ten digits.
    let mut number = heapless::String::<16>::new();
    let _ = write!(number, "frame {frame}");
    let mut rate = heapless::String::<16>::new();
    let _ = write!(rate, "{RPM} rpm");
    for (text, font, gray, baseline) in [
        ("fixel", &ascii::FONT_9X18_BOLD, 15, 22),
        (rate.as_str(), &ascii::FONT_6X10, 11, 42),
        (number.as_str(), &ascii::FONT_6X10, 11, 54),
    ] {
        let style = MonoTextStyle::new(font, Gray4::new(gray));
        let Ok(_) = Text::new(text, Point::new(4, baseline), style).draw(canvas);
    }
}
