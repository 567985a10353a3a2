//! The rasterizer: it finds the pixels of a triangle, row by row, and passes them on to a [`Blitter`].

use core::hint::black_box;
use core::ops::Range;

use super::edge::{Edge, ShortEdge, first_center};
use super::polygon::Part;
use super::{Blitter, Columns, Patch, Rows, Scissor, ScreenVertex, Triangle};
use crate::mesh::{Indices, Primitive};

/// The most rows that [`Rows::draw`] receives at once. This is enough for all rows of a small triangle, and takes 256
/// bytes of stack.
const ROWS: i32 = 64;

/// A triangle, edge or point of a mesh, the pixels that may be drawn, and the blitter that draws them.
pub(crate) struct Rasterizer<'r> {
    blitter: &'r mut dyn Blitter,
    primitive: Primitive<'r>,
    pub(super) scissor: &'r Scissor,
    /// The answer of [`Blitter::varies`].
    pub(super) varies: bool,
    /// The answer of [`Blitter::blends`].
    pub(super) blends: bool,
    /// Memory for the rows of a triangle.
    block: [Columns; ROWS as usize],
}

impl<'r> Rasterizer<'r> {
    #[inline]
    pub(crate) fn new(
        blitter: &'r mut dyn Blitter,
        primitive: Primitive<'r>,
        scissor: &'r Scissor,
    ) -> Self {
        Self {
            varies: blitter.varies(),
            blends: blitter.blends(),
            blitter,
            primitive,
            scissor,
            block: [[0; 2]; ROWS as usize],
        }
    }

    /// Moves on to another triangle of the mesh. `area` is twice its area on the screen.
    #[inline]
    pub(crate) fn begin_primitive(&mut self, indices: Indices, area: i64) -> &mut Self {
        self.primitive.indices = indices;
        self.primitive.area = (area >> 32) as i32;
        self
    }

    /// Moves on to another edge or point of the mesh. For an outline's edge, `slope_beside` is how steep the faces
    /// beside it are.
    #[inline]
    pub(crate) fn begin_thin(&mut self, indices: Indices, slope_beside: u16) -> &mut Self {
        self.primitive.slope_beside = slope_beside;
        self.begin_primitive(indices, 0)
    }

    #[inline]
    pub(super) fn set_up(&mut self, patch: &Patch<'_>) -> &mut dyn Rows {
        self.blitter.set_up(&self.primitive, patch)
    }

    /// Fills a triangle inside the scissor; with `part`, only the pixels that `part` selects.
    ///
    /// A center on a left or top edge belongs to the triangle. A center on a right or bottom edge does not.
    #[cfg_attr(for_size, inline(never))]
    pub(crate) fn triangle(&mut self, triangle: &Triangle<'_>, part: Option<&Part<'_>>) {
        let block = &mut self.block;
        let Range { start, end } = triangle.rows;
        let (mut first, mut rows) = (start, scan_convert(block, start, triangle));
        // Many slivers cover no pixel center. For such a sliver, no interpolant is set up.
        while !rows.iter().copied().any(has_pixels) {
            first += ROWS;
            if first >= end {
                return;
            }
            rows = scan_convert(block, first, triangle);
        }
        let blit = self.blitter.set_up(&self.primitive, &triangle.patch);
        loop {
            match part {
                None => blit.draw(first, rows),
                Some(part) => part.rows(blit, first, rows),
            }
            first += ROWS;
            if first >= end {
                return;
            }
            rows = scan_convert(block, first, triangle);
        }
    }

    /// Draws an upright rectangle inside the scissor. The triangle `half` is one half of the rectangle, but its
    /// interpolants are set up over the whole rectangle. So at the fourth corner, no interpolant may have a value beyond
    /// its values at the other three corners.
    ///
    /// The rectangle has the pixels of both halves. An interpolant has the same greatest error as in a half, because
    /// this error depends only on the width and the height of the triangle.
    #[inline(never)]
    pub(crate) fn rectangle(&mut self, half: &Triangle<'_>) {
        let blit = self.blitter.set_up(&self.primitive, &half.patch);
        let [[ax, _], [bx, _], [cx, _]] = ScreenVertex::screens(half.patch.vertices);
        let [start, end] = [ax.min(bx).min(cx), ax.max(bx).max(cx)].map(first_center);
        let (columns, rows) = (&self.scissor.columns, &half.rows);
        let columns = [start.max(columns.start) as i16, end.min(columns.end) as i16];
        let mut first = rows.start;
        while first < rows.end {
            let next = rows.end.min(first + ROWS);
            let count = (next - first).cast_unsigned() as usize;
            let rows = self.block.get_mut(..count).unwrap_or_default();
            for row in &mut *rows {
                *row = columns;
            }
            blit.draw(first, rows);
            first = next;
        }
    }
}

