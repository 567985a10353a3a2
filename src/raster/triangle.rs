//! Triangles: which way they face and which pixels they cover.

use core::hint::black_box;
use core::ops::Range;

use super::edge::{Edge, ShortEdge, first_center};
use super::scissor::meet;
use super::{Barycentric, Columns, Patch, Scissor, ScreenVertex};
use crate::num::wide::cross;

/// A triangle on the screen.
#[derive(Clone, Debug)]
pub(crate) struct Triangle<'a> {
    pub(super) patch: Patch<'a>,
    /// The rows of the scissor in which the triangle may have pixels.
    pub(crate) rows: Range<i32>,
    /// The scissor, if some columns of the triangle may be outside.
    pub(super) cut: Option<&'a Scissor>,
}

/// Twice the area of a triangle, in units of (1/256 pixel)²: positive for corners that run clockwise on the screen.
#[inline]
pub(crate) fn area([a, b, c]: &[[i32; 2]; 3]) -> i64 {
    // Differences take 21 bits.
    cross([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]])
}

/// Whether a triangle covers the center of a pixel.
pub(super) fn covers(corners: [&ScreenVertex; 3], area: i64, [x, row]: [i32; 2]) -> bool {
    let scissor = Scissor {
        columns: x..x + 1,
        rows: row..row + 1,
    };
    let mut columns = [[0; 2]];
    if let Some(triangle) = &Triangle::new(corners, None, area, &scissor) {
        scan_convert(&mut columns, row, triangle);
    }
    let [[start, end]] = columns;
    start < end
}

impl<'a> Triangle<'a> {
    /// A triangle of a mesh or, with `barycentric`, of a clipped polygon; `None` if the smallest upright rectangle
    /// around it contains no pixel center of the scissor.
    #[cfg_attr(for_size, inline(never))]
    pub(crate) fn new(
        vertices: [&'a ScreenVertex; 3],
        barycentric: Option<&'a [Barycentric; 3]>,
        area: i64,
        scissor: &'a Scissor,
    ) -> Option<Self> {
        let [[ax, ay], [bx, by], [cx, cy]] = ScreenVertex::screens(vertices);
        let (top, bottom) = (ay.min(by).min(cy), ay.max(by).max(cy));
        // Rows are tested first, because most triangles without pixels in a band have no row in it.
        let rows = meet(&(first_center(top)..first_center(bottom)), &scissor.rows);
        if rows.is_empty() {
            return None;
        }
        let (left, right) = (ax.min(bx).min(cx), ax.max(bx).max(cx));
        let columns = first_center(left)..first_center(right);
        let inside = meet(&columns, &scissor.columns);
        if inside.is_empty() {
            return None;
        }
        Some(Self {
            patch: Patch {
                vertices,
                barycentric,
                size: [right - left, bottom - top],
                area,
            },
            rows,
            cut: (inside != columns).then_some(scissor),
        })
    }
}

/// Finds, for each row of a block, the columns in the scissor whose centers lie between the edges of a triangle.
///
/// ```text
///      a ●
///       ╱ ╲         a is the highest corner, c the lowest. The edge from a to c bounds rows on one
///      ╱   ● b      side. The edges from a to b and from b to c bound rows on the other side.
///     ╱ ╱
///  c ●
/// ```
#[inline(never)]
pub(super) fn scan_convert<'b, 't>(
    block: &'b mut [Columns],
    first: i32,
    triangle: &Triangle<'t>,
) -> &'b [Columns] {
    let Patch {
        vertices: [mut a, mut b, mut c],
        size: [width, height],
        area,
        ..
    } = triangle.patch;
    let rows_to = |row: i32| (row - first).max(0).cast_unsigned() as usize;
    let count = rows_to(triangle.rows.end).min(block.len());
    let rows = block.get_mut(..count).unwrap_or_default();
    // If abc runs clockwise, the edge from a to c is on the left: side 0. An exchange of two corners turns the winding
    // around.
    let mut sign = (area >> 32) as i32;
    let mut sort = |a: &'t ScreenVertex, b: &'t ScreenVertex| {
        if a.screen[1] <= b.screen[1] {
            (a, b)
        } else {
            sign = !sign;
            (b, a)
        }
    };
    (a, b) = sort(a, b);
    (b, c) = sort(b, c);
    (a, b) = sort(a, b);
    // All rows are between a and c.
    let middle = rows_to(first_center(b.screen[1])).min(count);
    let side = usize::from(sign < 0);
    let is_short = ShortEdge::fits(width, height);
    edge(rows, side, [a, c], first, is_short);
    if let Some((upper, lower)) = rows.split_at_mut_checked(middle) {
        edge(upper, 1 - side, [a, b], first, is_short);
        let first = first + (middle as u32).cast_signed();
        edge(lower, 1 - side, [b, c], first, is_short);
    }
    if let Some(scissor) = triangle.cut {
        cut(rows, &scissor.columns);
    }
    rows
}

