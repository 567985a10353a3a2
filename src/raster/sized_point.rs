//! Points with a size: squares and discs.

use super::scissor::meet;
use super::{Rasterizer, ScreenVertex, point};
use crate::error::{Error, check_above, ok};
use crate::num::Scalar;

/// The size and the shape of points, for [`Mesh::points`](crate::Mesh::points).
///
/// By default, a point is [one pixel](Self::PIXEL).
///
/// A pixel belongs to a point if its center lies within the square or disc around the point's position on the screen.
/// The position is exact to 1/256 pixel. A center exactly on the lower or the right border of a square is within the
/// square; a center on the upper or the left border is not. So if n is a whole number, a square of size n always covers
/// n × n pixels, and a square of size 1 is [one pixel](Self::PIXEL). If the positions of two squares are as far apart
/// as the squares are wide, the squares touch without a gap or an overlap. A center on the border of a disc is within
/// the disc. A disc also covers the pixel that contains its position, even if this pixel's center lies outside.
///
/// A size below 1 pixel is drawn as 1 pixel, and a size above 255 pixels as 255 pixels. All pixels of a square or disc
/// have the depth and the varyings of its position.
///
/// ```
/// use fixel::prelude::*;
/// let star = PointStyle::square(fx!(2))?; // pixels
/// let ball = PointStyle::round(fx!(0.25))?.attenuated(); // units of world space
/// assert!(PointStyle::round(fx!(0)).is_err());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PointStyle {
    size: Scalar,
    is_round: bool,
    is_attenuated: bool,
}

impl Default for PointStyle {
    fn default() -> Self {
        Self::PIXEL
    }
}

impl PointStyle {
    /// Points of one pixel: the pixel that contains the position. For this style, [`size`](Self::size) returns 0.
    pub const PIXEL: Self = Self {
        size: Scalar::ZERO,
        is_round: false,
        is_attenuated: false,
    };

    /// Upright squares with sides of `size` pixels, rounded to the nearest 1/128.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless `size` is above 0.
    pub const fn square(size: Scalar) -> Result<Self, Error> {
        ok!(check_above("point size", size, Scalar::ZERO));
        Ok(Self {
            size,
            is_round: false,
            is_attenuated: false,
        })
    }

    /// Discs with a diameter of `size` pixels, rounded to the nearest 1/128.
    ///
    /// # Errors
    ///
    /// The same as for [`square`](Self::square).
    pub const fn round(size: Scalar) -> Result<Self, Error> {
        Ok(Self {
            is_round: true,
            ..ok!(Self::square(size))
        })
    }

    /// The same style with a size in world units, so that points become smaller with the distance.
    ///
    /// If a projection scales x and y differently, the scale of y determines the size on the screen. A scale in the
    /// model's transform does not change the size.
    #[must_use]
    pub const fn attenuated(self) -> Self {
        Self {
            is_attenuated: true,
            ..self
        }
    }

    /// The side of the square or the diameter of the disc, in pixels; for an [attenuated](Self::attenuated) style, in
    /// units of world space.
    #[must_use]
    pub const fn size(self) -> Scalar {
        self.size
    }

    /// Whether points are single pixels.
    #[inline]
    pub(crate) fn is_pixel(self) -> bool {
        self.size == Scalar::ZERO
    }

    /// Whether points are discs.
    #[must_use]
    pub const fn is_round(self) -> bool {
        self.is_round
    }

    /// Whether the size is in world units.
    #[must_use]
    pub const fn is_attenuated(self) -> bool {
        self.is_attenuated
    }
}

/// Half the least and half the greatest size that is drawn, in units of 1/256 pixel. The square of the greatest number
/// fits into 31 bits.
const HALF: [i64; 2] = [128, 255 * 128];

/// The first column (or row) with a center beyond a coordinate in units of 1/256 pixel.
const fn beyond(at: i32) -> i32 {
    (at + 128) >> 8
}

/// Half the size of a point, clamped to the sizes that are drawn, in units of 1/256 pixel.
#[inline]
pub(crate) fn half_size(half: i64) -> i32 {
    let [least, most] = HALF;
    half.clamp(least, most) as i32
}

/// Draws the square or disc around a point; `half` is its [`half_size`].
pub(crate) fn sized_point(
    raster: &mut Rasterizer<'_>,
    at: &ScreenVertex,
    half: i32,
    is_round: bool,
) {
    let scissor = raster.scissor;
    let [x, y] = at.screen;
    // A disc includes its upper border, a square does not.
    let top = y - half - i32::from(is_round);
    let rows = meet(&(beyond(top)..beyond(y + half)), &scissor.rows);
    if rows.is_empty() {
        return;
    }
    let mut block = point::set_up(raster, at, None);
    for row in rows {
        let columns = if is_round {
            let away = (row << 8) + 128 - y;
            let reach = (half * half - away * away)
                .cast_unsigned()
                .isqrt()
                .cast_signed();
            // A center at a distance of exactly `reach` belongs to the disc, on either side.
            let columns = beyond(x - reach - 1)..beyond(x + reach);
            if row == y >> 8 {
                columns.start.min(x >> 8)..columns.end.max((x >> 8) + 1)
            } else {
                columns
            }
        } else {
            beyond(x - half)..beyond(x + half)
        };
        let columns = meet(&columns, &scissor.columns);
        if !columns.is_empty() {
            block.add(row, &columns);
        }
    }
    block.draw();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::{Picture, vertex};

    /// Draws a point. The place and the size of the point are in quarters of a pixel.
    fn draw(picture: &mut Picture, place: [i32; 2], size: i64, is_round: bool) {
        let scissor = picture.scissor();
        let at = vertex(place.map(|at| at * 64));
        picture.draw(&scissor, |raster| {
            sized_point(raster, &at, half_size(size * 32), is_round);
        });
    }

    #[test]
    fn squares_adjoin_without_overlaps() {
        let mut picture = Picture::new(9, 6);
        for (ink, place) in ('a'..).zip([[1, 3], [13, 3], [25, 3], [1, 15], [13, 15], [25, 15]]) {
            picture.ink = ink;
            draw(&mut picture, place, 12, false);
        }
        picture.assert(&[
            "aabbbccc.",
            "aabbbccc.",
            "ddeeefff.",
            "ddeeefff.",
            "ddeeefff.",
            ".........",
        ]);
    }

    #[test]
    fn discs_are_symmetric_and_never_empty() {
        let mut picture = Picture::new(18, 8);
        draw(&mut picture, [16, 16], 28, true);
        draw(&mut picture, [46, 14], 12, true);
        draw(&mut picture, [60, 24], 4, true);
        picture.assert(&[
            "..................",
            "..####............",
            ".######...###.....",
            ".######...###.....",
            ".######...###.....",
            ".######...........",
            "..####.........#..",
            "..................",
        ]);
    }

    #[test]
    fn the_border_of_a_disc_belongs_to_it_on_all_sides() {
        let mut picture = Picture::new(7, 7);
        draw(&mut picture, [14, 14], 24, true);
        picture.assert(&[
            "...#...", ".#####.", ".#####.", "#######", ".#####.", ".#####.", "...#...",
        ]);
    }
}
