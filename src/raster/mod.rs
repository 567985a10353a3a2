//! From primitives on the screen to spans of pixels.

mod block;
mod cull;
mod edge;
mod line;
mod line_style;
mod point;
mod polygon;
mod rasterizer;
mod scissor;
mod sized_point;
mod smooth_line;
mod straddle;
mod triangle;
mod vertex;
mod wide_line;

use crate::mesh::Primitive;

pub use cull::Cull;
pub(crate) use edge::first_center;
pub(crate) use line::line;
pub use line_style::LineStyle;
pub(crate) use point::point;
pub(crate) use polygon::Polygon;
pub(crate) use rasterizer::Rasterizer;
pub(crate) use scissor::Scissor;
pub use sized_point::PointStyle;
pub(crate) use sized_point::{half_size, sized_point};
pub(crate) use smooth_line::{Coverage, smooth_line};
pub(crate) use straddle::{Pair, Straddle, smooth_edge};
pub(crate) use triangle::{Triangle, area};
pub(crate) use vertex::{
    Barycentric, ClippedVertex, DepthShift, LEAST_WEIGHT, MOST_WEIGHT, ScreenVertex,
};
pub(crate) use wide_line::wide_line;

/// Three vertices on the screen. Each interpolant is the plane through its values at these vertices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch<'a> {
    pub(crate) vertices: [&'a ScreenVertex; 3],
    /// The vertices' places in the mesh's triangle; `None` if they are its corners.
    pub(crate) barycentric: Option<&'a [Barycentric; 3]>,
    /// Width and height, in units of 1/256 pixel.
    pub(crate) size: [i32; 2],
    /// Twice the area, in units of (1/256 pixel)²: positive for vertices that run clockwise on the screen. It is 0, as
    /// the size, for a point: all three vertices are then the same.
    pub(crate) area: i64,
}

impl Patch<'_> {
    /// Whether all three vertices are the same. Optimized for size, the answer is no, and points take the path of large
    /// triangles, where all gains are 0.
    #[inline]
    pub(crate) fn is_point(&self) -> bool {
        let [a, b, _] = self.vertices;
        core::ptr::eq(a, b) && !cfg!(for_size)
    }

    /// A patch where nothing varies.
    const EVEN: Self = Self {
        vertices: [&ScreenVertex::UNSET; 3],
        barycentric: None,
        size: [0; 2],
        area: 0,
    };
}

/// The columns of a row that are drawn: the first column, and the column after the last. They lie within ±2^15.
pub(crate) type Columns = [i16; 2];

/// A shader, a mode and a canvas, which together draw the pixels that the rasterizer finds.
///
/// The stages before a blitter, from the mesh's indices to rows of pixels, call the blitter through a `dyn`. So a
/// program has a single copy of these stages, however many shaders and canvases there are. A call costs a few
/// instructions.
pub(crate) trait Blitter {
    /// Begins a draw call. `shift` turns the call's 1/w into depths.
    fn begin(&mut self, shift: DepthShift) -> Coloring;

    /// Sets up the interpolants of a triangle, edge or point over a patch: the whole primitive or a part of it.
    fn set_up(&mut self, primitive: &Primitive<'_>, patch: &Patch<'_>) -> &mut dyn Rows;
}

/// How the pixels of a draw call are colored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coloring {
    /// Whether the pixels of a primitive differ in more than their position. If they do not, [`Blitter::set_up`]
    /// ignores its patch.
    pub(crate) varies: bool,
    /// Whether colors are mixed with the colors below. A pixel that is drawn twice then looks different.
    pub(crate) blends: bool,
}

/// What [`Blitter::set_up`] returns: the blitter, now ready to draw rows of the patch.
pub(crate) trait Rows {
    /// Draws the given columns of consecutive rows, the first of which is row `first`. All columns lie within the
    /// canvas; a row may be empty.
    fn draw(&mut self, first: i32, columns: &[Columns]);
}
