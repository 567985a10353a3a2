//! Labels: text and shapes at a place and a depth of the picture.

use core::convert::Infallible;
use core::ops::Range;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::Rectangle;

use super::canvas::Canvas;
use super::depth::DepthBuffer;
use super::draw_target::{draw_target, moved, plus, skip, wide};
use super::storage::Storage;

/// A canvas as an embedded-graphics [`DrawTarget`] whose origin is a point of the scene, and whose pixels are hidden by
/// nearer surfaces; [`Canvas::label`] makes it.
///
/// Everything drawn to it has the point's depth, so it looks like a sheet of paper that faces the viewer. A pixel is
/// drawn if it is at least as near as the stored depth; the stored depth does not change. On a canvas without a depth
/// buffer, every pixel is drawn.
///
/// Drawing cannot fail. Any point and any rectangle is allowed. `clear` fills every pixel that the scene does not hide.
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
    /// Draws the pixels of `columns` of `row` that are not hidden.
    fn draw_row(&mut self, row: u32, columns: &Range<u32>, colors: impl Iterator<Item = C>) {
        let depth = u32::from(self.depth);
        let Some(mut cells) = self.canvas.cells(row, columns.clone()) else {
            return;
        };
        let count = cells.len();
        // The colors come second, so that `zip` does not consume one more than there are cells.
        for ((cell, stored), color) in cells.first(count).zip(colors) {
            if D::passes(&stored, depth) {
                O::set(cell, color);
            }
        }
    }
}

impl<C, O: Storage<C>, D> Dimensions for Label<'_, Canvas<'_, C, O, D>> {
    /// The part of the frame that is in memory, as seen from the label's origin.
    fn bounding_box(&self) -> Rectangle {
        let Rectangle { top_left, size } = self.canvas.bounding_box();
        let Point { x, y } = self.origin;
        Rectangle::new(
            Point::new(top_left.x.saturating_sub(x), top_left.y.saturating_sub(y)),
            size,
        )
    }
}

draw_target!(Label<'_, Canvas<'_, C, O, D>>, in canvas at origin);
