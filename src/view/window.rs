//! The rectangle that a projection shows.

use crate::error::{Error, check_above};
use crate::num::Scalar;

/// The edges of the rectangle in eye space that fills the picture.
///
/// In perspective, the rectangle lies on the near plane. Under a parallel projection, it is the cross section of the
/// visible box. `x` increases to the right, and `y` increases upward.
///
/// A `Window` can hold any numbers. A projection refuses a window unless `left` < `right` and `bottom` < `top`.
///
/// ```
/// use fixel::prelude::*;
/// use fixel::Window;
/// let window = Window { left: fx!(-1), right: fx!(2), bottom: fx!(-1), top: fx!(1) };
/// let projection = Projection::frustum(window, fx!(2), fx!(10))?;
/// assert_eq!(projection.window(), window);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Window {
    /// x of the left edge.
    pub left: Scalar,
    /// x of the right edge.
    pub right: Scalar,
    /// y of the bottom edge.
    pub bottom: Scalar,
    /// y of the top edge.
    pub top: Scalar,
}

impl Window {
    /// Makes a window of this width and height, centered on the line of sight.
    ///
    /// The left and the right edge are half the width away from the center, and the top and the bottom edge half the
    /// height; these halves are rounded toward zero to a multiple of 2⁻¹⁶.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// let window = Window::centered(fx!(4), fx!(3));
    /// assert_eq!((window.left, window.top), (fx!(-2), fx!(1.5)));
    /// ```
    #[must_use]
    pub const fn centered(width: Scalar, height: Scalar) -> Self {
        let [x, y] = [width.to_bits() / 2, height.to_bits() / 2];
        Self {
            left: Scalar::from_bits(-x),
            right: Scalar::from_bits(x),
            bottom: Scalar::from_bits(-y),
            top: Scalar::from_bits(y),
        }
    }

    /// Returns width and height in units of 2^-16, both above zero.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless `left` < `right` and `bottom` < `top`.
    pub(super) fn checked(&self) -> Result<(i64, i64), Error> {
        let width = check_above("right edge of the window", self.right, self.left)?;
        let height = check_above("top edge of the window", self.top, self.bottom)?;
        Ok((width, height))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn centered_windows_are_symmetric_at_the_ends_of_the_format() {
        let window = Window::centered(Scalar::MAX, Scalar::MIN);
        // 2^31 − 1 is odd: half of it is rounded toward zero.
        assert_eq!(window.right.to_bits(), (1 << 30) - 1);
        assert_eq!(window.left, -window.right);
        assert_eq!(window.top.to_bits(), -(1 << 30));
        assert_eq!(window.bottom, -window.top);
    }
}
