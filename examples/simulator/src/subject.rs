//! The model to draw, and its placement.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use fixel::Cull;
use fixel_assets::vector::unit;
use fixel_assets::{Alpha, Disk, Files, INVISIBLE, Model, Picture};

use super::Result;
use crate::advice;
use crate::args::{Args, Color, Shade};
use crate::dump::Recorder;
use crate::framing::{Framing, Point, Solid, turntable};
use crate::mode::Mode;
use crate::part::{self, Finish, Part, rgb};
use crate::progress::{self, Progress, Reading};
use crate::report;
use crate::scene::{Motion, Scene};
use crate::skin::Skin;
use crate::units::Units;
use crate::view::View;
use crate::window::MOST_ZOOM;

/// If two faces meet at a larger angle, in degrees, an outline has a line between them.
const CREASE: f64 = 40.0;

/// What the alpha of the texture that the user names means: as in an MTL file.
const CUT: Alpha = Alpha::Cut(128);

/// A model with everything that belongs to it.
pub struct Subject {
    parts: Vec<Part>,
    pub framing: Framing,
    /// The cameras without the planes that the user gave.
    others: Vec<(&'static str, Framing)>,
    pub units: Units,
    /// The finish of each material. The last finish is for faces without a material.
    finishes: Vec<Finish>,
    /// The textures that the finishes use.
    pub skins: Vec<Skin>,
    largest_uv: f64,
    shade: Shade,
    default_shade: Shade,
    /// The files from which the model was read.
    pub inputs: Vec<PathBuf>,
}

impl Subject {
    /// Reads the model at `path` and the other files that `args` name. Chooses the camera.
    ///
    /// # Errors
    ///
    /// A file cannot be read, or the camera of `args` shows nothing.
    pub fn load(args: &Args, path: &Path) -> Result<Self> {
        let skin = args.texture.as_deref().map(texture).transpose()?;
        let reading = Reading(Progress::new(args, "reading", true));
        let read = fixel_assets::read(path, &reading);
        let mut model = read.map_err(|problem| format!("model {}: {problem}", path.display()))?;
        drop(reading);
        let line = progress::step(args, model.triangles.len(), "computing normals");
        model.complete();
        drop(line);
        let line = progress::step(args, model.triangles.len(), "preparing");
        let (finishes, skins) = finishes(args, &mut model, skin);
        let is_wire = args.wire || args.shade == Some(Shade::Wire);
        if model.has_lines && !is_wire {
            model.notes.left_out("lines: see --wire");
        }
        if args.texture.is_some() && !model.had_uvs {
            model.notes.add(
                "--texture is projected from six sides, because some faces have no texture coordinates: add them to the file",
            );
        }
        report::notes(args, model.notes.iter().chain(model.far.clone()))?;
        let given = [&args.model, &args.texture].into_iter().flatten();
        let inputs = given.chain(&model.files).cloned().collect();
        if !args.cull {
            model.turn_normals();
        }
        let points = used(&model);
        let solid = Solid::of(&points);
        let merging = model.merging(1.0);
        report::notes(
            args,
            merging.map(|note| format!("in include_mesh!, {note}")),
        )?;
        report::notes(args, advice::lying(args, &model))?;
        let mut framing = frame(args, &points, &solid, solid.middle)?;
        let others = ["near", "far"].into_iter().filter_map(|option| {
            let other = frame(&args.without(option)?, &points, &solid, solid.middle).ok()?;
            (!other.has_planes_of(&framing) && !args.window).then_some((option, other))
        });
        let others = others.collect();
        if args.window {
            framing.widen(args, &points, solid.middle, MOST_ZOOM.into());
        }
        let units = Units::new(args, &framing, &solid)?;
        for position in &mut model.positions {
            *position = units.point(*position);
        }
        let textured = args.texture.is_some() || model.had_uvs || model.is_colored();
        let default_shade = if textured { Shade::Lit } else { Shade::Gouraud };
        let shade = args.shade.unwrap_or(default_shade);
        let crease = match args.color {
            _ if args.wire || shade == Shade::Wire => Some(CREASE),
            Color::Mono => Some(180.0),
            _ => None,
        };
        let uvs = model.uvs.iter().flatten();
        let largest_uv = uvs.fold(0.0, |all, x| x.abs().max(all));
        let parts = part::split(model, crease)?;
        drop(line);
        Ok(Self {
            parts,
            framing,
            others,
            units,
            finishes,
            skins,
            largest_uv,
            shade,
            default_shade,
            inputs,
        })
    }

    fn motion(&self, args: &Args, framing: &Framing) -> Result<Motion> {
        Ok(Motion::Turning {
            view: View::new(args, framing, &self.units)?,
            axis: framing.up,
            frames: args.frames,
        })
    }

    /// Returns the motion without the near or the far plane that the user gave; `None` if the planes stay the same.
    pub fn motion_without(&self, plane: &str, args: &Args) -> Option<Motion> {
        let (_, other) = self.others.iter().find(|(option, _)| *option == plane)?;
        self.motion(args, other).ok()
    }

