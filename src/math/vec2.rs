//! Texture coordinates.

use crate::num::TexCoord;

/// A texture coordinate: two [`TexCoord`]s, up to 2048 repeats of the texture in each direction.
///
/// (0, 0) is the top left corner of the texture and (1, 1) the bottom right corner of its first repeat. `y` increases
/// downward, in the order of the stored rows.
///
/// `Vec2` has the operators of [`Vec3`](crate::Vec3), with the same rounding and saturation; none of them panics. The
/// factor or divisor is a [`Scalar`](crate::Scalar) or an `i32`.
///
/// ```
/// use fixel::{Vec2, fx, vec2};
/// let corner = vec2!(0.5, 1);
/// assert_eq!(corner * fx!(3) - vec2!(1, 1), vec2!(0.5, 2));
/// assert_eq!(Vec2::try_from([0.5, 1.0]), Ok(corner));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec2 {
    /// Increases to the right.
    pub x: TexCoord,
    /// Increases downward.
    pub y: TexCoord,
}

impl Vec2 {
    /// The top left corner of the texture.
    pub const ZERO: Self = Self::from_bits([0, 0]);
}

/// A [`Vec2`] from two literals, each rounded to the nearest [`TexCoord`] at compile time.
///
/// A literal out of range does not compile. For components that are not literals, use [`Vec2::new`].
///
/// ```
/// use fixel::{TexCoord, vec2};
/// assert_eq!(vec2!(0.5, -1).x, TexCoord::ONE / 2);
/// assert_eq!(vec2!(0.5, 0.2).to_bits(), [524_288, 209_715]);
/// ```
/// ```compile_fail
/// let _ = fixel::vec2!(0, 2048);
/// ```
#[macro_export]
macro_rules! vec2 {
    (@ $value:expr) => {
        $crate::__rounded!(
            TexCoord::nearest,
            "expected two literals, such as vec2!(0.5, 1); for TexCoords write Vec2::new(x, y), and for other numbers \
             Vec2::try_from([x, y])?",
            $value
        )
    };
    ($x:expr, $y:expr $(,)?) => {
        $crate::Vec2::new($crate::vec2!(@ $x), $crate::vec2!(@ $y))
    };
}
