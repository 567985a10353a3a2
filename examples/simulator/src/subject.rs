//! The model to draw, which is read from a file or is the project's own, and its placement.

use std::collections::HashMap;
use std::path::PathBuf;

use fixel_assets::vector::unit;

use super::Result;
use super::common::lighthouse;
use crate::args::{Args, Filter, Kind, Shade};
use crate::dump::Recorder;
use crate::export::{self, Files};
use crate::framing::{Framing, Point, Solid, turntable};
use crate::job::{self, Model, Turn};
use crate::mode::Mode;
use crate::parts::{self, Part};
use crate::piece::{Finish, Piece};
use crate::progress::Reading;
use crate::report;
use crate::skin::Skin;
use crate::units::Units;
use crate::view::{AnyProjection, View};
use crate::window::MOST_ZOOM;

/// A model, with everything that belongs to it.
pub struct Subject {
    /// Empty for the project's own scene.
    parts: Vec<Part>,
    pub framing: Framing,
    pub units: Units,
    /// How the model's materials are drawn; the last entry is for faces without one.
    finishes: Vec<Finish>,
    /// The textures that the finishes name.
    pub skins: Vec<Skin>,
    largest_uv: f64,
    /// `None` for the project's own scene as a microcontroller draws it.
    shade: Option<Shade>,
    /// Whether it is the project's own scene, with sea and sky.
    is_scene: bool,
    /// The files from which the model was read.
    pub inputs: Vec<PathBuf>,
    /// The files to which the model is exported.
    pub exports: Files,
}

impl Subject {
    /// Reads the files that `args` name, and chooses the camera.
    ///
    /// # Errors
    ///
    /// A file cannot be read, or the camera that `args` ask for shows nothing.
    pub fn load(args: &Args) -> Result<Self> {
        let skin = args.texture.as_deref().map(Skin::read).transpose()?;
        let Some(path) = &args.model else {
            return Self::own(args, skin);
        };
        let mut model = fixel_assets::read(path, &Reading::new(args.quiet))?;
        model.complete();
        let (finishes, skins) = finishes(&mut model, skin);
        report::notes(args, model.notes.iter())?;
        let inputs = inputs(args, &model);
        let exports = export::files(args, &inputs, &model, (&finishes, &skins))?;
        if args.two_sided {
            model.turn_normals();
        }
        let solid = Solid::of(&model.positions)?;
        let mut framing = frame(args, &model.positions, &solid, solid.middle)?;
        if args.window {
            framing.widen(args, &model.positions, solid.middle, MOST_ZOOM.into());
        }
        let units = Units::new(args, &framing, &solid)?;
        for position in &mut model.positions {
            *position = units.point(*position);
        }
        let textured = args.texture.is_some() || model.had_uvs || model.is_colored();
        let shade = if textured { Shade::Lit } else { Shade::Gouraud };
        Ok(Self {
            parts: parts::split(&model)?,
            framing,
            units,
            largest_uv: model
                .uvs
                .iter()
                .flatten()
                .fold(0.0, |all, x| x.abs().max(all)),
            inputs,
            exports,
            finishes,
            skins,
            shade: Some(args.shade.unwrap_or(shade)),
            is_scene: false,
        })
    }

    /// The project's own scene: sea and island, as on a microcontroller or in another look. In a shade without
    /// textures, it is only the island.
    fn own(args: &Args, skin: Option<Skin>) -> Result<Self> {
        let is_plain = args.shade.is_none()
            && skin.is_none()
            && !args.two_sided
            && !args.has_look()
            && args.filter == Filter::Nearest;
        let is_scene = matches!(args.shade, None | Some(Shade::Texture | Shade::Lit));
        let points: Vec<Point> = lighthouse::ISLAND
            .positions()
            .iter()
            .map(|p| p.to_bits().map(|bits| f64::from(bits) / 65536.0))
            .collect();
        let solid = Solid::of(&points)?;
        let frame = |args: &Args| frame(args, &points, &solid, [0.0; 3]);
        let mut framing = if is_scene && has_own_camera(args) {
            frame(&with_own_camera(args))?
        } else if is_scene {
            let framing = frame(args)?;
            // The sea begins in front of the island and continues behind it.
            let near = match args.projection {
                Kind::Perspective => 0.25,
                _ => framing.near - 120.0,
            };
            frame(&Args {
                near: args.near.or(Some(near)),
                far: args.far.or(Some(framing.far + 120.0)),
                ..args.clone()
            })?
        } else {
            frame(args)?
        };
        if args.window {
            framing.widen(args, &points, [0.0; 3], MOST_ZOOM.into());
        }
        let mut skins = vec![skin.unwrap_or_else(|| Skin::of(&lighthouse::SKIN))];
        if is_scene {
            skins.push(Skin::of(&lighthouse::WAVES));
        }
        Ok(Self {
            parts: Vec::new(),
            units: Units::own(args, &framing, &solid)?,
            framing,
            finishes: Vec::new(),
            skins,
            inputs: args.texture.iter().cloned().collect(),
            exports: Vec::new(),
            largest_uv: 20.0,
            shade: args.shade.or((!is_plain).then_some(Shade::Lit)),
            is_scene,
        })
    }

