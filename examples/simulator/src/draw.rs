//! Draws the pieces of a scene, in any mode and projection.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888, RgbColor};
use embedded_graphics::primitives::{PointsIter, Rectangle};
use fixel::canvas::{Biased, DepthBuffer, Replace, TestAndWrite, TestOnly};
use fixel::mode::Newton;
use fixel::prelude::*;
use fixel::shade::{Flat, PixelFormat, Varyings};
use fixel::view::{Parallel, Perspective};
use fixel::{Cull, Drawn};
use fixel_assets::Alpha as Meaning;

use super::Result;
use super::common::{layers, lighthouse};
use super::look::{Backdrop, Look};
use super::mode::{Mode, in_mode};
use super::paint::{self, Shown, Skin};
use super::scene::{Motion, Scene};
use super::surface::{Any, Glass, Surface};
use crate::args::{Args, Shade};
use crate::dump::Recording;
use crate::part::Piece;

/// The simulator's canvas.
pub type Board<'a, D> = Canvas<'a, Rgb888, Native, D>;

/// The lines that are drawn for each piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    None,
    Edges,
    /// Creases and silhouettes, except lines that faces hide.
    Outline,
}

/// The style of a picture: everything that it needs besides the model.
pub struct Style<'a> {
    /// A shader for each piece of the model.
    surfaces: Vec<Surface<'a>>,
    /// Whether faces are drawn.
    has_faces: bool,
    /// For each piece, whether it is translucent.
    is_blended: Vec<bool>,
    lines: Lines,
    /// The shader of lines.
    line: Surface<'a>,
    mode: Mode,
    /// The faces that are culled. If present, it overrides the materials.
    cull: Option<Cull>,
    /// The bias that moves the depths of faces behind the lines on these faces.
    bias: Biased,
    backdrop: Backdrop,
    /// Converts a color to the color that the canvas shows at a pixel.
    color: fn(Rgb888, Point) -> Rgb888,
    /// Whether the caption has a black background; `None` if the picture has no caption.
    caption: Option<bool>,
}

impl<'a> Style<'a> {
    /// Makes the style for a canvas of color `C`, and for the scene's pieces with their `textures`.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins.
    pub fn new<C: Shown>(
        args: &Args,
        look: &'a Look,
        scene: &Scene<'_>,
        textures: &'a [Skin<'a, C::Texel>],
        lines: Lines,
    ) -> Result<Self> {
        let is_mono = lighthouse::is_mono::<C>();
        let surfaces = match (scene.motion, look.shade) {
            (Motion::Measured(name), _) => vec![paint::measured::<C>(name)?],
            (_, None) => paint::own::<C>()?,
            (Motion::Turning { view, .. }, _) => {
                let surface = |piece: &Piece<'_>| {
                    let texture = piece.finish.texture.and_then(|at| textures.get(at));
                    paint::surface::<C>(look, &view, args.filter, piece, texture)
                };
                scene.pieces.iter().map(surface).collect::<Result<_>>()?
            }
        };
        let is_lit = !matches!(look.shade, Some(Shade::Depth | Shade::Normal)) && !look.has_fog();
        let lines = match lines {
            // In black and white, silhouettes separate a model from the background.
            Lines::None if is_mono && is_lit => Lines::Outline,
            lines => lines,
        };
        let bias = match lines {
            Lines::Edges => Biased::behind(TestAndWrite),
            Lines::Outline | Lines::None => Biased::new(TestAndWrite, 0, fx!(0)),
        };
        // Lines on a surface are black. Lines around a surface contrast with the background.
        let is_around = is_mono || look.shade == Some(Shade::Wire);
        let line = if is_around && lines_are_white(look.backdrop) {
            Rgb888::WHITE
        } else {
            Rgb888::BLACK
        };
        Ok(Self {
            surfaces,
            has_faces: look.shade != Some(Shade::Wire) || lines == Lines::Outline,
            is_blended: (scene.pieces.iter())
                .map(|piece| is_blended(piece, look.shade))
                .collect(),
            lines,
            line: Surface::of_rgb(Flat::new(paint::on_canvas::<C>(line, Point::zero())))?,
            mode: scene.mode,
            cull: None,
            bias,
            backdrop: look.backdrop,
            color: paint::on_canvas::<C>,
            caption: scene.is_own.then_some(is_mono),
        })
    }

    /// Makes the style of a recording of the scene's faces or edges.
    ///
    /// # Errors
    ///
    /// None.
    pub fn recording(
        scene: &Scene<'_>,
        recording: Recording<'a>,
        edges: bool,
        cull: Option<Cull>,
    ) -> Result<Self> {
        let pieces = &scene.pieces;
        let surfaces = pieces.iter().map(|_| Surface::of_rgb(recording));
        Ok(Self {
            surfaces: surfaces.collect::<Result<_>>()?,
            has_faces: !edges,
            is_blended: vec![false; pieces.len()],
            lines: if edges { Lines::Edges } else { Lines::None },
            line: Surface::of_rgb(recording)?,
            mode: scene.recorded,
            cull,
            bias: Biased::new(TestAndWrite, 0, fx!(0)),
            backdrop: Backdrop::Color(Rgb888::BLACK),
            color: |color, _| color,
            caption: None,
        })
    }

    /// Fills the canvas.
    pub fn clear<D: DepthBuffer>(&self, canvas: &mut Board<'_, D>) {
        canvas.clear(Rgb888::default());
        let height = canvas.frame_size().height;
        let area = area(canvas);
        let colors = area.points().map(|at| {
            let color = match self.backdrop {
                Backdrop::Color(color) => color,
                Backdrop::Sky => lighthouse::sky_color(at.y.cast_unsigned(), height),
            };
            (self.color)(color, at)
        });
        let Ok(()) = canvas.fill_contiguous(&area, colors);
    }

    /// Converts blended colors to the canvas's color type. Writes the caption, if the picture has one.
    pub fn finish<D: DepthBuffer>(&self, canvas: &mut Board<'_, D>) {
        if self.is_blended.contains(&true) {
            let area = area(canvas);
            let colors: Vec<Rgb888> = (area.points().zip(canvas.pixels()))
                .map(|(at, color)| (self.color)(color, at))
                .collect();
            let Ok(()) = canvas.fill_contiguous(&area, colors);
        }
        if let Some(on_black) = self.caption {
            let size = canvas.frame_size();
            lighthouse::caption_on(canvas, size, on_black);
        }
    }
}

