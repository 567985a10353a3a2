//! A clipped triangle as a fan of triangles.

use core::ops::Range;

use heapless::Vec;

use super::{Triangle, Window, area};
use crate::geometry::{Cull, MOST_CORNERS, Projected, Weights};

/// The triangles that a clipped one is drawn as.
#[derive(Debug)]
pub(crate) struct Fan {
    /// Those that may have pixels, and where their corners lie in the whole.
    triangles: Vec<(Triangle, [Weights; 3]), { MOST_CORNERS - 2 }>,
    /// Twice the area of the outline, positive if it runs clockwise as seen.
    area: i64,
}

/// One triangle of a fan, where rounding has turned some of them over.
///
/// The outline is convex but for the rounding of its corners; where that made it cross itself or
/// dented it, triangles of the fan turn over and lie upon others. A pixel is the outline's if it
/// is in more of them that run clockwise as the whole than in those that do not, and then the
/// first of those draws it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<'a> {
    fan: &'a Fan,
    at: usize,
}

impl Fan {
    /// The fan of an outline, as far as it may cover pixels of the window.
    pub(crate) fn new(outline: &[(Projected, Weights)], window: &Window) -> Self {
        let mut fan = Self {
            triangles: Vec::new(),
            area: 0,
        };
        let mut corners = outline.iter();
        let (Some(first), Some(mut from)) = (corners.next(), corners.next()) else {
            return fan;
        };
        for to in corners {
            let part = [first, from, to];
            let projected = part.map(|corner| corner.0);
            fan.area += area(projected.map(|corner| corner.screen));
            if let Some(triangle) = Triangle::new(&projected, Cull::Nothing, window) {
                // There is room.
                let _ = fan.triangles.push((triangle, part.map(|corner| corner.1)));
            }
            from = to;
        }
        fan
    }

    /// Twice the area of the outline, positive if it runs clockwise as seen.
    pub(crate) const fn area(&self) -> i64 {
        self.area
    }

    /// The rows that it may have pixels in; `None` if it has none.
    pub(crate) fn row_range(&self) -> Option<Range<i32>> {
        let rows = self.triangles.iter().map(|(part, _)| part.row_range());
        rows.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end))
    }

    /// The triangles to be drawn, and where in the whole their corners are; with a [`Part`] if not all of their pixels
    /// are theirs.
    pub(crate) fn parts(
        &self,
    ) -> impl Iterator<Item = (&Triangle, &[Weights; 3], Option<Part<'_>>)> {
        let runs_as_whole = |triangle: &Triangle| triangle.is_clockwise() == (self.area > 0);
        let folded = !self.triangles.iter().all(|part| runs_as_whole(&part.0));
        self.triangles
            .iter()
            .enumerate()
            .filter(move |(_, part)| runs_as_whole(&part.0))
            .map(move |(at, (triangle, corners))| {
                let part = Part { fan: self, at };
                (triangle, corners, folded.then_some(part))
            })
    }
}

impl Part<'_> {
    /// Whether this triangle is to draw a pixel.
    pub(super) fn has(&self, pixel: [i32; 2]) -> bool {
        let mut winding = 0;
        for (i, (triangle, _)) in self.fan.triangles.iter().enumerate() {
            if triangle.covers(pixel) {
                if triangle.is_clockwise() != (self.fan.area > 0) {
                    winding -= 1;
                } else if i < self.at {
                    return false;
                } else {
                    winding += 1;
                }
            }
        }
        winding > 0
    }
}
