//! The canvas as an embedded-graphics target: text and shapes over the picture.

use core::convert::Infallible;
use core::ops::Range;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::Rectangle;

use super::canvas::Canvas;
use super::depth::DepthBuffer;
use super::storage::Storage;

/// Makes a canvas, or a type that holds a canvas and its own origin, a [`DrawTarget`] that draws row by row. Its
/// `draw_row` sets pixels of a row of the frame to colors.
macro_rules! draw_target {
    ($(#[$doc:meta])* $Target:ty $(, in $canvas:ident at $origin:ident)? $(; $clear:item)?) => {
        $(#[$doc])*
        impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> DrawTarget for $Target {
            type Color = C;
            type Error = Infallible;

            fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
                let area = self$(.$canvas)?.bounding_box();
                for Pixel(point, color) in pixels {
                    $(let point = moved(point, self.$origin);)?
                    if area.contains(point) {
                        // The area has no negative coordinates.
                        let (x, y) = (point.x.cast_unsigned(), point.y.cast_unsigned());
                        self.draw_row(y, &(x..x + 1), core::iter::once(color));
                    }
                }
                Ok(())
            }

            fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
            where
                I: IntoIterator<Item = C>,
            {
                let (Rectangle { top_left, size }, mut colors) = (*area, colors.into_iter());
                let corner = wide(top_left);
                $(let corner = plus(corner, wide(self.$origin));)?
                let Some(inside) = self$(.$canvas)?.inside(corner, size) else {
                    return Ok(());
                };
                // The colors of pixels outside are consumed and dropped: first those of the rows above, then, row by
                // row, those on the left and on the right.
                let outside = |start: u32, of: i64| (i64::from(start) - of).cast_unsigned() as usize;
                let (width, left) = (size.width as usize, outside(inside.columns.start, corner[0]));
                let right = width - left - inside.columns.len();
                let above = outside(inside.rows.start, corner[1]);
                skip(&mut colors, above.saturating_mul(width));
                for y in inside.rows {
                    skip(&mut colors, left);
                    self.draw_row(y, &inside.columns, &mut colors);
                    skip(&mut colors, right);
                }
                Ok(())
            }

            fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
                let Rectangle { top_left, size } = *area;
                let corner = wide(top_left);
                $(let corner = plus(corner, wide(self.$origin));)?
                if let Some(inside) = self$(.$canvas)?.inside(corner, size) {
                    for y in inside.rows {
                        self.draw_row(y, &inside.columns, core::iter::repeat(color));
                    }
                }
                Ok(())
            }

            $($clear)?
        }
    };
}
pub(super) use draw_target;

draw_target!(
    /// Drawing cannot fail. It does not touch the depth buffer, except that `clear` clears both.
    ///
    /// Any point and any rectangle is allowed, even one that reaches beyond the range of `i32`.
    Canvas<'_, C, O, D>;
    /// Clears the depth buffer too, as [`Canvas::clear`] does. Adapters such as
    /// [`clipped`](embedded_graphics::draw_target::DrawTargetExt::clipped) turn a `clear` into a
    /// fill, which leaves the depth buffer alone.
    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        Canvas::clear(self, color);
        Ok(())
    }
);

/// The pixels of a rectangle that a canvas has in memory.
pub(super) struct Inside {
    pub(super) columns: Range<u32>,
    pub(super) rows: Range<u32>,
}

impl<C, O: Storage<C>, D> Canvas<'_, C, O, D> {
    fn draw_row(&mut self, row: u32, columns: &Range<u32>, colors: impl Iterator<Item = C>) {
        // The colors come second, so that `zip` does not consume one more than there are cells.
        for (pixel, color) in self.pixels_mut(row, columns).zip(colors) {
            O::set(pixel, color);
        }
    }

    /// The part of a rectangle that is in memory; `None` if it is empty.
    ///
    /// [`Rectangle::intersection`] adds a size to a corner in `i32`, which overflows for large areas.
    pub(super) fn inside(&self, [x, y]: [i64; 2], size: Size) -> Option<Inside> {
        let columns = overlap(x, size.width, 0..self.frame_size().width)?;
        let rows = overlap(y, size.height, self.rows().clone())?;
        Some(Inside { columns, rows })
    }
}

/// The part of `bounds` within `length` from `start`; `None` if it is empty. `bounds` ends at 2048 or before.
fn overlap(start: i64, length: u32, bounds: Range<u32>) -> Option<Range<u32>> {
    let end = start + i64::from(length);
    let inside = |at: i64| {
        let inside = at.max(bounds.start.into()).min(bounds.end.into());
        inside.cast_unsigned() as u32
    };
    let (start, end) = (inside(start), inside(end));
    (start < end).then_some(start..end)
}

/// The corner of a rectangle. In 32 bits, its place in the frame would saturate, and the rectangle would reach as far
/// beyond its other side.
pub(super) fn wide(Point { x, y }: Point) -> [i64; 2] {
    [x.into(), y.into()]
}

pub(super) const fn plus([x, y]: [i64; 2], [u, v]: [i64; 2]) -> [i64; 2] {
    [x + u, y + v]
}

/// A point plus an offset; saturates, which leaves it outside of all frames.
pub(super) const fn moved(point: Point, by: Point) -> Point {
    Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y))
}

/// Drops the next `count` items.
pub(super) fn skip(items: &mut impl Iterator, count: usize) {
    if let Some(last) = count.checked_sub(1) {
        items.nth(last);
    }
}
