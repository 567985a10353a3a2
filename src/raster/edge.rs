//! A triangle's edge, row by row.

use core::num::NonZeroU32;

use crate::num::wide::{DIVIDES, times_short};

/// Where an edge crosses the centers of rows, stepped exactly from row to row.
///
/// Positions are in units of 1/256 pixel. The crossing is the rational number `x` − 127 − `deficit` / `dy`, where
/// 0 ≤ `deficit` / `dy` < 1. So `x` is its ceiling plus the 127 that [`first_center`] adds, and rounding to pixels is
/// exact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    x: i32,
    deficit: i32,
    /// The crossing moves right by `step` + `remainder` / `dy` for each row.
    step: i32,
    remainder: i32,
    dy: i32,
}

/// The first row (or column) whose center is at or after a position in units of 1/256 pixel.
///
/// A center exactly at the position counts. So of two triangles that adjoin there, exactly one covers it.
#[inline]
pub(super) const fn first_center(position: i32) -> i32 {
    (position + 127) >> 8
}

impl Edge {
    /// The edge from `from` down to `to`, at `row`.
    ///
    /// The ends differ by at most 4096 pixels in each direction, and the edge crosses the center of `row`, so
    /// everything fits in 32 bits. For an edge that crosses no center, the result is meaningless.
    #[inline]
    pub(super) fn new(from: [i32; 2], to: [i32; 2], row: i32) -> Self {
        let dx = to[0] - from[0];
        let dy = NonZeroU32::new((to[1] - from[1]).cast_unsigned()).unwrap_or(NonZeroU32::MIN);
        // step = floor(256 · dx / dy). A negative numerator n is divided by way of its complement:
        // floor(n / d) = !floor(!n / d).
        let sign = dx >> 31;
        let size = ((dx ^ sign).cast_unsigned() << 8) | (sign & 255).cast_unsigned();
        let (quotient, remainder) = (size / dy, size % dy);
        let (step, remainder) = (
            quotient.cast_signed() ^ sign,
            if sign < 0 {
                dy.get() - 1 - remainder
            } else {
                remainder
            },
        );

        // The first center is `down` < 256 units below `from`, and the edge moves by dx · down / dy on the way there.
        // `moved` = floor(step · down / 256) is less than 2 units below that: the rounding of `step` takes less than
        // one unit, and the floor less than another. So `deficit` = moved · dy − dx · down is above −2 · dy and at
        // most 0, which is correct even if the products wrap, and at most two corrections bring it to 0..dy.
        let first = first_center(from[1]);
        let down = (first << 8) + 128 - from[1];
        let moved = (step >> 8) * down + (((step & 255) * down) >> 8);
        let height = dy.get().cast_signed();
        let (mut x, mut deficit) = (
            from[0] + 127 + moved,
            moved
                .wrapping_mul(height)
                .wrapping_sub(dx.wrapping_mul(down)),
        );
        for _ in 0..2 {
            if deficit < 0 {
                deficit += height;
                x += 1;
            }
        }
        let mut edge = Self {
            x,
            deficit,
            step,
            remainder: remainder.cast_signed(),
            dy: height,
        };

        let skipped = (row - first).cast_unsigned();
        if skipped > 0 {
            // Skips rows above the scissor, such as those of earlier bands: at most 4095, each with a remainder below
            // 2^20.
            let moved = skipped.wrapping_mul(remainder);
            let units = skipped.cast_signed() * step + (moved / dy).cast_signed();
            edge.add(units, (moved % dy).cast_signed());
        }
        edge
    }

    /// Moves the crossing right by `units` + `remainder` / `dy`, where `remainder` < `dy`.
    #[inline]
    const fn add(&mut self, units: i32, remainder: i32) {
        self.x += units;
        self.deficit -= remainder;
        if self.deficit < 0 {
            self.deficit += self.dy;
            self.x += 1;
        }
    }

    /// Goes to the next row.
    #[inline]
    pub(super) const fn step(&mut self) {
        self.add(self.step, self.remainder);
    }

    /// The first column whose center is on the crossing or to the right of it.
    #[inline]
    pub(super) const fn column(&self) -> i32 {
        self.x >> 8
    }

    /// The column that contains the crossing.
    #[inline]
    pub(super) const fn inside(&self) -> i32 {
        // The floor is one less than the ceiling unless the crossing is a whole number.
        (self.x - 127 - (self.deficit != 0) as i32) >> 8
    }
}

/// An [`Edge`] of less than 128 columns and rows in fixed point, which takes half as long.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortEdge {
    /// The crossing plus half a pixel and less [`BELOW`], in units of 2^-32 pixel: the upper half is the first column
    /// whose center is on the crossing or to the right of it.
    x: i64,
    step: i64,
}

