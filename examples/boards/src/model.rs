//! Draws the model in flash, turning in the sun, or a message if there is none or it is damaged.

use core::fmt::Write;

use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X13};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::text::Text;
use fixel::Window;
use fixel::canvas::Storage;
use fixel::mode::Fast;
use fixel::prelude::*;
use flash_model::{Model, Module, Problem};
use heapless::String;

const SKY: Rgb565 = Rgb565::new(3, 8, 8);

/// Everything that stays the same from frame to frame.
pub struct Scene<'a> {
    size: (u32, u32),
    model: Result<Model<'a>, String<128>>,
    view: Mvp,
    sun: Light,
}

impl<'a> Scene<'a> {
    /// The scene of the model in these words, for the module that they name.
    ///
    /// # Errors
    ///
    /// None.
    pub fn new(words: &'a [u32]) -> Result<Self, Error> {
        let size = Module::wanted(words).size();
        // The model lies in the ball of radius 1, which touches the nearer borders of the picture: 2.924 sin 20° = 1.
        let (near, far) = (fx!(1.9), fx!(3.95));
        let projection = if size.0 < size.1 {
            let width = fx!(1.38309); // 2 · 1.9 tan 20°
            let height = width.to_bits() * size.1 as i32 / size.0 as i32;
            Projection::frustum(
                Window::centered(width, Scalar::from_bits(height)),
                near,
                far,
            )?
        } else {
            Projection::perspective(deg!(40), size, near, far)?
        };
        let camera = Camera::look_at(vec3!(0, 1, 2.748), Vec3::ZERO, Vec3::Y)?;
        Ok(Self {
            size,
            model: Model::read(words).map_err(message),
            view: projection * camera,
            sun: Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?,
        })
    }

    /// Columns and rows of the picture.
    #[must_use]
    pub const fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Draws the part of the frame that belongs to the canvas, at the time `now_ms`.
    ///
    /// # Errors
    ///
    /// There are fewer depths than pixels.
    pub fn draw<O: Storage<Rgb565>>(
        &self,
        now_ms: u64,
        mut canvas: Canvas<'_, Rgb565, O>,
        depths: &mut [u16],
    ) -> Result<(), Error> {
        let model = match &self.model {
            Ok(model) => model,
            Err(message) => {
                canvas.clear(Rgb565::BLACK);
                let style = MonoTextStyle::new(&FONT_6X13, Rgb565::WHITE);
                canvas.overlay(&Text::new(message, Point::new(8, 100), style));
                return Ok(());
            }
        };
        let pixels = canvas.as_cells().len();
        let mut canvas = canvas.with_depth(depths.get_mut(..pixels).unwrap_or_default())?;
        canvas.clear(SKY);
        let mvp = self.view * Transform::rotate_y(Rate::rpm(6).angle_at(now_ms));
        let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
        let mesh = model.mesh();
        for part in model.parts() {
            let mesh = mesh.part(part.faces);
            macro_rules! draw {
                ($surface:expr) => {
                    canvas.draw_with(&options, &mesh, &mvp, &$surface.lit(self.sun))
                };
            }
            let color = Flat::<Rgb565>::rgb(part.color);
            match (part.texture.map(Textured::new), model.colors()) {
                (Some(skin), Some(colors)) => draw!(colors.over(skin)),
                (Some(skin), None) => draw!(skin),
                (None, Some(colors)) => draw!(colors.over(color)),
                (None, None) => draw!(color),
            };
        }
        Ok(())
    }
}

fn message(problem: Problem) -> String<128> {
    let mut message = String::new();
    // What does not fit is left out: nothing does.
    let _ = write!(message, "{problem}");
    message
}
