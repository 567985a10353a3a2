//! Triangles: which way they face and which pixels they cover.

use core::ops::Range;

use super::edge::{Edge, first_center};
use super::polygon::Part;
use super::{Barycentric, Blitter, Patch, Scissor, ScreenVertex, spans};
use crate::num::wide::cross;

/// A triangle on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle<'a> {
    pub(crate) vertices: [&'a ScreenVertex; 3],
    /// The corners' places in the mesh's triangle; `None` if they are its corners.
    pub(crate) barycentric: Option<&'a [Barycentric; 3]>,
    /// Twice the area, in units of (1/256 pixel)²: positive for corners that run clockwise on the screen.
    pub(crate) area: i64,
}

/// Twice the area of a triangle, in units of (1/256 pixel)²: positive for corners that run clockwise on the screen.
#[inline]
pub(crate) fn area([a, b, c]: &[[i32; 2]; 3]) -> i64 {
    // Differences take 21 bits.
    cross([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]])
}

/// The [`area`] of a triangle; 0 if its bounds contain no pixel center of the scissor.
#[inline(never)]
pub(super) fn area_in(corners: [&ScreenVertex; 3], scissor: &Scissor) -> i64 {
    if !meets(corners, scissor) {
        return 0;
    }
    area(&ScreenVertex::screens(corners))
}

/// Whether a triangle's bounds contain a pixel center of the scissor.
#[inline(never)]
fn meets(corners: [&ScreenVertex; 3], scissor: &Scissor) -> bool {
    let [a, b, c] = ScreenVertex::screens(corners);
    let meets = |corners: [i32; 3], scissor: &Range<i32>| {
        let centers = centers(corners);
        centers.start.max(scissor.start) < centers.end.min(scissor.end)
    };
    meets([a[1], b[1], c[1]], &scissor.rows) && meets([a[0], b[0], c[0]], &scissor.columns)
}

/// The columns or rows whose centers lie between the corners.
#[inline]
fn centers([a, b, c]: [i32; 3]) -> Range<i32> {
    first_center(a.min(b).min(c))..first_center(a.max(b).max(c))
}

/// The rows in which a triangle may have pixels, regardless of the scissor.
#[inline]
pub(super) fn row_range(corners: [&ScreenVertex; 3]) -> Range<i32> {
    let [a, b, c] = ScreenVertex::screens(corners);
    centers([a[1], b[1], c[1]])
}

/// Whether a triangle covers the center of a pixel. It uses the same edges as [`draw`], and so follows the same rule.
pub(super) fn covers([a, b, c]: &[[i32; 2]; 3], area: i64, [x, row]: [i32; 2]) -> bool {
    // With clockwise corners, an edge that runs down is on the right.
    let edges = if area > 0 {
        [(a, b), (b, c), (c, a)]
    } else {
        [(a, c), (c, b), (b, a)]
    };
    let mut crossed = false;
    for (from, to) in edges {
        let is_right = to[1] > from[1];
        let (top, bottom) = if is_right { (from, to) } else { (to, from) };
        if (first_center(top[1])..first_center(bottom[1])).contains(&row) {
            crossed = true;
            let is_beyond = x >= Edge::new(*top, *bottom, row).column();
            if is_beyond == is_right {
                return false;
            }
        }
    }
    crossed
}

