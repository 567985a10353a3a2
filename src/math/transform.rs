//! Affine transforms: placing a model in the world, and the world before the eye.

use core::ops::Mul;

use super::{Matrix4, Vec3};
use crate::num::Unit;
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt as unit;
use crate::num::wide::dot;
use crate::{Angle, Error, Scalar};

/// An affine transform of points: a 3×3 matrix and a translation.
///
/// The matrix and the translation are block floating point: 30-bit mantissas with one exponent
/// each, good to 2⁻³⁰ of the largest entry. Products accumulate in 64 bits and round once. Entries
/// reach from 2⁻⁶² to 2⁶²; what would be larger saturates there.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transform {
    /// Mantissas by rows, below 2^30 in magnitude.
    pub(crate) linear: [[i32; 3]; 3],
    /// Values are mantissas · 2^-exp; see [`block`] for its range.
    pub(crate) linear_exp: i32,
    /// Mantissas, below 2^30 in magnitude.
    pub(crate) translation: [i32; 3],
    /// As `linear_exp`.
    pub(crate) translation_exp: i32,
}

/// One in units of 2^-29.
const ONE: i32 = 1 << 29;

fn transpose([x, y, z]: [[i32; 3]; 3]) -> [[i32; 3]; 3] {
    // Indices are constant: optimised for size, a loop over them would keep its checks.
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]
}

/// A linear function of space: a row of a matrix of mantissas, and an offset.
#[derive(Clone, Copy)]
pub(crate) struct AffineRow {
    pub(crate) row: [i32; 3],
    pub(crate) exp: i32,
    pub(crate) offset: BlockFloat,
}

/// The transform of three functions, after `other`.
///
/// Nothing is rounded before the end, where all rows come to share an exponent.
#[inline(never)]
pub(crate) fn compose(lines: &[AffineRow; 3], other: &Transform) -> Transform {
    let (mut linear, mut translation) = ([[BlockFloat::ZERO; 3]; 3], [BlockFloat::ZERO; 3]);
    let [x, y, z] = &other.linear;
    for (line, (linear, moved)) in lines.iter().zip(linear.iter_mut().zip(&mut translation)) {
        for (product, ((&x, &y), &z)) in linear.iter_mut().zip(x.iter().zip(y).zip(z)) {
            *product = BlockFloat::new(dot(&line.row, &[x, y, z]), line.exp + other.linear_exp);
        }
        // What may cancel is added before it is rounded.
        *moved = BlockFloat::new(
            dot(&line.row, &other.translation),
            line.exp + other.translation_exp,
        )
        .plus(line.offset);
    }
    Transform::from_block_floats(&linear, &translation)
}

impl Transform {
    /// The transform that leaves everything where it is.
    pub const IDENTITY: Self = Self {
        linear: [[1 << 29, 0, 0], [0, 1 << 29, 0], [0, 0, 1 << 29]],
        linear_exp: 29,
        translation: [0; 3],
        translation_exp: block::MAX_EXP,
    };

    /// A transform of its numbers, which are rounded once.
    fn from_block_floats(linear: &[[BlockFloat; 3]; 3], translation: &[BlockFloat; 3]) -> Self {
        let mut t = Self::IDENTITY;
        t.linear_exp = block::normalize(t.linear.as_flattened_mut(), linear.as_flattened());
        t.translation_exp = block::normalize(&mut t.translation, translation);
        t
    }

    /// A transform of a matrix by rows, values · 2^-`exp`, and no translation.
    fn from_linear(rows: [[i64; 3]; 3], exp: i32) -> Self {
        let number = |value| BlockFloat::new(value, exp);
        Self::from_block_floats(&rows.map(|row| row.map(number)), &[BlockFloat::ZERO; 3])
    }

    /// A transform of a matrix by rows, in units of 2^-29, whose largest entry is about one.
    const fn from_rotation_rows(linear: [[i32; 3]; 3]) -> Self {
        Self {
            linear,
            ..Self::IDENTITY
        }
    }

