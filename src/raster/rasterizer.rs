//! Where the rasterizer draws to.

use core::hint::black_box;
use core::ops::Range;

use super::edge::{Edge, first_center};
use super::{Blitter, Bounds, Columns, Scissor};
use crate::mesh::Primitive;

/// The most rows that a [`Blitter`] receives at once: all rows of a small triangle. They take 256 bytes of stack.
const ROWS: i32 = 64;

/// A blitter, the pixels that it may draw, and memory for the rows of a triangle.
pub(crate) struct Rasterizer<'r> {
    pub(super) blitter: &'r mut dyn Blitter,
    pub(super) scissor: &'r Scissor,
    rows: [Columns; ROWS as usize],
}

impl<'r> Rasterizer<'r> {
    #[inline]
    pub(crate) fn new(blitter: &'r mut dyn Blitter, scissor: &'r Scissor) -> Self {
        Self {
            blitter,
            scissor,
            rows: [[0; 2]; ROWS as usize],
        }
    }

    /// Starts another triangle, edge or point of the mesh.
    #[inline]
    pub(crate) fn start(&mut self, primitive: &Primitive<'_>) {
        self.blitter.primitive(primitive);
    }

    /// Draws some columns of one row, which lie within the scissor.
    pub(super) fn span(&mut self, row: i32, columns: &Range<i32>) {
        self.blitter
            .rows(row, &[[columns.start as i16, columns.end as i16]]);
    }

    /// Draws the pixels between three edges that run clockwise; `each` receives the first row and the columns of some
    /// rows.
    #[inline]
    pub(super) fn fill(
        &mut self,
        clockwise: &[[i32; 2]; 3],
        bounds: &Bounds,
        mut each: impl FnMut(&mut dyn Blitter, i32, &[Columns]),
    ) {
        let (scissor, columns, rows) = (self.scissor, bounds.columns(), bounds.rows());
        let is_cut = columns.start < scissor.columns.start || columns.end > scissor.columns.end;
        let end = rows.end.min(scissor.rows.end);
        let mut first = rows.start.max(scissor.rows.start);
        while first < end {
            let part = first..end.min(first + ROWS);
            let count = (part.end - part.start).cast_unsigned() as usize;
            let rows = self.rows.get_mut(..count).unwrap_or_default();
            scan_convert(rows, first, clockwise);
            if is_cut {
                cut(rows, &scissor.columns);
            }
            each(self.blitter, first, rows);
            first = part.end;
        }
    }
}

/// Finds the columns of consecutive rows whose centers lie between three edges, which run clockwise.
///
/// ```text
///      a ●
///       ╱ ╲         The edge from a down to b ends rows on the right,
///      ╱   ● b      as does the one from b to c;
///     ╱ ╱           the edge from c up to a begins them on the left.
///  c ●
/// ```
#[inline(never)]
pub(super) fn scan_convert(rows: &mut [Columns], first: i32, [a, b, c]: &[[i32; 2]; 3]) {
    let last = first + (rows.len() as u32).cast_signed();
    for edge in [a, b, c, a].windows(2) {
        let [from, to] = *edge else { continue };
        let (side, top, bottom) = if to[1] > from[1] {
            (1, from, to)
        } else {
            (0, to, from)
        };
        let start = first_center(top[1]).max(first);
        let end = first_center(bottom[1]).min(last);
        let at = |row: i32| (row - first).cast_unsigned() as usize;
        // An edge may pass the center of no row.
        let Some(rows) = rows.get_mut(at(start)..at(end)) else {
            continue;
        };
        let mut edge = Edge::new(*top, *bottom, start);
        for columns in rows {
            // Keeps the compiler from unrolling: most edges pass few rows.
            black_box(());
            columns[side] = edge.column() as i16;
            edge.step();
        }
    }
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
