//! Products, lengths and directions of vectors.

use core::ops::Mul;

use super::Vec3;
use crate::Scalar;
use crate::num::block;
use crate::num::rsqrt::{measure, unit};

impl Vec3 {
    /// The dot product, rounded to nearest; saturates.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(1, 2, 3).dot(vec3!(4, 0.5, -1)), fx!(2));
    /// ```
    #[must_use]
    pub fn dot(self, other: Self) -> Scalar {
        let [a, b] = [self, other].map(|v| v.to_bits().map(i64::from));
        // Products reach 2^62; a sum that saturates is beyond the format anyway.
        let sum = (a[0] * b[0])
            .saturating_add(a[1] * b[1])
            .saturating_add(a[2] * b[2]);
        Scalar::from_bits(block::fixed(sum, 32, 16))
    }

    /// The cross product, rounded to nearest; saturates.
    ///
    /// ```
    /// use fixel::Vec3;
    /// assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
    /// ```
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        let [a, b] = [self, other].map(|v| v.to_bits().map(i64::from));
        let part =
            |i: usize, j: usize| block::fixed((a[i] * b[j]).saturating_sub(a[j] * b[i]), 32, 16);
        Self::from_bits([part(1, 2), part(2, 0), part(0, 1)])
    }

    /// The length, to 2⁻²⁹ of itself and rounded; saturates.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(3, 0, -4).length(), fx!(5));
    /// ```
    #[must_use]
    pub fn length(self) -> Scalar {
        let Some(of) = measure(self.to_bits().map(i64::from)) else {
            return Scalar::ZERO;
        };
        // √x = x · 1/√x, in units of 2^-62: below 2^63.
        let length = (u64::from(of.square) * u64::from(of.root)).cast_signed();
        let exp = 16 + of.up + 30 + of.half.cast_signed();
        Scalar::from_bits(block::fixed(length, exp, 16))
    }

    /// The vector of length one in this direction, however short or long this is; `None` for zero.
    ///
    /// Components are rounded to 2⁻¹⁶, so that the length is within 2⁻¹⁶ of one.
    ///
    /// ```
    /// use fixel::{vec3, Vec3};
    /// assert_eq!(vec3!(0, 0.001, 0).normalized(), Some(Vec3::Y));
    /// assert_eq!(Vec3::ZERO.normalized(), None);
    /// ```
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let unit = unit(self.to_bits().map(i64::from))?;
        Some(Self::from_bits(
            unit.map(|v| block::fixed(v.into(), 30, 16)),
        ))
    }
}

impl Mul<Scalar> for Vec3 {
    type Output = Self;

    /// The vector so many times as long, rounded to nearest; saturates.
    fn mul(self, times: Scalar) -> Self {
        let times = i64::from(times.to_bits());
        Self::from_bits(
            self.to_bits()
                .map(|v| block::fixed(i64::from(v) * times, 32, 16)),
        )
    }
}
