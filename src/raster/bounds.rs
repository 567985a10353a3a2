//! The smallest upright rectangle around a triangle.

use core::ops::Range;

use super::Scissor;
use super::edge::first_center;

/// The least and the greatest coordinates of corners, in units of 1/256 pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    least: [i32; 2],
    most: [i32; 2],
}

/// The guard band takes 20 bits.
const MOST: i32 = 1 << 20;

impl Bounds {
    /// Beyond all canvases: for patches that are slivers, whose size does not matter.
    pub(super) const ANY: Self = Self {
        least: [-MOST; 2],
        most: [MOST; 2],
    };

    /// The bounds of a triangle; `None` if they contain no pixel center of the scissor.
    #[inline]
    pub(super) fn in_scissor(
        &[[ax, ay], [bx, by], [cx, cy]]: &[[i32; 2]; 3],
        scissor: &Scissor,
    ) -> Option<Self> {
        let (top, bottom) = (ay.min(by).min(cy), ay.max(by).max(cy));
        // Rows first: most triangles that miss a band have none in it.
        if !meet(top, bottom, &scissor.rows) {
            return None;
        }
        let (left, right) = (ax.min(bx).min(cx), ax.max(bx).max(cx));
        meet(left, right, &scissor.columns).then_some(Self {
            least: [left, top],
            most: [right, bottom],
        })
    }

    /// Width and height, in units of 1/256 pixel.
    #[inline]
    pub(super) const fn size(&self) -> [i32; 2] {
        let ([left, top], [right, bottom]) = (self.least, self.most);
        [right - left, bottom - top]
    }

    /// The columns whose centers are inside.
    #[inline]
    pub(super) const fn columns(&self) -> Range<i32> {
        first_center(self.least[0])..first_center(self.most[0])
    }

    /// The rows whose centers are inside.
    #[inline]
    pub(super) const fn rows(&self) -> Range<i32> {
        first_center(self.least[1])..first_center(self.most[1])
    }
}

/// Whether a center between two positions is in the scissor.
#[inline]
fn meet(least: i32, most: i32, scissor: &Range<i32>) -> bool {
    first_center(least).max(scissor.start) < first_center(most).min(scissor.end)
}
