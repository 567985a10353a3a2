//! Points and directions in space.

use crate::num::Scalar;
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt::{measure, unit};

/// A point or a direction in model, world or eye space: three [`Scalar`]s.
///
/// The axes are right-handed. Every operation saturates at the ends of the format, and none panics:
///
/// | operation | rounding |
/// |---|---|
/// | `a + b`, `a - b`, `-a`, `+=`, `-=`, `sum()`, `a * n` with an `i32` | exact |
/// | `a * k`, `k * a`, `a *= k` | to nearest, halves up |
/// | `a / k`, `a /= k`, `a / n` with an `i32` | to nearest, halves away from zero |
///
/// Division by zero turns a positive component into the highest number, and a negative one into the lowest; 0/0 is 0.
///
/// ```
/// use fixel::{Vec3, fx, vec3};
/// let eye = vec3!(0, 1.5, -2);
/// assert_eq!(eye - Vec3::Y, vec3!(0, 0.5, -2));
/// assert_eq!(fx!(2.5) * eye / 3, vec3!(0, 1.25, -1.66667));
/// assert_eq!(Vec3::try_from([0.0, 1.5, -2.0]), Ok(eye));
/// assert_eq!(Vec3::from([fx!(0), fx!(1.5), fx!(-2)]), eye);
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec3 {
    /// Increases to the right.
    pub x: Scalar,
    /// Increases upward.
    pub y: Scalar,
    /// Increases toward the viewer.
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

    /// Makes a vector from whole numbers; exact.
    #[must_use]
    pub const fn from_ints(x: i16, y: i16, z: i16) -> Self {
        Self::from_bits([(x as i32) << 16, (y as i32) << 16, (z as i32) << 16])
    }
}

/// A [`Vec3`] from three literals, each rounded to the nearest [`Scalar`] at compile time.
///
/// A literal out of range does not compile. For components that are not literals, use [`Vec3::new`]. Literals near 0
/// lose digits like those of [`fx!`](crate::fx).
///
/// ```
/// use fixel::{Vec3, vec3};
/// const UP: Vec3 = vec3!(0, 1, 0);
/// assert_eq!(UP, Vec3::Y);
/// ```
/// ```compile_fail
/// let x = 0.5;
/// let _ = fixel::vec3!(-x, 0, 0); // error: expected three literals, such as vec3!(0, 1.5, -2); …
/// ```
#[macro_export]
macro_rules! vec3 {
    (@ $value:expr) => {
        $crate::__rounded!(
            Scalar::nearest,
            "expected three literals, such as vec3!(0, 1.5, -2); for Scalars write Vec3::new(x, y, z), and for other \
             numbers Vec3::try_from([x, y, z])?",
            $value
        )
    };
    ($x:expr, $y:expr, $z:expr $(,)?) => {
        $crate::Vec3::new($crate::vec3!(@ $x), $crate::vec3!(@ $y), $crate::vec3!(@ $z))
    };
}

impl Vec3 {
    /// Returns the dot product, rounded to nearest (half up); saturates.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(1, 2, 3).dot(vec3!(4, 0.5, -1)), fx!(2));
    /// ```
    #[must_use]
    pub const fn dot(self, other: Self) -> Scalar {
        let ([a, b, c], [x, y, z]) = (self.to_wide_bits(), other.to_wide_bits());
        // Products reach 2^62; a sum that saturates is beyond the range of the result anyway.
        let sum = (a * x).saturating_add(b * y).saturating_add(c * z);
        Scalar::from_bits(block::fixed(sum, 32, 16))
    }

    /// Returns the cross product, rounded to nearest (half up); saturates.
    ///
    /// ```
    /// use fixel::Vec3;
    /// assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
    /// ```
    #[must_use]
    pub const fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.to_wide_bits(), other.to_wide_bits());
        Self::from_bits([
            block::fixed((b * z).saturating_sub(c * y), 32, 16),
            block::fixed((c * x).saturating_sub(a * z), 32, 16),
            block::fixed((a * y).saturating_sub(b * x), 32, 16),
        ])
    }

    /// Returns the length; saturates.
    ///
    /// The relative error is at most 2⁻²⁹ before the result is rounded to the nearest 2⁻¹⁶.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(3, 0, -4).length(), fx!(5));
    /// ```
    #[must_use]
    pub const fn length(self) -> Scalar {
        length(self.to_wide_bits())
    }

    /// Returns the distance between two points; saturates.
    ///
    /// The result is as accurate as [`length`](Self::length), even where `self - other` would saturate.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(1, 2, 3).distance(vec3!(4, 2, -1)), fx!(5));
    /// ```
    #[must_use]
    pub const fn distance(self, other: Self) -> Scalar {
        length(self.way_to(other))
    }

    /// Returns the vector of length one in the direction of this vector, however short or long this vector is; `None`
    /// for zero.
    ///
    /// Components are rounded to the nearest 2⁻¹⁶, so the length is within 2⁻¹⁶ of one.
    ///
    /// ```
    /// use fixel::{Vec3, vec3};
    /// assert_eq!(vec3!(0, 0.001, 0).normalized(), Some(Vec3::Y));
    /// assert_eq!(Vec3::ZERO.normalized(), None);
    /// ```
    #[must_use]
    pub const fn normalized(self) -> Option<Self> {
        let Some([x, y, z]) = unit(self.to_wide_bits()) else {
            return None;
        };
        Some(Self::from_bits([
            block::fixed(x as i64, 30, 16),
            block::fixed(y as i64, 30, 16),
            block::fixed(z as i64, 30, 16),
        ]))
    }

    /// Returns the distance between two points in units of 2⁻¹⁶, which may be more than a [`Scalar`] holds: 34 bits.
    pub(crate) const fn wide_distance(self, other: Self) -> i64 {
        exact_length(self.way_to(other)).at(16)
    }

    /// Returns the vector from this point to another point; components have 33 bits.
    #[inline]
    pub(crate) const fn way_to(self, to: Self) -> [i64; 3] {
        let ([a, b, c], [x, y, z]) = (self.to_wide_bits(), to.to_wide_bits());
        [x - a, y - b, z - c]
    }

    /// Returns the bits of the components in 64 bits each.
    #[inline]
    const fn to_wide_bits(self) -> [i64; 3] {
        let [x, y, z] = self.to_bits();
        [x as i64, y as i64, z as i64]
    }
}