impl<'a> Triangle<'a> {
    /// A mesh's triangle whose area is known; `None` if its bounds contain no pixel center of the scissor.
    #[inline]
    pub(crate) fn of_area(
        vertices: [&'a ScreenVertex; 3],
        area: i64,
        scissor: &Scissor,
    ) -> Option<Self> {
        meets(vertices, scissor).then_some(Self {
            vertices,
            barycentric: None,
            area,
        })
    }

    /// A mesh's triangle that an earlier [`of_area`](Self::of_area) accepted.
    #[inline]
    pub(crate) fn new(vertices: [&'a ScreenVertex; 3]) -> Self {
        Self {
            vertices,
            barycentric: None,
            area: area(&ScreenVertex::screens(vertices)),
        }
    }

    /// The rows in which it may have pixels, regardless of the scissor.
    #[inline]
    pub(crate) fn row_range(&self) -> Range<i32> {
        row_range(self.vertices)
    }

    /// Draws the part in the scissor.
    #[inline]
    pub(crate) fn draw(&self, blitter: &mut dyn Blitter, scissor: &Scissor) {
        draw(blitter, scissor, self, None);
    }
}

/// Draws a triangle row by row, or only those pixels that `part` selects.
///
/// A center on a left or top edge belongs to the triangle, one on a right or bottom edge does not.
#[inline(never)]
pub(super) fn draw(
    blitter: &mut dyn Blitter,
    scissor: &Scissor,
    triangle: &Triangle<'_>,
    part: Option<&Part<'_>>,
) {
    let screen = ScreenVertex::screens(triangle.vertices);
    let longest = blitter.set_up(&Patch {
        vertices: triangle.vertices,
        barycentric: triangle.barycentric,
        screen: &screen,
        area: triangle.area,
    });
    // Interpolants are counted from this pixel.
    let (origin_x, origin_y) = (screen[0][0] >> 8, screen[0][1] >> 8);

    // With the corners sorted from top to bottom, one long edge runs from the first to the last, on the left or on
    // the right; two short edges are on the other side. Every exchange of corners swaps the sides.
    //
    //        top ●
    //           ╱ ╲
    //          ╱   ● middle
    //         ╱ ╱
    // bottom ●            `long_is_left` is true
    let [mut top, mut middle, mut bottom] = screen;
    let mut long_is_left = triangle.area > 0;
    let mut sort = |upper: &mut [i32; 2], lower: &mut [i32; 2]| {
        if lower[1] < upper[1] {
            // Not `swap`: optimized for size, it is a loop over memory, like a `map` of an array.
            (*upper, *lower) = (*lower, *upper);
            long_is_left = !long_is_left;
        }
    };
    sort(&mut top, &mut middle);
    sort(&mut middle, &mut bottom);
    sort(&mut top, &mut middle);

    let mut row = first_center(top[1]).max(scissor.rows.start);
    let end = first_center(bottom[1]).min(scissor.rows.end);
    let mut short_end = first_center(middle[1]).min(end);
    let long = Edge::new(top, bottom, row);
    let [mut left, mut right] = [long; 2];
    while row < end {
        if row >= short_end {
            (top, middle, short_end) = (middle, bottom, end);
        }
        let short = if long_is_left { &mut right } else { &mut left };
        *short = Edge::new(top, middle, row);
        while row < short_end {
            let start = left.column().max(scissor.columns.start);
            let end = right.column().min(scissor.columns.end);
            if start < end {
                let (x, y) = (start - origin_x, row - origin_y);
                match part {
                    None if end - start <= longest => blitter.span(row, start..end, x, y),
                    None => spans(blitter, row, start..end, [x, y], longest),
                    Some(part) => part.span(blitter, row, start..end, [x, y]),
                }
            }
            left.step();
            right.step();
            row += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::picture::{Picture, vertex};
    use super::*;

    /// Draws a triangle with its corners in quarters of a pixel; whether it is thought to have a pixel.
    fn draw(picture: &mut Picture, scissor: &Scissor, corners: [[i32; 2]; 3]) -> bool {
        let vertices = corners.map(|corner| vertex(corner.map(|at| at * 64)));
        let area = area(&vertices.map(|vertex| vertex.screen));
        let triangle = Triangle::of_area(vertices.each_ref(), area, scissor);
        if let Some(triangle) = &triangle {
            triangle.draw(picture, scissor);
        }
        triangle.is_some()
    }

    fn drawn(width: usize, height: usize, triangles: &[[[i32; 2]; 3]]) -> Picture {
        let mut picture = Picture::new(width, height);
        let scissor = picture.scissor();
        for (ink, &corners) in ('a'..).zip(triangles) {
            picture.ink = ink;
            draw(&mut picture, &scissor, corners);
        }
        picture
    }

    /// The corners are centers of pixels: left and top edges have theirs, right and bottom ones have not.
    #[test]
    fn centers_on_edges_belong_to_the_left_and_the_top() {
        let [left, right, top, bottom] = [6, 22, 6, 18];
        let a = [[left, top], [left, bottom], [right, top]];
        let b = [[right, top], [left, bottom], [right, bottom]];
        let expected = [".......", ".aaaa..", ".aaab..", ".aabb..", "......."];
        drawn(7, 5, &[a, b]).assert(&expected);
        // The picture depends neither on the first corner nor on the winding.
        for turn in 0..3 {
            let [mut a, mut b] = [a, b];
            a.rotate_left(turn);
            b.rotate_right(turn);
            drawn(7, 5, &[a, b]).assert(&expected);
            a.reverse();
            b.swap(0, 1);
            drawn(7, 5, &[a, b]).assert(&expected);
        }
    }

    #[test]
    fn four_triangles_about_a_center_have_each_pixel_once() {
        let [a, b, c, d, middle] = [[2, 2], [22, 2], [22, 22], [2, 22], [10, 14]];
        let fan = [
            [a, middle, b],
            [b, middle, c],
            [c, middle, d],
            [d, middle, a],
        ];
        drawn(6, 6, &fan).assert(&["aaaaa.", "daaab.", "ddabb.", "ddbbb.", "dcccb.", "......"]);
    }

    #[test]
    fn a_triangle_between_centers_covers_nothing() {
        let mut picture = Picture::new(4, 4);
        let scissor = picture.scissor();
        // Between two rows, and between two columns.
        assert!(!draw(&mut picture, &scissor, [[1, 3], [15, 4], [8, 5]]));
        assert!(!draw(&mut picture, &scissor, [[3, 1], [4, 15], [5, 8]]));
        // Within a pixel, beside its center.
        assert!(!draw(&mut picture, &scissor, [[7, 7], [7, 8], [8, 7]]));
        // Along a diagonal of centers: bounds do not tell.
        assert!(draw(&mut picture, &scissor, [[0, 1], [14, 15], [13, 15]]));
        picture.assert(&["....", "....", "....", "...."]);
        assert!(picture.spans.is_empty());
    }

    /// Its pixels in a part of the picture are those that it has in the whole.
    #[test]
    fn a_scissor_and_bands_cut_a_triangle() {
        let corners = [[1, 0], [39, 13], [9, 31]];
        let whole = drawn(10, 8, &[corners]);
        whole.assert(&[
            "aa........",
            ".aaaa.....",
            ".aaaaaaa..",
            ".aaaaaaaa.",
            ".aaaaaaa..",
            "..aaaa....",
            "..aa......",
            "..a.......",
        ]);
        let scissor = whole.scissor();
        let mut bands = Picture::new(10, 8);
        bands.ink = 'a';
        for first in [0, 3, 6] {
            let rows = first..(first + 3).min(8);
            let columns = scissor.columns.clone();
            draw(&mut bands, &Scissor { columns, rows }, corners);
        }
        assert_eq!(bands.text(), whole.text());
        // Interpolants are counted from the same pixel.
        assert_eq!(bands.spans, whole.spans);

        let mut inner = Picture::new(10, 8);
        let scissor = Scissor {
            columns: 3..6,
            rows: 2..6,
        };
        assert!(draw(&mut inner, &scissor, corners));
        inner.assert(&[
            "..........",
            "..........",
            "...###....",
            "...###....",
            "...###....",
            "...###....",
            "..........",
            "..........",
        ]);
        // Beside it there is nothing to set up.
        let scissor = Scissor {
            columns: 0..10,
            rows: 8..9,
        };
        assert!(!draw(&mut inner, &scissor, corners));
    }
}
