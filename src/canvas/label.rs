//! The canvas as an embedded-graphics target: text and shapes over the picture, or at a point of the scene.

use core::convert::Infallible;
use core::iter;
use core::ops::Range;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::{Drawable, Pixel};

use super::canvas::Canvas;
use super::depth::DepthBuffer;
use super::storage::Storage;
use crate::num::wide::at_least;

/// An embedded-graphics [`DrawTarget`](DrawTarget) that draws on a canvas, with its origin at a point of the scene.
/// Surfaces nearer than this point hide the label's pixels. [`Canvas::label`] makes a label.
#[doc(hidden)]
#[derive(Debug)]
pub struct Label<'c, T> {
    canvas: &'c mut T,
    origin: Point,
    depth: u16,
}

impl<'c, T> Label<'c, T> {
    pub(crate) const fn new(canvas: &'c mut T, origin: Point, depth: u16) -> Self {
        Self {
            canvas,
            origin,
            depth,
        }
    }
}

impl<C, O: Storage<C>, D: DepthBuffer> Label<'_, Canvas<'_, C, O, D>> {
    /// Draws the pixels of a row of the frame that are in `columns` and not hidden.
    fn draw_row(&mut self, row: u32, columns: &Range<u32>, colors: impl Iterator<Item = C>) {
        let Some(mut cells) = self.canvas.memory().cells(row, columns.clone()) else {
            return;
        };
        // The colors come second, so that `zip` does not consume one color more than there are cells.
        for ((cell, depth), color) in cells.first(usize::MAX).zip(colors) {
            let is_seen = |stored: &mut u16| at_least(self.depth.into(), *stored);
            // Nothing is nearer than the greatest depth, so the stored depth is not read.
            if self.depth == u16::MAX || depth.is_none_or(is_seen) {
                *cell = O::store(color);
            }
        }
    }