/// Finds, for each row of a block, the columns in the scissor whose centers lie between the edges of a triangle.
///
/// ```text
///      a ●
///       ╱ ╲         a is the highest corner, c the lowest. The edge from a to c bounds rows on one
///      ╱   ● b      side. The edges from a to b and from b to c bound rows on the other side.
///     ╱ ╱
///  c ●
/// ```
#[inline(never)]
pub(super) fn scan_convert<'b, 't>(
    block: &'b mut [Columns],
    first: i32,
    triangle: &Triangle<'t>,
) -> &'b [Columns] {
    let Patch {
        vertices: [mut a, mut b, mut c],
        size: [width, height],
        area,
        ..
    } = triangle.patch;
    let rows_to = |row: i32| (row - first).max(0).cast_unsigned() as usize;
    let count = rows_to(triangle.rows.end).min(block.len());
    let rows = block.get_mut(..count).unwrap_or_default();
    // If abc runs clockwise, the edge from a to c is on the left: side 0. An exchange of two corners turns the winding
    // around.
    let mut sign = (area >> 32) as i32;
    let mut sort = |a: &'t ScreenVertex, b: &'t ScreenVertex| {
        if a.screen[1] <= b.screen[1] {
            (a, b)
        } else {
            sign = !sign;
            (b, a)
        }
    };
    (a, b) = sort(a, b);
    (b, c) = sort(b, c);
    (a, b) = sort(a, b);
    // All rows are between a and c.
    let middle = rows_to(first_center(b.screen[1])).min(count);
    let side = usize::from(sign < 0);
    let is_short = ShortEdge::fits(width, height);
    edge(rows, side, [a, c], first, is_short);
    if let Some((upper, lower)) = rows.split_at_mut_checked(middle) {
        edge(upper, 1 - side, [a, b], first, is_short);
        let first = first + (middle as u32).cast_signed();
        edge(lower, 1 - side, [b, c], first, is_short);
    }
    if let Some(scissor) = triangle.cut {
        cut(rows, &scissor.columns);
    }
    rows
}

/// Sets one side of the rows to the columns of an edge from a corner down to another corner. The first row is `row`.
#[cfg_attr(for_size, inline(never))]
fn edge(rows: &mut [Columns], side: usize, ends: [&ScreenVertex; 2], row: i32, is_short: bool) {
    if !is_short {
        long_edge(rows, side, ends, row);
        return;
    }
    let [top, bottom] = ends;
    if let Some(mut edge) = ShortEdge::new(top.screen, bottom.screen, row) {
        // Most edges pass few rows, so an empty statement keeps the compiler from unrolling the loops.
        for columns in rows {
            black_box(());
            columns[side & 1] = edge.next();
        }
    }
}

#[inline(never)]
fn long_edge(rows: &mut [Columns], side: usize, [top, bottom]: [&ScreenVertex; 2], row: i32) {
    if rows.is_empty() {
        return;
    }
    let mut edge = Edge::new(top.screen, bottom.screen, row);
    for columns in rows {
        black_box(());
        columns[side & 1] = edge.next() as i16;
    }
}

/// Whether a row has a pixel.
fn has_pixels([start, end]: Columns) -> bool {
    black_box(()); // so that the loop over rows is not unrolled: most triangles have a pixel in the first row or two
    start < end
}

/// Limits rows to the scissor. Out of line, because most triangles are inside the scissor.
#[cold]
#[inline(never)]
fn cut(rows: &mut [Columns], scissor: &Range<i32>) {
    let (first, last) = (scissor.start as i16, scissor.end as i16);
    for [start, end] in rows {
        *start = (*start).max(first);
        *end = (*end).min(last);
    }
}
