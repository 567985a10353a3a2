//! Directions in world space, and the matrix that takes a model's normals to world space.

use crate::error::Error;
use crate::math::Vec3;
use crate::num::Fraction;
use crate::num::rsqrt::{measure, unit};
use crate::num::wide::dot;

/// A direction: a vector of length one, or of length zero for [`NONE`](Self::NONE).
///
/// Each component has 30 fraction bits and is accurate to 2⁻²⁸.
///
/// ```
/// use fixel::{Fraction, math::Direction, vec3};
/// let up = Direction::of(vec3!(0, 7, 0));
/// assert_eq!(up.components(), [Fraction::ZERO, Fraction::ONE, Fraction::ZERO]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direction([i32; 3]);

impl Direction {
    /// No direction: the vector of length zero.
    pub const NONE: Self = Self([0; 3]);

    /// Returns the direction of a vector of any length; [`NONE`](Self::NONE) for the zero vector.
    #[must_use]
    pub const fn of(vector: Vec3) -> Self {
        let [x, y, z] = vector.to_bits();
        match unit([x as i64, y as i64, z as i64]) {
            Some(components) => Self(components),
            None => Self::NONE,
        }
    }

    /// Like [`of`](Self::of), but the zero vector is an error.
    pub(crate) const fn checked(vector: Vec3) -> Result<Self, Error> {
        match Self::of(vector) {
            Self::NONE => Err(Error::ZERO_DIRECTION),
            direction => Ok(direction),
        }
    }

    /// Returns x, y and z.
    #[must_use]
    pub fn components(self) -> [Fraction; 3] {
        self.0.map(Fraction::from_bits)
    }

    /// Returns the dot product: the cosine of the angle between this direction and `other`.
    ///
    /// The error is at most 2⁻²⁸. The result is 0 if either direction is [`NONE`](Self::NONE).
    ///
    /// ```
    /// use fixel::{Fraction, Vec3, math::Direction, vec3};
    /// let up = Direction::of(Vec3::Y);
    /// assert_eq!(up.dot(Direction::of(vec3!(0, -3, 0))), -Fraction::ONE);
    /// assert_eq!(up.dot(Direction::of(vec3!(2, 0, 5))), Fraction::ZERO);
    /// ```
    #[must_use]
    #[inline]
    pub fn dot(self, other: Self) -> Fraction {
        // Both vectors have a length of at most one, so the dot product is at most 2^60.
        Fraction::from_bits(((dot(&self.0, &other.0) + (1 << 29)) >> 30) as i32)
    }

    /// The cosine of the angle to the direction halfway between two others, in units of 2⁻³⁰; 0 if they are opposite.
    pub(crate) fn dot_halfway(self, from: Self, to: Self) -> i32 {
        let ([a, b, c], [x, y, z]) = (from.0, to.0);
        let sum = |a: i32, b: i32| i64::from(a) + i64::from(b);
        measure([sum(a, x), sum(b, y), sum(c, z)]).map_or(0, |halfway| halfway.along(&self.0))
    }

    /// Makes a direction from a unit vector in units of 2⁻³⁰.
    #[inline]
    pub(crate) const fn from_bits(bits: [i32; 3]) -> Self {
        Self(bits)
    }

    /// Returns x, y and z in units of 2⁻³⁰.
    #[inline]
    pub(crate) const fn to_bits(self) -> [i32; 3] {
        self.0
    }
}

/// The matrix that takes a model's normals to world space: the inverse transpose of the model's linear part, up to a
/// positive factor. With it, normals stay at right angles to a surface that is stretched or mirrored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NormalMatrix(
    /// Rows; entries are below 2^30 in magnitude.
    pub(crate) [[i32; 3]; 3],
);

impl NormalMatrix {
    /// Returns the direction in world space of a model's normal, which may have any length.
    pub(crate) fn direction(&self, normal: Vec3) -> Direction {
        // The sum of three products of 30 by 31 bits is below 2^63.
        let normal = normal.to_bits();
        let components = unit(self.0.map(|row| dot(&row, &normal)));
        Direction(components.unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn a_dot_product_is_rounded_to_nearest() {
        cases(256, |random| {
            let [a, b] = [(); 2].map(|()| Direction::of(Vec3::from_bits(random.random())));
            let products = a.to_bits().into_iter().zip(b.to_bits());
            let exact: i64 = products.map(|(a, b)| i64::from(a) * i64::from(b)).sum();
            let found = i64::from(a.dot(b).to_bits()) << 30;
            assert!((found - exact).abs() <= 1 << 29, "{a:?} · {b:?}");
        });
    }
}
