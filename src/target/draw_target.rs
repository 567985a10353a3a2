//! The canvas as an embedded-graphics target: text and shapes over the picture.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::Rectangle;

use super::canvas::Canvas;
use super::storage::Storage;

/// Drawing through embedded-graphics leaves the depth buffer as it is and cannot fail.
impl<C: PixelColor, O: Storage<C>, D> DrawTarget for Canvas<'_, C, O, D> {
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
                if let [cell] = self.cells_mut(y, &(x..x + 1)) {
                    *cell = O::store(color);
                }
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        let inside = area.intersection(&self.bounding_box());
        if inside.is_zero_sized() {
            return Ok(());
        }
        let mut colors = colors.into_iter();
        // Colours that fall outside are taken and dropped: first the rows above, then those to
        // the left and right of each row.
        let above = inside.top_left.y.abs_diff(area.top_left.y) as usize;
        let left = inside.top_left.x.abs_diff(area.top_left.x) as usize;
        let width = area.size.width as usize;
        let right = width - left - inside.size.width as usize;
        skip(&mut colors, above.saturating_mul(width));
        let columns = columns(&inside);
        for y in inside.rows() {
            skip(&mut colors, left);
            // The colours come second: `zip` must not take one more than there are cells.
            for (cell, color) in self
                .cells_mut(y.cast_unsigned(), &columns)
                .iter_mut()
                .zip(&mut colors)
            {
                *cell = O::store(color);
            }
            skip(&mut colors, right);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        let inside = area.intersection(&self.bounding_box());
        let columns = columns(&inside);
        for y in inside.rows() {
            self.cells_mut(y.cast_unsigned(), &columns)
                .fill(O::store(color));
        }
        Ok(())
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.fill_solid(&self.bounding_box(), color)
    }
}

/// The columns of a rectangle that lies within a canvas.
fn columns(inside: &Rectangle) -> core::ops::Range<u32> {
    let left = inside.top_left.x.cast_unsigned();
    left..left + inside.size.width
}

/// Drops the next `count` items.
fn skip(items: &mut impl Iterator, count: usize) {
    if let Some(last) = count.checked_sub(1) {
        items.nth(last);
    }
}
