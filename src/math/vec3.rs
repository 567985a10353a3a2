//! Points and directions in space.

use crate::Scalar;

/// A point or a direction in model, world or eye space: three [`Scalar`]s.
///
/// The axes are right-handed. Every operation saturates at the ends of the format, and none panics:
///
/// | operation | rounding |
/// |---|---|
/// | `a + b`, `a - b`, `-a`, `+=`, `-=`, `sum()` | exact |
/// | `a * k`, `k * a`, `a *= k` | to nearest, halves up |
/// | `a / k`, `a /= k` | to nearest, halves away from zero |
///
/// Division by zero saturates each component by its sign; 0/0 is 0.
///
/// ```
/// use fixel::{Vec3, fx, vec3};
/// let eye = vec3!(0, 1.5, -2);
/// assert_eq!(eye - Vec3::Y, vec3!(0, 0.5, -2));
/// assert_eq!(fx!(2) * eye / fx!(3), vec3!(0, 1, -1.33333));
/// assert_eq!(Vec3::try_from([0.0, 1.5, -2.0]), Ok(eye));
/// assert_eq!(Vec3::from([fx!(0), fx!(1.5), fx!(-2)]), eye);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec3 {
    /// To the right.
    pub x: Scalar,
    /// Up.
    pub y: Scalar,
    /// Towards the viewer.
    pub z: Scalar,
}

impl Vec3 {
    /// The origin.
    pub const ZERO: Self = Self::from_ints(0, 0, 0);
    /// The unit vector along x.
    pub const X: Self = Self::from_ints(1, 0, 0);
    /// The unit vector along y.
    pub const Y: Self = Self::from_ints(0, 1, 0);
    /// The unit vector along z.
    pub const Z: Self = Self::from_ints(0, 0, 1);

    /// Makes a vector from its components.
    #[must_use]
    pub const fn new(x: Scalar, y: Scalar, z: Scalar) -> Self {
        Self { x, y, z }
    }

    /// Makes a vector from whole numbers; exact.
    #[must_use]
    pub const fn from_ints(x: i16, y: i16, z: i16) -> Self {
        Self::from_bits([(x as i32) << 16, (y as i32) << 16, (z as i32) << 16])
    }

    /// Makes a vector from the bits of its components, in units of 2⁻¹⁶.
    #[must_use]
    pub const fn from_bits(bits: [i32; 3]) -> Self {
        Self::new(
            Scalar::from_bits(bits[0]),
            Scalar::from_bits(bits[1]),
            Scalar::from_bits(bits[2]),
        )
    }

    /// Returns the bits of the components, in units of 2⁻¹⁶.
    #[must_use]
    pub const fn to_bits(self) -> [i32; 3] {
        [self.x.to_bits(), self.y.to_bits(), self.z.to_bits()]
    }
}

/// A [`Vec3`] from three literals, each rounded to the nearest [`Scalar`] at compile time.
///
/// A literal out of range does not compile. For components that are not literals, use [`Vec3::new`].
///
/// ```
/// use fixel::{Vec3, vec3};
/// const UP: Vec3 = vec3!(0, 1, 0);
/// assert_eq!(UP, Vec3::Y);
/// ```
/// ```compile_fail
/// let x = 0.5;
/// let _ = fixel::vec3!(-x, 0, 0); // error: expected a literal, such as 0.5; …
/// ```
#[macro_export]
macro_rules! vec3 {
    ($x:expr, $y:expr, $z:expr $(,)?) => {
        $crate::Vec3::new($crate::fx!($x), $crate::fx!($y), $crate::fx!($z))
    };
}
