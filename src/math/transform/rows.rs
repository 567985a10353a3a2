//! Transforms from matrices and back.

use super::Transform;
use super::inverse::determinant;
use crate::error::Error;
use crate::math::{Matrix4, Vec3};
use crate::num::Scalar;
use crate::num::block::{self, BlockFloat};

impl Transform {
    /// Makes a transform from the rows of its 3×3 matrix, for column vectors, and its translation.
    ///
    /// Any matrix is accepted. Entries of the matrix are accurate to 2⁻³⁰ of its largest entry. Entries of the
    /// translation are accurate to 2⁻³⁰ of the translation's largest entry.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let (zero, one) = (fx!(0), fx!(1));
    /// let swap = [[zero, one, zero], [one, zero, zero], [zero, zero, one]];
    /// let swap_and_move = Transform::from_rows(swap, vec3!(0, 0, 5));
    /// assert_eq!(swap_and_move.point(vec3!(1, 2, 3)), vec3!(2, 1, 8));
    /// ```
    #[must_use]
    pub fn from_rows(rows: [[Scalar; 3]; 3], translation: Vec3) -> Self {
        let mut numbers = [BlockFloat::ZERO; 12];
        let entries = rows.as_flattened().iter();
        let translation = [translation.x, translation.y, translation.z];
        for (number, entry) in numbers.iter_mut().zip(entries.chain(&translation)) {
            *number = BlockFloat::new(entry.to_bits().into(), 16);
        }
        let transform = Self::from_block_floats(&numbers);
        Self {
            is_mirror: determinant(&transform.linear)[0] < 0,
            ..transform
        }
    }

    /// Returns the 4×4 matrix: entries are rounded to the nearest 2⁻¹⁶ and saturate at ±32768.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let matrix = Transform::translate(vec3!(1, 2, 3)).to_matrix();
    /// assert_eq!(Transform::try_from(matrix), Ok(Transform::translate(vec3!(1, 2, 3))));
    /// ```
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

impl TryFrom<Matrix4> for Transform {
    type Error = Error;

    /// Converts the upper three rows of an affine matrix, as [`from_rows`](Transform::from_rows) does.
    ///
    /// # Errors
    ///
    /// [`Error::NotAffine`] unless the last row is exactly 0 0 0 1.
    fn try_from(matrix: Matrix4) -> Result<Self, Error> {
        let [x, y, z, last] = *matrix.rows();
        let (zero, one) = (Scalar::ZERO, Scalar::ONE);
        if last != [zero, zero, zero, one] {
            return Err(Error::NotAffine { last_row: last });
        }
        let rows = [x, y, z].map(|[x, y, z, _]| [x, y, z]);
        Ok(Self::from_rows(rows, Vec3::new(x[3], y[3], z[3])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn rows_come_back_from_the_matrix() {
        cases(256, |random| {
            let rows = random.random::<[[i32; 3]; 3]>();
            let moved = random.random::<[i32; 3]>();
            let cut = random.random_range(0_u32..32);
            let scalars = rows.map(|row| row.map(|v| Scalar::from_bits(v >> cut)));
            let t = Transform::from_rows(scalars, Vec3::from_bits(moved.map(|v| v >> cut)));
            let matrix = t.to_matrix();
            for i in 0..3 {
                let expected = [rows[i][0], rows[i][1], rows[i][2], moved[i]].map(|v| v >> cut);
                for (found, expected) in matrix.rows()[i].iter().zip(expected) {
                    // Mantissas have 30 bits: numbers of 31 or 32 bits lose their last one or two bits.
                    let slack = if cut < 2 { 2 } else { 0 };
                    let error = i64::from(found.to_bits()) - i64::from(expected);
                    assert!(error.abs() <= slack, "{error}");
                }
            }
            assert_eq!(
                Transform::try_from(matrix).map(|t| t.to_matrix()),
                Ok(matrix)
            );
        });
    }

    #[test]
    fn the_last_row_of_a_projection_is_refused() {
        let (zero, one) = (Scalar::ZERO, Scalar::ONE);
        let mut rows = *Matrix4::IDENTITY.rows();
        for i in 0..4 {
            rows[3] = [zero, zero, zero, one];
            rows[3][i] += Scalar::DELTA;
            let refused = Transform::try_from(Matrix4::new(rows));
            assert_eq!(refused, Err(Error::NotAffine { last_row: rows[3] }));
        }
        rows[3] = [zero, zero, zero, one];
        let t = Transform::try_from(Matrix4::new(rows));
        assert_eq!(t, Ok(Transform::IDENTITY));
        let refused = Error::NotAffine {
            last_row: [zero, zero, -one, zero],
        };
        assert_eq!(
            std::string::ToString::to_string(&refused),
            "last row is (0, 0, -1, 0): it must be (0, 0, 0, 1) in an affine matrix"
        );
    }
}
