//! Lines: one pixel per column or row, whichever is longer.

use core::ops::Range;

use super::edge::{Edge, first_center};
use super::{Planes, Window, align, span, varies};
use crate::geometry::{DepthShift, Projected};
use crate::interpolate::{Interpolate, Slope};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};

/// Draws a line: along its longer axis every pixel whose centre is passed. A centre at the left (of
/// steep lines: upper) end belongs to the line, one at the right (lower) end does not, so that
/// lines end to end draw no pixel twice while they go on along the same axis.
///
/// Which pixels does not depend on the line's direction. Across, the pixel is the one the line is in.
pub(crate) fn line<I, F, O, D, const N: usize>(
    canvas: &mut Canvas<'_, F::Color, O, D>,
    window: &Window,
    mut ends: [Projected; 2],
    mut varyings: [[i32; N]; 2],
    (fragment, depth_shift): (&F, DepthShift),
) where
    I: Interpolate,
    F: Fragment<N>,
    O: Storage<F::Color>,
    D: DepthBuffer,
{
    let [[x0, y0], [x1, y1]] = ends.map(|end| end.screen);
    let steep = x0.abs_diff(x1) < y0.abs_diff(y1);
    let major = usize::from(steep);
    if ends[1].screen[major] < ends[0].screen[major] {
        ends.reverse();
        varyings.reverse();
    }
    let [from, to] = ends.map(|end| end.screen);
    let (along, across) = if steep {
        (&window.rows, &window.columns)
    } else {
        (&window.columns, &window.rows)
    };
    let steps = first_center(from[major]).max(along.start)..first_center(to[major]).min(along.end);
    if steps.is_empty() {
        return;
    }
    // The edge runs down its second coordinate: the major axis.
    let minor = 1 - major;
    let mut edge = Edge::new(
        [from[minor], from[major]],
        [to[minor], to[major]],
        steps.start,
    );

    let (q, exponent) = align(&ends);
    let planes = if varies::<F, D, N>() {
        let slope = Slope::along(from[major], from[major].abs_diff(to[major]));
        Planes::new::<I, 2>(slope, q, &varyings, Slope::line)
    } else {
        Planes::EVEN
    };
    let start = from[major] >> 8;
    let paint = (fragment, depth_shift.of(exponent));
    // `step` is the one at which the first of the columns is reached; a steep line has no other.
    let mut draw = |row: i32, columns: Range<i32>, step: i32| {
        span::<I, F, O, D, N>(canvas, (row, columns), &planes, [step - start, 0], paint);
    };
    // Columns of one row are drawn together.
    let mut waiting: Option<(i32, Range<i32>)> = None;
    for step in steps {
        let offset = edge.inside();
        edge.step();
        if steep {
            if across.contains(&offset) {
                draw(step, offset..offset + 1, step);
            }
            continue;
        }
        match &mut waiting {
            Some((row, columns)) if *row == offset => columns.end = step + 1,
            _ => {
                let next = across.contains(&offset).then_some((offset, step..step + 1));
                if let Some((row, columns)) = core::mem::replace(&mut waiting, next) {
                    let start = columns.start;
                    draw(row, columns, start);
                }
            }
        }
    }
    if let Some((row, columns)) = waiting {
        let start = columns.start;
        draw(row, columns, start);
    }
}
