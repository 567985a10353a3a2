//! The canvas as an embedded-graphics target: text and shapes over the picture.

use core::convert::Infallible;
use core::ops::Range;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::Rectangle;

use super::canvas::Canvas;
use super::depth::DepthBuffer;
use super::storage::Storage;

/// Drawing cannot fail. It does not touch the depth buffer, except that `clear` clears both.
///
/// Any point and any rectangle is allowed, even one that reaches beyond the range of `i32`.
impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> DrawTarget for Canvas<'_, C, O, D> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        let area = self.bounding_box();
        for Pixel(point, color) in pixels {
            if area.contains(point) {
                // The area has no negative coordinates.
                let (x, y) = (point.x.cast_unsigned(), point.y.cast_unsigned());
                if let Some(pixel) = self.pixels_mut(y, &(x..x + 1)).next() {
                    O::set(pixel, color);
                }
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        let Some(inside) = self.inside(area) else {
            return Ok(());
        };
        let mut colors = colors.into_iter();
        let Margins { above, left, right } = inside.margins(area);
        skip(&mut colors, above);
        for y in inside.rows {
            skip(&mut colors, left);
            // The colors come second, so that `zip` does not consume one more than there are cells.
            for (pixel, color) in self.pixels_mut(y, &inside.columns).zip(&mut colors) {
                O::set(pixel, color);
            }
            skip(&mut colors, right);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        if let Some(inside) = self.inside(area) {
            for y in inside.rows {
                for pixel in self.pixels_mut(y, &inside.columns) {
                    O::set(pixel, color);
                }
            }
        }
        Ok(())
    }

    /// Clears the depth buffer too, as [`Canvas::clear`] does. Adapters such as
    /// [`clipped`](embedded_graphics::draw_target::DrawTargetExt::clipped) turn a `clear` into a
    /// fill, which leaves the depth buffer alone.
    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        Canvas::clear(self, color);
        Ok(())
    }
}

/// The pixels of a rectangle that a canvas has in memory.
pub(super) struct Inside {
    pub(super) columns: Range<u32>,
    pub(super) rows: Range<u32>,
}

/// How many colors of pixels outside are consumed and dropped: first for the rows above, then, row by row, for the
/// pixels on the left and on the right.
pub(super) struct Margins {
    pub(super) above: usize,
    pub(super) left: usize,
    pub(super) right: usize,
}

impl Inside {
    /// The rest of the rectangle `area`, of which this is the part in memory.
    #[inline]
    pub(super) fn margins(&self, area: &Rectangle) -> Margins {
        let above = self.rows.start.cast_signed().abs_diff(area.top_left.y) as usize;
        let left = self.columns.start.cast_signed().abs_diff(area.top_left.x) as usize;
        let width = area.size.width as usize;
        Margins {
            above: above.saturating_mul(width),
            left,
            right: width - left - self.columns.len(),
        }
    }
}

impl<C, O: Storage<C>, D> Canvas<'_, C, O, D> {
    /// The part of `area` that is in memory; `None` if it is empty.
    ///
    /// [`Rectangle::intersection`] adds a size to a corner in `i32`, which overflows for large areas.
    pub(super) fn inside(&self, area: &Rectangle) -> Option<Inside> {
        let columns = overlap(area.top_left.x, area.size.width, 0..self.frame_size().width)?;
        let rows = overlap(area.top_left.y, area.size.height, self.rows().clone())?;
        Some(Inside { columns, rows })
    }
}

/// The part of `bounds` within `length` from `start`; `None` if it is empty. `bounds` ends at 2048 or before.
fn overlap(start: i32, length: u32, bounds: Range<u32>) -> Option<Range<u32>> {
    // The end saturates at i32::MAX, which is beyond all bounds.
    let end = start.saturating_add_unsigned(length);
    let [start, end] = [start, end].map(|at| at.max(0).cast_unsigned());
    let (start, end) = (start.max(bounds.start), end.min(bounds.end));
    (start < end).then_some(start..end)
}

/// Drops the next `count` items.
pub(super) fn skip(items: &mut impl Iterator, count: usize) {
    if let Some(last) = count.checked_sub(1) {
        items.nth(last);
    }
}
