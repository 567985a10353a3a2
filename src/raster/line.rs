//! Hairlines: one pixel for each step along the line's longer axis.

use core::ops::Range;

use super::block::Block;
use super::edge::{Edge, ShortEdge, first_center};
use super::point::point;
use super::scissor::meet;
use super::{ClippedVertex, Patch, Rasterizer, ScreenVertex};

/// Draws a hairline: in each step along the longer axis, the one pixel that contains the line there.
#[inline(never)]
pub(crate) fn line(raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]) {
    let (steep, ends) = in_order(ends);
    // Without the pixels that contain the ends, lines that meet at a corner might leave a gap. A blended line leaves these
    // pixels out, so that a polyline blends no pixel twice.
    if !raster.coloring.blends {
        let [first, last] = ends;
        for (end, is_last) in [(first, false), (last, true)] {
            if is_beyond(end, steep, is_last) {
                point(raster, &end.vertex, Some(&[end.barycentric; 3]));
            }
        }
    }
    let Some(Course {
        mut block,
        steep,
        start: [start, minor],
        end: [end, minor_end],
        steps,
        across,
    }) = Course::in_order(raster, steep, ends)
    else {
        return;
    };

    // An edge steps along its second coordinate, which is the longer axis here. It returns the first center at or after
    // the line, a ceiling. A hairline needs the pixel that contains the line, a floor. So the edge is mirrored:
    // ⌊x⌋ = −⌈−x⌉.
    let (from, to) = ([128 - minor, start], [128 - minor_end, end]);
    block.rises = minor_end < minor;
    if !cfg!(for_size)
        && ShortEdge::fits((minor_end - minor).abs(), end - start)
        && let Some(mut edge) = ShortEdge::new(from, to, steps.start)
    {
        pixels(block, steep, &steps, &across, || -i32::from(edge.next()));
    } else {
        let mut edge = Edge::new(from, to, steps.start);
        pixels(block, steep, &steps, &across, || -edge.next());
    }
}

/// Draws one pixel for each step along the longer axis. `next` returns the next pixel's place across that axis.
#[inline(always)]
#[allow(clippy::inline_always)] // so that the edge stays in registers
fn pixels(
    mut block: Block<'_>,
    steep: bool,
    steps: &Range<i32>,
    across: &Range<i32>,
    mut next: impl FnMut() -> i32,
) {
    let size = (across.end - across.start).max(0).cast_unsigned();
    let is_inside = |at: i32| at.wrapping_sub(across.start).cast_unsigned() < size;
    if steep {
        block.fill(steps, || {
            let column = next();
            if is_inside(column) {
                [column as i16, column as i16 + 1]
            } else {
                [0; 2]
            }
        });
        return;
    }
    // Consecutive pixels of one row are drawn as one span, which starts at `first`.
    let mut first = steps.start;
    let mut row = next();
    for step in steps.clone() {
        let following = next();
        if following != row || step + 1 == steps.end {
            if is_inside(row) {
                block.add(row, &(first..step + 1));
            }
            (first, row) = (step + 1, following);
        }
    }
    block.draw();
}

/// Whether a line does not pass the center of the pixel that contains an end of the line.
#[inline]
fn is_beyond(end: &ClippedVertex, steep: bool, is_last: bool) -> bool {
    (along(end, steep) & 255 <= 128) == is_last
}

/// An end's coordinate along the longer axis.
#[inline]
fn along(end: &ClippedVertex, steep: bool) -> i32 {
    let [x, y] = end.vertex.screen;
    if steep { y } else { x }
}

/// Whether a line's longer axis is vertical, and the line's ends from left to right or, if it is steep, from top to
/// bottom.
#[inline]
fn in_order([from, to]: [&ClippedVertex; 2]) -> (bool, [&ClippedVertex; 2]) {
    let ([x0, y0], [x1, y1]) = (from.vertex.screen, to.vertex.screen);
    let steep = x0.abs_diff(x1) < y0.abs_diff(y1);
    if along(to, steep) < along(from, steep) {
        (steep, [to, from])
    } else {
        (steep, [from, to])
    }
}

/// A line from its left to its right end or, if it is steep, from its upper to its lower end.
pub(super) struct Course<'r> {
    pub(super) block: Block<'r>,
    pub(super) steep: bool,
    /// The ends: the coordinate along the longer axis, then the coordinate across it.
    pub(super) start: [i32; 2],
    pub(super) end: [i32; 2],
    /// The pixels along the longer axis whose centers the line passes, within the scissor.
    pub(super) steps: Range<i32>,
    /// The pixels across the longer axis that are in the scissor.
    pub(super) across: Range<i32>,
}

impl<'r> Course<'r> {
    /// Sets up the interpolants over a line; `None` if it passes no center within the scissor.
    #[inline]
    pub(super) fn new(raster: &'r mut Rasterizer<'_>, ends: [&ClippedVertex; 2]) -> Option<Self> {
        let (steep, ends) = in_order(ends);
        Self::in_order(raster, steep, ends)
    }

