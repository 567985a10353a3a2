//! The model to draw, read from a file or the project's own, and its place.

use std::collections::HashMap;
use std::path::PathBuf;

use fixel::prelude::*;

use super::Result;
use super::common::lighthouse;
use crate::args::{Args, Filter, Kind, Shade};
use crate::export;
use crate::framing::{Framing, middle};
use crate::job::{self, Model, Turn};
use crate::model;

use crate::parts::{self, Part};
use crate::piece::{Finish, Piece};
use crate::skin::Skin;
use crate::view::{Lens, View};

/// A model, with everything that belongs to it.
pub struct Subject {
    /// Empty for the project's own scene.
    parts: Vec<Part>,
    points: Vec<[f64; 3]>,
    /// How the model's materials are drawn, and in the end faces without one.
    finishes: Vec<Finish>,
    /// The textures that the finishes name.
    pub skins: Vec<Skin>,
    largest_uv: f64,
    shade: Option<Shade>,
    /// The files that it was read from.
    pub inputs: Vec<PathBuf>,
}

impl Subject {
    /// Reads the files that `args` name.
    ///
    /// # Errors
    ///
    /// A file cannot be read.
    pub fn load(args: &Args) -> Result<Self> {
        let skin = args.texture.as_deref().map(Skin::read).transpose()?;
        let Some(path) = &args.model else {
            let positions = lighthouse::ISLAND.positions();
            let plain = args.shade.is_none()
                && skin.is_none()
                && !args.two_sided
                && args.filter == Filter::Nearest;
            return Ok(Self {
                parts: Vec::new(),
                points: positions
                    .iter()
                    .map(|p| p.to_bits().map(|bits| f64::from(bits) / 65536.0))
                    .collect(),
                finishes: vec![Finish::textured(0)],
                skins: vec![skin.unwrap_or_else(|| Skin::of(&lighthouse::SKIN))],
                largest_uv: 20.0,
                inputs: args.texture.iter().cloned().collect(),
                shade: args.shade.or(if plain { None } else { Some(Shade::Lit) }),
            });
        };
        let mut model = model::read(path, false)?;
        let (finishes, skins) = finishes(&mut model, skin);
        for note in &model.notes {
            eprintln!("note: {note}");
        }
        let inputs = inputs(args, &model);
        let textures = args
            .export
            .iter()
            .find(|path| path.extension().is_some_and(|x| x == "bmp"));
        for path in &args.export {
            for file in export::files(path, skins.len()) {
                export::refuse_inputs(&file, &inputs)?;
            }
            let looks = (&finishes[..], &skins[..]);
            export::write(
                path,
                &model,
                looks,
                args.mesh,
                textures.map(PathBuf::as_path),
            )?;
        }
        if let Some(scale) = scale(args, &model.positions) {
            println!("scaled by {scale} to suit the number format");
            for position in &mut model.positions {
                *position = position.map(|x| x * scale);
            }
        }
        let textured = args.texture.is_some() || model.had_uvs || model.is_colored();
        let shade = if textured { Shade::Lit } else { Shade::Gouraud };
        Ok(Self {
            parts: parts::split(&model)?,
            largest_uv: model
                .uvs
                .iter()
                .flatten()
                .fold(0.0, |all, x| x.abs().max(all)),
            points: model.positions,
            inputs,
            finishes,
            skins,
            shade: Some(args.shade.unwrap_or(shade)),
        })
    }

