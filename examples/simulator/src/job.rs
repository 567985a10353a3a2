//! Draws and records the frames of a run, one band at a time.

use std::time::{Duration, Instant};

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use fixel::prelude::*;
use fixel::shade::{FaceColors, Textured};
use fixel::target::DepthBuffer;
use fixel::view::Perspective;
use fixel::{Drawn, Mesh};

use super::Result;
use super::common::scenes;
use super::depth::with_depth;
use super::draw::{Board, Posed, Shown, Style, draw_surface_in, screen};
use super::encoder::FRAME_MS;
use super::mode::Mode;
use super::surface::Surface;
use super::view::{View, direction};
use super::window::Orbit;
use crate::args::{self, Args, DepthFormat, SceneName, Shade};
use crate::dump::{Record, Recorder};
use crate::piece::Piece;

/// A moment of an animation, and how the user turned the model in a window.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moment {
    pub frame: u32,
    pub orbit: Orbit,
}

/// A band of a frame, to be drawn.
#[derive(Debug)]
pub struct Band<'a, C> {
    pub pixels: &'a mut [C],
    pub depth: &'a mut [u16],
    /// Width and height of the frame.
    pub size: (u32, u32),
    pub first_row: u32,
    /// The viewport of the whole picture, if this frame is only a part of it.
    pub viewport: Option<Viewport>,
}

/// The result of drawing a band, and the time of the draw calls.
pub type Done = (Drawn, Duration);

fn timed(draw: impl FnOnce() -> Drawn) -> Done {
    let start = Instant::now();
    let drawn = draw();
    (drawn, start.elapsed())
}

impl<'a, C: PixelColor> Band<'a, C> {
    fn canvas(self) -> Result<(Canvas<'a, C>, &'a mut [u16])> {
        let (width, height) = self.size;
        let canvas = Canvas::band(self.pixels, width, height, self.first_row)?;
        Ok((canvas, self.depth))
    }

    /// The position of the frame's top left corner in the whole picture.
    fn origin(&self) -> Point {
        self.viewport.map_or(Point::zero(), |viewport| {
            Point::new(-viewport.x(), -viewport.y())
        })
    }

    /// Width and height of the whole picture.
    fn picture(&self) -> Size {
        let (width, height) = self.size;
        self.viewport.map_or(Size::new(width, height), |viewport| {
            Size::new(viewport.width(), viewport.height())
        })
    }
}

/// How the model turns.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// The direction that is up, of any length. The axis runs through the origin, where `units` put the middle of the
    /// model.
    pub axis: [f64; 3],
    pub frames: u32,
    pub rate: Option<Rate>,
}

impl Turn {
    /// Returns the pose in one of the frames.
    fn pose(&self, frame: u32) -> Result<Transform> {
        let angle = if let Some(rate) = self.rate {
            rate.angle_at(u64::from(frame) * FRAME_MS)
        } else {
            let part = (u64::from(frame) << 32) / u64::from(self.frames);
            #[allow(clippy::cast_possible_truncation)] // whole turns drop out
            Angle::from_bits(part as u32)
        };
        Ok(
            if self.axis[0] == 0.0 && self.axis[2] == 0.0 && self.axis[1] > 0.0 {
                // Equal to the board's pose, bit for bit.
                Transform::rotate_y(angle)
            } else {
                Transform::rotate(direction(self.axis)?, angle)?
            },
        )
    }
}

/// A model, or the project's own scene.
pub struct Model<'a> {
    pub pieces: &'a [Piece<'a>],
    pub view: View,
    pub turn: Turn,
    /// `None` for the project's own scene as a microcontroller draws it.
    pub shade: Option<Shade>,
    /// Whether it is the project's own scene, with sea and sky.
    pub is_scene: bool,
    /// The mode in which the recorder draws.
    pub recorded: Mode,
    pub recorder: Recorder,
}

impl Model<'_> {
    fn posed<'a>(
        &'a self,
        view: &'a View,
        moment: Moment,
        viewport: Option<Viewport>,
    ) -> Result<Posed<'a>> {
        Ok(Posed {
            pieces: self.pieces,
            view,
            pose: moment.orbit.turned(self.turn.pose(moment.frame)?, view),
            viewport,
        })
    }

    /// Draws a band of a frame.
    pub fn draw(&self, band: Band<'_, Rgb888>, moment: Moment, style: &Style<'_>) -> Result<Done> {
        let (origin, size) = (band.origin(), band.picture());
        let posed = self.posed(&self.view, moment, band.viewport)?;
        let (canvas, depth) = band.canvas()?;
        Ok(with_depth!(self.view.depth, canvas, depth, |canvas| {
            style.clear(canvas, origin, size.height);
            let done = timed(|| posed.draw_in_style(canvas, style));
            style.write(canvas, origin, size);
            done
        }))
    }

    /// Records a band of a frame.
    pub fn record(&self, band: Band<'_, Record>, moment: Moment) -> Result<Done> {
        let mut view = self.view;
        view.mode = self.recorded;
        self.record_in(&view, band, moment, self.shade == Some(Shade::Wire))
    }

    /// Records a band of a frame: faces, or edges.
    pub fn record_in(
        &self,
        view: &View,
        band: Band<'_, Record>,
        moment: Moment,
        edges: bool,
    ) -> Result<Done> {
        let posed = self.posed(view, moment, band.viewport)?;
        let (canvas, depth) = band.canvas()?;
        Ok(with_depth!(self.view.depth, canvas, depth, |canvas| {
            self.record_on(posed, canvas, edges)
        }))
    }

    fn record_on<D: DepthBuffer>(
        &self,
        posed: Posed<'_>,
        canvas: &mut Board<'_, Record, D>,
        edges: bool,
    ) -> Done {
        canvas.clear(Record::default());
        timed(|| {
            if edges {
                posed.draw_edges(canvas, &self.recorder)
            } else {
                posed.draw(canvas, &self.recorder, false)
            }
        })
    }
}

