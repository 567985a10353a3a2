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

/// Three vertices and where on the screen their values belong: the plane that each interpolant is laid through.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch<'a> {
    pub(crate) vertices: &'a [ScreenVertex; 3],
    /// Where the vertices lie in the mesh's triangle; `None` if they are its corners.
    pub(crate) barycentric: Option<&'a [Barycentric; 3]>,
    /// Where the values belong, in units of 1/256 pixel: of a triangle, the vertices' own places.
    pub(crate) screen: &'a [[i32; 2]; 3],
    /// Twice the area between these places, positive if they run clockwise as seen.
    pub(crate) area: i64,
}

/// What the rasterizer draws spans with: a shader, a mode and a canvas.
///
/// All that comes before, from the mesh's indices to rows of pixels, calls it through a `dyn`. So that code exists once
/// in a program, whatever the number of shaders and canvases. A call costs a few instructions.
pub(crate) trait Blitter {
    /// Goes on to another triangle, edge or point of the mesh.
    fn primitive(&mut self, primitive: &Primitive<'_>);

    /// Lays the interpolants over a patch, all or a part of the primitive; gives the longest span in pixels.
    fn set_up(&mut self, patch: &Patch<'_>) -> i32;

    /// Draws `columns` of `row`, which lie within the canvas and are no longer than [`set_up`](Self::set_up) said.
    ///
    /// The span begins `x` columns and `y` rows from the pixel in which the patch's first place lies.
    fn span(&mut self, row: i32, columns: Range<i32>, x: i32, y: i32);
}

/// Draws columns that may be more than the `longest` span.
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
