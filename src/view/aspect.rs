//! The aspect ratio of a picture.

use embedded_graphics::geometry::Size;

use crate::{Error, Scalar};

/// The width of a picture relative to its height.
///
/// It converts from a size in pixels, or from the ratio itself. The conversion accepts any number; a projection refuses
/// a width or a height that is not above 0.
///
/// ```
/// use embedded_graphics::geometry::Size;
/// use fixel::{fx, Aspect};
/// assert_eq!(Aspect::from((320, 240)), Aspect::from(Size::new(320, 240)));
/// let wide: Aspect = fx!(1.5).into();
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Aspect {
    /// In units of 2^-16.
    width: i64,
    /// In units of 2^-16.
    height: i64,
}

impl Aspect {
    /// Returns width and height in a common unit, both above zero.
    ///
    /// # Errors
    ///
    /// [`Error::Aspect`] otherwise.
    pub(super) fn checked(self) -> Result<(i64, i64), Error> {
        if self.width > 0 && self.height > 0 {
            Ok((self.width, self.height))
        } else {
            // A size in pixels may be out of range.
            let scalar =
                |v: i64| Scalar::from_bits(v.clamp(i32::MIN.into(), i32::MAX.into()) as i32);
            Err(Error::Aspect {
                width: scalar(self.width),
                height: scalar(self.height),
            })
        }
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
            height: Scalar::ONE.to_bits().into(),
        }
    }
}
