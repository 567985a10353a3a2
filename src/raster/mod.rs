//! From primitives on the screen to spans of pixels.

mod cull;
mod edge;
mod gradient;
mod line;
mod line_style;
#[cfg(test)]
pub(crate) mod picture;
mod point;
mod polygon;
mod rasterizer;
mod scale;
mod scissor;
mod setup;
mod sized_point;
mod smooth_line;
mod triangle;
mod vertex;
mod wide_line;

use crate::mesh::Primitive;

pub use cull::Cull;
pub(crate) use edge::first_center;
pub(crate) use gradient::Gradient;
pub(crate) use line::line;
pub use line_style::LineStyle;
pub(crate) use point::point;
pub(crate) use polygon::Polygon;
pub(crate) use rasterizer::Rasterizer;
pub(crate) use scissor::Scissor;
pub(crate) use setup::{
    Attribute, Interpolation, LEAST_WEIGHT, MOST_WEIGHT, SHALLOW, SPAN, Scale, Setup, unpaired,
};
pub use sized_point::PointStyle;
pub(crate) use sized_point::{half_size, sized_point};
pub(crate) use smooth_line::{Coverage, smooth_line};
pub(crate) use triangle::{Triangle, area};
pub(crate) use vertex::{Barycentric, ClippedVertex, DepthShift, ScreenVertex};
pub(crate) use wide_line::wide_line;

/// Three vertices on the screen; each interpolant is the plane through its values at them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch<'a> {
    pub(crate) vertices: [&'a ScreenVertex; 3],
    /// The vertices' places in the mesh's triangle; `None` if they are its corners.
    pub(crate) barycentric: Option<&'a [Barycentric; 3]>,
    /// Width and height, in units of 1/256 pixel.
    pub(crate) size: [i32; 2],
    /// Twice the area, in units of (1/256 pixel)²: positive for vertices that run clockwise on the screen.
    pub(crate) area: i64,
}

/// The columns of a row that are drawn: the first, and the one after the last. They lie within ±2^15.
pub(crate) type Columns = [i16; 2];

/// Draws the rasterizer's spans: a shader, a mode and a canvas.
///
/// Everything before it, from the mesh's indices to rows of pixels, calls it through a `dyn`. This keeps a single
/// copy of that code in a program, however many shaders and canvases there are. A call costs a few instructions.
pub(crate) trait Blitter {
    /// Whether anything is interpolated; if not, patches need not be set up.
    fn varies(&self) -> bool;

    /// Starts another triangle, edge or point of the mesh.
    fn primitive(&mut self, primitive: &Primitive<'_>);

    /// Lays the interpolants over a patch, which is the whole primitive or a part of it.
    fn set_up(&mut self, patch: &Patch<'_>);

    /// Draws these columns of consecutive rows, which lie within the canvas; some may be empty. If one is not, the
    /// patch has been [set up](Self::set_up).
    fn rows(&mut self, first: i32, columns: &[Columns]);
}