    /// Returns the pieces.
    ///
    /// # Errors
    ///
    /// None for a model that was read without one.
    pub fn pieces(&self) -> Result<Vec<Piece<'_>>> {
        if self.parts.is_empty() {
            let finish = Finish::textured(0);
            let piece = |mesh| Piece { mesh, finish };
            return Ok(match self.shade {
                None => vec![piece(lighthouse::SEA), piece(lighthouse::ISLAND)],
                Some(_) => vec![piece(lighthouse::ISLAND)],
            });
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

    /// Returns the job of drawing it, with `pieces` of its own and the camera that `args` ask for.
    ///
    /// # Errors
    ///
    /// The library refuses the camera.
    pub fn model<'a>(&self, args: &Args, pieces: &'a [Piece<'a>]) -> Result<Model<'a>> {
        let rate = job::rate(args)?;
        let about = if self.parts.is_empty() {
            [0.0; 3]
        } else {
            middle(&self.points)
        };
        let turn = Turn {
            about: Vec3::try_from(about)?,
            frames: args.frames,
            rate,
        };
        let turns = args.frames > 1 || rate.is_some();
        let frame = |args: &Args| {
            if turns {
                Framing::new(args, &ring(&self.points, about))
            } else {
                Framing::new(args, &self.points)
            }
        };
        let mut framing = frame(args);
        let own = self.shade.is_none();
        if own && args.has_camera() {
            // The sea begins in front of the island and continues behind it.
            let near = match args.projection {
                Kind::Perspective => 0.25,
                _ => framing.near - 120.0,
            };
            framing = frame(&Args {
                near: args.near.or(Some(near)),
                far: args.far.or(Some(framing.far + 120.0)),
                ..args.clone()
            });
        }
        let mut view = View::new(args, &framing)?;
        if own && !args.has_camera() {
            view.projection = Lens::Perspective(lighthouse::projection(args.size)?);
            view.camera = lighthouse::camera()?;
        }
        Ok(Model {
            pieces,
            view,
            turn,
            shade: self.shade,
            largest_uv: self.largest_uv,
        })
    }
}

/// Returns all files that belong to a model.
fn inputs(args: &Args, model: &model::Model) -> Vec<PathBuf> {
    let given = [&args.model, &args.texture].into_iter().flatten();
    given.chain(&model.files).cloned().collect()
}

/// Returns the finish of each material, and in the end that of faces without one; and the textures that they need.
///
/// `skin` replaces all materials. A texture that cannot be read is noted.
fn finishes(model: &mut model::Model, skin: Option<Skin>) -> (Vec<Finish>, Vec<Skin>) {
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
            *places.entry((image, material.color)).or_insert_with(|| {
                match Skin::of_model(&model.images[image as usize], material.color) {
                    Ok(skin) => {
                        skins.push(skin);
                        Some(skins.len() - 1)
                    }
                    Err(problem) => {
                        model
                            .notes
                            .push(format!("{problem}: its faces have one color"));
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

/// Returns the points that a turning model passes: each on its circle around the axis, a step of the turn apart.
fn ring(points: &[[f64; 3]], about: [f64; 3]) -> Vec<[f64; 3]> {
    const STEPS: u32 = 24;
    let turned = |p: &[f64; 3], step: u32| {
        let (sin, cos) = (f64::from(step) / f64::from(STEPS) * std::f64::consts::TAU).sin_cos();
        let (x, z) = (p[0] - about[0], p[2] - about[2]);
        [
            about[0] + x * cos + z * sin,
            p[1],
            about[2] + z * cos - x * sin,
        ]
    };
    points
        .iter()
        .flat_map(|p| (0..STEPS).map(move |step| turned(p, step)))
        .collect()
}

/// Returns the factor to scale a model by if it is too large to be seen whole from a representable place, or so small
/// that the format's steps show. A model is scaled only if no option was given in its own units.
fn scale(args: &Args, points: &[[f64; 3]]) -> Option<f64> {
    if args.has_camera() {
        return None;
    }
    let middle = middle(points);
    let reach = |from: [f64; 3]| {
        let distance = |p: &[f64; 3]| (0..3).map(|i| (p[i] - from[i]).abs()).fold(0.0, f64::max);
        points.iter().map(distance).fold(0.0, f64::max)
    };
    let (size, far) = (reach(middle), reach([0.0; 3]).max(reach(middle) * 8.0));
    let scale = if far > 32_000.0 {
        (32_000.0 / far).log2().floor()
    } else if size < 0.5 && size > 0.0 {
        (1.0 / size)
            .log2()
            .floor()
            .min((32_000.0 / far).log2().floor())
    } else {
        0.0
    };
    (scale.abs() > 0.5).then(|| scale.exp2())
}
