//! Affine transforms: they place a model in the world, and the world in front of the eye.

use core::ops::Mul;

use super::{NormalMatrix, Vec3};
use crate::num::Scalar;
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt as unit;
use crate::num::wide::{dot, product};

mod inverse;
mod plane;
mod rotation;
mod rows;
#[cfg(test)]
mod tests;

/// An affine transform of points: a 3×3 matrix and a translation.
///
/// The matrix and the translation are in block floating point: each has 30-bit mantissas and one exponent. So an entry
/// is accurate to 2⁻³⁰ of the largest entry of the matrix or of the translation. Sums of products accumulate in 64 bits
/// and are rounded once. Entries range from 2⁻⁶² to 2⁶²; larger entries saturate.
///
/// `a * b` applies `b` first, as matrices do.
///
/// ```
/// use fixel::prelude::*;
/// let quarter = Transform::rotate_z(Angle::from_degrees(90));
/// let up = Transform::translate(vec3!(0, 2, 0));
/// assert_eq!((up * quarter).point(Vec3::X), vec3!(0, 3, 0));
/// assert_eq!((quarter * up).point(Vec3::X), vec3!(-2, 1, 0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transform {
    /// Mantissas by rows, below 2^30 in magnitude.
    pub(crate) linear: [[i32; 3]; 3],
    /// The exponent of the matrix: entries are mantissas · 2^-exp. [`block`] gives the range of exponents.
    pub(crate) linear_exp: i32,
    /// Mantissas, below 2^30 in magnitude.
    pub(crate) translation: [i32; 3],
    /// The exponent of the translation, with the same meaning as `linear_exp`.
    pub(crate) translation_exp: i32,
    /// Whether the determinant is negative. This is stored, because computing it from the matrix is slow.
    pub(crate) is_mirror: bool,
}

/// A row of an affine transform: three mantissas of up to 31 bits that share an exponent, and an offset.
#[derive(Clone, Copy)]
pub(crate) struct AffineRow {
    pub(crate) row: [i32; 3],
    pub(crate) exp: i32,
    /// The offset is the product of these two factors, which are stored so that the offset keeps all bits of the
    /// product.
    pub(crate) offset: [i32; 2],
    pub(crate) offset_exp: i32,
}

impl AffineRow {
    /// Computes the row that applies `other` first and then this row: writes its coefficients to `linear`, and returns
    /// its offset. Nothing is rounded.
    #[inline]
    pub(crate) fn after(&self, other: &Transform, linear: &mut [BlockFloat]) -> BlockFloat {
        let [x, y, z] = &other.linear;
        for (product, ((&x, &y), &z)) in linear.iter_mut().zip(x.iter().zip(y).zip(z)) {
            *product = BlockFloat::new(dot(&self.row, &[x, y, z]), self.exp + other.linear_exp);
        }
        self.offset_after(other)
    }

    /// The coefficients of the row that applies `other` first and then this row.
    #[inline]
    fn linear_after(&self, other: &Transform) -> [i64; 3] {
        let [x, y, z] = &other.linear;
        [
            dot(&self.row, &[x[0], y[0], z[0]]),
            dot(&self.row, &[x[1], y[1], z[1]]),
            dot(&self.row, &[x[2], y[2], z[2]]),
        ]
    }

    /// The offset of the row that applies `other` first and then this row.
    #[inline]
    fn offset_after(&self, other: &Transform) -> BlockFloat {
        // Terms that may cancel are added before the sum is rounded.
        let [a, b] = self.offset;
        BlockFloat::new(
            dot(&self.row, &other.translation),
            self.exp + other.translation_exp,
        )
        .plus(BlockFloat::new(product(a, b), self.offset_exp))
    }
}

/// Returns the transform that applies `other` first, then the three rows.
///
/// Nothing is rounded before the end, where all rows take one exponent.
#[inline(never)]
pub(crate) fn compose(rows: &[AffineRow; 3], other: &Transform) -> Transform {
    // One loop over all numbers is 316 bytes smaller.
    if cfg!(for_size) {
        let mut numbers = [BlockFloat::ZERO; 12];
        let (linear, translation) = numbers.split_at_mut(9);
        for (row, (linear, moved)) in rows.iter().zip(linear.chunks_exact_mut(3).zip(translation)) {
            *moved = row.after(other, linear);
        }
        return Transform::from_block_floats(&numbers);
    }
    let [a, b, c] = rows;
    let linear = [
        a.linear_after(other),
        b.linear_after(other),
        c.linear_after(other),
    ];
    let exp = other.linear_exp;
    let exps = [a.exp + exp, b.exp + exp, c.exp + exp];
    let mut t = Transform::IDENTITY;
    t.linear_exp = block::normalize_rows(&mut t.linear, &linear, &exps);
    t.moved_to(rows, other)
}

