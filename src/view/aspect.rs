//! The aspect ratio of a picture.

use embedded_graphics::geometry::Size;

use crate::error::{Error, check_above};
use crate::num::Scalar;
use crate::num::block::saturated;

/// The width of a picture relative to its height.
///
/// A size in pixels or the ratio itself converts to an `Aspect`. The conversion accepts any numbers; a projection
/// returns an error unless width and height are above 0.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Aspect {
    /// The width in units of 2^-16. Width and height are not an array, because `map` over an array would be a loop,
    /// which the compiler does not fold to a constant.
    width: i64,
    height: i64,
}

impl Aspect {
    /// Returns width and height in a common unit, both above zero.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if the width or the height is not above zero.
    pub(super) fn checked(self) -> Result<(i64, i64), Error> {
        let Self { width, height } = self;
        // A size in pixels can be beyond the range of a `Scalar`.
        let scalar = |side| Scalar::from_bits(saturated(side));
        check_above("width of the aspect ratio", scalar(width), Scalar::ZERO)?;
        check_above("height of the aspect ratio", scalar(height), Scalar::ZERO)?;
        Ok((width, height))
    }
}

impl From<(u32, u32)> for Aspect {
    fn from((width, height): (u32, u32)) -> Self {
        Self {
            width: i64::from(width) << 16,
            height: i64::from(height) << 16,
        }
    }
}

impl From<Size> for Aspect {
    fn from(size: Size) -> Self {
        Self::from((size.width, size.height))
    }
}

impl From<Scalar> for Aspect {
    fn from(ratio: Scalar) -> Self {
        Self {
            width: ratio.to_bits().into(),
            height: 1 << 16,
        }
    }
}
