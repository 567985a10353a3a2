//! Lines of a width.

use super::edge::Edge;
use super::line::Course;
use super::scissor::meet;
use super::{ClippedVertex, Rasterizer, SmoothLine};
use crate::error::{check_range, ok};
use crate::{Error, Scalar};

/// Lines of a width in pixels. For anti-aliased ones, see [`smooth`](Self::smooth).
///
/// For each pixel center that a line passes along its longer axis, a run of pixels is drawn across that axis: those
/// whose centers are at most half the width away from the line. A center exactly on the upper or left end of the run
/// does not belong to it; a center on the lower or right end does. So a line of width 1 has the pixels of a
/// [`Hairline`](crate::Hairline), and a line of width n has n pixels in each run.
///
/// ```text
///  run        #   #   #            As in OpenGL, the width counts across the longer axis.
///     #   #   #   #   #   ●        A diagonal line is narrower by √½, and its ends are cut
///  ●  #   #   #   #   #            along the axes.
///     #   #   #
/// ```
///
/// ```
/// use fixel::prelude::*;
/// assert_eq!(LineWidth::new(fx!(2.5))?.pixels(), fx!(2.5));
/// assert!(LineWidth::new(fx!(0.5)).is_err());
/// # Ok::<(), Error>(())
/// ```
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
/// let corners = [vec3!(1, -6, 0), vec3!(6, -2, 0), vec3!(11, -6, 0)];
/// let roof = Mesh::new(&corners, &[])?.with_edges(&[[0, 1], [1, 2]])?;
/// let window = Window { left: fx!(0), right: fx!(12), bottom: fx!(-8), top: fx!(0) };
/// let projection = Projection::orthographic(window, fx!(-1), fx!(1))?;
/// let mut color = [BinaryColor::Off; 12 * 8];
/// let mut canvas = Canvas::new(&mut color, 12, 8)?;
/// let white = Flat::new(BinaryColor::On);
/// let wide = DrawOptions::new().with_line(LineWidth::new(fx!(3))?);
/// canvas.draw_edges(&wide, &roof, &projection, &white);
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "............",
///     ".....##.....",
///     "....####....",
///     "..########..",
///     ".####..####.",
///     ".###....###.",
///     ".#........#.",
///     "............",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineWidth {
    /// Half the width, in units of 1/256 pixel.
    pub(crate) half: i32,
}

impl LineWidth {
    /// The greatest width, in pixels.
    pub const MAX: Scalar = crate::fx!(64);

    /// A width in pixels, rounded to the nearest 1/128.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless it lies between 1 and [`MAX`](Self::MAX).
    pub const fn new(pixels: Scalar) -> Result<Self, Error> {
        ok!(check_range("line width", pixels, [Scalar::ONE, Self::MAX]));
        Ok(Self {
            half: (pixels.to_bits() + (1 << 8)) >> 9,
        })
    }

    /// Anti-aliased lines of this width, measured at right angles to the line.
    #[must_use]
    pub const fn smooth(self) -> SmoothLine {
        SmoothLine { width: self }
    }

    /// By how many rows a line of this width may reach beyond its ends, anti-aliased or not.
    pub(crate) const fn reach(self) -> i32 {
        // The center of a pixel that it covers is less than half the width and half a pixel away.
        (self.half + 255) >> 8
    }

    /// The width in pixels.
    #[must_use]
    pub const fn pixels(self) -> Scalar {
        Scalar::from_bits(self.half << 9)
    }
}

/// Draws a line of a width.
pub(crate) fn wide_line(raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2], width: LineWidth) {
    let Some(Course {
        steep,
        start: [start, minor],
        end: [end, minor_end],
        steps,
        across,
    }) = Course::new(raster, ends)
    else {
        return;
    };
    // Two lines beside this one, each as `line` draws it: the pixels of a run begin after those of the one, and end
    // with those of the other.
    let beside = |by: i32| {
        Edge::new(
            [128 - minor - by, start],
            [128 - minor_end - by, end],
            steps.start,
        )
    };
    let (mut before, mut last) = (beside(-width.half - 128), beside(width.half - 128));
    let mut next = move || 1 - before.next()..1 - last.next();
    if steep {
        for row in steps {
            let columns = meet(&next(), &across);
            if !columns.is_empty() {
                raster.span(row, &columns);
            }
        }
        return;
    }
    // Equal runs side by side are drawn as a block, which starts at `first`. They are compared before they are cut: a
    // band must have the spans of the frame, because each span has its own rounding.
    let mut first = steps.start;
    let mut rows = next();
    for column in steps.clone() {
        let following = next();
        if following != rows || column + 1 == steps.end {
            for row in meet(&rows, &across) {
                raster.span(row, &(first..column + 1));
            }
            (first, rows) = (column + 1, following);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::picture::{Picture, clipped};
    use super::*;
    use crate::fx;

    /// Draws a line between two places in quarters of a pixel.
    fn draw(picture: &mut Picture, width: Scalar, ends: [[i32; 2]; 2]) {
        let [from, to] = ends.map(|end| clipped(end.map(|at| at * 64)));
        let scissor = picture.scissor();
        let width = LineWidth::new(width).unwrap();
        wide_line(&mut Rasterizer::new(picture, &scissor), [&from, &to], width);
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
