//! The scene and its motion. The scene is drawn band by band.

use std::cell::Cell;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use embedded_graphics::pixelcolor::Rgb888;
use fixel::prelude::*;
use fixel::{Cull, Drawn};
use fixel_assets::Files;

use super::Result;
use super::common::{lighthouse, scenes};
use super::draw::{AnyMvp, Posed, Style};
use super::mode::{Mode, with_depth};
use super::view::{AnyProjection, View, direction};
use super::window::Orbit;
use crate::args::{Args, DepthBuffer, SceneName, Shade};
use crate::dump::{Record, Recorder, Recording};
use crate::part::{Part, Piece};

/// The number of an animation's frame, and how the user has turned the model in a window.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moment {
    pub frame: u32,
    pub orbit: Orbit,
}

impl Moment {
    pub fn of(frame: u32) -> Self {
        Self {
            frame,
            ..Self::default()
        }
    }
}

/// The motion of a scene: the pose and the view of each frame.
#[derive(Clone, Copy, Debug)]
pub enum Motion {
    Measured(SceneName),
    /// The model turns once about an axis through the origin. `units` moves the middle of the model to the origin.
    Turning {
        view: View,
        /// The direction that is up, of any length.
        axis: [f64; 3],
        frames: u32,
    },
}

impl Motion {
    pub fn mvp(&self, moment: Moment) -> Result<AnyMvp> {
        match *self {
            Self::Measured(scene) => {
                let k = moment.frame.cast_signed() % scenes::POSES;
                Ok(AnyMvp::Perspective(match scene {
                    SceneName::Floor => scenes::floor_mvp(k)?,
                    SceneName::Cube => scenes::cube_mvp(k)?,
                    SceneName::Sphere | SceneName::SphereFlat => scenes::sphere_mvp(k)?,
                }))
            }
            Self::Turning { view, axis, frames } => {
                let part = (u64::from(moment.frame) << 32) / u64::from(frames);
                #[allow(clippy::cast_possible_truncation)] // whole turns drop out
                let angle = Angle::from_bits(part as u32);
                let pose = if axis[0] == 0.0 && axis[2] == 0.0 && axis[1] > 0.0 {
                    // With this function, the pose equals the pose on a board, bit for bit.
                    Transform::rotate_y(angle)
                } else {
                    Transform::rotate(direction(axis)?, angle)?
                };
                Ok(view.mvp(moment.orbit.turned(pose, &view)))
            }
        }
    }
}

/// A model, the project's own scene, or a measured scene.
pub struct Scene<'a> {
    pub pieces: Vec<Piece<'a>>,
    pub motion: Motion,
    pub mode: Mode,
    pub depth: DepthBuffer,
    /// `None` for the measured scenes and for the project's own scene.
    pub shade: Option<Shade>,
    /// Whether this is the project's own scene, with its sea and sky.
    pub is_own: bool,
    /// The mode in which the recorder draws.
    pub recorded: Mode,
    pub recorder: Recorder,
}

/// The file of the island in the project's own scene.
struct Island;

impl Files for Island {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Ok(include_bytes!("../../assets/lighthouse.obj").into())
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        Some(path.into())
    }
}

/// Reads the island of the project's own scene. (Firmware includes it by a macro. With this macro, Cargo would build the
/// importer twice: for the simulator and for the compiler.)
///
/// # Errors
///
/// None: the file is part of the program.
pub fn island() -> Result<Part> {
    Part::whole(&fixel_assets::read(Path::new("lighthouse.obj"), &Island)?)
}

