//! Styles of lines: how wide they are, and whether they are anti-aliased.

use core::ops::Bound::Included;

use crate::error::{Error, check_range, ok};
use crate::num::Scalar;

/// The width of lines, and whether they are anti-aliased; [`Mesh::edges`](crate::Mesh::edges) and
/// [`Mesh::outline`](crate::Mesh::outline) take a style.
///
/// A line is drawn in steps of one pixel: along y if the line is steep (y changes more than x), otherwise along x. Each
/// step draws a run of pixels: a part of a row if the line is steep, otherwise a part of a column. A line from a to b
/// has the same pixels as a line from b to a.
///
/// A run consists of the pixels whose centers are at most half the width away from the line, measured along the run. A
/// center exactly at the upper or left end of the run does not belong to it; a center at the lower or right end does.
/// So a line of width n has n pixels in each run.
///
/// The line has a run at each pixel center between its two ends, measured along the axis of the steps. A center exactly
/// at the left end (in steep lines, the upper end) gets a run; a center exactly at the right end (in steep lines, the
/// lower end) does not.
///
/// A [hairline](Self::HAIRLINE) also draws the pixels that contain its ends, so that lines meet at every corner. If
/// colors are [blended](crate::DrawOptions::with_blending) or translucent, it draws the pixel at an end only if the
/// line passes the pixel's center. So two hairlines that meet do not blend the pixel between them twice.
///
/// ```text
///  run        #   #   #            As in OpenGL, the width counts across the longer axis.
///     #   #   #   #   #   ●        A diagonal line is narrower by √½, and its ends are cut
///  ●  #   #   #   #   #            along the axes.
///     #   #   #
/// ```
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
/// use fixel::Window;
/// let corners = [vec3!(1, -6, 0), vec3!(6, -2, 0), vec3!(11, -6, 0)];
/// let roof = Mesh::new(&corners, &[])?.with_edges(&[[0, 1], [1, 2]])?;
/// let window = Window { left: fx!(0), right: fx!(12), bottom: fx!(-8), top: fx!(0) };
/// let projection = Projection::orthographic(window, fx!(-1), fx!(1))?;
/// let mut color = [BinaryColor::Off; 12 * 8];
/// let mut canvas = Canvas::new(&mut color, 12, 8)?;
/// let wide = LineStyle::wide(fx!(3))?;
/// canvas.draw(roof.edges(wide), &projection, &Flat::new(BinaryColor::On));
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
///
/// # Anti-aliased lines
///
/// In a [`smooth`](Self::smooth) style, each pixel takes the line's color in proportion to the share of the pixel that
/// the line covers. The canvas needs a color that implements [`PixelFormat`](crate::PixelFormat).
///
/// The ends of a line are exact to 1/256 pixel. Let d be the distance from the pixel's center to the nearest point of
/// the line. Then the share is (width + 1)/2 − d, limited to the range from 0 to 1. So the width is measured at right
/// angles to the line, ends are round, and a line looks equally wide in every direction. A share has an error of at
/// most 1.3/256. Blending rounds like [`Opacity`](crate::canvas::Opacity), and dithers coarse colors. On 1-bit panels,
/// hairlines look better.
///
/// All pixels of a step have the same depth and the same varyings: the line's values at this step, as on a hairline.
/// Beyond an end, they have the values at the end. So a pixel may have the depth of a place on the line that is up to
/// √2 · (width + 1)/2 pixels away. A mesh may therefore hide the lines on it. To prevent this, draw the mesh
/// [`Biased`](crate::canvas::Biased) away from the eye, with the slope √2 · (width + 1)/2, as in the example below. Or
/// draw the outline of the mesh `Biased` toward the eye, with the same slope. Draw smooth lines last, with
/// [`TestOnly`](crate::canvas::TestOnly). A line is blended with the colors that are already on the canvas, so a
/// surface behind it that is drawn later does not show through.
///
/// If the draw options have a blending, a pixel's color is first blended with the color on the canvas. The blended
/// color then covers the color on the canvas in proportion to the pixel's share.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::{prelude::*, canvas::{Biased, TestAndWrite, TestOnly}};
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.5), fx!(8))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -4)) * Transform::rotate_y(deg!(30));
/// let (mut color, mut depth) = ([Gray8::BLACK; 24 * 24], [0; 24 * 24]);
/// let mut canvas = Canvas::new(&mut color, 24, 24)?.with_depth(&mut depth)?;
/// canvas.clear(Gray8::BLACK);
/// let behind = DrawOptions::new().with_depth_test(Biased::new(TestAndWrite, -2, fx!(-1.5)));
/// canvas.draw_with(&behind, &BOX, &mvp, &Flat::new(Gray8::new(60)));
/// let last = DrawOptions::new().with_depth_test(TestOnly);
/// let lines = BOX.edges(LineStyle::HAIRLINE.smooth());
/// canvas.draw_with(&last, lines, &mvp, &Flat::new(Gray8::WHITE));
/// assert!(canvas.pixels().any(|pixel| (61..255).contains(&pixel.luma())));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineStyle<const SMOOTH: bool = false> {
    /// Half the width, in units of 1/256 pixel.
    half: i32,
}

impl Default for LineStyle {
    fn default() -> Self {
        Self::HAIRLINE
    }
}

impl LineStyle {
    /// Lines one pixel wide, not anti-aliased. Each step along the longer axis draws the pixel that contains the line.
    pub const HAIRLINE: Self = Self { half: 128 };

    /// The greatest width, in pixels.
    pub const MAX_WIDTH: Scalar = crate::fx!(64);

    /// Lines with a width of `pixels`, rounded to the nearest 1/128.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// assert_eq!(LineStyle::wide(fx!(2.5))?.width(), fx!(2.5));
    /// assert!(LineStyle::wide(fx!(0.5)).is_err());
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless the width lies between 1 and [`MAX_WIDTH`](Self::MAX_WIDTH).
    pub const fn wide(pixels: Scalar) -> Result<Self, Error> {
        ok!(check_range(
            "line width",
            pixels,
            (Included(Scalar::ONE), Included(Self::MAX_WIDTH))
        ));
        Ok(Self {
            half: (pixels.to_bits() + (1 << 8)) >> 9,
        })
    }

    /// The same lines, anti-aliased.
    #[must_use]
    pub const fn smooth(self) -> LineStyle<true> {
        LineStyle { half: self.half }
    }
}

impl<const SMOOTH: bool> LineStyle<SMOOTH> {
    /// The width, in pixels.
    #[must_use]
    pub const fn width(self) -> Scalar {
        Scalar::from_bits(self.half << 9)
    }

    /// Half the width, in units of 1/256 pixel.
    #[inline]
    pub(crate) const fn half(self) -> i32 {
        self.half
    }

    /// Whether lines are one pixel wide and not anti-aliased.
    #[inline]
    pub(crate) const fn is_hairline(self) -> bool {
        !SMOOTH && self.half == LineStyle::HAIRLINE.half
    }

    /// How many rows a line may reach beyond the rows of its ends: 0 to 32.
    #[inline]
    pub(crate) const fn reach(self) -> i32 {
        if self.is_hairline() {
            return 0;
        }
        // The center of a covered pixel is less than half the width plus half a pixel away from the line.
        (self.half + 255) >> 8
    }
}
