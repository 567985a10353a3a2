//! The pixels that an edge divides: how much of each lies on either side of the edge.

use core::ops::Range;

use super::edge::{Edge, first_center};
use super::scissor::meet;
use super::{ClippedVertex, Patch, Rasterizer, Scissor, ScreenVertex};
use crate::num::wide::divide;

/// Passes an edge on to a blitter that smooths edges: the ends are the first two vertices of the patch.
pub(crate) fn smooth_edge(raster: &mut Rasterizer<'_>, [a, b]: [&ClippedVertex; 2]) {
    raster.set_up(&Patch {
        vertices: [&a.vertex, &b.vertex, &b.vertex],
        ..Patch::EVEN
    });
}

/// Whether an edge has more rows than columns.
const fn is_steep([[ax, ay], [bx, by]]: [[i32; 2]; 2]) -> bool {
    ax.abs_diff(bx) < ay.abs_diff(by)
}

/// The pixels whose centers lie on either side of an edge: for each column that the edge passes, a pixel and the pixel
/// below it, or, for each row that a steep edge passes, a pixel and the pixel on its right.
///
/// The centers on one side of the edge are exactly those that a triangle on this side covers.
pub(crate) struct Straddle {
    pub(crate) is_steep: bool,
    /// The columns or, of a steep edge, the rows in the scissor whose centers the edge passes.
    pub(crate) steps: Range<i32>,
    edge: Edge,
    /// Whether the edge steps through a picture that is turned upside down.
    is_mirrored: bool,
    /// Where the edge starts, in units of 1/256 pixel, along the axis of its steps.
    start: i32,
    /// Whether it starts at b.
    is_turned: bool,
    /// The edge's length along this axis, in units of 1/256 pixel.
    length: i32,
    /// 2^30 / `length`.
    share: i32,
    /// The edge's slope, from 0 (along the axis of its steps) to 256 (diagonal), rounded down.
    slope: i32,
    /// 2^16 / `slope`.
    inverse: i32,
}

/// Two neighboring pixels with an edge between their centers.
pub(crate) struct Pair {
    /// The row of the upper pixel or, of a steep edge, the column of the left pixel; the other pixel has the next number.
    pub(crate) first: i32,
    /// The share of each pixel that lies on the other pixel's side of the edge, in 256ths: 0 to 128.
    pub(crate) beyond: [i32; 2],
}

impl Straddle {
    /// The pixels of an edge from a to b; `None` if there are none in the scissor.
    #[inline]
    pub(crate) fn new(scissor: &Scissor, [a, b]: [&ScreenVertex; 2]) -> Option<Self> {
        let ([ax, ay], [bx, by]) = (a.screen, b.screen);
        let is_steep = is_steep([a.screen, b.screen]);
        let (mut from, mut to, along) = if is_steep {
            ([ax, ay], [bx, by], &scissor.rows)
        } else {
            ([ay, ax], [by, bx], &scissor.columns)
        };
        let is_turned = to[1] < from[1];
        if is_turned {
            (from, to) = (to, from);
        }
        let ([minor, start], [minor_end, end]) = (from, to);
        let steps = meet(&(first_center(start)..first_center(end)), along);
        if steps.is_empty() {
            return None;
        }
        // A center exactly on an edge belongs to the triangle on its right. If the edge falls from left to right, its
        // right is above it. An `Edge` counts such a center to the pixels after it, so the picture is turned over.
        let is_mirrored = !is_steep && minor_end > minor;
        let mirrored = |at: i32| if is_mirrored { -at } else { at };
        // A center lies between the ends, so they differ, and by at most 2^20.
        let length = (end - start).max(1);
        let slope = (((minor_end - minor).abs()) << 8) / length;
        Some(Self {
            is_steep,
            edge: Edge::new(
                [mirrored(minor), start],
                [mirrored(minor_end), end],
                steps.start,
            ),
            steps,
            is_mirrored,
            start,
            is_turned,
            length,
            share: (1 << 30) / length,
            slope,
            inverse: (1 << 16) / slope.max(1),
        })
    }