    /// Returns the scene.
    ///
    /// # Errors
    ///
    /// The library refuses the camera.
    pub fn scene(&self, args: &Args) -> Result<Scene<'_>> {
        let mut pieces = Vec::new();
        for part in &self.parts {
            let finish = match part.material {
                Some(material) => self.finishes.get(material as usize),
                None => self.finishes.last(),
            };
            pieces.push(part.piece(*finish.unwrap_or(&Finish::textured(0)))?);
        }
        // The tolerance assumes that a repeat has the same number of texels along u and v, as if the texture were
        // square.
        let recorder = Recorder::new(self.largest_uv, self.units.exponent, args.mode);
        let side = self.skins.iter().map(|skin| skin.side).max().unwrap_or(1);
        Ok(Scene {
            pieces,
            motion: self.motion(args, &self.framing)?,
            mode: Mode::new(args.mode, 1.0)?,
            depth: args.depth,
            shade: Some(self.shade),
            default_shade: self.default_shade,
            is_own: false,
            recorded: Mode::new(args.mode, recorder.repeat() / f64::from(side))?,
            recorder,
        })
    }
}

/// Reads the texture that the user names. Its alpha cuts holes.
fn texture(path: &Path) -> Result<Picture> {
    let bytes = Disk.read(path).map_err(|error| error.to_string());
    let picture = bytes.and_then(|bytes| Picture::decode(&bytes));
    Ok(picture.map_err(|problem| format!("cannot read texture {}: {problem}", path.display()))?)
}

/// Returns the positions that faces use.
fn used(model: &Model) -> Vec<Point> {
    let mut is_used = vec![false; model.positions.len()];
    for corner in model.triangles.iter().flat_map(|triangle| triangle.corners) {
        is_used[corner.position as usize] = true;
    }
    let used = model
        .positions
        .iter()
        .zip(is_used)
        .filter(|(_, is_used)| *is_used);
    used.map(|(point, _)| *point).collect()
}

/// Chooses the camera for `points` or, if they turn around the axis through `about`, for the space in which they turn.
fn frame(args: &Args, points: &[Point], solid: &Solid, about: Point) -> Result<Framing> {
    match unit(args.up()) {
        Some(up) if args.frames > 1 => {
            Framing::new(args, &turntable::swept(points, about, up), solid)
        }
        _ => Framing::new(args, points, solid),
    }
}

/// Returns the finish of each material, followed by the finish of faces without a material, and the textures of the
/// finishes.
///
/// `picture` replaces all textures and colors. If a texture cannot be read, the function adds a note for the user.
fn finishes(args: &Args, model: &mut Model, picture: Option<Picture>) -> (Vec<Finish>, Vec<Skin>) {
    let cull = |two_sided: bool| {
        if args.cull || !two_sided {
            Cull::Back
        } else {
            Cull::Nothing
        }
    };
    if picture.is_some() || !model.is_colored() {
        let skin = picture.map_or_else(Skin::checker, |mut picture| {
            if picture.cut(CUT) {
                model.notes.add(INVISIBLE);
            }
            Skin::new(&picture)
        });
        let alpha = if skin.has_alpha() {
            CUT
        } else {
            Alpha::Ignored
        };
        let sides = model.materials.iter().map(|material| material.two_sided);
        let finish = |two_sided| Finish {
            alpha,
            cull: cull(two_sided),
            ..Finish::textured(0)
        };
        let finishes = sides.chain([true]).map(finish).collect();
        return (finishes, vec![skin]);
    }
    let mut skins: Vec<Skin> = Vec::new();
    let mut places: HashMap<_, Option<usize>> = HashMap::new();
    let mut finishes = Vec::new();
    for material in model.materials.clone() {
        if material.texture.is_some() && material.clamp[0] != material.clamp[1] {
            model
                .notes
                .left_out("textures that continue their border along one side only");
        }
        let texture = material.texture.and_then(|image| {
            let key = (image, material.tint, material.alpha);
            *places.entry(key).or_insert_with(|| {
                skins.push(Skin::new(&model.texture(&material, &Disk)?));
                Some(skins.len() - 1)
            })
        });
        let has_alpha = texture.is_some_and(|at| skins[at].has_alpha());
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
        let opacity = (material.opacity * 255.0).round() as u8;
        finishes.push(Finish {
            glow: rgb(material.emission),
            opacity,
            alpha: if has_alpha {
                material.alpha
            } else {
                Alpha::Ignored
            },
            is_clamped: material.clamp == [true; 2],
            is_unlit: material.unlit,
            cull: cull(material.two_sided),
            ..texture.map_or(Finish::plain(rgb(material.color)), Finish::textured)
        });
    }
    finishes.push(Finish {
        cull: cull(true),
        ..Finish::plain(rgb([255; 3]))
    });
    (finishes, skins)
}