    /// Does the same as [`new`](Self::new) for a line whose ends are [in order](in_order).
    #[inline]
    fn in_order(
        raster: &'r mut Rasterizer<'_>,
        steep: bool,
        [from, to]: [&ClippedVertex; 2],
    ) -> Option<Self> {
        let scissor = raster.scissor;
        // The coordinates along the longer axis and across it.
        let major_first = |[x, y]: [i32; 2]| if steep { [y, x] } else { [x, y] };
        let [start, minor] = major_first(from.vertex.screen);
        let [end, minor_end] = major_first(to.vertex.screen);
        let (along, across) = if steep {
            (&scissor.rows, &scissor.columns)
        } else {
            (&scissor.columns, &scissor.rows)
        };
        let steps = meet(&(first_center(start)..first_center(end)), along);
        if steps.is_empty() {
            return None;
        }

        // Values change along the longer axis only. A sliver along that axis, one pixel wide, defines their plane.
        let at = |end: &ClippedVertex, place: [i32; 2]| ScreenVertex {
            screen: major_first(place),
            q: end.vertex.q,
            exponent: end.vertex.exponent,
            ..ScreenVertex::UNSET
        };
        let block = if raster.coloring.varies {
            let [a, b, c] = [
                at(from, [start, 128]),
                at(to, [end, 128]),
                at(to, [end, 384]),
            ];
            let area = (end - start) << 8;
            raster.set_up(&Patch {
                vertices: [&a, &b, &c],
                barycentric: Some(&[from.barycentric, to.barycentric, to.barycentric]),
                size: major_first([end - start, 256]),
                area: if steep { -area } else { area }.into(),
            })
        } else {
            raster.set_up(&Patch::EVEN)
        };
        Some(Self {
            block,
            steep,
            start: [start, minor],
            end: [end, minor_end],
            steps,
            across: across.clone(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::Scissor;
    use super::*;
    use crate::fixtures::picture::{Picture, clipped};

    /// Draws a line between two places in quarters of a pixel.
    fn draw(picture: &mut Picture, scissor: &Scissor, ends: [[i32; 2]; 2]) {
        let [from, to] = ends.map(|end| clipped(end.map(|at| at * 64)));
        picture.draw(scissor, |raster| line(raster, [&from, &to]));
    }

    /// A line in each octant, from either end.
    #[test]
    fn a_line_in_each_octant() {
        // Around the center of pixel (6, 6), two lines lead to the right, two down, two to the left and two up. The two
        // lines of a pair turn aside by a third of their length, to opposite sides.
        let ends = [
            [[34, 26], [46, 30]],
            [[30, 34], [34, 46]],
            [[22, 34], [18, 46]],
            [[18, 30], [6, 34]],
            [[18, 22], [6, 18]],
            [[22, 18], [18, 6]],
            [[30, 18], [34, 6]],
            [[34, 22], [46, 18]],
        ];
        let expected = [
            ".............",
            "....7...8....",
            "....7...8....",
            ".....7.8.....",
            ".66..7.8..99.",
            "...66...99...",
            "........22...",
            "...55.....22.",
            ".55..4.3.....",
            ".....4.3.....",
            "....4...3....",
            "....4...3....",
            ".............",
        ];
        let mut picture = Picture::new(13, 13);
        let mut turned = Picture::new(13, 13);
        let scissor = picture.scissor();
        for (ink, [from, to]) in ('2'..).zip(ends) {
            (picture.ink, turned.ink) = (ink, ink);
            draw(&mut picture, &scissor, [from, to]);
            draw(&mut turned, &scissor, [to, from]);
        }
        picture.assert(&expected);
        turned.assert(&expected);
    }

    /// Each line starts where the line before ends. The pixel there is blended once, whether the end is on the pixel's
    /// center or beside it.
    #[test]
    fn lines_end_to_end_blend_no_pixel_twice() {
        let mut picture = Picture::new(12, 4);
        picture.blends = true;
        let scissor = picture.scissor();
        let places = [[2, 2], [14, 6], [26, 6], [38, 14], [46, 10]];
        for (ink, ends) in ('a'..).zip(places.windows(2)) {
            picture.ink = ink;
            draw(&mut picture, &scissor, [ends[0], ends[1]]);
        }
        picture.assert(&[
            "aa..........",
            "..abbbc.....",
            ".......cc...",
            ".........dd.",
        ]);
    }

    #[test]
    fn a_line_is_cut_at_the_scissor_and_at_bands() {
        let ends = [[2, 3], [46, 13]];
        let mut frame = Picture::new(12, 4);
        let scissor = frame.scissor();
        draw(&mut frame, &scissor, ends);
        let mut bands = Picture::new(12, 4);
        for row in 0..4 {
            let rows = row..row + 1;
            let band = Scissor {
                rows,
                ..scissor.clone()
            };
            draw(&mut bands, &band, ends);
        }
        assert_eq!(frame.text(), bands.text());
        frame.assert(&[
            "##..........",
            "..####......",
            "......####..",
            "..........##",
        ]);
        let mut inner = Picture::new(12, 4);
        let scissor = Scissor {
            columns: 3..8,
            rows: 1..3,
        };
        draw(&mut inner, &scissor, ends);
        inner.assert(&[
            "............",
            "...###......",
            "......##....",
            "............",
        ]);
    }
}