/// The area of a canvas, which can be a band of the frame.
fn area<D: DepthBuffer>(canvas: &Board<'_, D>) -> Rectangle {
    let rows = canvas.rows().clone();
    let corner = Point::new(0, rows.start.cast_signed());
    Rectangle::new(
        corner,
        Size::new(canvas.frame_size().width, rows.end - rows.start),
    )
}

/// Whether lines on a backdrop are white. (On a bright backdrop, lines are black.)
fn lines_are_white(backdrop: Backdrop) -> bool {
    match backdrop {
        Backdrop::Color(color) => Gray8::from_rgb(color, Point::zero()).luma() < 128,
        Backdrop::Sky => false,
    }
}

/// Whether a piece is translucent.
pub fn is_blended(piece: &Piece<'_>, shade: Option<Shade>) -> bool {
    let has_alpha = piece.finish.alpha == Meaning::Blended;
    match shade {
        Some(Shade::Texture | Shade::Lit) => has_alpha || piece.finish.opacity < 255,
        Some(Shade::Gouraud | Shade::Flat) => piece.finish.opacity < 255,
        _ => false,
    }
}

/// The transform from a model to the picture, for either projection.
#[derive(Clone, Copy, Debug)]
pub enum AnyMvp {
    Perspective(Mvp<Perspective>),
    Parallel(Mvp<Parallel>),
}

/// Evaluates an expression with the transform inside an [`AnyMvp`].
macro_rules! either {
    ($any:expr, |$mvp:ident| $value:expr) => {
        match $any {
            AnyMvp::Perspective($mvp) => $value,
            AnyMvp::Parallel($mvp) => $value,
        }
    };
}

impl AnyMvp {
    /// The viewer's position.
    pub fn viewer(&self) -> Viewer {
        either!(self, |mvp| Viewer::of(mvp))
    }

    /// How often a pixel of a picture of this size is drawn by all faces of the pieces, on average.
    ///
    /// # Errors
    ///
    /// None.
    pub fn layers(&self, pieces: &[Piece<'_>], size: (u32, u32)) -> Result<u64> {
        let meshes = pieces.iter().map(|piece| &piece.mesh);
        Ok(either!(self, |mvp| layers::count(meshes, mvp, size))?)
    }
}

/// The pieces of a model, with their pose, view and style.
#[derive(Clone, Copy)]
pub struct Posed<'a> {
    pub pieces: &'a [Piece<'a>],
    pub mvp: AnyMvp,
    pub style: &'a Style<'a>,
}

/// The options of the simulator's draw calls.
type Options<Z = Biased, B = Replace> = DrawOptions<Newton, Z, B>;

/// Draws in the mode of `$posed` if the projection is perspective, otherwise in the default mode.
macro_rules! projected {
    ($posed:expr, $options:expr, |$with:ident, $mvp:ident| $draw:expr) => {
        match &$posed.mvp {
            AnyMvp::Perspective($mvp) => in_mode!($posed.style.mode, $options, |$with| $draw),
            AnyMvp::Parallel($mvp) => {
                let $with = &$options;
                $draw
            }
        }
    };
}

