//! A ball of 1,984 triangles turns in the light, each triangle in a color of its own.

use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::text::Text;
use fixel::canvas::Storage;
use fixel::prelude::*;
use fixel::shade::FaceLit;
use fixel::{Prepared, ShadeList};

static BALL: Mesh = shape!(sphere(32, 32));

const SKY: Rgb565 = Rgb565::new(3, 8, 8);
const CAPTION: &str = "1984 facets";

/// Everything that stays the same from frame to frame.
pub struct Scene {
    size: (u32, u32),
    view: Mvp,
    clay: Clay,
}

type Clay = FaceLit<Flat<Rgb565>, Light>;

/// The triangles that face the eye, and their light: once for all bands.
pub struct Memory {
    list: DrawList<736, 440>,
    light: ShadeList<Clay, 736>,
}

impl Memory {
    /// Empty memory.
    #[must_use]
    #[allow(clippy::new_without_default)] // for statics
    pub const fn new() -> Self {
        Self {
            list: DrawList::new(),
            light: ShadeList::new(),
        }
    }
}

impl Scene {
    /// Makes the scene for a frame of `width` x `height` pixels.
    ///
    /// # Errors
    ///
    /// No canvas can have this size.
    pub fn new(width: u32, height: u32) -> Result<Self, Error> {
        let size = (width, height);
        let projection = Projection::perspective(deg!(62), size, fx!(0.25), fx!(100))?;
        let camera = Camera::look_at(vec3!(0, 0, 2.256), Vec3::ZERO, Vec3::Y)?;
        let sun = Light::new(vec3!(2, 3, 6), fx!(0.25), fx!(0.75))?;
        Ok(Self {
            size,
            view: projection * camera,
            clay: Flat::new(Rgb565::new(31, 42, 11)).lit_faces(sun),
        })
    }

    /// The scene at the time `now_ms`.
    ///
    /// # Errors
    ///
    /// The memory is too short for the visible triangles.
    pub fn at<'m>(
        &self,
        now_ms: u64,
        memory: &'m mut Memory,
    ) -> Result<Moment<'m, impl ShaderFor<Rgb565> + use<'m>>, Error> {
        let turn = Transform::rotate_x(Rate::rpm(7).angle_at(now_ms))
            * Transform::rotate_y(Rate::rpm(10).angle_at(now_ms));
        let mvp = self.view * turn;
        let ball = memory
            .list
            .prepare(&DrawOptions::new(), self.size, &BALL, &mvp)?;
        let clay = self.clay;
        let clay = ball.shade(&mut memory.light, move |()| clay)?(&());
        Ok(Moment { ball, clay })
    }
}

/// A moment of the scene.
pub struct Moment<'m, S> {
    ball: Prepared<'m>,
    clay: S,
}

impl<S: ShaderFor<Rgb565>> Moment<'_, S> {
    /// Draws the part of the frame that belongs to the canvas.
    pub fn draw<O: Storage<Rgb565>>(&self, canvas: &mut Canvas<'_, Rgb565, O>) {
        canvas.clear(SKY);
        // A ball hides nothing of itself but its back, so no depth buffer is needed.
        let Ok(_) = canvas.draw_prepared(&self.ball, &self.clay) else {
            return;
        };
        let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
        canvas.overlay(&Text::new(CAPTION, Point::new(4, 12), style));
    }
}
