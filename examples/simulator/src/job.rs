//! The work of a run, a frame at a time.

use std::time::{Duration, Instant};

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::Drawn;
use fixel::prelude::*;
use fixel::shade::{FaceColors, Gouraud, Levels, Textured};
use fixel::target::{DepthBuffer, Float, WideFloat};
use fixel::view::Perspective;

use super::Result;
use super::common::{lighthouse, scenes};
use super::mode::{Mode, in_mode};
use super::output::FRAME_MS;
use super::paint::{Board, Posed, Shown, add};
use super::view::{Lens, View, direction};
use crate::args::{self, Args, DepthFormat, SceneName, Shade};
use crate::dump::{Record, Recorder};
use crate::piece::Piece;

/// A band of a frame, to be drawn.
#[derive(Debug)]
pub struct Band<'a, C> {
    pub pixels: &'a mut [C],
    pub depth: &'a mut [u16],
    pub size: (u32, u32),
    pub first_row: u32,
}

/// The result of drawing a band, and the time of the draw calls.
pub type Done = (Drawn, Duration);

fn timed(draw: impl FnOnce() -> Drawn) -> Done {
    let start = Instant::now();
    let drawn = draw();
    (drawn, start.elapsed())
}

impl<'a, C: embedded_graphics::pixelcolor::PixelColor> Band<'a, C> {
    fn canvas(self) -> Result<(Canvas<'a, C>, &'a mut [u16])> {
        let (width, height) = self.size;
        let canvas = Canvas::band(self.pixels, width, height, self.first_row)?;
        Ok((canvas, self.depth))
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
    fn posed<'a>(&'a self, view: &'a View, frame: u32) -> Result<Posed<'a>> {
        Ok(Posed {
            pieces: self.pieces,
            view,
            pose: self.turn.pose(frame)?,
        })
    }

    /// Draws a band of a frame.
    pub fn paint<C: Shown>(
        &self,
        band: Band<'_, C>,
        frame: u32,
        textures: &[Texture<'_, C::Texel>],
    ) -> Result<Done> {
        let (canvas, depth) = band.canvas()?;
        match self.view.depth {
            DepthFormat::Linear => self.paint_on(canvas.with_depth(depth)?, frame, textures),
            DepthFormat::Float => {
                let canvas = canvas.with_depth_format::<Float>(depth)?;
                self.paint_on(canvas, frame, textures)
            }
            DepthFormat::Wide => {
                let canvas = canvas.with_depth_format::<WideFloat>(depth)?;
                self.paint_on(canvas, frame, textures)
            }
        }
    }

    fn paint_on<C: Shown, D: DepthBuffer>(
        &self,
        mut canvas: Board<'_, C, D>,
        frame: u32,
        textures: &[Texture<'_, C::Texel>],
    ) -> Result<Done> {
        let posed = self.posed(&self.view, frame)?;
        let Some(shade) = self.shade else {
            lighthouse::sky(&mut canvas);
            let camera = self.view.camera;
            let start = Instant::now();
            let [sea, island] = match self.view.projection {
                Lens::Perspective(projection) => {
                    in_mode!(self.view.mode, DrawOptions::new(), |options| {
                        lighthouse::draw(&mut canvas, options, &(projection * camera * posed.pose))?
                    })
                }
                Lens::Parallel(projection) => lighthouse::draw(
                    &mut canvas,
                    &DrawOptions::new(),
                    &(projection * camera * posed.pose),
                )?,
            };
            let time = start.elapsed();
            lighthouse::caption(&mut canvas);
            return Ok((add(sea, island), time));
        };
        canvas.clear(background(shade));
        Ok(timed(|| posed.paint(&mut canvas, shade, textures)))
    }

    /// Records a band of a frame.
    pub fn record(&self, band: Band<'_, Record>, frame: u32) -> Result<Done> {
        let mut view = self.view;
        view.mode = self.recorded;
        self.record_in(&view, band, frame, self.shade == Some(Shade::Wire))
    }

    /// Records a band of a frame: faces, or edges.
    pub fn record_in(
        &self,
        view: &View,
        band: Band<'_, Record>,
        frame: u32,
        edges: bool,
    ) -> Result<Done> {
        let (canvas, depth) = band.canvas()?;
        let posed = self.posed(view, frame)?;
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
                posed.draw(&mut canvas, &self.recorder)
            }
        })
    }
}

/// The background of a model, unlike any of its shades.
fn background<C: Levels>(shade: Shade) -> C {
    let color = match shade {
        Shade::Wire | Shade::Depth => Rgb888::new(0, 0, 0),
        // The dithered formats would show a pattern instead.
        _ if C::MAX_STEPS[0] < 31 => Rgb888::new(0, 0, 0),
        _ => Rgb888::new(34, 40, 52),
    };
    C::from_rgb(color, Point::zero())
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
    pub fn paint(self, band: Band<'_, Rgb565>, frame: u32) -> Result<Done> {
        let mvp = mvp(self.scene, frame)?;
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
    }

    /// Draws a band of the scene in another color.
    pub fn paint_in<C: Levels>(self, band: Band<'_, C>, frame: u32) -> Result<Done> {
        let mvp = mvp(self.scene, frame)?;
        let black = C::from_rgb(Rgb888::new(0, 0, 0), Point::zero());
        let checker = Textured::new(&scenes::CHECKER).converted();
        let faces = FaceColors::new(&scenes::FACE_COLORS).converted();
        Ok(on_canvas!(band, self, black, |canvas| in_mode!(
            self.mode,
            DrawOptions::new(),
            |options| match self.scene {
                SceneName::Floor => canvas.draw_with(options, &scenes::FLOOR, &mvp, &checker),
                SceneName::Cube => canvas.draw_with(options, &scenes::CUBE, &mvp, &checker),
                SceneName::Sphere => {
                    canvas.draw_with(options, &scenes::SPHERE, &mvp, &Gouraud::new())
                }
                SceneName::SphereFlat => canvas.draw_with(options, &scenes::SPHERE, &mvp, &faces),
            }
        )))
    }

    /// Records a band of the scene.
    pub fn record(self, band: Band<'_, Record>, frame: u32) -> Result<Done> {
        let mvp = mvp(self.scene, frame)?;
        let mesh = match self.scene {
            SceneName::Floor => &scenes::FLOOR,
            SceneName::Cube => &scenes::CUBE,
            SceneName::Sphere | SceneName::SphereFlat => &scenes::SPHERE,
        };
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
