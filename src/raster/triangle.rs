//! Triangles: which way they face, which pixels are theirs.

use super::edge::{Edge, first_center};
use super::{Part, Planes, Window, align, span, weights};
use crate::geometry::{Cull, Projected};
use crate::interpolate::{Interpolate, Slope, Weighted};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};

/// A triangle on the screen that faces the right way and may cover pixels of the window.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    /// Clockwise as seen, so that with y down the area is positive.
    corners: [Projected; 3],
    /// Twice the area, in units of (1/256 pixel)².
    area: u64,
    /// Whether the last two corners have changed places.
    turned: bool,
}

/// Twice the area of a triangle, in units of (1/256 pixel)²: positive for corners that run clockwise as seen.
#[inline]
pub(crate) fn area([a, b, c]: [[i32; 2]; 3]) -> i64 {
    let product = |x: i32, y: i32| i64::from(x) * i64::from(y);
    // Differences of 21 bits.
    product(b[0] - a[0], c[1] - a[1]) - product(c[0] - a[0], b[1] - a[1])
}

impl Triangle {
    /// `None` if it has no area, is culled, or covers no pixel centre of the window.
    #[inline]
    pub(crate) fn new(corners: [Projected; 3], cull: Cull, window: &Window) -> Option<Self> {
        let screen @ [a, b, c] = corners.map(|corner| corner.screen);
        let area = area(screen);
        let meets = |axis: usize, window: &core::ops::Range<i32>| {
            let least = a[axis].min(b[axis]).min(c[axis]);
            let most = a[axis].max(b[axis]).max(c[axis]);
            let (start, end) = (first_center(least), first_center(most));
            start.max(window.start) < end.min(window.end)
        };
        if cull.leaves_out(area) || !meets(1, &window.rows) || !meets(0, &window.columns) {
            return None;
        }
        let turned = area < 0;
        let [first, second, third] = corners;
        let corners = if turned {
            [first, third, second]
        } else {
            corners
        };
        Some(Self {
            corners,
            area: area.unsigned_abs(),
            turned,
        })
    }

    /// Whether the corners as given run clockwise as seen.
    #[inline]
    pub(crate) const fn is_clockwise(&self) -> bool {
        !self.turned
    }

    /// Whether the centre of a pixel is the triangle's, by the same rule as [`rows`](Self::rows) has it.
    pub(super) fn covers(&self, pixel: [i32; 2]) -> bool {
        let [a, b, c] = self.corners.map(|corner| corner.screen);
        let [x, y] = pixel.map(|at| (at << 8) + 128);
        [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| {
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            let product = |x: i32, y: i32| i64::from(x) * i64::from(y);
            let inside = product(dx, y - from[1]) - product(dy, x - from[0]);
            // A left edge runs up, a top edge to the right.
            inside > 0 || inside == 0 && (dy < 0 || dy == 0 && dx > 0)
        })
    }

    /// The rows that it may have pixels in, whatever the window.
    #[inline]
    pub(crate) fn row_range(&self) -> core::ops::Range<i32> {
        let [a, b, c] = self.corners.map(|corner| corner.screen[1]);
        first_center(a.min(b).min(c))..first_center(a.max(b).max(c))
    }

    /// Draws the triangle, or what `part` says is its own; `varyings` are those of the corners as
    /// they were given.
    ///
    /// A function of its own: it is the same for whole triangles and for parts of clipped ones.
    #[inline(never)]
    pub(crate) fn draw<I, F, O, D, const N: usize>(
        &self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        window: &Window,
        varyings: &[[i32; N]; 3],
        (fragment, depth_shift): (&F, impl Fn(u8) -> u32),
        part: Option<&Part<'_>>,
    ) where
        I: Interpolate,
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        let [first, second, third] = *varyings;
        let varyings = if self.turned {
            [first, third, second]
        } else {
            [first, second, third]
        };
        let (q, exponent) = align(&self.corners);
        let weighted = Weighted::new(&varyings, weights::<I, 3>(q));
        let slope = Slope::new(self.corners.map(|corner| corner.screen), self.area);
        let q = slope.plane(q.map(u32::cast_signed));
        let planes = Planes::new(slope, q, weighted.p.map(|p| slope.plane(p)), weighted.scale);
        let [left, top] = slope.origin();
        let paint = (fragment, depth_shift(exponent));
        self.rows(window, |row, columns| {
            let mut column = columns.start;
            while column < columns.end {
                let (end, own) = match part {
                    None => (columns.end, true),
                    Some(part) => (column + 1, part.has([column, row])),
                };
                if own {
                    let start = [column - left, row - top];
                    span::<I, F, O, D, N>(canvas, (row, column..end), &planes, start, paint);
                }
                column = end;
            }
        });
    }

    /// Calls `each` for every row with the columns whose centres are the triangle's.
    ///
    /// A centre on a left or top edge belongs to it, one on a right or bottom edge does not.
    #[inline]
    fn rows(&self, window: &Window, mut each: impl FnMut(i32, core::ops::Range<i32>)) {
        let [mut top, mut middle, mut bottom] = self.corners.map(|corner| corner.screen);
        // Sorting from the top; every exchange turns the triangle over.
        let mut right = true;
        if middle[1] < top[1] {
            (top, middle, right) = (middle, top, !right);
        }
        if bottom[1] < middle[1] {
            (middle, bottom, right) = (bottom, middle, !right);
            if middle[1] < top[1] {
                (top, middle, right) = (middle, top, !right);
            }
        }
        // With positive area and no exchange, the middle corner is to the right of the long edge.
        let mut long = None;
        for (from, to) in [(top, middle), (middle, bottom)] {
            let start = first_center(from[1]).max(window.rows.start);
            let end = first_center(to[1]).min(window.rows.end);
            if start >= end {
                continue;
            }
            let Some(mut side) = Edge::new(from, to, start) else {
                continue;
            };
            let Some(mut other) = long.take().or_else(|| Edge::new(top, bottom, start)) else {
                continue;
            };
            for row in start..end {
                let (left, end) = if right {
                    (other.column(), side.column())
                } else {
                    (side.column(), other.column())
                };
                let columns = left.max(window.columns.start)..end.min(window.columns.end);
                if !columns.is_empty() {
                    each(row, columns);
                }
                side.step();
                other.step();
            }
            long = Some(other);
        }
    }
}
