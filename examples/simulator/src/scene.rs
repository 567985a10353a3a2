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
use super::view::{View, direction};
use super::window::Orbit;
use crate::args::{Args, DepthBuffer, SceneName, Shade};
use crate::dump::{Record, Recorder, Recording};
use crate::framing::{Framing, Point, Solid, about};
use crate::part::{CLAY, Finish, Part, Piece};
use crate::skin::Skin;
use crate::units::Units;

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
    /// `None` for the measured scenes and for the project's own scene, unless an option changes the look of the latter.
    pub shade: Option<Shade>,
    /// The shade if the user names none.
    pub default_shade: Shade,
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

/// The textures of the project's own scene: of the island and of the sea.
pub fn own_skins() -> [Skin; 2] {
    [
        Skin::of_rows(&lighthouse::SKIN),
        Skin::of_rows(&lighthouse::WAVES),
    ]
}

/// The mean color of the sea.
const SEA: Rgb888 = Rgb888::new(41, 106, 151);

/// The options with which the project's own scene is drawn as a model is: without the shaders of its own.
const LOOK: [&str; 5] = ["shade", "filter", "light", "ambient", "fog"];

/// The planes of the project's own scene, if the user does not move the camera.
const PLANES: [f64; 2] = [1.0, 140.0];

impl<'a> Scene<'a> {
    /// The project's own scene, with the camera and the look of `args`. By default, it is the picture that a
    /// microcontroller draws.
    ///
    /// # Errors
    ///
    /// The camera of `args` shows nothing.
    pub fn own(args: &Args, island: &'a Part) -> Result<(Self, Framing)> {
        let finish = |texture, color, is_unlit| Finish {
            color,
            is_unlit,
            cull: Cull::Back,
            ..Finish::textured(texture)
        };
        let mut sea = Piece::own(lighthouse::SEA, None);
        let mut island = Piece::own(island.mesh()?, Some(island.outline()?));
        (island.finish, sea.finish) = (finish(0, CLAY, false), finish(1, SEA, true));
        let pieces = vec![sea, island];

        let point = |at: Vec3| at.to_bits().map(|bits| f64::from(bits) / 65536.0);
        let positions = pieces
            .iter()
            .flat_map(|piece| piece.mesh.positions().iter());
        let points: Vec<Point> = positions.map(point).collect();
        let solid = Solid::of(&points);
        let mut camera = args.clone();
        if args.eye.is_none() {
            camera.eye = Some(point(lighthouse::EYE).map(about));
            camera.near = args.near.or(Some(PLANES[0]));
            camera.far = args.far.or(Some(PLANES[1]));
        }
        let target = || point(lighthouse::TARGET).map(about);
        camera.look_at = Some(args.look_at.unwrap_or_else(target));
        camera.fov = Some(args.fov.unwrap_or(40.0));
        let framing = Framing::new(&camera, &points, &solid)?;
        let units = Units::own(&camera, &framing, &solid)?;
        let mut view = View::new(&camera, &framing, &units)?;
        view.sun = lighthouse::SUN;
        // Exactly as a microcontroller looks at it.
        if let (Ok(eye), Ok(target)) = (framing.eye.try_into(), framing.target.try_into()) {
            view.camera = Camera::look_at(eye, target, direction(framing.up)?)?;
        }
        let motion = Motion::Turning {
            view,
            axis: framing.up,
            frames: args.frames,
        };
        // The larger texture has 128 texels.
        let mut scene = Self::constant(args, pieces, motion, (20.0, 128.0))?;
        if LOOK.iter().any(|option| args.has(option)) {
            scene.shade = Some(args.shade.unwrap_or(scene.default_shade));
        }
        Ok((scene, framing))
    }

    /// The same scene with other options of the look, and with another motion.
    ///
    /// # Errors
    ///
    /// None.
    pub fn with(&self, args: &Args, motion: Motion) -> Result<Self> {
        let shade = args.shade.unwrap_or(self.default_shade);
        Ok(Self {
            pieces: self.pieces.clone(),
            motion,
            mode: Mode::new(args.mode, 1.0)?,
            depth: args.depth,
            shade: self.shade.map(|_| shade),
            ..*self
        })
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
            default_shade: Shade::Lit,
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
