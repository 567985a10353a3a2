//! Draws the model in flash, turning in the sun, or a message if there is none or it is damaged.

use core::fmt::Write;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::canvas::Storage;
use fixel::mode::Fast;
use fixel::prelude::*;
use flash_model::{HOLE, Model, Module, Problem, turn, view};

use crate::report::Report;

const SKY: Rgb565 = Rgb565::new(3, 8, 8);

/// Everything that stays the same from frame to frame.
pub struct Scene<'a> {
    size: (u32, u32),
    model: Result<Model<'a>, Report>,
    view: Mvp,
    /// For fronts and then for backs: the side to leave out, and the sun. A back has the normal of its front, so its sun
    /// shines from the other side. Two draw calls cost less than `two_sided`, which computes the light of a vertex for
    /// each triangle.
    sides: [(Cull, Light); 2],
}

impl<'a> Scene<'a> {
    /// The scene of the model in these words, for the module that they name.
    ///
    /// # Errors
    ///
    /// None.
    pub fn new(words: &'a [u32]) -> Result<Self, Error> {
        let size = Module::wanted(words).size();
        let sun = |direction| Light::new(direction, fx!(0.35), fx!(0.65));
        Ok(Self {
            size,
            model: Model::read(words).map_err(|problem| message(&problem, size)),
            view: view(size)?,
            sides: [
                (Cull::Back, sun(vec3!(2, 3, 4))?),
                (Cull::Front, sun(vec3!(-2, -3, -4))?),
            ],
        })
    }

    /// Columns and rows of the picture.
    #[must_use]
    pub const fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Whether there is a model. Otherwise, the picture is a message.
    #[must_use]
    pub const fn has_model(&self) -> bool {
        self.model.is_ok()
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
                message.draw(&mut canvas);
                return Ok(());
            }
        };
        let pixels = canvas.as_cells().len();
        let mut canvas = canvas.with_depth(depths.get_mut(..pixels).unwrap_or_default())?;
        canvas.clear(SKY);
        let mvp = self.view * turn(now_ms);
        let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
        let mesh = model.mesh();
        for part in model.parts() {
            let mesh = mesh.part(part.faces.clone());
            let color = Flat::<Rgb565>::rgb(part.color);
            let skin = part.texture.map(Textured::new);
            let count = if part.is_two_sided { 2 } else { 1 };
            for &(cull, sun) in &self.sides[..count] {
                let options = options.with_cull(cull);
                macro_rules! draw {
                    ($shader:expr) => {
                        canvas.draw_with(&options, &mesh, &mvp, &$shader)
                    };
                }
                match skin {
                    None if part.is_plain() => draw!(color.lit(sun)),
                    Some(skin) if part.is_plain() => draw!(skin.lit(sun)),
                    None => draw!(part.painted(color, sun)),
                    Some(skin) if part.has_holes => draw!(part.painted(skin.cut_out(HOLE), sun)),
                    Some(skin) => draw!(part.painted(skin, sun)),
                };
            }
        }
        Ok(())
    }
}

fn message(problem: &Problem, size: (u32, u32)) -> Report {
    let mut message = Report::new(size);
    // A report returns no errors.
    write!(message, "{problem}").ok();
    message
}
