//! Normals on their way to world space.

use crate::Vec3;
use crate::{
    math::Transform,
    num::{rsqrt::unit, wide::dot},
};

/// What a model's pose does to its normals: the inverse transpose of its linear part, up to a
/// positive factor, so that they stay upright on a surface that is stretched or mirrored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pose {
    /// Rows, below 2^30.
    rows: [[i32; 3]; 3],
}

impl Pose {
    /// World space and model space are one.
    pub(super) const IDENTITY: Self = Self {
        rows: [[1 << 29, 0, 0], [0, 1 << 29, 0], [0, 0, 1 << 29]],
    };

    pub(super) fn of(model: &Transform) -> Self {
        Self {
            rows: model.normal_matrix(),
        }
    }

    /// The world's unit vector of a model's normal of any length, in units of 2⁻³⁰; `None` for a
    /// normal that is zero or becomes it.
    pub(super) fn unit(&self, normal: Vec3) -> Option<[i32; 3]> {
        // 30 bits times 31, thrice: below 2^63.
        let normal = normal.to_bits();
        unit(self.rows.map(|row| dot(&row, &normal)))
    }
}
