//! A triangle's edge, row by row.

use core::hint::black_box;
use core::num::NonZeroU32;

use crate::num::wide::{DIVIDES, divide};

/// The first column whose center is on an edge or to the right of it, stepped exactly from row to row.
///
/// That column is the integer part of a rational number, `column` + 1 + `part` / `height`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    column: i32,
    /// The range is -`height` to -1. When a step makes `part` 0 or more, the edge has reached the next column.
    part: i32,
    /// The rational number grows by `step` + `rest` / `height` for each row.
    step: i32,
    rest: i32,
    /// The edge's height, in units of 1/256 pixel. `rest` is from 0 to `height` − 1.
    height: i32,
}

/// The first row (or column) whose center is at or after a position in units of 1/256 pixel.
///
/// A center exactly at the position counts, so exactly one of two triangles that adjoin there covers it.
#[inline]
pub(crate) const fn first_center(position: i32) -> i32 {
    (position + 127) >> 8
}

impl Edge {
    /// The edge from [x, y] down to `to`, ready for `row`.
    ///
    /// The ends differ by at most 4096 pixels in each direction, and the edge crosses the center of `row`, so
    /// everything fits in 32 bits. For an edge that crosses no center, the result is meaningless.
    #[inline]
    pub(super) fn new([x, y]: [i32; 2], to: [i32; 2], row: i32) -> Self {
        let height = (to[1] - y).max(1);
        let (step, rest) = divide(to[0] - x, height);
        // The edge crosses the first row's centers, `down` < 256 units below the upper end, at x + step · down + rest ·
        // down / height. The first column is this crossing plus half a pixel minus the least fraction, rounded down.
        let first = first_center(y);
        let down = (first << 8) + 128 - y;
        let x = x + 128 + step * down;
        // The sum is in units of 1 / (256 · height) pixel. Its last 8 bits never change from row to row, so they are
        // cut. `part` is then from -1 to below 2 · height.
        let part = ((x & 255) * height + rest * down - 1) >> 8;
        let mut edge = Self {
            column: x >> 8,
            part,
            step,
            rest,
            height,
        };
        if part < 0 {
            edge.part += height;
            edge.column -= 1;
        } else if part >= height {
            edge.part -= height;
            edge.column += 1;
        }
        let skipped = row - first;
        if skipped > 0 {
            edge.skip(skipped);
        }
        // So far, `part` is from 0 to `height` − 1. In the field, it is less by `height`. The edge starts one row back,
        // because `next` moves on before it returns a column.
        edge.column -= step;
        edge.part -= rest + height;
        edge
    }

    /// Skips rows above the scissor, such as the rows of earlier bands: at most 4095 rows, each with a rest below 2^20.
    #[inline]
    fn skip(&mut self, rows: i32) {
        let height = NonZeroU32::new(self.height.cast_unsigned()).unwrap_or(NonZeroU32::MIN);
        let moved = rows.wrapping_mul(self.rest).wrapping_add(self.part);
        let moved = moved.cast_unsigned();
        self.column += rows * self.step + (moved / height).cast_signed();
        self.part = (moved % height).cast_signed();
    }

    /// Moves to the next row, at first to the row given to `new`, and returns the first column whose center is on the
    /// edge or to the right of it.
    #[inline]
    pub(super) fn next(&mut self) -> i32 {
        self.column += self.step;
        self.part += self.rest;
        if self.part >= 0 {
            // This line keeps the compiler from computing both cases, because a small core has too few registers for
            // both.
            black_box(());
            self.part -= self.height;
            self.column += 1;
        }
        self.column
    }

    /// Does the same as [`next`](Self::next). Also returns how far the column's center is from the edge, in 256ths of a
    /// pixel, rounded down: 0 to 256. `share` is 2^30 divided by the edge's height, rounded down.
    #[inline]
    pub(super) fn next_with_distance(&mut self, share: i32) -> (i32, i32) {
        let column = self.next();
        (column, (-self.part * share) >> 22)
    }
}

/// An [`Edge`] of less than 128 columns and rows, in fixed point, for cores that divide fast. A row takes 6
/// instructions, not the 10 of an [`Edge`].
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortEdge {
    /// The crossing plus half a pixel minus [`BELOW`], in units of 2^-32 pixel. The upper 32 bits are the first column
    /// with its center on the crossing or to the right of it.
    x: i64,
    step: i64,
}

/// Limit for the sides of a short edge, in units of 1/256 pixel.
const SHORT: i32 = 128 << 8;

/// The number by which `x` of a short edge is too small at the start, in units of 2^-32 pixel: half of the greatest
/// number that is allowed.
///
/// Let dx and dy be the sides of the edge. A crossing is a multiple of 1 / (256 · dy) pixel, which is more than 2^9
/// units. So `x` must be too small by at least one unit, and by less than 2^9 units: then a center on the crossing
/// counts. Rounding changes `x` by at most 129 units: by less than a unit for each row, because the step is rounded,
/// and by one unit more.
const BELOW: u32 = 1 << 8;

/// A number of 64 bits from its halves.
#[inline]
const fn join(upper: i32, lower: i32) -> i64 {
    (upper as i64) << 32 | lower.cast_unsigned() as i64
}