    /// The columns and rows of the frame where a rectangle's pixels are in memory, and the rectangle's top left corner
    /// in the frame; `None` if no pixel is in memory.
    ///
    /// [`Rectangle::intersection`] adds a size to a corner in `i32`, which overflows for large areas. In 32 bits, the
    /// corner's place in the frame could also saturate, which would move the rectangle's other side. So this function
    /// computes in 64 bits.
    fn inside(&self, area: &Rectangle) -> Option<(Range<u32>, Range<u32>, [i64; 2])> {
        let (Point { x, y }, Point { x: u, y: v }) = (area.top_left, self.origin);
        let corner @ [x, y] =
            [[x, u], [y, v]].map(|[at, origin]| i64::from(at) + i64::from(origin));
        let columns = overlap(x, area.size.width, 0..self.canvas.frame_size().width)?;
        let rows = overlap(y, area.size.height, self.canvas.rows().clone())?;
        Some((columns, rows, corner))
    }
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> DrawTarget for Label<'_, Canvas<'_, C, O, D>> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let area = self.canvas.bounding_box();
        for Pixel(Point { x, y }, color) in pixels {
            // A saturated point stays outside of all frames.
            let [x, y] = [
                x.saturating_add(self.origin.x),
                y.saturating_add(self.origin.y),
            ];
            if area.contains(Point::new(x, y)) {
                // No point in the area has a negative coordinate.
                let (x, y) = (x.cast_unsigned(), y.cast_unsigned());
                self.draw_row(y, &(x..x + 1), iter::once(color));
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        let Some((columns, rows, [x, y])) = self.inside(area) else {
            return Ok(());
        };
        let mut colors = colors.into_iter();
        // The colors of pixels outside are consumed and dropped: first the colors of the rows above, then, row by row,
        // the colors on the left and on the right.
        let outside = |start: u32, of: i64| (i64::from(start) - of).cast_unsigned() as usize;
        let (width, left) = (area.size.width as usize, outside(columns.start, x));
        let right = width - left - columns.len();
        skip(&mut colors, outside(rows.start, y).saturating_mul(width));
        for row in rows {
            skip(&mut colors, left);
            self.draw_row(row, &columns, &mut colors);
            skip(&mut colors, right);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        if let Some((columns, rows, _)) = self.inside(area) {
            for row in rows {
                self.draw_row(row, &columns, iter::repeat(color));
            }
        }
        Ok(())
    }
}

impl<C, O: Storage<C>, D> Dimensions for Label<'_, Canvas<'_, C, O, D>> {
    /// The part of the frame that is in memory, as seen from the label's origin.
    fn bounding_box(&self) -> Rectangle {
        let Rectangle { top_left, size } = self.canvas.bounding_box();
        let Point { x, y } = self.origin;
        let top_left = Point::new(top_left.x.saturating_sub(x), top_left.y.saturating_sub(y));
        Rectangle::new(top_left, size)
    }
}

impl<C, O: Storage<C>, D> Canvas<'_, C, O, D> {
    /// Draws text, a shape or an image of embedded-graphics over the picture, unless its bounding box misses the rows
    /// in memory.
    ///
    /// The result is the same as with `thing.draw(&mut canvas)`, but `overlay` saves time when you draw in bands.
    /// `draw` computes all pixels of a text in every band; `overlay` computes the pixels only in the bands that show
    /// part of the text. Pixels that `thing` draws outside its bounding box may be missing.
    ///
    /// ```
    /// use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use embedded_graphics::{geometry::Point, text::Text};
    /// use fixel::prelude::*;
    ///
    /// let text = Text::new("fixel", Point::new(2, 9), MonoTextStyle::new(&FONT_6X10, Gray8::WHITE));
    /// let mut pixels = [Gray8::BLACK; 40 * 8];
    /// for first_row in [0, 8, 16, 24] {
    ///     let mut band = Canvas::band(&mut pixels, 40, 32, first_row)?;
    ///     band.clear(Gray8::BLACK);
    ///     band.overlay(&text);
    ///     let is_shown = band.pixels().any(|pixel| pixel == Gray8::WHITE);
    ///     assert_eq!(is_shown, first_row < 16);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn overlay<T>(&mut self, thing: &T)
    where
        C: PixelColor,
        D: DepthBuffer,
        T: Drawable<Color = C> + Dimensions,
    {
        if self.over().inside(&thing.bounding_box()).is_some() {
            let Ok(_) = thing.draw(self);
        }
    }

    /// A label with its origin at the frame's top left corner. Nothing hides it.
    const fn over(&mut self) -> Label<'_, Self> {
        Label::new(self, Point::zero(), u16::MAX)
    }
}

/// Drawing cannot fail. Drawing does not change the depth buffer, except that `clear` clears both colors and depths.
///
/// Any point and any rectangle is allowed, even one that reaches beyond the range of `i32`.
impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> DrawTarget for Canvas<'_, C, O, D> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.over().draw_iter(pixels)
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        self.over().fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.over().fill_solid(area, color)
    }

    /// Clears the depth buffer too, as [`Canvas::clear`] does. Adapters such as
    /// [`clipped`](embedded_graphics::draw_target::DrawTargetExt::clipped) turn a `clear` into a fill, which does not
    /// change the depth buffer.
    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        Canvas::clear(self, color);
        Ok(())
    }
}

/// The part of `bounds` from `start` to `start` + `length`; `None` if this part is empty. `bounds` ends at 2048 or
/// before.
fn overlap(start: i64, length: u32, bounds: Range<u32>) -> Option<Range<u32>> {
    let end = start + i64::from(length);
    let inside = |at: i64| {
        let inside = at.max(bounds.start.into()).min(bounds.end.into());
        inside.cast_unsigned() as u32
    };
    let (start, end) = (inside(start), inside(end));
    (start < end).then_some(start..end)
}

/// Drops the next `count` items.
fn skip(items: &mut impl Iterator, count: usize) {
    if let Some(last) = count.checked_sub(1) {
        items.nth(last);
    }
}
