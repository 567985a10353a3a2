//! 4×4 matrices, as textbooks write them.

use core::ops::Mul;

use super::Vec3;
use crate::num::{Scalar, block};

/// A 4×4 matrix of [`Scalar`]s by rows, for column vectors.
///
/// Use this type to read, compare and exchange matrices. Draw calls take a [`Transform`](crate::Transform) and a
/// [`Projection`](crate::Projection), which keep more digits. Sums of products accumulate in 64 bits, are rounded once
/// to the nearest 2⁻¹⁶ (half up), and saturate.
///
/// ```
/// use fixel::prelude::*;
/// use fixel::Matrix4;
/// let move_up = Matrix4::translate(vec3!(0, 2, 0));
/// let halve = Matrix4::scale(vec3!(0.5, 0.5, 0.5));
/// assert_eq!((halve * move_up).rows()[1][3], fx!(1));
/// assert_eq!(move_up * Matrix4::IDENTITY, move_up);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Matrix4 {
    rows: [[Scalar; 4]; 4],
}

const O: Scalar = Scalar::ZERO;
const I: Scalar = Scalar::ONE;

impl Matrix4 {
    /// The matrix that changes nothing.
    pub const IDENTITY: Self = Self::scale(Vec3::from_ints(1, 1, 1));

    /// Makes a matrix from its rows.
    #[must_use]
    pub const fn new(rows: [[Scalar; 4]; 4]) -> Self {
        Self { rows }
    }

    /// Returns the rows.
    #[must_use]
    pub const fn rows(&self) -> &[[Scalar; 4]; 4] {
        &self.rows
    }

    /// Makes the matrix that moves by `offset`.
    #[must_use]
    pub const fn translate(offset: Vec3) -> Self {
        Self::new([
            [I, O, O, offset.x],
            [O, I, O, offset.y],
            [O, O, I, offset.z],
            [O, O, O, I],
        ])
    }

    /// Makes the matrix that scales each axis about the origin.
    #[must_use]
    pub const fn scale(factors: Vec3) -> Self {
        Self::new([
            [factors.x, O, O, O],
            [O, factors.y, O, O],
            [O, O, factors.z, O],
            [O, O, O, I],
        ])
    }

    /// Multiplies the matrix by a point (x, y, z, 1), in homogeneous coordinates.
    #[must_use]
    pub fn homogeneous(&self, point: Vec3) -> [Scalar; 4] {
        *self * [point.x, point.y, point.z, I]
    }

    /// Multiplies the matrix by a point (x, y, z, 1) and divides by the fourth coordinate w. The result is rounded to
    /// nearest (half away from zero).
    ///
    /// `None` if a coordinate of the result is beyond ±32768, or if w is 0 or negative: the picture of such a point
    /// would be missing or mirrored.
    #[must_use]
    pub fn project(&self, point: Vec3) -> Option<Vec3> {
        let [x, y, z, w] = self.homogeneous(point);
        if w <= O {
            return None;
        }
        let divide = |v: Scalar| {
            block::divide(i64::from(v.to_bits()) << 16, w.to_bits().into()).map(Scalar::from_bits)
        };
        Some(Vec3::new(divide(x)?, divide(y)?, divide(z)?))
    }
}

/// Returns the dot product of two rows, rounded once.
///
/// Partial sums saturate at 2^63, which is sixteen bits more than the largest result has.
fn dot(a: [Scalar; 4], b: [Scalar; 4]) -> Scalar {
    let sum = a.iter().zip(&b).fold(0_i64, |sum, (a, b)| {
        sum.saturating_add(i64::from(a.to_bits()) * i64::from(b.to_bits()))
    });
    Scalar::from_bits(block::fixed(sum, 32, 16))
}

impl Default for Matrix4 {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Mul for Matrix4 {
    type Output = Self;

    /// Returns the matrix that applies `other` first, then `self`.
    fn mul(self, other: Self) -> Self {
        let columns = [0, 1, 2, 3].map(|i| other.rows.map(|row| row[i]));
        Self::new(self.rows.map(|row| columns.map(|column| dot(row, column))))
    }
}

impl Mul<[Scalar; 4]> for Matrix4 {
    type Output = [Scalar; 4];

    fn mul(self, vector: [Scalar; 4]) -> [Scalar; 4] {
        self.rows.map(|row| dot(row, vector))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn products_round_once_and_saturate() {
        cases(256, |random| {
            let a = random.random::<[[i32; 4]; 4]>();
            let b = random.random::<[[i32; 4]; 4]>();
            let cut = random.random_range(0_u32..32);
            let cut = |m: [[i32; 4]; 4]| m.map(|row| row.map(|v| v >> cut));
            let (a, b) = (cut(a), cut(b));
            let matrix = |m: [[i32; 4]; 4]| Matrix4::new(m.map(|row| row.map(Scalar::from_bits)));
            let product = matrix(a) * matrix(b);
            for (i, row) in a.iter().enumerate() {
                for j in 0..4 {
                    let terms = row.iter().zip(&b);
                    let sum: i128 = terms.map(|(&a, b)| i128::from(a) * i128::from(b[j])).sum();
                    let rounded = (sum + (1 << 15)) >> 16;
                    let expected = rounded.clamp(i32::MIN.into(), i32::MAX.into());
                    assert_eq!(i128::from(product.rows()[i][j].to_bits()), expected);
                }
            }
        });
    }

    #[test]
    fn projecting_never_panics() {
        cases(256, |random| {
            let m = random.random::<[[i32; 4]; 4]>();
            let p = random.random::<[i32; 3]>();
            let m = Matrix4::new(m.map(|row| row.map(Scalar::from_bits)));
            let _ = m.project(Vec3::from_bits(p));
        });
    }
}
