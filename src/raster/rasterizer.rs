//! Where the rasterizer draws to.

use core::hint::black_box;
use core::ops::Range;

use super::edge::{Edge, ShortEdge, first_center};
use super::polygon::Part;
use super::{Blitter, Columns, Patch, Rows, Scissor, ScreenVertex, Triangle};
use crate::mesh::{Indices, Primitive};

/// The most rows that [`Rows`] receive at once: all rows of a small triangle. They take 256 bytes of stack.
const ROWS: i32 = 64;

/// A triangle, edge or point of a mesh, the pixels that it may have, and what draws them.
pub(crate) struct Rasterizer<'r> {
    blitter: &'r mut dyn Blitter,
    primitive: Primitive<'r>,
    pub(super) scissor: &'r Scissor,
    /// Whether patches matter.
    pub(super) varies: bool,
    /// Whether the colors below are read.
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

    /// The rasterizer of another triangle, edge or point of the mesh, with twice its area on the screen.
    #[inline]
    pub(crate) fn of(&mut self, indices: Indices, area: i64) -> &mut Self {
        self.primitive.indices = indices;
        self.primitive.area = (area >> 32) as i32;
        self
    }

    #[inline]
    pub(super) fn lay(&mut self, patch: &Patch<'_>) -> &mut dyn Rows {
        self.blitter.lay(&self.primitive, patch)
    }

    /// Fills a triangle inside the scissor; with `part`, only the pixels that it selects.
    ///
    /// A center on a left or top edge belongs to the triangle, one on a right or bottom edge does not.
    #[cfg_attr(for_size, inline(never))]
    pub(crate) fn triangle(&mut self, triangle: &Triangle<'_>, part: Option<&Part<'_>>) {
        let block = &mut self.block;
        let Range { start, end } = triangle.rows;
        let (mut first, mut rows) = (start, scan_convert(block, start, triangle));
        // For the many slivers that pass between all centers, nothing is laid.
        while !rows.iter().copied().any(has_pixels) {
            first += ROWS;
            if first >= end {
                return;
            }
            rows = scan_convert(block, first, triangle);
        }
        let laid = self.blitter.lay(&self.primitive, &triangle.patch);
        loop {
            match part {
                None => laid.draw(first, rows),
                Some(part) => part.rows(laid, first, rows),
            }
            first += ROWS;
            if first >= end {
                return;
            }
            rows = scan_convert(block, first, triangle);
        }
    }

    /// Draws, within the scissor, the upright rectangle of which a triangle is a half. Interpolants are laid over the
    /// whole rectangle, so at the fourth corner none may be beyond its values at the other three.
    ///
    /// It has the pixels of both halves. The errors of planes, which are derived from the width and the height of a
    /// triangle, are the same.
    #[inline(never)]
    pub(crate) fn rectangle(&mut self, half: &Triangle<'_>) {
        let laid = self.blitter.lay(&self.primitive, &half.patch);
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
            laid.draw(first, rows);
            first = next;
        }
    }
}

/// Finds the columns of a block of rows whose centers lie between the edges of a triangle, in the scissor.
///
/// ```text
///      a ●
///       ╱ ╲         From the highest corner, a, down to the lowest one, c: the edge from a to c bounds
///      ╱   ● b      rows on one side, those from a to b and from b to c on the other.
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
    // If abc runs clockwise, the edge from a to c is on the left: side 0. An exchange of two corners turns that around.
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

/// Sets the columns on one side of rows to those of an edge from a corner down to another; the first row is `row`.
#[cfg_attr(for_size, inline(never))]
fn edge(rows: &mut [Columns], side: usize, ends: [&ScreenVertex; 2], row: i32, is_short: bool) {
    if !is_short {
        long_edge(rows, side, ends, row);
        return;
    }
    let [top, bottom] = ends;
    if let Some(mut edge) = ShortEdge::new(top.screen, bottom.screen, row) {
        // An empty statement keeps the compiler from unrolling the loops, because most edges pass few rows.
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
    black_box(()); // so that the loop over rows is not unrolled: most triangles have a pixel in the first one or two
    start < end
}

/// Limits rows to the scissor. Apart, because most triangles are inside it.
#[cold]
#[inline(never)]
fn cut(rows: &mut [Columns], scissor: &Range<i32>) {
    let (first, last) = (scissor.start as i16, scissor.end as i16);
    for [start, end] in rows {
        *start = (*start).max(first);
        *end = (*end).min(last);
    }
}
