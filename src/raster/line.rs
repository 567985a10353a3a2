//! Lines: one pixel per column or row, whichever is longer.

use super::edge::{Edge, first_center};
use super::{Blitter, ClippedVertex, Patch, Scissor, spans};

/// Draws a line.
///
/// Along its longer axis, the line gets one pixel for each pixel center that it passes; across, it is the pixel that
/// contains the line there. A center at the left end (of steep lines, the upper end) belongs to the line, a center at
/// the right (lower) end does not. So lines that continue each other along the same axis draw no pixel twice.
///
/// ```text
///  pixels  |   ·   |   ·   |   ·   |   ·   |
///  line        ●───────────────────────●
///  drawn   |#######|#######|#######|       |
/// ```
///
/// The pixels do not depend on the line's direction.
pub(crate) fn line(blitter: &mut dyn Blitter, scissor: &Scissor, ends: [&ClippedVertex; 2]) {
    let [mut from, mut to] = ends;
    let steep = {
        let ([x0, y0], [x1, y1]) = (from.vertex.screen, to.vertex.screen);
        x0.abs_diff(x1) < y0.abs_diff(y1)
    };
    // The coordinates along the longer axis and across it.
    let major_first = |[x, y]: [i32; 2]| if steep { [y, x] } else { [x, y] };
    let ([mut start, mut minor], [mut end, mut minor_end]) = (
        major_first(from.vertex.screen),
        major_first(to.vertex.screen),
    );
    if end < start {
        (from, to) = (to, from);
        (start, minor, end, minor_end) = (end, minor_end, start, minor);
    }
    let (along, across) = if steep {
        (&scissor.rows, &scissor.columns)
    } else {
        (&scissor.columns, &scissor.rows)
    };
    let steps = first_center(start).max(along.start)..first_center(end).min(along.end);
    if steps.is_empty() {
        return;
    }

    // Values change along the longer axis only. A sliver along that axis, one unit high, defines their plane.
    let longest = blitter.set_up(&Patch {
        vertices: [&from.vertex, &to.vertex, &to.vertex],
        barycentric: Some(&[from.barycentric, to.barycentric, to.barycentric]),
        screen: &[[start, 128], [end, 128], [end, 129]],
        area: i64::from(end - start),
    });

    // An edge runs along its second coordinate, which is the longer axis here.
    let mut edge = Edge::new([minor, start], [minor_end, end], steps.start);
    // Consecutive pixels of one row are drawn as one span, which starts at `first`.
    let mut first = steps.start;
    let mut offset = edge.inside();
    for step in steps.clone() {
        edge.step();
        let next = edge.inside();
        if steep || next != offset || step + 1 == steps.end {
            if across.contains(&offset) {
                let (row, columns) = if steep {
                    (step, offset..offset + 1)
                } else {
                    (offset, first..step + 1)
                };
                spans(blitter, row, columns, [first - (start >> 8), 0], longest);
            }
            (first, offset) = (step + 1, next);
        }
    }
}
