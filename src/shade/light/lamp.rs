//! Lights that come from one place or direction.

use super::adapters::share;
use super::{Lighting, SurfacePoint};
use crate::math::Direction;

/// A light from one place or direction: [`Light`](super::Light),
/// [`PointLight`](super::PointLight) or [`SpotLight`](super::SpotLight). A lamp can be
/// [`shiny`](Lighting::shiny).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a single lamp",
    note = "make each `Light`, `PointLight` and `SpotLight` shiny before you put them together"
)]
pub trait Lamp: Lighting {
    /// The direction from a point toward the light, and the strength of the light at the point: 65,536 is full
    /// brightness. Where no light reaches the point, the strength is 0, and the direction may be [`Direction::NONE`].
    fn ray(&self, point: &SurfacePoint) -> (Direction, i32);

    /// The light on a matte surface, in units of 2⁻¹⁶, by Lambert's law: the strength of the light at a point, times
    /// the cosine of the angle between the normal and the direction toward the light.
    #[inline]
    fn diffuse(&self, point: &SurfacePoint) -> i32 {
        let (toward, light) = self.ray(point);
        share(light, point.normal.dot(toward).to_bits().max(0) >> 14)
    }

    /// The light that comes from all sides, in units of 2⁻¹⁶.
    #[inline]
    fn ambient(&self) -> i32 {
        0
    }
}
