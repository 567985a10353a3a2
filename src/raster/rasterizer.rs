//! Where the rasterizer draws to.

use core::hint::black_box;
use core::ops::Range;

use super::edge::{Edge, first_center};
use super::{Blitter, Columns, Patch, Scissor, ScreenVertex, Triangle};

/// The most rows that a [`Blitter`] receives at once: all rows of a small triangle. They take 256 bytes of stack.
const ROWS: i32 = 64;

/// A blitter, the pixels that it may draw, and memory for the rows of a triangle.
pub(crate) struct Rasterizer<'r> {
    pub(crate) blitter: &'r mut dyn Blitter,
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

    /// Draws some columns of one row, which lie within the scissor.
    pub(super) fn span(&mut self, row: i32, columns: &Range<i32>) {
        self.blitter.rows(
            &mut None,
            row,
            &[[columns.start as i16, columns.end as i16]],
        );
    }

    /// Finds the rows of a triangle; `each` receives the first row and the columns of some of them.
    #[inline]
    pub(super) fn fill(
        &mut self,
        triangle: &Triangle<'_>,
        mut each: impl FnMut(&mut dyn Blitter, i32, &[Columns]),
    ) {
        let Range { start, end } = triangle.rows;
        let mut first = start;
        while first < end {
            let next = end.min(first + ROWS);
            let count = (next - first).cast_unsigned() as usize;
            let rows = self.rows.get_mut(..count).unwrap_or_default();
            let Patch { vertices, area, .. } = &triangle.patch;
            scan_convert(rows, first, vertices, *area > 0);
            if triangle.is_cut {
                cut(rows, &self.scissor.columns);
            }
            each(self.blitter, first, rows);
            first = next;
        }
    }

    /// Draws the same columns of some rows, as far as they are within the scissor.
    #[inline]
    pub(super) fn fill_upright(&mut self, rows: &Range<i32>, [start, end]: [i32; 2]) {
        let columns = &self.scissor.columns;
        let columns = [start.max(columns.start) as i16, end.min(columns.end) as i16];
        let mut first = rows.start;
        while first < rows.end {
            let next = rows.end.min(first + ROWS);
            let count = (next - first).cast_unsigned() as usize;
            let rows = self.rows.get_mut(..count).unwrap_or_default();
            for row in &mut *rows {
                *row = columns;
            }
            self.blitter.rows(&mut None, first, rows);
            first = next;
        }
    }
}

/// Finds the columns of consecutive rows whose centers lie between the edges of a triangle.
///
/// ```text
///      a ●
///       ╱ ╲         Clockwise, the edge from a down to b ends rows on the right,
///      ╱   ● b      as does the one from b to c;
///     ╱ ╱           the edge from c up to a begins them on the left.
///  c ●
/// ```
#[inline(never)]
pub(super) fn scan_convert(
    rows: &mut [Columns],
    first: i32,
    vertices: &[&ScreenVertex; 3],
    is_clockwise: bool,
) {
    let count = (rows.len() as u32).cast_signed();
    // The first of the rows that is not above a corner.
    let row_of = |corner: &ScreenVertex| {
        let row = first_center(corner.screen[1]) - first;
        row.max(0).min(count).cast_unsigned() as usize
    };
    let [.., mut from] = *vertices;
    let mut from_row = row_of(from);
    for &to in vertices {
        let to_row = row_of(to);
        let is_down = to_row > from_row;
        let (top, bottom, start, end) = if is_down {
            (from, to, from_row, to_row)
        } else {
            (to, from, to_row, from_row)
        };
        (from, from_row) = (to, to_row);
        // An edge may pass the center of no row.
        if start == end {
            continue;
        }
        let Some(rows) = rows.get_mut(start..end) else {
            continue;
        };
        let side = usize::from(is_down == is_clockwise);
        let row = first + (start as u32).cast_signed();
        let mut edge = Edge::new(top.screen, bottom.screen, row);
        for columns in rows {
            // Keeps the compiler from unrolling the loop, because most edges pass few rows.
            black_box(());
            columns[side] = edge.next() as i16;
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