impl ShortEdge {
    /// Whether the edges of a triangle of this width and height are short.
    #[inline]
    pub(super) const fn fits(width: i32, height: i32) -> bool {
        DIVIDES && width | height < SHORT
    }

    /// The edge from [x, y] down to `to`, ready for `row`. The edge must cross the center of `row`. `None` if the edge
    /// is level.
    #[inline]
    pub(super) fn new([x, y]: [i32; 2], to: [i32; 2], row: i32) -> Option<Self> {
        let (dx, dy) = (to[0] - x, to[1] - y);
        if dy <= 0 {
            return None;
        }
        // step = 2^32 · dx / dy, rounded toward zero, 16 bits at a time.
        let size = dx << 16;
        let upper = size / dy;
        let lower = ((size - upper * dy) << 16) / dy;
        let step = join(upper >> 16, upper << 16).wrapping_add(lower.into());
        // `start` is 2^8 · (x · 2^24 + 2^31 - BELOW). To this, the change from the upper end down to the center of the
        // row is added.
        let down = ((row << 8) + 128 - y).cast_unsigned();
        let start = join(x + 127, -(BELOW << 8).cast_signed());
        let x = start.wrapping_add(step.wrapping_mul(down.into())) >> 8;
        // The edge starts one row back, as in `Edge::new`.
        let x = x.wrapping_sub(step);
        Some(Self { x, step })
    }

    /// The same as [`Edge::next`].
    #[inline]
    pub(super) const fn next(&mut self) -> i16 {
        self.x = self.x.wrapping_add(self.step);
        (self.x >> 32) as i16
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{cases, within};
    use rand::Rng;

    /// The height of an edge, and the x at which the edge crosses the centers of a row, times the height.
    fn crossing(from: [i32; 2], to: [i32; 2], row: i32) -> (i64, i64) {
        let [[x0, y0], [x1, y1]] = [from, to].map(|end| end.map(i64::from));
        let height = y1 - y0;
        (
            height,
            x0 * height + (256 * i64::from(row) + 128 - y0) * (x1 - x0),
        )
    }

    /// The first column whose center is on the rational crossing or to the right of it.
    fn column(from: [i32; 2], to: [i32; 2], row: i32) -> i64 {
        let (height, crossing) = crossing(from, to, row);
        // Rounded up.
        -(128 * height - crossing).div_euclid(256 * height)
    }

    /// Compares all rows of a short edge with the rational crossing, for edges that start at the first row or at any
    /// other row.
    fn check_short(from: [i32; 2], to: [i32; 2]) {
        let rows = first_center(from[1])..first_center(to[1]);
        if rows.is_empty() {
            return;
        }
        let mut edge = ShortEdge::new(from, to, rows.start).unwrap();
        for row in rows {
            let expected = column(from, to, row);
            assert_eq!(i64::from(edge.next()), expected, "{from:?} {to:?} {row}");
            let mut begun = ShortEdge::new(from, to, row).unwrap();
            assert_eq!(i64::from(begun.next()), expected, "{from:?} {to:?} {row}");
        }
    }

    #[test]
    fn short_edges_are_exact() {
        cases(4000, |random| {
            let from = within(random, [-2048 << 8..2048 << 8, -2048 << 8..2048 << 8]);
            let dx = random.random_range(-SHORT..SHORT);
            let dy = random.random_range(1_i32..SHORT);
            let size = random.random_range(0_u32..15);
            let [x, y] = from;
            check_short(from, [x + dx, y + dy]);
            // Many small edges, and edges that cross a row at a center or near it.
            let (dx, dy) = (dx >> size, i32::max(dy >> size, 1));
            check_short(from, [x + dx, y + dy]);
            let from = from.map(|at| at & !255 | 128);
            check_short(from, from.map(|at| at + (dy & !255).max(256)));
            check_short(from, [from[0] + dx, from[1] + (dy & !255).max(256)]);
        });
    }

    /// Tests sizes just inside and just outside of the limit.
    #[test]
    fn edges_of_up_to_128_pixels_are_short() {
        assert!(ShortEdge::fits(SHORT - 1, SHORT - 1));
        assert!(!ShortEdge::fits(SHORT, 1) && !ShortEdge::fits(1, SHORT));
    }

    /// Compares every row of every edge with the rational crossing, for every row at which the edge may start.
    #[test]
    fn crossings_are_exact() {
        let ends = [
            -524_288, -70_001, -300, -257, -1, 0, 1, 127, 128, 129, 255, 256, 1000, 90_003, 524_287,
        ];
        for x0 in ends {
            for x1 in ends {
                for y0 in [-300, -129, -128, -127, 0, 5] {
                    for y1 in [-100, 1, 127, 128, 129, 1500] {
                        if y1 <= y0 {
                            continue;
                        }
                        let rows = first_center(y0)..first_center(y1);
                        for start in rows.clone() {
                            let mut edge = Edge::new([x0, y0], [x1, y1], start);
                            for row in start..rows.end {
                                let expected = column([x0, y0], [x1, y1], row);
                                assert_eq!(i64::from(edge.next()), expected);
                            }
                        }
                    }
                }
            }
        }
    }
}
