//! The work of a run, a frame at a time.

use std::time::{Duration, Instant};

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888};
use embedded_graphics::primitives::Rectangle;
use fixel::prelude::*;
use fixel::shade::{FaceColors, Gouraud, Textured, Varyings};
use fixel::target::{DepthBuffer, Float, WideFloat};
use fixel::view::Perspective;
use fixel::{Drawn, Mesh};

use super::Result;
use super::common::{lighthouse, scenes};
use super::mode::{Mode, in_mode};
use super::output::FRAME_MS;
use super::paint::{Board, Brush, Posed, Shown, draw_surface_in};
use super::surface::{FaceValues, Surface};
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
    /// The whole picture, as seen from this frame, which may be a part of it.
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

    /// Where the top left corner of the frame is in the whole picture.
    fn origin(&self) -> Point {
        self.viewport.map_or(Point::zero(), |viewport| {
            Point::new(-viewport.x(), -viewport.y())
        })
    }

    /// The same band in another color; `draw` fills it, and it is converted.
    fn drawn_in<B: PixelColor + Default + Into<C>>(
        self,
        draw: impl FnOnce(Band<'_, B>) -> Result<Done>,
    ) -> Result<Done> {
        let mut pixels = vec![B::default(); self.pixels.len()];
        let done = draw(Band {
            pixels: &mut pixels,
            depth: self.depth,
            size: self.size,
            first_row: self.first_row,
            viewport: self.viewport,
        })?;
        for (to, from) in self.pixels.iter_mut().zip(pixels) {
            *to = from.into();
        }
        Ok(done)
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
                // As on the board, bit for bit.
                Transform::rotate_y(angle)
            } else {
                Transform::rotate(direction(self.axis)?, angle)?
            },
        )
    }
}

/// A model, or the project's own scene if there is no `shade`.
pub struct Model<'a> {
    pub pieces: &'a [Piece<'a>],
    pub view: View,
    pub turn: Turn,
    /// None for the project's own scene.
    pub shade: Option<Shade>,
    /// The mode for the recorder.
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
    pub fn paint(&self, band: Band<'_, Rgb888>, moment: Moment, brush: &Brush<'_>) -> Result<Done> {
        let origin = band.origin();
        let posed = self.posed(&self.view, moment, band.viewport)?;
        let (canvas, depth) = band.canvas()?;
        Ok(match self.view.depth {
            DepthFormat::Linear => paint_on(canvas.with_depth(depth)?, origin, posed, brush),
            DepthFormat::Float => {
                let canvas = canvas.with_depth_format::<Float>(depth)?;
                paint_on(canvas, origin, posed, brush)
            }
            DepthFormat::Wide => {
                let canvas = canvas.with_depth_format::<WideFloat>(depth)?;
                paint_on(canvas, origin, posed, brush)
            }
        })
    }

    /// Draws a band of the project's own scene in the color `C`, with its surfaces.
    pub fn paint_own<C: Shown>(
        &self,
        band: Band<'_, Rgb888>,
        moment: Moment,
        surfaces: &[Surface<'_>; 2],
    ) -> Result<Done> {
        let posed = self.posed(&self.view, moment, None)?;
        let (pixels, depth, size, first_row) = (band.pixels, band.depth, band.size, band.first_row);
        let mut sky = vec![C::default(); pixels.len()];
        lighthouse::sky(&mut Canvas::band(&mut sky, size.0, size.1, first_row)?);
        let sky = sky.into_iter().map(Into::into).collect::<Vec<Rgb888>>();
        let is_mono = lighthouse::is_mono::<C>();
        let canvas = Canvas::band(pixels, size.0, size.1, first_row)?;
        Ok(match self.view.depth {
            DepthFormat::Linear => {
                let canvas = canvas.with_depth(depth)?;
                posed.paint_own(canvas, &sky, is_mono, surfaces)
            }
            DepthFormat::Float => {
                let canvas = canvas.with_depth_format::<Float>(depth)?;
                posed.paint_own(canvas, &sky, is_mono, surfaces)
            }
            DepthFormat::Wide => {
                let canvas = canvas.with_depth_format::<WideFloat>(depth)?;
                posed.paint_own(canvas, &sky, is_mono, surfaces)
            }
        })
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
        Ok(match self.view.depth {
            DepthFormat::Linear => self.record_on(posed, canvas.with_depth(depth)?, edges),
            DepthFormat::Float => {
                self.record_on(posed, canvas.with_depth_format::<Float>(depth)?, edges)
            }
            DepthFormat::Wide => {
                self.record_on(posed, canvas.with_depth_format::<WideFloat>(depth)?, edges)
            }
        })
    }

    fn record_on<D: DepthBuffer>(
        &self,
        posed: Posed<'_>,
        mut canvas: Board<'_, Record, D>,
        edges: bool,
    ) -> Done {
        canvas.clear(Record::default());
        timed(|| {
            if edges {
                posed.draw_edges(&mut canvas, &self.recorder)
            } else {
                posed.draw(&mut canvas, &self.recorder, false)
            }
        })
    }
}

