//! From primitives on the screen to spans of pixels.

mod cull;
mod edge;
mod gradient;
mod line;
#[cfg(test)]
pub(crate) mod picture;
mod point;
mod polygon;
mod scale;
mod scissor;
mod setup;
mod triangle;
mod vertex;

use core::ops::Range;

use crate::mesh::Primitive;

pub use cull::Cull;
pub(crate) use line::line;
pub(crate) use point::point;
pub(crate) use polygon::Polygon;
pub(crate) use scissor::Scissor;
pub(crate) use setup::{Attribute, FAR, SPAN, Scale, Setup};
pub(crate) use triangle::{Triangle, area};
pub(crate) use vertex::{Barycentric, ClippedVertex, DepthShift, ScreenVertex};

/// Three vertices and the screen positions of their values; each interpolant is the plane through these values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch<'a> {
    pub(crate) vertices: [&'a ScreenVertex; 3],
    /// The vertices' places in the mesh's triangle; `None` if they are its corners.
    pub(crate) barycentric: Option<&'a [Barycentric; 3]>,
    /// Screen positions of the values, in units of 1/256 pixel; for a triangle, the vertices' own.
    pub(crate) screen: &'a [[i32; 2]; 3],
    /// Twice the area between these positions, positive if they run clockwise on the screen.
    pub(crate) area: i64,
}

/// Draws the rasterizer's spans: a shader, a mode and a canvas.
///
/// Everything before it, from the mesh's indices to rows of pixels, calls it through a `dyn`. This keeps a single
/// copy of that code in a program, however many shaders and canvases there are. A call costs a few instructions.
pub(crate) trait Blitter {
    /// Starts another triangle, edge or point of the mesh.
    fn primitive(&mut self, primitive: &Primitive<'_>);

    /// Lays the interpolants over a patch, which is all or a part of the primitive; returns the longest span in
    /// pixels.
    fn set_up(&mut self, patch: &Patch<'_>) -> i32;

    /// Draws `columns` of `row`, which lie within the canvas and are no longer than [`set_up`](Self::set_up)
    /// returned.
    ///
    /// The span begins `x` columns and `y` rows from the pixel that contains the patch's first position.
    fn span(&mut self, row: i32, columns: Range<i32>, x: i32, y: i32);
}

/// Splits columns into spans of at most `longest` pixels and draws them.
#[inline(never)]
fn spans(
    blitter: &mut dyn Blitter,
    row: i32,
    mut columns: Range<i32>,
    [mut x, y]: [i32; 2],
    longest: i32,
) {
    while columns.start < columns.end {
        let count = longest.min(columns.end - columns.start);
        let stop = columns.start + count;
        blitter.span(row, columns.start..stop, x, y);
        x += count;
        columns.start = stop;
    }
}

#[cfg(test)]
mod tests {
    use super::picture::Picture;
    use super::*;

    #[test]
    fn a_long_span_is_drawn_in_pieces_without_gaps() {
        let mut picture = Picture::new(9, 1);
        spans(&mut picture, 0, 1..8, [5, 2], 3);
        picture.assert(&[".#######."]);
        let expected = [(0, 1..4, [5, 2]), (0, 4..7, [8, 2]), (0, 7..8, [11, 2])];
        assert_eq!(picture.spans, expected);
    }
}