    /// A value of 31 bits that is linear along the edge: at the first step, and its change from step to step. At the ends
    /// a and b, it has the given values. On an edge of less than a pixel, the change per step is the whole change.
    ///
    /// It is stepped from the first center of the whole edge, not of its part in the scissor. So it has the same bits in
    /// each band. The change per step is a quotient of integers, rounded down: at the end of an edge of n pixels, the
    /// value has an error of at most n units.
    #[inline]
    pub(crate) fn linear(&self, [at_a, at_b]: [i32; 2]) -> [i32; 2] {
        let [from, to] = if self.is_turned {
            [at_b, at_a]
        } else {
            [at_a, at_b]
        };
        let change = to - from;
        let first = first_center(self.start);
        let before = ((first << 8) + 128 - self.start) * self.share;
        let at_first = from + ((i64::from(change) * i64::from(before)) >> 30) as i32;
        let length = self.length.max(1 << 8);
        let (whole, rest) = divide(change, length);
        let (part, _) = divide(rest << 8, length);
        let per_step = (whole << 8) + part;
        let skipped = self.steps.start - first;
        [
            at_first.wrapping_add(per_step.wrapping_mul(skipped)),
            per_step,
        ]
    }

    /// The pixels of the next step.
    #[inline]
    pub(crate) fn next(&mut self) -> Pair {
        let (after, distance) = self.edge.next_with_distance(self.share);
        let beyond = [self.beyond(256 - distance), self.beyond(distance)];
        Pair {
            // Turned over, the center 256n + 128 of pixel n becomes the center of pixel −n − 1.
            first: if self.is_mirrored { !after } else { after - 1 },
            beyond: if self.is_mirrored {
                [beyond[1], beyond[0]]
            } else {
                beyond
            },
        }
    }

    /// The share of a pixel on the far side of the edge, by the distance from the pixel's center to the edge across its
    /// steps. Both are in 256ths, and the distance is at least 0.
    ///
    /// With the distance d and the slope s, across the pixel the edge is from d − s/2 to d + s/2 away from its middle:
    ///
    /// - d ≤ (1 − s)/2: the edge cuts both sides of the pixel, and leaves a trapezoid of area 1/2 − d;
    /// - d < (1 + s)/2: the edge cuts off a triangle of height u = (1 + s)/2 − d and area u²/(2s);
    /// - otherwise, the edge misses the pixel.
    #[inline]
    fn beyond(&self, distance: i32) -> i32 {
        // In units of 1/512: 1 + s − 2d.
        let u = 256 + self.slope - 2 * distance;
        if u >= 2 * self.slope {
            128 - distance
        } else if u > 0 {
            // u is below 2s, so u² / s is below 4 · 2^16. The area is 256 · (u/512)² / (2s/256) = u² / (8s).
            (u * u * self.inverse) >> 19
        } else {
            0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::{Picture, vertex};
    use crate::random::{cases, within};
    use crate::raster::{Triangle, area};
    use rand::Rng;

    const SIDES: [usize; 2] = [24, 18];

    /// The pixels that a parallelogram covers: it has a side from a to b, and reaches from there along the axis that the
    /// edge is crossed by, to the right or down.
    fn beside(a: [i32; 2], b: [i32; 2], is_steep: bool) -> Picture {
        let mut picture = Picture::new(SIDES[0], SIDES[1]);
        let scissor = picture.scissor();
        let moved = |[x, y]: [i32; 2]| {
            if is_steep {
                [x + (40 << 8), y]
            } else {
                [x, y + (40 << 8)]
            }
        };
        for corners in [[a, b, moved(a)], [moved(a), b, moved(b)]] {
            let vertices = corners.map(vertex);
            if let Some(triangle) =
                &Triangle::new(vertices.each_ref(), None, area(&corners), &scissor)
            {
                picture.draw(&scissor, |raster| raster.triangle(triangle, None));
            }
        }
        picture
    }

    /// Between the two pixels of each pair, and nowhere else in the columns or rows of the steps, triangles on one side of
    /// the edge end. Many edges pass through the centers of pixels.
    #[test]
    fn triangles_end_between_the_pixels_of_a_pair() {
        cases(4000, |random| {
            let grid = 1 << random.random_range(0..8);
            let ends = [0, 1].map(|_| {
                within(random, [-4 << 8..28 << 8, -4 << 8..22 << 8]).map(|at| at / grid * grid)
            });
            let [a, b] = ends.map(vertex);
            let picture = beside(ends[0], ends[1], is_steep(ends));
            let scissor = picture.scissor();
            let Some(mut straddle) = Straddle::new(&scissor, [&a, &b]) else {
                return;
            };
            let rows = picture.text();
            for step in straddle.steps.clone() {
                let pair = straddle.next();
                let step = usize::try_from(step).unwrap();
                for (number, at) in (0..).zip(0..SIDES[usize::from(!straddle.is_steep)]) {
                    let [x, y] = if straddle.is_steep {
                        [at, step]
                    } else {
                        [step, at]
                    };
                    let is_drawn = rows[y].as_bytes()[x] != b'.';
                    assert_eq!(is_drawn, number > pair.first, "{ends:?} {x} {y}");
                }
            }
        });
    }
}
