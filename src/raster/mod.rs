//! From a primitive on the screen to runs of pixels.

mod brush;
mod edge;
mod fan;
mod line;
mod planes;
mod point;
mod triangle;

use core::ops::Range;

use crate::view::Viewport;

pub(crate) use brush::{Brush, Paint};
pub(crate) use fan::Fan;
pub(crate) use line::line;
pub(crate) use point::point;
pub(crate) use triangle::{Triangle, area};

/// The part of the canvas that may be drawn into; nothing outside is.
#[derive(Clone, Debug)]
pub(crate) struct Window {
    pub(crate) columns: Range<i32>,
    pub(crate) rows: Range<i32>,
}

impl Window {
    /// Where a viewport and `rows` of a frame so wide meet.
    pub(crate) fn new(viewport: &Viewport, width: u32, rows: &Range<u32>) -> Self {
        let [across, down] = viewport.pixels();
        let meet = |a: Range<i32>, start: u32, end: u32| {
            a.start.max(start.cast_signed())..a.end.min(end.cast_signed())
        };
        Self {
            columns: meet(across, 0, width),
            rows: meet(down, rows.start, rows.end),
        }
    }
}
