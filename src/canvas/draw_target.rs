//! The canvas as an embedded-graphics target: text and shapes over the picture.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::Rectangle;

use super::canvas::Canvas;
use super::depth::DepthBuffer;
use super::label::Label;
use super::storage::Storage;

impl<C, O: Storage<C>, D> Canvas<'_, C, O, D> {
    /// A label that nothing hides, at the frame's corner.
    const fn over(&mut self) -> Label<'_, Self> {
        Label::new(self, Point::zero(), u16::MAX)
    }
}

/// Drawing cannot fail. It does not touch the depth buffer, except that `clear` clears both.
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
    /// [`clipped`](embedded_graphics::draw_target::DrawTargetExt::clipped) turn a `clear` into a
    /// fill, which leaves the depth buffer alone.
    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        Canvas::clear(self, color);
        Ok(())
    }
}
