//! Draws the model in flash, turning in the sun, or a message if there is none or it is damaged.

use core::fmt::Write;
use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::canvas::{LinearDepth, Storage};
use fixel::mesh::Bounds;
use fixel::mode::Fast;
use fixel::prelude::*;
use flash_model::{HOLE, Model, Module, Problem, turn, view};
use heapless::Vec;

use crate::report::Report;

const SKY: Rgb565 = Rgb565::new(3, 8, 8);

/// The most groups of a model.
const GROUPS: usize = 128;
/// The faces of a group, unless the model has more than `GROUPS` groups of them.
const FACES: usize = 64;

/// Everything that stays the same from frame to frame.
pub struct Scene<'a> {
    size: (u32, u32),
    model: Result<Model<'a>, Report>,
    view: Mvp,
    /// The boxes around groups of consecutive faces, and the faces of a group. Groups out of a band are not drawn there.
    boxes: Vec<Bounds, GROUPS>,
    group: usize,
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
        let model = Model::read(words).map_err(|problem| message(&problem, size));
        let (boxes, group) = model.as_ref().map(groups).unwrap_or_default();
        Ok(Self {
            size,
            model,
            view: view(size)?,
            boxes,
            group,
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
    pub fn draw<O: Storage<Rgb565>>(
        &self,
        now_ms: u64,
        canvas: &mut Canvas<'_, Rgb565, O, LinearDepth>,
    ) {
        let model = match &self.model {
            Ok(model) => model,
            Err(message) => {
                message.draw(canvas);
                return;
            }
        };
        canvas.clear(SKY);
        let mvp = self.view * turn(now_ms);
        let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
        let mesh = model.mesh();
        let mut is_shown = [false; GROUPS];
        for (is_shown, bounds) in is_shown.iter_mut().zip(&self.boxes) {
            *is_shown = canvas.is_in_view(&options, bounds, &mvp);
        }
        for part in model.parts() {
            let color = Flat::<Rgb565>::rgb(part.color);
            let skin = part.texture.map(Textured::new);
            let count = if part.is_two_sided { 2 } else { 1 };
            for &(cull, sun) in &self.sides[..count] {
                let options = options.with_cull(cull);
                macro_rules! draw {
                    ($shader:expr) => {
                        for faces in self.shown(&is_shown, &part.faces) {
                            canvas.draw_with(&options, &mesh.part(faces), &mvp, &$shader);
                        }
                    };
                }
                match skin {
                    None if part.is_plain() => draw!(color.lit(sun)),
                    Some(skin) if part.is_plain() => draw!(skin.lit(sun)),
                    None => draw!(part.painted(color, sun)),
                    Some(skin) if part.has_holes => draw!(part.painted(skin.cut_out(HOLE), sun)),
                    Some(skin) => draw!(part.painted(skin, sun)),
                }
            }
        }
    }

    /// The faces of a part in shown groups. Groups that follow each other take one draw call.
    fn shown<'s>(
        &self,
        is_shown: &'s [bool],
        part: &Range<usize>,
    ) -> impl Iterator<Item = Range<usize>> + use<'s> {
        let (group, part, mut end) = (self.group, part.clone(), 0);
        let runs = is_shown.chunk_by(|a, b| a == b).map(move |run| {
            let start = end;
            end += group * run.len();
            (run[0], part.start.max(start)..part.end.min(end))
        });
        runs.filter_map(|(is_shown, faces)| (is_shown && !faces.is_empty()).then_some(faces))
    }
}

/// The boxes around groups of a model's faces, and the faces of a group.
fn groups(model: &Model<'_>) -> (Vec<Bounds, GROUPS>, usize) {
    let mesh = model.mesh();
    let group = FACES.max(mesh.faces().len().div_ceil(GROUPS));
    let boxes = mesh.faces().chunks(group).map(|faces| {
        let corners = faces.as_flattened().iter().map(|&at| usize::from(at));
        let mut points = corners.filter_map(|at| mesh.positions().get(at));
        let first = points.next().unwrap_or_default();
        points.fold(Bounds::new(first, first), Bounds::with)
    });
    (boxes.collect(), group)
}

fn message(problem: &Problem, size: (u32, u32)) -> Report {
    let mut message = Report::new(size);
    // A report returns no errors.
    write!(message, "{problem}").ok();
    message
}