/// The model-view-projection of a measured scene in pose `k`.
fn mvp(scene: SceneName, k: u32) -> Result<Mvp<Perspective>> {
    let k = k.cast_signed() % scenes::POSES;
    Ok(match scene {
        SceneName::Floor => scenes::floor_mvp(k)?,
        SceneName::Cube => scenes::cube_mvp(k)?,
        SceneName::Sphere | SceneName::SphereFlat => scenes::sphere_mvp(k)?,
    })
}

/// A measured scene, and its options.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    pub scene: SceneName,
    pub mode: Mode,
    pub depth: DepthFormat,
}

impl Measured {
    /// Returns the shader of the scene in color `C`. The measurements may use another color.
    ///
    /// # Errors
    ///
    /// None.
    pub fn surface<C: Shown>(self) -> Result<Surface<'static>> {
        match self.scene {
            SceneName::Floor | SceneName::Cube => Surface::new(
                Surface::Few,
                Textured::new(&scenes::CHECKER).converted::<C>(),
                screen,
            ),
            SceneName::Sphere => C::vertex_colors(),
            SceneName::SphereFlat => Surface::new(
                Surface::Few,
                FaceColors::new(&scenes::FACE_COLORS).converted::<C>(),
                screen,
            ),
        }
    }

    /// Draws a band of the scene with its shader.
    pub fn draw(
        self,
        band: Band<'_, Rgb888>,
        moment: Moment,
        surface: &Surface<'_>,
    ) -> Result<Done> {
        let mvp = mvp(self.scene, moment.frame)?;
        let mesh = self.mesh();
        let (mut canvas, depth) = band.canvas()?;
        if self.scene == SceneName::SphereFlat {
            canvas.clear(Rgb888::default());
            // Each face has one color, so the mode does not matter.
            return match surface {
                Surface::Few(shader) => Ok(timed(|| canvas.draw(mesh, &mvp, &shader))),
                _ => Err("colors of faces need no numbers".into()),
            };
        }
        Ok(with_depth!(self.depth, canvas, depth, |canvas| {
            canvas.clear(Rgb888::default());
            timed(|| draw_surface_in(canvas, self.mode, mesh, &mvp, surface))
        }))
    }

    fn mesh(self) -> &'static Mesh<'static> {
        match self.scene {
            SceneName::Floor => &scenes::FLOOR,
            SceneName::Cube => &scenes::CUBE,
            SceneName::Sphere | SceneName::SphereFlat => &scenes::SPHERE,
        }
    }

    /// Records a band of the scene.
    pub fn record(self, band: Band<'_, Record>, moment: Moment) -> Result<Done> {
        let mvp = mvp(self.scene, moment.frame)?;
        let mesh = self.mesh();
        let recorder = Recorder::new(1.0, 0, args::Mode::Newton);
        let (mut canvas, depth) = band.canvas()?;
        if self.scene == SceneName::SphereFlat {
            canvas.clear(Record::default());
            return Ok(timed(|| canvas.draw(mesh, &mvp, &recorder)));
        }
        Ok(with_depth!(self.depth, canvas, depth, |canvas| {
            canvas.clear(Record::default());
            timed(|| canvas.draw(mesh, &mvp, &recorder))
        }))
    }
}

/// Returns the rate at which the model turns.
///
/// # Errors
///
/// The rate is too fast for the format.
pub fn rate(args: &Args) -> Result<Option<Rate>> {
    const MOST: f64 = 2_000_000.0;
    let Some(rpm) = args.rpm else {
        return Ok(None);
    };
    if rpm.abs() > MOST {
        return Err(format!("--rpm {rpm}: it must be between -{MOST} and {MOST}").into());
    }
    #[allow(clippy::cast_possible_truncation)] // rounded, and in range as checked
    Ok(Some(Rate::milli_rpm((rpm * 1000.0).round() as i32)))
}
