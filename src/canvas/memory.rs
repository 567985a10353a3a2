//! The pixels of a canvas as spans receive them: each color with its depth, row by row.

use core::marker::PhantomData;
use core::mem;
use core::ops::Range;

use super::depth::DepthBuffer;
use super::storage::Storage;

/// The colors and depths of a canvas. Once it is in registers, rows are found without reading the canvas.
pub(crate) struct Memory<'a, C, O: Storage<C>, D> {
    pub(super) colors: &'a mut [O::Cell],
    /// Empty if there is no depth buffer.
    pub(super) depths: &'a mut [u16],
    pub(super) width: u32,
    pub(super) first_row: u32,
    pub(super) buffer: PhantomData<D>,
}

impl<'a, C, O: Storage<C>, D: DepthBuffer> Memory<'a, C, O, D> {
    #[inline]
    pub(crate) fn reborrow(&mut self) -> Memory<'_, C, O, D> {
        Memory {
            colors: self.colors,
            depths: self.depths,
            ..*self
        }
    }

    /// The pixels of `columns` of `row` with their depths. Both must lie within the canvas's area, as the rasterizer's
    /// do. It returns `None` and does not panic if memory ends before them, or if columns end before they start.
    #[inline]
    pub(crate) fn cells(self, row: u32, columns: Range<u32>) -> Option<Cells<'a, C, O, D>> {
        let first = (row - self.first_row) * self.width;
        // It wraps: a triangle's row that is left of the frame ends before it starts, possibly below 0. The result is
        // then a range outside of any memory.
        let (start, end) = (
            first.wrapping_add(columns.start),
            first.wrapping_add(columns.end),
        );
        let range = start as usize..end as usize;
        Some(Cells {
            colors: self.colors.get_mut(range.clone())?,
            depths: if D::IS_KEPT {
                self.depths.get_mut(range)?
            } else {
                &mut []
            },
            buffer: PhantomData,
        })
    }
}

/// Pixels of a row in memory: colors and depths.
pub(crate) struct Cells<'a, C, O: Storage<C>, D> {
    colors: &'a mut [O::Cell],
    depths: &'a mut [u16],
    buffer: PhantomData<D>,
}

impl<'a, C, O: Storage<C>, D: DepthBuffer> Cells<'a, C, O, D> {
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.colors.len()
    }

    /// Splits off the first `count` pixels, or all that are left.
    #[inline]
    pub(crate) fn first(
        &mut self,
        count: usize,
    ) -> impl Iterator<Item = (&'a mut O::Cell, Option<&'a mut u16>)> + use<'a, C, O, D> {
        let (colors, depths) = (
            first(&mut self.colors, count),
            first(&mut self.depths, count),
        );
        colors.iter_mut().zip(D::each(depths))
    }
}

/// Splits off the first `count` elements of a slice, or all that are left.
#[inline]
#[allow(clippy::mut_mut)] // the slice is replaced by its rest
fn first<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let all = mem::take(slice);
    let (first, rest) = all.split_at_mut(count.min(all.len()));
    *slice = rest;
    first
}
