//! Directions in world space, and how a model's normals come there.

use crate::num::Unit;
use crate::num::rsqrt::unit;
use crate::num::wide::dot;
use crate::{Transform, Vec3};

/// A vector of length one, or of length zero where there is no direction.
///
/// Components have 30 fraction bits and are within 2⁻²⁸.
///
/// ```
/// use fixel::{Unit, math::Direction, vec3};
/// let up = Direction::of(vec3!(0, 7, 0));
/// assert_eq!(up.components(), [Unit::ZERO, Unit::ONE, Unit::ZERO]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direction([i32; 3]);

impl Direction {
    /// No direction.
    pub const NONE: Self = Self([0; 3]);

    /// The direction of a vector of any length.
    #[must_use]
    pub const fn of(vector: Vec3) -> Self {
        let [x, y, z] = vector.to_bits();
        match unit([x as i64, y as i64, z as i64]) {
            Some(components) => Self(components),
            None => Self::NONE,
        }
    }

    /// x, y and z.
    #[must_use]
    pub fn components(self) -> [Unit; 3] {
        self.0.map(Unit::from_bits)
    }

    /// In units of 2⁻³⁰.
    #[inline]
    pub(crate) const fn to_bits(self) -> [i32; 3] {
        self.0
    }
}

/// Takes normals of a model to world space: the inverse transpose of the model's linear part, up to a positive
/// factor, so that they stay upright on a surface that is stretched or mirrored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NormalMatrix {
    /// Rows, below 2^30.
    rows: [[i32; 3]; 3],
}

impl NormalMatrix {
    pub(crate) fn of(model: &Transform) -> Self {
        Self {
            rows: model.normal_matrix(),
        }
    }

    /// The direction in world space of a model's normal of any length.
    pub(crate) fn direction(&self, normal: Vec3) -> Direction {
        // 30 bits times 31, thrice: below 2^63.
        let normal = normal.to_bits();
        let components = unit(self.rows.map(|row| dot(&row, &normal)));
        Direction(components.unwrap_or_default())
    }
}
