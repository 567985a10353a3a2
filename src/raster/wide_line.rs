//! Wide lines.

use super::edge::Edge;
use super::line::Course;
use super::scissor::meet;
use super::{ClippedVertex, Rasterizer};

/// Draws a wide line; `half` is half its width, in units of 1/256 pixel.
pub(crate) fn wide_line(raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2], half: i32) {
    let Some(Course {
        mut block,
        steep,
        start: [start, minor],
        end: [end, minor_end],
        steps,
        across,
    }) = Course::new(raster, ends)
    else {
        return;
    };
    // `before` and `last` are hairlines beside this line, stepped as in `line`. A run begins after the pixel of
    // `before`, and ends with the pixel of `last`.
    let beside = |by: i32| {
        Edge::new(
            [128 - minor - by, start],
            [128 - minor_end - by, end],
            steps.start,
        )
    };
    let (mut before, mut last) = (beside(-half - 128), beside(half - 128));
    let mut next = move || 1 - before.next()..1 - last.next();
    if steep {
        for row in steps {
            let columns = meet(&next(), &across);
            if !columns.is_empty() {
                block.add(row, &columns);
            }
        }
        block.draw();
        return;
    }
    // Equal runs side by side are drawn as a block, which starts at `first`. Runs are compared before they are cut at
    // the scissor. So a band has the same spans as the whole frame, and each span has the same rounding.
    let mut first = steps.start;
    let mut rows = next();
    for column in steps.clone() {
        let following = next();
        if following != rows || column + 1 == steps.end {
            for row in meet(&rows, &across) {
                block.draw_alone(row, &(first..column + 1));
            }
            (first, rows) = (column + 1, following);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::{Picture, clipped};
    use crate::{LineStyle, Scalar, fx};

    /// Draws a line between two places in quarters of a pixel.
    fn draw(picture: &mut Picture, width: Scalar, ends: [[i32; 2]; 2]) {
        let [from, to] = ends.map(|end| clipped(end.map(|at| at * 64)));
        let scissor = picture.scissor();
        let half = LineStyle::wide(width).unwrap().half();
        picture.draw(&scissor, |raster| wide_line(raster, [&from, &to], half));
    }

    #[test]
    fn runs_are_across_the_longer_axis() {
        let mut picture = Picture::new(13, 8);
        draw(&mut picture, fx!(3), [[2, 8], [26, 20]]);
        draw(&mut picture, fx!(4), [[42, 30], [36, 2]]);
        picture.assert(&[
            ".......####..",
            "##.....####..",
            "####...####..",
            "######..####.",
            "..####..####.",
            "....##..####.",
            "........####.",
            ".............",
        ]);
    }
}
