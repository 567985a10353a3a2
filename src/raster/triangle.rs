//! Triangles: which way they face, which pixels are theirs.

use super::edge::first_center;
use super::{Part, Planes, Rows, Window, align, span, varies};
use crate::geometry::{Cull, DepthShift, Projected};
use crate::interpolate::{Interpolate, Slope};
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

/// [`area`] of a triangle that is not culled and covers a pixel centre of the window; 0 of others.
///
/// A call that takes little and gives little: most triangles of a band, and the back of most things, end here.
#[inline(never)]
fn area_in(corners: &[Projected; 3], cull: Cull, window: &Window) -> i64 {
    let [a, b, c] = corners.each_ref().map(|corner| corner.screen);
    let misses = |axis: usize, window: &core::ops::Range<i32>| {
        let least = first_center(a[axis].min(b[axis]).min(c[axis]));
        let end = first_center(a[axis].max(b[axis]).max(c[axis]));
        least.max(window.start) >= end.min(window.end)
    };
    if misses(1, &window.rows) {
        return 0;
    }
    let area = area([a, b, c]);
    if cull.leaves_out(area) || misses(0, &window.columns) {
        return 0;
    }
    area
}

impl Triangle {
    /// `None` if it has no area, is culled, or covers no pixel centre of the window.
    #[inline]
    pub(crate) fn new(corners: &[Projected; 3], cull: Cull, window: &Window) -> Option<Self> {
        let area = area_in(corners, cull, window);
        if area == 0 {
            return None;
        }
        let [first, second, third] = *corners;
        let turned = area < 0;
        Some(Self {
            corners: if turned {
                [first, third, second]
            } else {
                [first, second, third]
            },
            area: area.unsigned_abs(),
            turned,
        })
    }

    /// Whether the corners as given run clockwise as seen.
    #[inline]
    pub(crate) const fn is_clockwise(&self) -> bool {
        !self.turned
    }

    /// Whether the centre of a pixel is the triangle's, by the same rule as [`Rows`] has it.
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
        (fragment, depth_shift): (&F, DepthShift),
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
        let planes = if varies::<F, D, N>() {
            let slope = Slope::new(self.corners.map(|corner| corner.screen), self.area);
            Planes::new::<I, 3>(slope, q, &varyings, Slope::plane)
        } else {
            Planes::EVEN
        };
        // The pixel that the planes are counted from.
        let [left, top] = self.corners[0].screen.map(|at| at >> 8);
        let paint = (fragment, depth_shift.of(exponent));
        for (row, columns) in self.rows(window) {
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
        }
    }

    /// Its rows in the window, each with the columns whose centres are the triangle's.
    fn rows<'w>(&self, window: &'w Window) -> Rows<'w> {
        Rows::new(self.corners.map(|corner| corner.screen), window)
    }
}
