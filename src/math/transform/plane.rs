//! Transforms about a plane: mirror images and shadows.

use super::Transform;
use crate::error::Error;
use crate::math::Vec3;
use crate::num::block::{self, BlockFloat};
use crate::num::wide::{dot, product};

impl Transform {
    /// Makes the transform for a shadow: it moves every point of a mesh along the rays of a distant light, onto the
    /// plane through `point` at right angles to `normal`. Drawn dark, the flat mesh is the shadow.
    ///
    /// `light` points to the light, as in [`Light::new`](crate::Light::new). Both vectors may have any length except
    /// zero. For a lamp near the mesh, use the direction from the mesh to the lamp.
    ///
    /// Multiply this transform by the transform that places the mesh, with the shadow on the left: `view * shadow *
    /// place`. Draw the mesh with this product and [`TestNearer`](crate::canvas::TestNearer), so that each pixel is
    /// darkened once; see [`Biased::coplanar`](crate::canvas::Biased::coplanar). If the mesh is closed, leave
    /// [culling](crate::Cull) as it is: the faces toward the light still show their fronts when they lie in the plane,
    /// and they cover the whole shadow. Parts of the mesh behind the plane throw a shadow, too. The
    /// [cookbook](crate::guide::cookbook::surfaces#a-mirror) has a scene with shadows.
    ///
    /// The entries of the matrix are accurate to 2⁻²⁸ of its largest entry. The lower the light, the larger this entry:
    /// about 1 / sin e, where e is the light's angle above the plane.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if a vector is zero, or if the light is parallel to the plane.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let (ground, light) = (vec3!(0, 1, 0), vec3!(1, 2, 0));
    /// let shadow = Transform::shadow(ground, Vec3::Y, light)?;
    /// assert_eq!(shadow.point(vec3!(5, 3, 7)), vec3!(4, 1, 7)); // 2 down, 1 to the left
    /// # Ok::<(), Error>(())
    /// ```
    pub fn shadow(point: Vec3, normal: Vec3, light: Vec3) -> Result<Self, Error> {
        Self::along(point, normal, light, 1)
    }

    /// Makes the reflection in the plane through `point` at right angles to `normal`.
    pub(crate) fn mirror(point: Vec3, normal: Vec3) -> Result<Self, Error> {
        Self::along(point, normal, normal, 2)
    }

    /// Makes the transform that moves points along `way` by their distance to the plane, times `factor`: 1 ends on the
    /// plane, and 2 as far behind it as the point was before it.
    ///
    /// The matrix is 1 - factor · way · normalᵀ / (normal · way), for vectors of any length. The numerators over the common
    /// denominator are exact.
    fn along(point: Vec3, normal: Vec3, way: Vec3, factor: i64) -> Result<Self, Error> {
        if normal == Vec3::ZERO {
            return Err(Error::ZERO_DIRECTION);
        }
        let (normal, mut steps) = (mantissas(normal), mantissas(way));
        let mut along = dot(&normal, &steps);
        if along == 0 {
            return Err(Error::NoDirection {
                of: "light",
                given: way,
                needed: "it must not be zero or parallel to the plane",
            });
        }
        if along < 0 {
            along = -along;
            steps = steps.map(|step| -step);
        }
        let mut rows = [[0; 3]; 3];
        for (i, (row, &step)) in rows.iter_mut().zip(&steps).enumerate() {
            for (j, (entry, &normal)) in row.iter_mut().zip(&normal).enumerate() {
                // The sum of five products of 60 bits.
                let kept = if i == j { along } else { 0 };
                let value = kept - factor * product(step, normal);
                // An entry of 1 is exactly 1 after this rounding.
                *entry = BlockFloat::new(value, 0)
                    .over(BlockFloat::new(along, 0))
                    .at(29);
            }
        }
        let mut linear = Self::from_linear(&rows, 29);
        linear.is_mirror = factor == 2;
        Ok(Self::translate(point) * linear * Self::translate(-point))
    }
}

/// A vector as mantissas with a common exponent.
fn mantissas(vector: Vec3) -> [i32; 3] {
    let mut mantissas = [0; 3];
    let numbers = vector.to_bits().map(|v| BlockFloat::new(v.into(), 0));
    block::normalize(&mut mantissas, &numbers);
    mantissas
}
