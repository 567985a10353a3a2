//! Points, directions and texture coordinates.

use core::fmt;
use core::ops::{Add, Neg, Sub};

use crate::num::{scalar, tex_coord};
use crate::{Error, Scalar, TexCoord};

/// A point or a direction in model, world or eye space: three [`Scalar`]s.
///
/// Right-handed. Arithmetic saturates at the ends of the format.
///
/// ```
/// use fixel::{vec3, Vec3};
/// let eye = vec3!(0, 1.5, -2);
/// assert_eq!(eye - Vec3::Y, vec3!(0, 0.5, -2));
/// assert_eq!(Vec3::try_from([0.0, 1.5, -2.0]), Ok(eye));
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

    /// A vector of its three components.
    #[must_use]
    pub const fn new(x: Scalar, y: Scalar, z: Scalar) -> Self {
        Self { x, y, z }
    }

    /// A vector of whole numbers; exact.
    #[must_use]
    pub const fn from_ints(x: i16, y: i16, z: i16) -> Self {
        Self::from_bits([(x as i32) << 16, (y as i32) << 16, (z as i32) << 16])
    }

    /// A vector of the components' bits, in units of 2⁻¹⁶.
    #[must_use]
    pub const fn from_bits(bits: [i32; 3]) -> Self {
        Self::new(
            Scalar::from_bits(bits[0]),
            Scalar::from_bits(bits[1]),
            Scalar::from_bits(bits[2]),
        )
    }

    /// The components' bits, in units of 2⁻¹⁶.
    #[must_use]
    pub const fn to_bits(self) -> [i32; 3] {
        [self.x.to_bits(), self.y.to_bits(), self.z.to_bits()]
    }
}

impl fmt::Display for Vec3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {}, {})", self.x, self.y, self.z)
    }
}

impl TryFrom<[f64; 3]> for Vec3 {
    type Error = Error;

    /// The nearest representable vector.
    fn try_from([x, y, z]: [f64; 3]) -> Result<Self, Error> {
        Ok(Self::new(scalar(x)?, scalar(y)?, scalar(z)?))
    }
}

impl TryFrom<[f32; 3]> for Vec3 {
    type Error = Error;

    /// The nearest representable vector.
    fn try_from(v: [f32; 3]) -> Result<Self, Error> {
        Self::try_from(v.map(f64::from))
    }
}

impl Add for Vec3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(
            self.x.saturating_add(other.x),
            self.y.saturating_add(other.y),
            self.z.saturating_add(other.z),
        )
    }
}

impl Sub for Vec3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(
            self.x.saturating_sub(other.x),
            self.y.saturating_sub(other.y),
            self.z.saturating_sub(other.z),
        )
    }
}

impl Neg for Vec3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

/// A texture coordinate: (0, 0) is the top left corner of the texture, (1, 1) the bottom right of
/// its first repeat; `v` runs down, as the rows are stored. Two [`TexCoord`]s: up to 2048 repeats each way.
///
/// ```
/// use fixel::{vec2, Vec2};
/// assert_eq!(vec2!(0.5, 1), Vec2::try_from([0.5, 1.0]).unwrap());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec2 {
    /// To the right.
    pub x: TexCoord,
    /// Down.
    pub y: TexCoord,
}

impl Vec2 {
    /// A texture coordinate of its two components.
    #[must_use]
    pub const fn new(x: TexCoord, y: TexCoord) -> Self {
        Self { x, y }
    }

    /// A texture coordinate of the components' bits, in units of 2⁻²⁰.
    #[must_use]
    pub const fn from_bits(bits: [i32; 2]) -> Self {
        Self::new(TexCoord::from_bits(bits[0]), TexCoord::from_bits(bits[1]))
    }

    /// The components' bits, in units of 2⁻²⁰.
    #[must_use]
    pub const fn to_bits(self) -> [i32; 2] {
        [self.x.to_bits(), self.y.to_bits()]
    }
}

impl TryFrom<[f64; 2]> for Vec2 {
    type Error = Error;

    /// The nearest representable texture coordinate.
    fn try_from([x, y]: [f64; 2]) -> Result<Self, Error> {
        Ok(Self::new(tex_coord(x)?, tex_coord(y)?))
    }
}

impl TryFrom<[f32; 2]> for Vec2 {
    type Error = Error;

    /// The nearest representable texture coordinate.
    fn try_from(v: [f32; 2]) -> Result<Self, Error> {
        Self::try_from(v.map(f64::from))
    }
}

/// A [`Vec3`] of three literals, rounded to the nearest while compiling.
///
/// ```
/// use fixel::{vec3, Vec3};
/// const UP: Vec3 = vec3!(0, 1, 0);
/// assert_eq!(UP, Vec3::Y);
/// ```
#[macro_export]
macro_rules! vec3 {
    ($x:expr, $y:expr, $z:expr $(,)?) => {
        $crate::Vec3::new($crate::fx!($x), $crate::fx!($y), $crate::fx!($z))
    };
}

/// A [`Vec2`] of two literals, rounded to the nearest while compiling.
///
/// A literal out of range does not compile.
///
/// ```
/// use fixel::{vec2, TexCoord};
/// assert_eq!(vec2!(0.5, -1).x, TexCoord::lit("0.5"));
/// assert_eq!(vec2!(0.5, 0.2).to_bits(), [524_288, 209_715]);
/// ```
/// ```compile_fail
/// let _ = fixel::vec2!(0, 2048);
/// ```
#[macro_export]
macro_rules! vec2 {
    ($x:expr, $y:expr $(,)?) => {
        const {
            #[allow(clippy::cast_lossless, clippy::unnecessary_cast)]
            $crate::Vec2::new(
                $crate::num::literal_tex_coord($x as f64),
                $crate::num::literal_tex_coord($y as f64),
            )
        }
    };
}