/// Sets one side of the rows to the columns of an edge from a corner down to another corner. The first row is `row`.
#[cfg_attr(for_size, inline(never))]
fn edge(rows: &mut [Columns], side: usize, ends: [&ScreenVertex; 2], row: i32, is_short: bool) {
    if !is_short {
        long_edge(rows, side, ends, row);
        return;
    }
    if rows.is_empty() {
        return; // before the edge is divided: half of the edges of small triangles pass no center
    }
    let [top, bottom] = ends;
    if let Some(mut edge) = ShortEdge::new(top.screen, bottom.screen, row) {
        // Most edges pass few rows, so an empty statement keeps the compiler from unrolling the loops.
        for columns in rows {
            black_box(());
            columns[side & 1] = edge.next();
        }
    }
}

#[inline(never)]
fn long_edge(rows: &mut [Columns], side: usize, [top, bottom]: [&ScreenVertex; 2], row: i32) {
    if rows.is_empty() {
        return;
    }
    let mut edge = Edge::new(top.screen, bottom.screen, row);
    for columns in rows {
        black_box(());
        columns[side & 1] = edge.next() as i16;
    }
}

/// Limits rows to the scissor. Out of line, because most triangles are inside the scissor.
#[cold]
#[inline(never)]
fn cut(rows: &mut [Columns], scissor: &Range<i32>) {
    let (first, last) = (scissor.start as i16, scissor.end as i16);
    for [start, end] in rows {
        *start = (*start).max(first);
        *end = (*end).min(last);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::{Picture, vertex};

    /// Draws a triangle with its corners in quarters of a pixel; returns false if its bounds show that it has no pixel.
    fn draw(picture: &mut Picture, scissor: &Scissor, corners: [[i32; 2]; 3]) -> bool {
        let vertices = corners.map(|corner| vertex(corner.map(|at| at * 64)));
        let area = area(&vertices.map(|vertex| vertex.screen));
        let triangle = Triangle::new(vertices.each_ref(), None, area, scissor);
        if let Some(triangle) = &triangle {
            picture.draw(scissor, |raster| raster.triangle(triangle, None));
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

    /// The corners are centers of pixels. Centers on left and top edges belong to a triangle, centers on right and
    /// bottom edges do not.
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
        // Along a diagonal of centers, where the bounds do not show that there is no pixel.
        assert!(draw(&mut picture, &scissor, [[0, 1], [14, 15], [13, 15]]));
        picture.assert(&["....", "....", "....", "...."]);
        assert!(picture.spans.is_empty());
    }

    /// In a part of the picture, a triangle has the same pixels as in the whole picture.
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
        // Spans begin at the same pixels, so interpolants have the same values.
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
        // A triangle beside the scissor needs no set-up.
        let scissor = Scissor {
            columns: 0..10,
            rows: 8..9,
        };
        assert!(!draw(&mut inner, &scissor, corners));
    }

    /// A triangle with more rows than the rasterizer's block, drawn at once and row by row.
    #[test]
    fn a_tall_triangle_has_the_rows_of_its_bands() {
        let corners = [[7, -20], [43, 301], [-9, 777]];
        let whole = drawn(12, 200, &[corners]);
        assert_eq!(whole.spans.len(), 167);
        let mut bands = Picture::new(12, 200);
        bands.ink = 'a';
        for row in 0..200 {
            let scissor = Scissor {
                columns: 0..12,
                rows: row..row + 1,
            };
            draw(&mut bands, &scissor, corners);
        }
        assert_eq!(bands.text(), whole.text());
        assert_eq!(bands.spans, whole.spans);
    }
}
