//! The pixels that a draw call may write.

use core::ops::Range;

use crate::view::Viewport;

/// The intersection of viewport and canvas; nothing outside is drawn.
#[derive(Clone, Debug)]
pub(crate) struct Scissor {
    pub(crate) columns: Range<i32>,
    pub(crate) rows: Range<i32>,
}

impl Scissor {
    /// Intersects a viewport with `rows` of a frame of this width.
    pub(crate) fn new(viewport: &Viewport, width: u32, rows: &Range<u32>) -> Self {
        let [across, down] = viewport.pixels();
        let rows = rows.start.cast_signed()..rows.end.cast_signed();
        Self {
            columns: meet(&across, &(0..width.cast_signed())),
            rows: meet(&down, &rows),
        }
    }

    /// Whether the scissor has no pixel.
    pub(crate) fn is_empty(&self) -> bool {
        self.columns.is_empty() || self.rows.is_empty()
    }
}

/// The intersection of two ranges of pixels.
#[inline]
pub(super) fn meet(a: &Range<i32>, b: &Range<i32>) -> Range<i32> {
    a.start.max(b.start)..a.end.min(b.end)
}