    /// Returns the pieces.
    ///
    /// # Errors
    ///
    /// None for a model that was read without an error.
    pub fn pieces(&self) -> Result<Vec<Piece<'_>>> {
        if self.parts.is_empty() {
            let piece = |mesh, texture| Piece {
                mesh,
                finish: Finish::textured(texture),
            };
            let sea = self.is_scene.then(|| piece(lighthouse::SEA, 1));
            let island = piece(lighthouse::ISLAND, 0);
            return Ok(sea.into_iter().chain([island]).collect());
        }
        let finish = |part: &Part| {
            let finish = match part.material {
                Some(material) => self.finishes.get(material as usize),
                None => self.finishes.last(),
            };
            finish.copied().unwrap_or(Finish::textured(0))
        };
        let mut pieces = Vec::new();
        for part in &self.parts {
            pieces.push(Piece {
                mesh: part.mesh()?,
                finish: finish(part),
            });
        }
        Ok(pieces)
    }

    /// Returns the job of drawing it, with `pieces` of its own.
    ///
    /// # Errors
    ///
    /// The library refuses the camera.
    pub fn model<'a>(&self, args: &Args, pieces: &'a [Piece<'a>]) -> Result<Model<'a>> {
        // If there are several textures, the tolerance holds for each of them.
        let resampled = self.least(Skin::resampled);
        let mut view = View::new(args, &self.framing, &self.units, resampled)?;
        if self.parts.is_empty() {
            view.sun = lighthouse::SUN;
        }
        if self.is_scene && has_own_camera(args) {
            view.projection = AnyProjection::Perspective(lighthouse::projection(args.size)?);
            view.camera = lighthouse::camera()?;
        }
        // A repeat counts as equally many texels along u and v, as if the given texture were square.
        let recorder = Recorder::new(self.largest_uv, self.units.exponent, args.mode);
        let recorded = Mode::new(
            args,
            recorder.repeat() * self.least(|skin| 1.0 / skin.side()),
        )?;
        Ok(Model {
            pieces,
            view,
            turn: Turn {
                axis: self.framing.up,
                frames: args.frames,
                rate: job::rate(args)?,
            },
            shade: self.shade,
            is_scene: self.is_scene,
            recorded,
            recorder,
        })
    }

    fn least(&self, number: impl Fn(&Skin) -> f64) -> f64 {
        self.skins.iter().map(number).fold(f64::INFINITY, f64::min)
    }
}

/// Frames `points` or, if they turn, the space through which they turn, around the axis through `about`.
fn frame(args: &Args, points: &[Point], solid: &Solid, about: Point) -> Result<Framing> {
    match unit(args.up()) {
        Some(up) if args.frames > 1 || args.window && args.rpm.is_some() => {
            Framing::new(args, &turntable::swept(points, about, up), solid)
        }
        _ => Framing::new(args, points, solid),
    }
}

/// Returns all files that belong to a model.
fn inputs(args: &Args, model: &fixel_assets::Model) -> Vec<PathBuf> {
    let given = [&args.model, &args.texture].into_iter().flatten();
    given.chain(&model.files).cloned().collect()
}

/// Returns the finish of each material, then the finish of faces without one; and the textures that they need.
///
/// `skin` replaces all materials. A texture that cannot be read is noted.
fn finishes(model: &mut fixel_assets::Model, skin: Option<Skin>) -> (Vec<Finish>, Vec<Skin>) {
    let count = model.materials.len();
    if let Some(skin) = skin {
        return (vec![Finish::textured(0); count + 1], vec![skin]);
    }
    if !model.is_colored() {
        return (vec![Finish::textured(0)], vec![Skin::checker()]);
    }
    let (mut finishes, mut skins) = (Vec::new(), Vec::new());
    let mut places: HashMap<(u32, [u8; 3]), Option<usize>> = HashMap::new();
    for material in &model.materials {
        let texture = material.texture.and_then(|image| {
            *places.entry((image, material.tint)).or_insert_with(|| {
                match Skin::of_model(&model.images[image as usize], material.tint) {
                    Ok(skin) => {
                        skins.push(skin);
                        Some(skins.len() - 1)
                    }
                    Err(problem) => {
                        model
                            .notes
                            .add(format!("{problem}: its faces have one color"));
                        None
                    }
                }
            })
        });
        finishes.push(texture.map_or(Finish::plain(material.color), Finish::textured));
    }
    finishes.push(Finish::plain([255; 3]));
    (finishes, skins)
}

/// Returns `args` with the camera of the project's own scene, which `lighthouse` defines in the library's formats.
fn with_own_camera(args: &Args) -> Args {
    Args {
        eye: Some([3.4, 3.1, 8.4]),
        look_at: Some([0.45, 1.62, 0.0]),
        up: Some([0.0, 1.0, 0.0]),
        fov: Some(40.0),
        near: Some(1.0),
        far: Some(140.0),
        ..args.clone()
    }
}

/// Returns whether `args` keep the camera of the project's own scene: every option given has its default value.
fn has_own_camera(args: &Args) -> bool {
    fn keeps<T: PartialEq + Copy>(given: Option<T>, own: Option<T>) -> bool {
        given.is_none() || given == own
    }
    let own = with_own_camera(args);
    args.projection == Kind::Perspective
        && keeps(args.eye, own.eye)
        && keeps(args.look_at, own.look_at)
        && keeps(args.up, own.up)
        && keeps(args.fov, own.fov)
        && keeps(args.near, own.near)
        && keeps(args.far, own.far)
}