/// Limit for the sides of a short edge, in units of 1/256 pixel.
const SHORT: i32 = 128 << 8;

/// Half of what a short edge may be below its crossing.
///
/// Let dx and dy be its sides. A crossing is a multiple of 1 / (256 · dy) pixel, which is more than 2^9 units of
/// 2^-32 pixel. So it may be less than 2^9 units below the crossing, and, for a center on it, must be below by at
/// least a unit. The step has an error of less than a unit, and the crossing one of less than a unit for each row
/// and one more: at most 129 units.
const BELOW: u32 = 1 << 8;

impl ShortEdge {
    /// The edge from `from` down to `to`, at `row`, whose center it crosses; `None` if it is too long.
    #[inline]
    pub(super) fn new([x, y]: [i32; 2], to: [i32; 2], row: i32) -> Option<Self> {
        let (dx, dy) = (to[0] - x, to[1] - y);
        let raised = (dx + SHORT).cast_unsigned();
        if !DIVIDES || (raised | dy.cast_unsigned() << 1) >= 2 * SHORT.cast_unsigned() {
            return None;
        }
        // step = 2^32 · dx / dy, rounded towards zero, 16 bits at a time.
        let dy = dy.max(1);
        let (size, down) = (dx << 16, (row << 8) + 128 - y);
        let quotient = size / dy;
        let lower = ((size - quotient * dy) << 16) / dy;
        let step = (i64::from(quotient) << 16) + i64::from(lower);
        let moved = times_short(step, down) >> 8;
        // (x · 2^24 + 2^31 - BELOW) in halves.
        let x = x + 127;
        let lower = (x << 24).cast_unsigned() | ((1 << 24) - BELOW);
        let start = (i64::from(x >> 8) << 32) | i64::from(lower);
        Some(Self {
            x: start.wrapping_add(moved),
            step,
        })
    }

    /// The first column whose center is on the crossing or to the right of it.
    #[inline]
    pub(super) const fn column(&self) -> i16 {
        (self.x >> 32) as i16
    }

    /// Goes to the next row.
    #[inline]
    pub(super) const fn step(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The height of an edge, and the height times its crossing of a row.
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

    /// Compares all rows of a short edge with the rational crossing, from its first row on and from any other.
    fn check_short(from: [i32; 2], to: [i32; 2]) {
        let rows = first_center(from[1])..first_center(to[1]);
        if rows.is_empty() {
            return;
        }
        let mut edge = ShortEdge::new(from, to, rows.start).unwrap();
        for row in rows {
            let expected = column(from, to, row);
            assert_eq!(i64::from(edge.column()), expected, "{from:?} {to:?} {row}");
            let begun = ShortEdge::new(from, to, row).unwrap();
            assert_eq!(i64::from(begun.column()), expected, "{from:?} {to:?} {row}");
            edge.step();
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4000, ..ProptestConfig::default() })]

        #[test]
        fn short_edges_are_exact(
            from in [-2048_i32 << 8..2048 << 8, -2048_i32 << 8..2048 << 8],
            dx in -SHORT..SHORT,
            dy in 1_i32..SHORT,
            size in 0_u32..15,
        ) {
            let [x, y] = from;
            check_short(from, [x + dx, y + dy]);
            // Many small ones, and crossings at centers or near them.
            let (dx, dy) = (dx >> size, i32::max(dy >> size, 1));
            check_short(from, [x + dx, y + dy]);
            let from = from.map(|at| at & !255 | 128);
            check_short(from, from.map(|at| at + (dy & !255).max(256)));
            check_short(from, [from[0] + dx, from[1] + (dy & !255).max(256)]);
        }
    }

    /// The limits, from both sides.
    #[test]
    fn what_is_short() {
        let is_short = |dx, dy| ShortEdge::new([3, 0], [3 + dx, dy], 0).is_some();
        assert!(is_short(SHORT - 1, SHORT - 1) && is_short(-SHORT, 1));
        assert!(!is_short(SHORT, 1) && !is_short(-SHORT - 1, 1) && !is_short(0, SHORT));
    }

    /// Compares every row of every edge with the rational crossing, for every row it may start at.
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
                                let (from, to) = ([x0, y0], [x1, y1]);
                                assert_eq!(i64::from(edge.column()), column(from, to, row));
                                let (height, crossing) = crossing(from, to, row);
                                let inside = crossing.div_euclid(256 * height);
                                assert_eq!(i64::from(edge.inside()), inside);
                                edge.step();
                            }
                        }
                    }
                }
            }
        }
    }
}
