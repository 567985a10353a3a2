//! The model to draw, read from a file or the project's own, and its place.

use fixel::prelude::*;

use super::Result;
use super::common::lighthouse;
use crate::args::{Args, Filter, Kind, Shade};
use crate::framing::{Framing, middle};
use crate::job::{self, Model, Turn};
use crate::load;
use crate::parts::{self, Part};
use crate::report;
use crate::skin::Skin;
use crate::view::{Lens, View};
use crate::window::MOST_ZOOM;

/// A model, with everything that belongs to it.
pub struct Subject {
    /// Empty for the project's own scene.
    parts: Vec<Part>,
    points: Vec<[f64; 3]>,
    pub skin: Skin,
    largest_uv: f64,
    shade: Option<Shade>,
    /// Length of one of the model's units as it is drawn.
    pub scale: f64,
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
                && !args.has_look()
                && args.filter == Filter::Nearest;
            return Ok(Self {
                parts: Vec::new(),
                points: positions
                    .iter()
                    .map(|p| p.to_bits().map(|bits| f64::from(bits) / 65536.0))
                    .collect(),
                skin: skin.unwrap_or_else(|| Skin::of(&lighthouse::SKIN)),
                largest_uv: 20.0,
                shade: args.shade.or(if plain { None } else { Some(Shade::Lit) }),
                scale: 1.0,
            });
        };
        let mut model = load::model(path)?;
        let scale = scale(args, &model.positions);
        if let Some(scale) = scale {
            report::say(
                args,
                format_args!("scaled by {scale} to suit the number format"),
            )?;
            for position in &mut model.positions {
                *position = position.map(|x| x * scale);
            }
        }
        let textured = skin.is_some() || model.had_uvs;
        let shade = if textured { Shade::Lit } else { Shade::Gouraud };
        Ok(Self {
            parts: parts::split(&model)?,
            largest_uv: model
                .uvs
                .iter()
                .flatten()
                .fold(0.0, |all, x| x.abs().max(all)),
            points: model.positions,
            skin: skin.unwrap_or_else(Skin::checker),
            shade: Some(args.shade.unwrap_or(shade)),
            scale: scale.unwrap_or(1.0),
        })
    }

    /// Returns the meshes.
    ///
    /// # Errors
    ///
    /// None for a model that was read without one.
    pub fn meshes(&self) -> Result<Vec<Mesh<'_>>> {
        if self.parts.is_empty() {
            return Ok(match self.shade {
                None => vec![lighthouse::SEA, lighthouse::ISLAND],
                Some(_) => vec![lighthouse::ISLAND],
            });
        }
        self.parts.iter().map(Part::mesh).collect()
    }

    /// Returns the job of drawing it, with `meshes` of its own and the camera that `args` ask for.
    ///
    /// # Errors
    ///
    /// The library refuses the camera.
    pub fn model<'a>(&self, args: &Args, meshes: &'a [Mesh<'a>]) -> Result<Model<'a>> {
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
        let turns = args.frames > 1 || rate.is_some() || args.window;
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
        if args.window {
            // The user may turn the model any way, and enlarge it.
            let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
            let distance = |p: &[f64; 3]| length([0, 1, 2].map(|i| p[i] - about[i]));
            let radius = self.points.iter().map(distance).fold(0.0, f64::max);
            let (eye, reach) = (distance(&framing.eye), radius * f64::from(MOST_ZOOM));
            let far = framing.far.max(eye + reach);
            let near = match args.projection {
                // The ratio suits 16-bit depth.
                Kind::Perspective => (eye - reach).max(far / 500.0),
                _ => eye - reach,
            };
            framing.near = args.near.unwrap_or(near.min(framing.near));
            framing.far = args.far.unwrap_or(far);
        }
        let mut view = View::new(args, &framing)?;
        if own && !args.has_camera() {
            view.projection = Lens::Perspective(lighthouse::projection(args.size)?);
            view.camera = lighthouse::camera()?;
        }
        Ok(Model {
            meshes,
            view,
            turn,
            shade: self.shade,
            largest_uv: self.largest_uv,
        })
    }
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
