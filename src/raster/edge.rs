//! A triangle's edge, row by row.

use core::hint::black_box;
use core::num::NonZeroU32;

use crate::num::wide::divide;

/// The first column whose center is on an edge or to the right of it, stepped exactly from row to row.
///
/// That column is the integer part of a rational number, `column` + 1 + `part` / `height`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    column: i32,
    /// From -`height` to -1, so that its sign tells when a column is complete.
    part: i32,
    /// The number grows by `step` + `rest` / `height` for each row.
    step: i32,
    rest: i32,
    /// In units of 1/256 pixel. `rest` is less than that, and not below 0.
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
    /// The edge from `from` down to `to`, at `row`.
    ///
    /// The ends differ by at most 4096 pixels in each direction, and the edge crosses the center of `row`, so
    /// everything fits in 32 bits. For an edge that crosses no center, the result is meaningless.
    #[inline]
    pub(super) fn new([x, y]: [i32; 2], to: [i32; 2], row: i32) -> Self {
        let height = (to[1] - y).max(1);
        let (step, rest) = divide(to[0] - x, height);
        // The edge crosses the first center, `down` < 256 units below its upper end, at x + step · down +
        // rest · down / height. The first column is that plus half a pixel less the least fraction, rounded down.
        let first = first_center(y);
        let down = (first << 8) + 128 - y;
        let x = x + 128 + step * down;
        // In units of 1 / (256 · height) pixel; the last 8 bits never change. It is from -1 to below 2 · height.
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
        // So far, `part` was counted from 0. One row back, because `next` goes to a row before it returns its column.
        edge.column -= step;
        edge.part -= rest + height;
        edge
    }

    /// Skips rows above the scissor, such as those of earlier bands: at most 4095, each with a rest below 2^20.
    #[inline]
    fn skip(&mut self, rows: i32) {
        let height = NonZeroU32::new(self.height.cast_unsigned()).unwrap_or(NonZeroU32::MIN);
        let moved = rows.wrapping_mul(self.rest).wrapping_add(self.part);
        let moved = moved.cast_unsigned();
        self.column += rows * self.step + (moved / height).cast_signed();
        self.part = (moved % height).cast_signed();
    }

    /// The first column whose center is on the edge or to the right of it, in the next row: at first in `row`.
    #[inline]
    pub(super) fn next(&mut self) -> i32 {
        self.column += self.step;
        self.part += self.rest;
        if self.part >= 0 {
            // Keeps the compiler from computing both cases, for which a small core lacks registers.
            black_box(());
            self.part -= self.height;
            self.column += 1;
        }
        self.column
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
