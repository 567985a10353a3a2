//! The inverse of a transform.

use super::Transform;
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt::cross;
use crate::num::wide::{dot, product};

fn transpose<T: Copy>([x, y, z]: [[T; 3]; 3]) -> [[T; 3]; 3] {
    // The indices are constants, because in a build for size, a loop would keep its bounds checks.
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]
}

/// The exact determinant of a matrix of mantissas, in two parts: the first in units of 2^31, and the rest, from 0 to 2^31.
pub(super) fn determinant(&[x, y, z]: &[[i32; 3]; 3]) -> [i64; 2] {
    // Each part is the sum of three products of 30 by 31 bits.
    let (mut high, mut low) = (0, 0);
    for (&x, cofactor) in x.iter().zip(cross(y, z)) {
        high += product(x, (cofactor >> 31) as i32);
        low += product(x, (cofactor & 0x7fff_ffff) as i32);
    }
    [high + (low >> 31), low & 0x7fff_ffff]
}

impl Transform {
    /// Returns the transform that undoes this one; `None` if this transform presses everything flat, so that its
    /// determinant is 0.
    ///
    /// A determinant that differs from 0 only by the rounding of the matrix's entries counts as 0. So the transform of
    /// a [shadow](Self::shadow) never has an inverse, whatever its plane.
    ///
    /// The entries of the result's matrix are accurate to 2⁻²⁸ of its largest entry. The translation is computed from this
    /// matrix, and rounded once to 30 bits.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let turn = Transform::rotate_y(Angle::from_degrees(30));
    /// let place = Transform::translate(vec3!(1, 2, 3)) * turn * Transform::scale(fx!(2));
    /// let back = place.inverse().expect("no factor is 0");
    /// assert_eq!((back * place).point(vec3!(4, 5, 6)), vec3!(4, 5, 6));
    /// assert_eq!(Transform::scale_axes(vec3!(1, 0, 1)).inverse(), None);
    /// ```
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        let [x, y, z] = self.linear;
        let cofactors = [cross(y, z), cross(z, x), cross(x, y)];
        let [high, low] = determinant(&self.linear);
        let determinant = BlockFloat::new(high, -31).plus(BlockFloat::new(low, 0));
        // Entries are rounded by up to half of a unit, which changes the determinant by up to half of the sum of the
        // cofactors. Cofactors have 61 bits, so a quarter of each is added.
        let quarters = cofactors.as_flattened().iter();
        let quarter = quarters.fold(0, |sum, cofactor| sum + (cofactor.unsigned_abs() >> 2));
        if determinant.at(0).unsigned_abs() / 2 <= quarter {
            return None;
        }
        let mut numbers = [BlockFloat::ZERO; 9];
        for (number, cofactor) in numbers.iter_mut().zip(transpose(cofactors).as_flattened()) {
            let cofactor = if high < 0 { -*cofactor } else { *cofactor };
            *number = BlockFloat::new(cofactor, -self.linear_exp).over(determinant);
        }
        let mut inverse = *self;
        inverse.linear_exp = block::normalize(inverse.linear.as_flattened_mut(), &numbers);
        Some(inverse.moving_back(self))
    }

    /// Inverts a rigid transform, or one that also mirrors: the result applies the opposite translation, then the
    /// transposed rotation. For a transform that scales or shears, the result is not the inverse.
    #[must_use]
    pub(crate) fn inverse_rigid(&self) -> Self {
        Self {
            linear: transpose(self.linear),
            ..*self
        }
        .moving_back(self)
    }

    /// The matrix of this transform, after the opposite of another transform's translation.
    #[inline]
    fn moving_back(mut self, from: &Self) -> Self {
        let exp = self.linear_exp + from.translation_exp;
        let moved = self
            .linear
            .map(|row| BlockFloat::new(-dot(&row, &from.translation), exp));
        self.translation_exp = block::normalize(&mut self.translation, &moved);
        self
    }
}