    /// Moves by an offset.
    ///
    /// Offsets of more than 30 significant bits, from ±8192 on, are rounded to those.
    #[must_use]
    pub fn translate(offset: Vec3) -> Self {
        let mut t = Self::IDENTITY;
        let numbers = offset.to_bits().map(|v| BlockFloat::new(v.into(), 16));
        t.translation_exp = block::normalize(&mut t.translation, &numbers);
        t
    }

    /// Scales about the origin.
    #[must_use]
    pub fn scale(factor: Scalar) -> Self {
        Self::scale_axes(Vec3::new(factor, factor, factor))
    }

    /// Scales each axis about the origin; a negative factor mirrors.
    #[must_use]
    pub fn scale_axes(factors: Vec3) -> Self {
        let [x, y, z] = factors.to_bits().map(i64::from);
        Self::from_linear([[x, 0, 0], [0, y, 0], [0, 0, z]], 16)
    }

    /// Turns about the x axis, from y towards z.
    #[must_use]
    pub fn rotate_x(angle: Angle) -> Self {
        let [s, minus, c] = halves(angle);
        Self::from_rotation_rows([[ONE, 0, 0], [0, c, minus], [0, s, c]])
    }

    /// Turns about the y axis, from z towards x.
    #[must_use]
    pub fn rotate_y(angle: Angle) -> Self {
        let [s, minus, c] = halves(angle);
        Self::from_rotation_rows([[c, 0, s], [0, ONE, 0], [minus, 0, c]])
    }

    /// Turns about the z axis, from x towards y.
    #[must_use]
    pub fn rotate_z(angle: Angle) -> Self {
        let [s, minus, c] = halves(angle);
        Self::from_rotation_rows([[c, minus, 0], [s, c, 0], [0, 0, ONE]])
    }

