//! The pixels of a canvas as spans receive them: each color with its depth, row by row.

use core::ops::Range;

use super::depth::DepthBuffer;
use super::storage::{RowSpan, Storage};

/// The colors and depths of a canvas. Once it is in registers, rows are found without reading the canvas.
pub(crate) struct Memory<'a, C, O: Storage<C>, D> {
    pub(super) cells: &'a mut [O::Cell],
    pub(super) depth: &'a mut D,
    pub(super) width: u32,
    pub(super) first_row: u32,
}

impl<'a, C, O: Storage<C>, D: DepthBuffer> Memory<'a, C, O, D> {
    #[inline]
    pub(crate) fn reborrow(&mut self) -> Memory<'_, C, O, D> {
        Memory {
            cells: self.cells,
            depth: self.depth,
            ..*self
        }
    }

    /// The pixels of `columns` of `row` with their depths. Both must lie within the canvas's area, as the rasterizer's
    /// do. It returns `None` and does not panic if memory ends before them, or if columns end before they start.
    #[inline]
    pub(crate) fn cells(self, row: u32, columns: Range<u32>) -> Option<Cells<'a, C, O, D>> {
        let span = RowSpan::new(row - self.first_row, columns, self.width);
        let range = span.pixels.clone();
        let (cells, cursor) = O::locate(span);
        Some(Cells {
            colors: self.cells.get_mut(cells)?,
            cursor,
            depths: self.depth.cells(range)?,
        })
    }
}

/// Pixels of a row in memory: colors and depths.
pub(crate) struct Cells<'a, C, O: Storage<C>, D: DepthBuffer + 'a> {
    colors: &'a mut [O::Cell],
    cursor: O::Cursor<'a>,
    depths: D::Cells<'a>,
}

impl<'a, C, O: Storage<C>, D: DepthBuffer + 'a> Cells<'a, C, O, D> {
    #[inline]
    pub(crate) fn len(&self) -> usize {
        O::len(self.colors.len(), self.cursor)
    }

    /// Splits off the first `count` pixels, or all that are left.
    #[inline]
    pub(crate) fn first(
        &mut self,
        count: usize,
    ) -> impl Iterator<Item = (O::PixelRef<'a>, D::Cell<'a>)> + use<'a, C, O, D> {
        let (colors, depths) = (
            O::first(&mut self.colors, &mut self.cursor, count),
            D::first(&mut self.depths, count),
        );
        colors.zip(D::each(depths))
    }
}
