//! Light on single sheets.

use super::{Illumination, Lighting, SurfacePoint, Viewer};
use crate::math::Direction;

/// A light that also lights the backs of triangles; see [`Lighting::two_sided`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TwoSided<L> {
    pub(super) light: L,
    pub(super) viewer: Viewer,
}

impl<L: Lighting> Lighting for TwoSided<L> {
    type Diffuse = L::Diffuse;
    type Specular = L::Specular;

    fn at(&self, point: &SurfacePoint) -> Illumination<L::Diffuse, L::Specular> {
        let mut seen = *point;
        if self.viewer.sees_back(point.face, point.position) {
            let [x, y, z] = point.normal.to_bits();
            seen.normal = Direction::from_bits([-x, -y, -z]);
        }
        self.light.at(&seen)
    }
}