impl<'a> Scene<'a> {
    /// The project's own scene, as a microcontroller draws it.
    ///
    /// # Errors
    ///
    /// None: the scene's numbers are constant.
    pub fn own(args: &Args, island: &'a Part) -> Result<Self> {
        let view = View {
            projection: AnyProjection::Perspective(lighthouse::projection(args.size)?),
            camera: lighthouse::camera()?,
            sun: lighthouse::SUN,
            up: Vec3::Y,
            depths: [0; 2],
        };
        let pieces = vec![
            Piece::own(lighthouse::SEA, None),
            Piece::own(island.mesh()?, Some(island.outline()?)),
        ];
        let motion = Motion::Turning {
            view,
            axis: [0.0, 1.0, 0.0],
            frames: args.frames,
        };
        // The larger texture has 128 texels.
        Self::constant(args, pieces, motion, (20.0, 128.0))
    }

    /// A measured scene.
    ///
    /// # Errors
    ///
    /// None: the scene's numbers are constant.
    pub fn measured(args: &Args, name: SceneName) -> Result<Self> {
        let mesh = match name {
            SceneName::Floor => scenes::FLOOR,
            SceneName::Cube => scenes::CUBE,
            SceneName::Sphere | SceneName::SphereFlat => scenes::SPHERE,
        };
        // The checker has 64 texels.
        let pieces = vec![Piece::own(mesh, None)];
        Self::constant(args, pieces, Motion::Measured(name), (1.0, 64.0))
    }

    /// A scene of constant numbers: the largest texture coordinate, and the texels of a texture.
    fn constant(
        args: &Args,
        pieces: Vec<Piece<'a>>,
        motion: Motion,
        (largest, texels): (f64, f64),
    ) -> Result<Self> {
        let recorder = Recorder::new(largest, 0, args.mode);
        Ok(Self {
            pieces,
            motion,
            mode: Mode::new(args.mode, 1.0)?,
            depth: args.depth,
            shade: None,
            is_own: matches!(motion, Motion::Turning { .. }),
            recorded: Mode::new(args.mode, recorder.repeat() / texels)?,
            recorder,
        })
    }

    /// The number of faces.
    pub fn faces(&self) -> usize {
        self.pieces
            .iter()
            .map(|piece| piece.mesh.faces().len())
            .sum()
    }

    /// Draws a frame in bands of `rows` rows, as a microcontroller with little memory does. Returns the pixels, and the
    /// time that the draw calls took.
    pub fn draw(
        &self,
        (width, height): (u32, u32),
        rows: u32,
        moment: Moment,
        style: &Style<'_>,
    ) -> Result<(Vec<Rgb888>, Drawn, Duration)> {
        let posed = Posed {
            pieces: &self.pieces,
            mvp: self.motion.mvp(moment)?,
            style,
        };
        let band = (width * rows.min(height)) as usize;
        let mut pixels = vec![Rgb888::default(); (width * height) as usize];
        let mut depth = vec![0; band];
        let (mut counts, mut time) = (Drawn::default(), Duration::ZERO);
        for (pixels, first_row) in pixels
            .chunks_mut(band)
            .zip((0..).step_by(band / width as usize))
        {
            let depth = &mut depth[..pixels.len()];
            let canvas = Canvas::band(pixels, width, height, first_row)?;
            with_depth!(self.depth, canvas, depth, |canvas| {
                style.clear(canvas);
                let start = Instant::now();
                counts += posed.draw(canvas)?;
                time += start.elapsed();
                style.finish(canvas);
            });
        }
        Ok((pixels, counts, time))
    }

    /// Records the faces or the edges of a frame, in bands of `rows` rows. `cull` overrides the materials.
    pub fn record(
        &self,
        size: (u32, u32),
        rows: u32,
        moment: Moment,
        edges: bool,
        cull: Option<Cull>,
    ) -> Result<(Vec<Record>, Drawn)> {
        let records = vec![Cell::default(); (size.0 * size.1) as usize];
        let recording = Recording {
            recorder: self.recorder,
            records: &records,
            width: size.0,
        };
        let style = Style::recording(self, recording, edges, cull)?;
        let (_, counts, _) = self.draw(size, rows, moment, &style)?;
        drop(style);
        Ok((records.into_iter().map(Cell::into_inner).collect(), counts))
    }
}
