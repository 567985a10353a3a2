//! Grays of four bits, two in a byte.

use embedded_graphics::pixelcolor::Gray4;

use super::Sampler;
use super::sampler::Grid;
use crate::Error;
use crate::error::{check_parts, ok};

/// A texture of 16 grays that takes half a byte for each texel: a mask, or a picture for a gray panel.
///
/// The left texel of each two is in the high bits of a byte, and rows follow each other without a gap. Width and height
/// are powers of two, and the width is at least 2.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray4;
/// use fixel::texture::{PackedGray4, Sampler};
/// static DROP: PackedGray4 = match PackedGray4::new(&[0x0f, 0xa5], 2, 2) {
///     Ok(drop) => drop,
///     Err(_) => panic!(),
/// };
/// assert_eq!((&DROP).texel(1, 0), Gray4::new(15));
/// assert_eq!((&DROP).texel(2, 1), Gray4::new(10)); // it repeats
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PackedGray4<'a> {
    /// Pairs of texels.
    pairs: Grid<'a, u8>,
}

impl<'a> PackedGray4<'a> {
    /// A texture of `width` x `height` texels.
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two, or if one is above
    /// [`MAX_TEXTURE_SIZE`](super::MAX_TEXTURE_SIZE); [`Error::Parts`] if the width is 1; [`Error::Length`] if `bytes`
    /// does not have exactly one element for each two texels.
    pub const fn new(bytes: &'a [u8], width: u32, height: u32) -> Result<Self, Error> {
        // A power of two, so the error below would name no bound that it violates.
        if width == 1 {
            ok!(check_parts("columns", width, [2, 1 << 15]));
        }
        // Texels have columns of 15 bits.
        if !width.is_power_of_two() || width > 1 << 15 {
            let (of, given, max) = ("width", width, 1 << 15);
            return Err(Error::PowerOfTwo { of, given, max });
        }
        let pairs = ok!(Grid::new(bytes, width / 2, height));
        Ok(Self { pairs })
    }
}

impl Sampler for PackedGray4<'_> {
    type Color = Gray4;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        let [width, height] = self.pairs.size_log2();
        [width + 1, height]
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> Gray4 {
        let pair = self.pairs.get(u >> 1, v).unwrap_or_default();
        Gray4::new(if u & 1 == 0 { pair >> 4 } else { pair & 15 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_that_do_not_fit_are_refused() {
        let bytes = [0; 8];
        assert!(PackedGray4::new(&bytes, 4, 4).is_ok());
        assert_eq!(
            std::string::ToString::to_string(&PackedGray4::new(&bytes, 1, 16).unwrap_err()),
            "number of columns is 1: it must lie between 2 and 32768"
        );
        for (width, height) in [(3, 4), (0, 4), (4, 3), (1 << 16, 1)] {
            assert!(
                matches!(
                    PackedGray4::new(&bytes, width, height),
                    Err(Error::PowerOfTwo { .. })
                ),
                "{width}x{height}"
            );
        }
        let (given, needed) = (8, 4);
        let refused = PackedGray4::new(&bytes, 4, 2);
        assert_eq!(refused, Err(Error::Length { given, needed }));
    }

    #[test]
    fn texels_repeat_far_away() {
        let bytes = [0x01, 0x23, 0x45, 0x67];
        let gray = PackedGray4::new(&bytes, 4, 2).unwrap();
        for (u, v, luma) in [(0, 0, 0), (3, 0, 3), (-1, -1, 7), (i32::MIN, i32::MAX, 4)] {
            assert_eq!(gray.texel(u, v), Gray4::new(luma), "{u}, {v}");
        }
    }
}
