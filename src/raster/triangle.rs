//! Triangles: which way they face, which pixels are theirs.

use core::mem::swap;
use core::ops::Range;

use super::edge::{Edge, first_center};
use super::fan::Part;
use super::{Brush, Window};
use crate::num::wide::{IS_NARROW, product};
use crate::pipeline::{Cull, Projected, Weights};

/// A triangle on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle<'a> {
    pub(crate) corners: &'a [Projected; 3],
    /// Where its corners lie in the mesh's triangle, if they are not the corners of that.
    pub(crate) weights: Option<&'a [Weights; 3]>,
    /// Twice the area, in units of (1/256 pixel)²: positive for corners that run clockwise as seen.
    pub(crate) area: i64,
}

/// Twice the area of a triangle, in units of (1/256 pixel)²: positive for corners that run clockwise as seen.
#[inline]
pub(crate) fn area([a, b, c]: &[[i32; 2]; 3]) -> i64 {
    // Differences of 21 bits.
    let [[bx, by], [cx, cy]] = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
    // Sides of less than 64 pixels, as most are, take 15 bits: twice the area then takes 31.
    let is_small = |side: i32| side.wrapping_add(1 << 14).cast_unsigned() < 1 << 15;
    if IS_NARROW && [bx, by, cx, cy].into_iter().all(is_small) {
        return i64::from(bx * cy - cx * by);
    }
    product(bx, cy) - product(cx, by)
}

/// [`area`] of a triangle that is not culled and covers a pixel centre of the window; 0 of others.
#[inline(never)]
pub(super) fn area_in(corners: &[Projected; 3], cull: Cull, window: &Window) -> i64 {
    let area = area(&Projected::screens(corners));
    if cull.leaves_out(area) || !meets(corners, window) {
        return 0;
    }
    area
}

/// Whether a pixel centre of the window is within a triangle's bounds.
#[inline(never)]
fn meets(corners: &[Projected; 3], window: &Window) -> bool {
    let [a, b, c] = Projected::screens(corners);
    let meets = |corners: [i32; 3], window: &Range<i32>| {
        let centers = centers(corners);
        centers.start.max(window.start) < centers.end.min(window.end)
    };
    meets([a[1], b[1], c[1]], &window.rows) && meets([a[0], b[0], c[0]], &window.columns)
}

/// The columns or rows whose centres lie between corners.
#[inline]
fn centers([a, b, c]: [i32; 3]) -> Range<i32> {
    first_center(a.min(b).min(c))..first_center(a.max(b).max(c))
}

/// The rows that a triangle may have pixels in, whatever the window.
#[inline]
pub(super) fn row_range(corners: &[Projected; 3]) -> Range<i32> {
    let [a, b, c] = Projected::screens(corners);
    centers([a[1], b[1], c[1]])
}

/// Whether the centre of a pixel is the triangle's, by the same rule as [`draw`] has it.
pub(super) fn covers([a, b, c]: &[[i32; 2]; 3], area: i64, pixel: [i32; 2]) -> bool {
    let [x, y] = pixel.map(|at| (at << 8) + 128);
    let edges = if area > 0 {
        [(a, b), (b, c), (c, a)]
    } else {
        [(a, c), (c, b), (b, a)]
    };
    edges.iter().all(|&(from, to)| {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let inside = product(dx, y - from[1]) - product(dy, x - from[0]);
        // A left edge runs up, a top edge to the right.
        inside > 0 || inside == 0 && (dy < 0 || dy == 0 && dx > 0)
    })
}

impl<'a> Triangle<'a> {
    /// A mesh's triangle of an area that is known, unless it covers no pixel centre of the window.
    #[inline]
    pub(crate) fn of_area(corners: &'a [Projected; 3], area: i64, window: &Window) -> Option<Self> {
        meets(corners, window).then_some(Self {
            corners,
            weights: None,
            area,
        })
    }

    /// A mesh's triangle, unless it is culled or covers no pixel centre of the window.
    #[inline]
    pub(crate) fn new(corners: &'a [Projected; 3], cull: Cull, window: &Window) -> Option<Self> {
        let area = area_in(corners, cull, window);
        (area != 0).then_some(Self {
            corners,
            weights: None,
            area,
        })
    }

    /// The rows that it may have pixels in, whatever the window.
    #[inline]
    pub(crate) fn row_range(&self) -> Range<i32> {
        row_range(self.corners)
    }

    /// Draws it.
    #[inline]
    pub(crate) fn draw(&self, brush: &mut dyn Brush, window: &Window) {
        draw(brush, window, self, None);
    }
}

/// Draws a triangle, or what `part` says is its own, row by row.
///
/// A centre on a left or top edge belongs to the triangle, one on a right or bottom edge does not.
#[inline(never)]
pub(super) fn draw(
    brush: &mut dyn Brush,
    window: &Window,
    triangle: &Triangle<'_>,
    part: Option<&Part<'_>>,
) {
    let longest = brush.triangle(triangle);
    let screen = Projected::screens(triangle.corners);
    // The pixel that interpolants are counted from.
    let [origin_x, origin_y] = screen[0].map(|at| at >> 8);

    // With the corners sorted from the top, one edge runs from the first to the last, on the left
    // or on the right, and two on the other side. Every exchange turns the triangle over.
    let [mut top, mut middle, mut bottom] = screen;
    let mut long_is_left = triangle.area > 0;
    let mut sort = |upper: &mut [i32; 2], lower: &mut [i32; 2]| {
        if lower[1] < upper[1] {
            swap(upper, lower);
            long_is_left = !long_is_left;
        }
    };
    sort(&mut top, &mut middle);
    sort(&mut middle, &mut bottom);
    sort(&mut top, &mut middle);

    let mut row = first_center(top[1]).max(window.rows.start);
    let end = first_center(bottom[1]).min(window.rows.end);
    let mut turn = first_center(middle[1]).min(end);
    let long = Edge::new(top, bottom, row);
    let [mut left, mut right] = [long; 2];
    while row < end {
        if row >= turn {
            (top, middle, turn) = (middle, bottom, end);
        }
        let short = if long_is_left { &mut right } else { &mut left };
        *short = Edge::new(top, middle, row);
        while row < turn {
            let start = left.column().max(window.columns.start);
            let end = right.column().min(window.columns.end);
            if start < end {
                let (x, y) = (start - origin_x, row - origin_y);
                match part {
                    None if end - start <= longest => brush.span(row, start..end, x, y),
                    None => spans(brush, row, start..end, [x, y], longest),
                    Some(part) => part.span(brush, row, start..end, [x, y]),
                }
            }
            left.step();
            right.step();
            row += 1;
        }
    }
}

/// Paints columns that are more than the brush does at a time.
#[inline(never)]
pub(super) fn spans(
    brush: &mut dyn Brush,
    row: i32,
    mut columns: Range<i32>,
    [mut x, y]: [i32; 2],
    longest: i32,
) {
    while columns.start < columns.end {
        // Columns are of a canvas.
        let count = longest.min(columns.end - columns.start);
        let stop = columns.start + count;
        brush.span(row, columns.start..stop, x, y);
        x += count;
        columns.start = stop;
    }
}
