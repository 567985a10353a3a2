//! Rows of a line or of a point, drawn together.

use core::hint::black_box;
use core::ops::Range;

use super::rasterizer::ROWS;
use super::{Columns, Rows};

/// Collects the columns of consecutive rows, and draws the rows together: drawn alone, each row would take the
/// instructions of three pixels more. Optimized for size, each row is drawn alone. All columns must lie within the
/// canvas.
pub(super) struct Block<'r> {
    rows: &'r mut [Columns; ROWS as usize],
    blit: &'r mut dyn Rows,
    /// How many rows are collected, and which is the last of them.
    count: u8,
    last: i32,
    /// Whether rows are added from bottom to top.
    pub(super) rises: bool,
}

impl<'r> Block<'r> {
    #[inline]
    pub(super) fn new(blit: &'r mut dyn Rows, rows: &'r mut [Columns; ROWS as usize]) -> Self {
        Self {
            rows,
            blit,
            count: 0,
            last: 0,
            rises: false,
        }
    }

    /// Adds a row: the next one below the last, or above it if the block [rises](Self::rises).
    #[inline]
    pub(super) fn add(&mut self, row: i32, columns: &Range<i32>) {
        if cfg!(for_size) {
            self.draw_alone(row, columns);
            return;
        }
        if i32::from(self.count) == ROWS {
            self.draw();
        }
        if let Some(of_row) = self.rows.get_mut(usize::from(self.count)) {
            *of_row = [columns.start as i16, columns.end as i16];
        }
        self.count += 1;
        self.last = row;
    }

    /// Draws rows from top to bottom, without the rows that were added. `columns` returns the columns of the next row,
    /// which may be empty.
    #[inline]
    pub(super) fn fill(&mut self, rows: &Range<i32>, mut columns: impl FnMut() -> Columns) {
        let mut first = rows.start;
        while first < rows.end {
            let count = (rows.end - first).min(ROWS).cast_unsigned() as usize;
            let block = self.rows.get_mut(..count).unwrap_or_default();
            for of_row in &mut *block {
                black_box(()); // so that the loop is not unrolled: most lines are short
                *of_row = columns();
            }
            self.blit.draw(first, block);
            first += ROWS;
        }
    }

    /// Draws a row at once.
    #[inline]
    pub(super) fn draw_alone(&mut self, row: i32, columns: &Range<i32>) {
        self.blit
            .draw(row, &[[columns.start as i16, columns.end as i16]]);
    }

    /// Draws the rows that were added. Any row may then be the next.
    #[inline]
    pub(super) fn draw(&mut self) {
        if cfg!(for_size) {
            return;
        }
        let rows = self
            .rows
            .get_mut(..usize::from(self.count))
            .unwrap_or_default();
        let mut first = self.last;
        if self.rises {
            rows.reverse();
        } else {
            first -= i32::from(self.count) - 1;
        }
        self.blit.draw(first, rows);
        self.count = 0;
    }
}