impl Transform {
    /// The transform that moves nothing.
    pub const IDENTITY: Self = Self {
        linear: [[1 << 29, 0, 0], [0, 1 << 29, 0], [0, 0, 1 << 29]],
        linear_exp: 29,
        translation: [0; 3],
        translation_exp: block::MAX_EXP,
        is_mirror: false,
    };

    /// Makes a transform from its entries, the matrix by rows and then the translation, each rounded once.
    fn from_block_floats(numbers: &[BlockFloat; 12]) -> Self {
        let (linear, translation) = numbers.split_at(9);
        let mut t = Self::IDENTITY;
        t.linear_exp = block::normalize(t.linear.as_flattened_mut(), linear);
        t.translation_exp = block::normalize(&mut t.translation, translation);
        t
    }

    /// Makes a transform without translation from rows in units of 2^-`exp`.
    // The entries are filled in place and out of line, because `map` copies arrays of this size.
    #[inline(never)]
    pub(crate) fn from_linear(rows: &[[i64; 3]; 3], exp: i32) -> Self {
        let mut t = Self::IDENTITY;
        t.linear_exp = block::normalize_rows(&mut t.linear, rows, &[exp; 3]);
        t
    }

    /// Makes the transform that moves points by `offset`.
    ///
    /// An offset keeps 30 significant bits. If a component's magnitude is 16,384 or more, the offset is rounded to
    /// nearest.
    #[must_use]
    pub fn translate(offset: Vec3) -> Self {
        let mut t = Self::IDENTITY;
        let numbers = offset.to_bits().map(|v| BlockFloat::new(v.into(), 16));
        t.translation_exp = block::normalize(&mut t.translation, &numbers);
        t
    }

    /// Makes the transform that scales all axes by one factor about the origin. The factor keeps 30 significant bits. A
    /// factor with a magnitude of 16,384 or more is rounded to nearest.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// assert_eq!(Transform::scale(fx!(0.5)).point(vec3!(2, 4, 6)), vec3!(1, 2, 3));
    /// ```
    #[must_use]
    pub fn scale(factor: Scalar) -> Self {
        Self::scale_axes(Vec3::splat(factor))
    }

    /// Makes the transform that scales each axis by its own factor about the origin; a negative factor mirrors.
    /// A mirrored mesh still shows its outside: [culling](crate::Cull) needs no change. To draw what a mirror shows,
    /// see [`Camera::mirrored`](crate::Camera::mirrored).
    ///
    /// Each factor is accurate to 2⁻³⁰ of the largest factor.
    #[must_use]
    pub fn scale_axes(factors: Vec3) -> Self {
        let [x, y, z] = factors.to_bits();
        let is_mirror = x ^ y ^ z < 0;
        let [x, y, z] = [x.into(), y.into(), z.into()];
        let mut t = Self::from_linear(&[[x, 0, 0], [0, y, 0], [0, 0, z]], 16);
        t.is_mirror = is_mirror;
        t
    }

    /// Whether this transform is a translation, like the first or the last factor of most models. A product with it keeps
    /// the bits of the other factor's matrix.
    #[inline]
    fn only_moves(&self) -> bool {
        const ONE: i32 = 1 << 29;
        let [[a, b, c], [d, e, f], [g, h, i]] = self.linear;
        a == ONE && e == ONE && i == ONE && (b | c | d | f | g | h) == 0 && self.linear_exp == 29
    }

    /// This matrix, with the translation of the transform that applies `other` first and then `rows`.
    #[inline(never)]
    fn moved_to(mut self, rows: &[AffineRow; 3], other: &Self) -> Self {
        let offsets = rows.each_ref().map(|row| row.offset_after(other));
        self.translation_exp = block::normalize(&mut self.translation, &offsets);
        self
    }

    /// Transforms a point, rounded to nearest (half up); saturates.
    #[must_use]
    pub fn point(&self, point: Vec3) -> Vec3 {
        Vec3::from_bits(self.coordinates([0, 1, 2], point))
    }

    /// The z coordinate of [`point`](Self::point).
    #[inline]
    pub(crate) fn z(&self, point: Vec3) -> Scalar {
        let [z] = self.coordinates([2], point);
        Scalar::from_bits(z)
    }