    /// Turns about an axis through the origin, counter-clockwise as seen from its tip (Rodrigues'
    /// formula).
    ///
    /// # Errors
    ///
    /// [`Error::ZeroDirection`] if the axis is zero.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let third = Transform::rotate(vec3!(1, 1, 1), Angle::from_degrees(120))?;
    /// assert_eq!(third.point(Vec3::X), Vec3::Y);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn rotate(axis: Vec3, angle: Angle) -> Result<Self, Error> {
        let u = unit::unit(axis.to_bits().map(i64::from)).ok_or(Error::ZeroDirection)?;
        let u = u.map(i64::from);
        let (s, c) = bits(angle);
        // Up to 2 and 1 in units of 2^-30: products stay below 2^62.
        let entry = |i: usize, j: usize, sine: i64| {
            let projection = (u[i] * u[j] + (1 << 29)) >> 30;
            ((1 << 30) - c) * projection + if i == j { c << 30 } else { s * sine }
        };
        Ok(Self::from_linear(
            [
                [entry(0, 0, 0), entry(0, 1, -u[2]), entry(0, 2, u[1])],
                [entry(1, 0, u[2]), entry(1, 1, 0), entry(1, 2, -u[0])],
                [entry(2, 0, -u[1]), entry(2, 1, u[0]), entry(2, 2, 0)],
            ],
            60,
        ))
    }

    /// The rows of a rotation in units of 2^-30, and the point that goes to the origin.
    pub(crate) fn from_pose(rows: [[i64; 3]; 3], origin: Vec3) -> Self {
        let rotation = Self::from_linear(rows, 30);
        rotation * Self::translate(-origin)
    }

    /// Where a point goes, rounded to nearest; saturates at the ends of the format.
    #[must_use]
    pub fn point(&self, point: Vec3) -> Vec3 {
        let ([i, j, k], [x, y, z]) = (self.times_linear(point), self.translation);
        Vec3::from_bits([(i, x), (j, y), (k, z)].map(|(linear, moved)| {
            let moved = BlockFloat::new(moved.into(), self.translation_exp);
            let sum = BlockFloat::new(linear, self.linear_exp + 16).plus(moved);
            block::fixed(sum.value, sum.exp, 16)
        }))
    }

    /// What a direction becomes: as a point, without the translation.
    #[must_use]
    pub fn direction(&self, direction: Vec3) -> Vec3 {
        let linear = self.times_linear(direction);
        Vec3::from_bits(linear.map(|v| block::fixed(v, self.linear_exp + 16, 16)))
    }

    /// The matrix times a vector: three products below 2^61.
    fn times_linear(&self, v: Vec3) -> [i64; 3] {
        let v = v.to_bits();
        self.linear.map(|row| dot(&row, &v))
    }

    /// The inverse of a rigid transform, one of rotations and translations only: the transpose of
    /// the rotation, after the opposite translation.
    ///
    /// Of any other transform this is not the inverse.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let turn = Transform::rotate_y(Angle::from_degrees(30));
    /// let pose = Transform::translate(vec3!(1, 2, 3)) * turn;
    /// assert_eq!((pose.inverse_rigid() * pose).point(vec3!(4, 5, 6)), vec3!(4, 5, 6));
    /// ```
    #[must_use]
    pub fn inverse_rigid(&self) -> Self {
        let linear = transpose(self.linear);
        let exp = self.linear_exp + self.translation_exp;
        let moved = linear.map(|row| BlockFloat::new(-dot(&row, &self.translation), exp));
        let mut inverse = Self { linear, ..*self };
        inverse.translation_exp = block::normalize(&mut inverse.translation, &moved);
        inverse
    }

    /// A transform that has drifted by many multiplications, made rigid again: the rows of the
    /// matrix become orthogonal and of length one. Its z axis keeps its direction, y the plane it
    /// makes with z, and a mirror stays one.
    ///
    /// For transforms of rotations and translations that are updated frame by frame. A matrix that
    /// has no such axes, because they are zero or parallel, stays as it is.
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
                ..Self::from_linear(rows, 30)
            },
        }
    }

    /// The matrix that takes normals where [`point`](Self::point) takes surfaces, up to a positive
    /// factor: the inverse transpose, as cofactors of the matrix with the sign of its determinant.
    #[must_use]
    pub(crate) fn normal_matrix(&self) -> [[i32; 3]; 3] {
        let [x, y, z] = self.linear;
        let cofactors =
            [(y, z), (z, x), (x, y)].map(|(a, b)| unit::cross(a, b).map(|v| BlockFloat::new(v, 0)));
        let cofactors = Self::from_block_floats(&cofactors, &[BlockFloat::ZERO; 3]).linear;
        if dot(&x, &cofactors[0]) < 0 {
            cofactors.map(|row| row.map(|v| -v))
        } else {
            cofactors
        }
    }

    /// As a matrix of [`Scalar`]s: entries are rounded to 2⁻¹⁶ and saturate at ±32768.
    #[must_use]
    pub fn to_matrix(&self) -> Matrix4 {
        let mut rows = [[Scalar::ZERO; 4]; 4];
        for (row, (linear, &translation)) in rows
            .iter_mut()
            .zip(self.linear.iter().zip(&self.translation))
        {
            let entry = |v: i32, exp| Scalar::from_bits(block::fixed(v.into(), exp, 16));
            let [x, y, z] = linear.map(|v| entry(v, self.linear_exp));
            *row = [x, y, z, entry(translation, self.translation_exp)];
        }
        rows[3][3] = Scalar::ONE;
        Matrix4::new(rows)
    }
}

/// Sine and cosine in units of 2^-30.
fn bits(angle: Angle) -> (i64, i64) {
    let (sin, cos) = angle.sin_cos();
    (Unit::to_bits(sin).into(), Unit::to_bits(cos).into())
}

/// Sine, the opposite of it, and cosine, each rounded to units of 2^-29.
fn halves(angle: Angle) -> [i32; 3] {
    let (sin, cos) = angle.sin_cos();
    let half = |v: i32| (v + 1) >> 1;
    let (sin, cos) = (sin.to_bits(), cos.to_bits());
    [half(sin), half(-sin), half(cos)]
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Mul for Transform {
    type Output = Self;

    /// The transform that applies `other` first, then `self`.
    fn mul(self, other: Self) -> Self {
        let ([i, j, k], [x, y, z]) = (self.linear, self.translation);
        let lines = [(i, x), (j, y), (k, z)].map(|(row, moved)| AffineRow {
            row,
            exp: self.linear_exp,
            offset: BlockFloat::new(moved.into(), self.translation_exp),
        });
        compose(&lines, &other)
    }
}

#[cfg(test)]
mod tests;
