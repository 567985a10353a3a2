//! A clipped triangle, drawn as a fan of triangles.

use core::ops::Range;

use super::triangle::{Triangle, area, covers};
use super::{ClippedVertex, Columns, Cull, Rows, Scissor, ScreenVertex};

/// A clipped triangle as a fan of triangles. All triangles of the fan share the first corner of the outline. For
/// example, the corners 0 to 4 make the triangles 0 1 2, 0 2 3 and 0 3 4.
///
/// The outline is convex except for the rounding of its corners. Where rounding dents the outline or makes it cross
/// itself, some triangles of the fan turn over and overlap others: the fan is folded. Take all triangles that cover a
/// pixel. The pixel belongs to the outline if more of them have the winding of the whole outline than the opposite
/// winding. The first of them with the winding of the whole draws the pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polygon<'a> {
    outline: &'a [ClippedVertex],
    /// Twice the area of the outline, positive if it runs clockwise on the screen.
    pub(super) area: i64,
    /// Whether a triangle of the fan has turned over, even a triangle outside the scissor. In a folded fan, every pixel
    /// is a span of its own. If a band ignored triangles outside the band, it might not see that the fan is folded, and
    /// draw longer spans. Values in longer spans might differ by a unit from the values in the whole frame.
    pub(super) is_folded: bool,
}

/// Whether an area has the sign, and so the winding, of `whole`.
const fn same_winding(whole: i64, area: i64) -> bool {
    (whole > 0) == (area > 0)
}

// Destructured by hand, because a `map` over references compiles to arrays and loops (see `ScreenVertex::screens`).

pub(super) fn vertices([a, b, c]: [&ClippedVertex; 3]) -> [&ScreenVertex; 3] {
    [&a.vertex, &b.vertex, &c.vertex]
}

#[inline(never)]
fn outline_area([a, b, c]: [&ClippedVertex; 3]) -> i64 {
    area(&[a.vertex.screen, b.vertex.screen, c.vertex.screen])
}

impl<'a> Polygon<'a> {
    /// The fan of an outline; `None` if it is culled.
    pub(crate) fn new(outline: &'a [ClippedVertex], cull: Cull) -> Option<Self> {
        let mut fan = Self {
            outline,
            area: 0,
            is_folded: false,
        };
        for (_, area) in fan.triangles() {
            fan.area += area;
        }
        fan.is_folded = fan
            .triangles()
            .any(|(_, area)| area != 0 && !fan.winds_as(area));
        if cull.leaves_out(fan.area) {
            return None;
        }
        Some(fan)
    }

    /// Twice the area of an outline, positive if it runs clockwise on the screen. This area decides whether the outline
    /// is culled.
    pub(crate) fn area(outline: &'a [ClippedVertex]) -> i64 {
        Self::new(outline, Cull::Nothing).map_or(0, |fan| fan.area)
    }

    /// The triangle of an outline's fan that has the greatest area, and twice this area; `None` if the outline has no
    /// area.
    pub(crate) fn widest(outline: &'a [ClippedVertex]) -> Option<([&'a ScreenVertex; 3], i64)> {
        let fan = Self::new(outline, Cull::Nothing)?;
        let widest = fan.triangles().max_by_key(|(_, area)| area.abs())?;
        Some((vertices(widest.0), widest.1))
    }

    /// The triangles of the fan, each with twice its area.
    #[inline]
    pub(super) fn triangles(
        &self,
    ) -> impl Iterator<Item = ([&'a ClippedVertex; 3], i64)> + use<'a> {
        let (first, rest) = match self.outline {
            [first, rest @ ..] => (Some(first), rest),
            [] => (None, self.outline),
        };
        rest.windows(2).filter_map(move |side| match (first, side) {
            (Some(first), [from, to]) => {
                let corners = [first, from, to];
                Some((corners, outline_area(corners)))
            }
            _ => None,
        })
    }

    /// Whether a triangle with this area may have pixels. A triangle that has turned over has none.
    #[inline]
    pub(super) const fn winds_as(&self, area: i64) -> bool {
        area != 0 && same_winding(self.area, area)
    }

    /// The rows in which the fan may have pixels; `None` if it has no pixel in the scissor.
    pub(crate) fn rows(&self, scissor: &Scissor) -> Option<Range<i32>> {
        let mut all: Option<Range<i32>> = None;
        for (corners, area) in self.triangles() {
            if !self.winds_as(area) {
                continue;
            }
            if let Some(triangle) = &Triangle::new(vertices(corners), None, area, scissor) {
                let rows = &triangle.rows;
                let all = all.get_or_insert(rows.clone());
                *all = all.start.min(rows.start)..all.end.max(rows.end);
            }
        }
        all
    }
}

/// One triangle of a folded fan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FanTriangle<'a> {
    pub(super) fan: &'a Polygon<'a>,
    pub(super) at: usize,
}