/// The length of a vector in units of 2^-16; saturates.
const fn length(vector: [i64; 3]) -> Scalar {
    let BlockFloat { value, exp } = exact_length(vector);
    Scalar::from_bits(block::fixed(value, exp, 16))
}

/// The length of a vector in units of 2^-16, before it is rounded.
#[inline]
const fn exact_length(vector: [i64; 3]) -> BlockFloat {
    let Some(of) = measure(vector) else {
        return BlockFloat::ZERO;
    };
    // √x = x · 1/√x, in units of 2^-62: below 2^63.
    let length = (of.square as u64 * of.root as u64).cast_signed();
    BlockFloat::new(length, 16 + of.up + 30 + of.half.cast_signed())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{cases, number};

    /// The length in units of 2^-16, saturated.
    fn real_length(v: [f64; 3]) -> f64 {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        length.min(i32::MAX.into())
    }

    #[test]
    fn lengths_have_29_bits() {
        cases(256, |random| {
            let v = [(); 3].map(|()| number(random));
            let length = real_length(v.map(f64::from));
            let found = f64::from(Vec3::from_bits(v).length().to_bits());
            // The length has 29 bits before it is rounded to a unit.
            assert!((found - length).abs() <= 0.5 + length * f64::from(-29).exp2());
        });
    }

    #[test]
    fn distances_have_29_bits() {
        cases(256, |random| {
            let a = [(); 3].map(|()| number(random));
            let b = [(); 3].map(|()| number(random));
            // Differences have 33 bits, which an f64 holds.
            let difference = core::array::from_fn(|i| f64::from(a[i]) - f64::from(b[i]));
            let length = real_length(difference);
            let (a, b) = (Vec3::from_bits(a), Vec3::from_bits(b));
            let found = f64::from(a.distance(b).to_bits());
            assert!((found - length).abs() <= 0.5 + length * f64::from(-29).exp2());
            assert_eq!(a.distance(b), b.distance(a));
        });
    }

    #[test]
    fn dot_and_cross_products_are_rounded_half_up_and_saturate() {
        cases(256, |random| {
            let a = [(); 3].map(|()| number(random));
            let b = [(); 3].map(|()| number(random));
            let (u, v) = (Vec3::from_bits(a), Vec3::from_bits(b));
            let [x, y] = [a, b].map(|v| v.map(i128::from));
            // Computed in 128 bits: rounded to nearest (half up), and saturated.
            let fixed = |p: i128| {
                i32::try_from((p + (1 << 15)) >> 16).unwrap_or(if p < 0 {
                    i32::MIN
                } else {
                    i32::MAX
                })
            };
            assert_eq!(
                u.dot(v).to_bits(),
                fixed(x[0] * y[0] + x[1] * y[1] + x[2] * y[2])
            );
            let cross = |i: usize, j: usize| fixed(x[i] * y[j] - x[j] * y[i]);
            assert_eq!(
                u.cross(v).to_bits(),
                [cross(1, 2), cross(2, 0), cross(0, 1)]
            );
        });
    }

    #[test]
    fn distances_do_not_saturate_before_the_end() {
        // The difference, 40,000, is beyond the format, which ends at 32,768. The length is also beyond the format.
        let (a, b) = (
            Vec3::from_ints(20_000, 0, 0),
            Vec3::from_ints(-20_000, 0, 0),
        );
        assert_eq!(a.distance(b), Scalar::MAX);
        let (a, b) = (
            Vec3::from_bits([i32::MAX; 3]),
            Vec3::from_bits([i32::MIN; 3]),
        );
        assert_eq!(a.distance(b), Scalar::MAX);
        assert_eq!(a.distance(a), Scalar::ZERO);
    }
}