impl Posed<'_> {
    /// Draws the project's own scene, as `lighthouse::draw` does.
    fn paint_own<D: DepthBuffer>(
        &self,
        mut canvas: Board<'_, Rgb888, D>,
        sky: &[Rgb888],
        is_mono: bool,
        surfaces: &[Surface<'_>; 2],
    ) -> Done {
        canvas.clear(Rgb888::default());
        let rows = canvas.rows().clone();
        let corner = Point::new(0, rows.start.cast_signed());
        let size = Size::new(canvas.frame_size().width, rows.end - rows.start);
        let Ok(()) = canvas.fill_contiguous(&Rectangle::new(corner, size), sky.iter().copied());
        let done = timed(|| {
            let sum = self.draw_surfaces(&mut canvas, surfaces, false);
            if is_mono {
                self.draw_outline(&mut canvas, &lighthouse::ISLAND, &lighthouse::SILHOUETTES);
            }
            sum
        });
        lighthouse::caption_on(&mut canvas, is_mono);
        done
    }
}

fn paint_on<D: DepthBuffer>(
    mut canvas: Board<'_, Rgb888, D>,
    origin: Point,
    posed: Posed<'_>,
    brush: &Brush<'_>,
) -> Done {
    brush.clear(&mut canvas, origin);
    timed(|| posed.paint(&mut canvas, brush))
}

/// The mvp of a measured scene in pose `k`.
fn mvp(scene: SceneName, k: u32) -> Result<Mvp<Perspective>> {
    let k = k.cast_signed() % scenes::POSES;
    Ok(match scene {
        SceneName::Floor => scenes::floor_chain(k)?,
        SceneName::Cube => scenes::cube_chain(k)?,
        SceneName::Sphere | SceneName::SphereFlat => scenes::sphere_chain(k)?,
    })
}

/// A measured scene, and its options.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    pub scene: SceneName,
    pub mode: Mode,
    pub depth: DepthFormat,
}

/// Gives `draw` the band as a canvas, with depth unless the scene has none.
macro_rules! on_canvas {
    ($band:expr, $measured:expr, $background:expr, |$canvas:ident| $draw:expr) => {{
        let (mut canvas, depth) = $band.canvas()?;
        match ($measured.scene, $measured.depth) {
            (SceneName::SphereFlat, _) => {
                canvas.clear($background);
                let $canvas = &mut canvas;
                timed(|| $draw)
            }
            (_, DepthFormat::Linear) => {
                let mut canvas = canvas.with_depth(depth)?;
                canvas.clear($background);
                let $canvas = &mut canvas;
                timed(|| $draw)
            }
            (_, DepthFormat::Float) => {
                let mut canvas = canvas.with_depth_format::<Float>(depth)?;
                canvas.clear($background);
                let $canvas = &mut canvas;
                timed(|| $draw)
            }
            (_, DepthFormat::Wide) => {
                let mut canvas = canvas.with_depth_format::<WideFloat>(depth)?;
                canvas.clear($background);
                let $canvas = &mut canvas;
                timed(|| $draw)
            }
        }
    }};
}

impl Measured {
    /// Draws a band of the scene as it is measured.
    pub fn paint(self, band: Band<'_, Rgb888>, moment: Moment) -> Result<Done> {
        let mvp = mvp(self.scene, moment.frame)?;
        band.drawn_in(|band: Band<'_, Rgb565>| {
            Ok(on_canvas!(
                band,
                self,
                Rgb565::default(),
                |canvas| in_mode!(self.mode, DrawOptions::new(), |options| match self.scene {
                    SceneName::Floor => scenes::floor(canvas, options, &mvp),
                    SceneName::Cube => scenes::cube(canvas, options, &mvp),
                    SceneName::Sphere => scenes::sphere(canvas, options, &mvp),
                    SceneName::SphereFlat => scenes::sphere_flat(canvas, options, &mvp),
                })
            ))
        })
    }

    /// Returns the shader of the scene in another color than it is measured in.
    ///
    /// # Errors
    ///
    /// None.
    pub fn surface<C: Shown>(self) -> Result<Surface<'static>>
    where
        Gouraud<C>: Shader<Color = C, Varyings: Varyings<Face: FaceValues>>,
    {
        match self.scene {
            SceneName::Floor | SceneName::Cube => {
                Surface::new(Textured::new(&scenes::CHECKER).converted::<C>())
            }
            SceneName::Sphere => Surface::new(Gouraud::<C>::new()),
            SceneName::SphereFlat => {
                Surface::new(FaceColors::new(&scenes::FACE_COLORS).converted::<C>())
            }
        }
    }

    /// Draws a band of the scene with another shader.
    pub fn paint_with(
        self,
        band: Band<'_, Rgb888>,
        moment: Moment,
        surface: &Surface<'_>,
    ) -> Result<Done> {
        let mvp = mvp(self.scene, moment.frame)?;
        let mesh = self.mesh();
        Ok(on_canvas!(band, self, Rgb888::default(), |canvas| {
            draw_surface_in(canvas, self.mode, mesh, &mvp, surface)
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
        Ok(on_canvas!(band, self, Record::default(), |canvas| {
            canvas.draw(mesh, &mvp, &recorder)
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