impl Posed<'_> {
    fn options(&self, piece: &Piece<'_>) -> DrawOptions {
        DrawOptions::new().with_cull(self.style.cull.unwrap_or(piece.finish.cull))
    }

    /// Draws the faces of a piece.
    fn draw_piece<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, D>,
        piece: &Piece<'_>,
        shader: &impl ShaderFor<Rgb888>,
    ) -> Drawn {
        let options: Options = self.options(piece).with_depth_test(self.style.bias);
        projected!(self, options, |options, mvp| {
            canvas.draw_with(options, &piece.mesh, mvp, shader)
        })
    }

    /// Draws the lines of the style, one pixel wide.
    fn draw_lines<D: DepthBuffer>(&self, canvas: &mut Board<'_, D>) -> Drawn {
        let Surface::Many(shader) = &self.style.line else {
            return Drawn::default();
        };
        let (pen, edges) = (LineStyle::HAIRLINE, self.style.lines == Lines::Edges);
        let draw = |piece: &Piece<'_>| {
            let (options, mesh) = (self.options(piece), &piece.mesh);
            let in_front = &options.with_depth_test(Biased::in_front(TestAndWrite));
            match &piece.outline {
                _ if edges => {
                    either!(&self.mvp, |mvp| canvas.draw_with(
                        &options,
                        mesh.edges(pen),
                        mvp,
                        &shader
                    ))
                }
                Some(outline) => {
                    let outline = mesh.outline(outline, pen);
                    either!(&self.mvp, |mvp| canvas
                        .draw_with(in_front, outline, mvp, &shader))
                }
                None => Drawn::default(),
            }
        };
        self.pieces
            .iter()
            .map(draw)
            .fold(Drawn::default(), |mut sum, drawn| {
                sum += drawn;
                sum
            })
    }

    /// Draws the surfaces and lines of the style. Counts surfaces or, if there are none, lines.
    ///
    /// # Errors
    ///
    /// None for the pieces of a model.
    pub fn draw<D: DepthBuffer>(&self, canvas: &mut Board<'_, D>) -> Result<Drawn> {
        let style = self.style;
        if !style.has_faces {
            return Ok(self.draw_lines(canvas));
        }
        let mut sum = Drawn::default();
        let mut blended = Vec::new();
        let pieces = self.pieces.iter().zip(&style.surfaces);
        for ((piece, surface), &is_blended) in pieces.zip(&style.is_blended) {
            if is_blended {
                blended.extend(piece.part.map(|part| (piece, surface, part)));
                continue;
            }
            let drawn = match surface {
                Surface::Many(shader) => self.draw_piece(canvas, piece, &shader),
                Surface::Channels(shader) => self.draw_piece(canvas, piece, &shader),
                Surface::Pairs(shader) => self.draw_piece(canvas, piece, &shader),
            };
            sum += drawn;
        }
        // Sort the translucent faces from back to front: first the pieces, then the faces of each piece.
        let mut sorted = Vec::new();
        for (piece, surface, part) in blended {
            if let Surface::Many(shader) = surface {
                let (middle, order) = self.order(piece);
                sorted.push((middle, piece, shader, part.in_order(&order)));
            }
        }
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, piece, shader, part) in &sorted {
            let piece = part.piece(piece.finish)?;
            sum += self.draw_glass(canvas, &piece, shader);
        }
        if style.lines != Lines::None {
            self.draw_lines(canvas);
        }
        Ok(sum)
    }

    fn draw_glass<V: Varyings, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, D>,
        piece: &Piece<'_>,
        shader: &Any<'_, V>,
    ) -> Drawn {
        let shader = &Glass(shader);
        let options: Options<TestOnly> = self.options(piece).with_depth_test(TestOnly);
        projected!(self, options, |options, mvp| {
            canvas.draw_with(options, &piece.mesh, mvp, shader)
        })
    }

    /// Returns the order of a piece's faces from back to front, and the distance of the middle of these faces.
    fn order(&self, piece: &Piece<'_>) -> (f64, Vec<usize>) {
        let to_eye = either!(&self.mvp, |mvp| mvp.model_view());
        // z points toward the eye.
        let z: Vec<f64> = (piece.mesh.positions().iter())
            .map(|p| f64::from(to_eye.point(p).to_bits()[2]))
            .collect();
        let faces = piece.mesh.faces();
        let keys: Vec<f64> = (faces.iter())
            .map(|face| face.iter().map(|&at| z[usize::from(at)]).sum())
            .collect();
        let mut order: Vec<usize> = (0..keys.len()).collect();
        order.sort_by(|&a, &b| keys[a].total_cmp(&keys[b]));
        #[allow(clippy::cast_precision_loss)] // far fewer than 2^53 faces
        let middle = keys.iter().sum::<f64>() / keys.len().max(1) as f64;
        (middle, order)
    }
}