impl FanTriangle<'_> {
    /// Draws some rows of the triangle, but only the pixels that this triangle of the fan has to draw.
    #[cold]
    #[inline(never)]
    pub(super) fn rows(&self, blit: &mut dyn Rows, first: i32, rows: &[Columns]) {
        for (row, &[start, end]) in (first..).zip(rows) {
            for column in start..end {
                if self.owns_pixel([column.into(), row]) {
                    blit.draw(row, &[[column, column + 1]]);
                }
            }
        }
    }

    /// Whether this triangle has to draw a pixel.
    fn owns_pixel(&self, pixel: [i32; 2]) -> bool {
        let mut winding = 0;
        for (i, (corners, area)) in self.fan.triangles().enumerate() {
            if covers(vertices(corners), area, pixel) {
                if !same_winding(self.fan.area, area) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::{Picture, clipped};
    use crate::mesh::Indices;
    use std::vec::Vec;

    /// Draws an outline with its corners in quarters of a pixel.
    fn drawn(corners: &[[i32; 2]]) -> Picture {
        let outline: Vec<_> = corners
            .iter()
            .map(|corner| clipped(corner.map(|at| at * 64)))
            .collect();
        let mut picture = Picture::new(9, 7);
        let scissor = picture.scissor();
        picture.draw(&scissor, |raster| {
            raster.draw_clipped(Indices::of_point(0), &outline, Cull::Nothing);
            assert_eq!(raster.drawn, 1);
        });
        picture
    }

    /// Outlines that clipping may leave: the first three to seven corners of an octagon.
    #[test]
    fn outlines_of_three_to_seven_corners_have_each_pixel_once() {
        let corners = [
            [9, 1],
            [1, 9],
            [1, 19],
            [9, 27],
            [27, 27],
            [35, 19],
            [35, 9],
        ];
        let pictures: [[&str; 7]; 5] = [
            [
                ".........",
                ".#.......",
                "#........",
                "#........",
                ".........",
                ".........",
                ".........",
            ],
            [
                ".........",
                ".#.......",
                "##.......",
                "##.......",
                "##.......",
                ".#.......",
                ".........",
            ],
            [
                ".........",
                ".##......",
                "####.....",
                "####.....",
                "#####....",
                ".#####...",
                "..#####..",
            ],
            [
                "..#......",
                ".###.....",
                "#####....",
                "#######..",
                "########.",
                ".#######.",
                "..#####..",
            ],
            [
                "..#......",
                ".#####...",
                "#########",
                "#########",
                "#########",
                ".#######.",
                "..#####..",
            ],
        ];
        for (count, expected) in (3..).zip(pictures) {
            let mut corners = corners[..count].to_vec();
            drawn(&corners).assert(&expected);
            corners.reverse();
            drawn(&corners).assert(&expected);
        }
    }

    /// Rounding may dent an outline. One triangle of the fan then has the opposite winding and overlaps others.
    #[test]
    fn a_folded_fan_has_each_pixel_once() {
        let dented = [[2, 2], [2, 26], [14, 8], [34, 26], [34, 2]];
        drawn(&dented).assert(&[
            "########.",
            "########.",
            "###.####.",
            "##...###.",
            "##....##.",
            "#......#.",
            ".........",
        ]);
    }

    /// The outline goes around its middle twice: two triangles of the fan, with the same winding, cover each pixel
    /// there.
    #[test]
    fn an_outline_that_goes_around_twice_has_each_pixel_once() {
        let star = [[2, 8], [34, 10], [6, 26], [18, 1], [30, 26]];
        drawn(&star).assert(&[
            "....#....",
            "....#....",
            ".#######.",
            "...####..",
            "..#####..",
            "..#...#..",
            ".........",
        ]);
    }
}
