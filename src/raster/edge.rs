//! A triangle's edge, row by row.

use core::num::NonZeroU32;

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

#[cfg(test)]
mod tests {
    use super::*;

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
                                let dy = i64::from(y1 - y0);
                                let numerator = i64::from(x0) * dy
                                    + i64::from(row * 256 + 128 - y0) * i64::from(x1 - x0);
                                let ceiling = |n: i64, d: i64| -(-n).div_euclid(d);
                                let column = ceiling(numerator - 128 * dy, 256 * dy);
                                assert_eq!(i64::from(edge.column()), column);
                                let inside = numerator.div_euclid(256 * dy);
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