    /// Some coordinates of [`point`](Self::point), in bits.
    #[inline]
    fn coordinates<const N: usize>(&self, axes: [usize; N], point: Vec3) -> [i32; N] {
        let exp = self.linear_exp;
        // The left shift from the units of the translation to the units of a product of the matrix and a point.
        let up = 16 + exp - self.translation_exp;
        if !(1..=40).contains(&exp) || up > 30 {
            let far = self.far_point(point).to_bits();
            return axes.map(|axis| far.get(axis).copied().unwrap_or_default());
        }
        // Bits that are shifted out are worth less than a unit of the products. They cannot change the result, because
        // the sum is rounded down at the end.
        let (down, factor) = (-up.clamp(-31, 0), 1 << up.clamp(0, 30));
        let (rows, [x, y, z]) = (&self.linear, self.translation);
        let point = point.to_bits();
        // The sum has three products below 2^61, one product below 2^60, and a half of the result's unit.
        let number = |row: &[i32; 3], moved: i32| {
            let sum = dot(row, &point) + product(moved >> down, factor) + (1 << (exp - 1));
            block::saturated(sum >> exp)
        };
        let [i, j, k] = rows;
        axes.map(|axis| match axis {
            0 => number(i, x),
            1 => number(j, y),
            _ => number(k, z),
        })
    }

    /// Like [`point`](Self::point), for numbers that do not fit into 64 bits. These numbers are rounded to 61 bits
    /// first.
    #[cold]
    #[inline(never)]
    fn far_point(&self, point: Vec3) -> Vec3 {
        let ([i, j, k], [x, y, z]) = (self.times_linear(point), self.translation);
        Vec3::from_bits([(i, x), (j, y), (k, z)].map(|(linear, moved)| {
            let moved = BlockFloat::new(moved.into(), self.translation_exp);
            let sum = BlockFloat::new(linear, self.linear_exp + 16).plus(moved);
            block::fixed(sum.value, sum.exp, 16)
        }))
    }

    /// Transforms a direction, without the translation; rounded to nearest (half up), saturates.
    #[must_use]
    pub fn direction(&self, direction: Vec3) -> Vec3 {
        let linear = self.times_linear(direction);
        Vec3::from_bits(linear.map(|v| block::fixed(v, self.linear_exp + 16, 16)))
    }

    /// Multiplies the matrix by a vector. Each result is a sum of three products below 2^61.
    fn times_linear(&self, v: Vec3) -> [i64; 3] {
        let v = v.to_bits();
        self.linear.map(|row| dot(&row, &v))
    }

    /// Makes a transform rigid again after many multiplications: the rows of its matrix become
    /// orthogonal and of length one.
    ///
    /// The z axis keeps its direction, and the y axis stays in the plane of y and z. If the transform mirrors (its
    /// matrix has a negative determinant), the result mirrors, too. A matrix with rows that are zero or parallel is
    /// returned unchanged.
    ///
    /// Use this method for rotations and translations that are multiplied frame by frame.
    #[must_use]
    pub fn renormalized(&self) -> Self {
        let axes = || {
            let z = unit::unit(self.linear[2].map(i64::from))?;
            let x = unit::unit(unit::cross(self.linear[1], z))?;
            let y = unit::cross(z, x).map(|v| (v + (1 << 29)) >> 30);
            let sign = if dot(&x, &self.linear[0]) < 0 { -1 } else { 1 };
            Some([x.map(|v| sign * i64::from(v)), y, z.map(i64::from)])
        };
        match axes() {
            None => *self,
            Some(rows) => Self {
                translation: self.translation,
                translation_exp: self.translation_exp,
                is_mirror: self.is_mirror,
                ..Self::from_linear(&rows, 30)
            },
        }
    }

    /// Returns the matrix that transforms the normals of a surface, if [`point`](Self::point) transforms the surface's
    /// points. The matrix may be multiplied by a positive factor.
    ///
    /// Apart from that factor, the matrix is the inverse transpose: the cofactors, with the sign of the determinant.
    #[must_use]
    #[inline(never)]
    pub(crate) fn normal_matrix(&self) -> NormalMatrix {
        let [x, y, z] = self.linear;
        let cofactors = [unit::cross(y, z), unit::cross(z, x), unit::cross(x, y)];
        let mut matrix = Self::from_linear(&cofactors, 0).linear;
        if dot(&x, &matrix[0]) < 0 {
            for v in matrix.as_flattened_mut() {
                *v = -*v;
            }
        }
        NormalMatrix(matrix)
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Mul for Transform {
    type Output = Self;

    /// Returns the transform that applies `other` first, then `self`.
    fn mul(self, other: Self) -> Self {
        let ([i, j, k], [x, y, z]) = (self.linear, self.translation);
        let row = |row, moved| AffineRow {
            row,
            exp: self.linear_exp,
            offset: [moved, 1],
            offset_exp: self.translation_exp,
        };
        let rows = [row(i, x), row(j, y), row(k, z)];
        // The product is changed in place, because a new struct would be a second copy in flash.
        let mut product = if cfg!(for_size) {
            compose(&rows, &other)
        } else if self.only_moves() {
            other.moved_to(&rows, &other)
        } else if other.only_moves() {
            self.moved_to(&rows, &other)
        } else {
            compose(&rows, &other)
        };
        product.is_mirror = self.is_mirror != other.is_mirror;
        product
    }
}
