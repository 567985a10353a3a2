//! Light on single sheets.

use super::{Illumination, Lighting, SurfacePoint, Viewer};
use crate::math::Direction;

/// A light that also lights the backs of triangles; see [`Lighting::two_sided`].
///
#[cfg_attr(doc, doc = page_picture!("two_sided", "Two sheets that turn their backs: dark without the adapter, bright with it"))]
/// A triangle turns its back to the viewer if its normal points to the other side of its plane. Edges and points have
/// no back.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::prelude::*;
/// use fixel::shade::{Lighting, Viewer};
/// static SHEET: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let below = Camera::look_at(vec3!(0, -1, 0), Vec3::ZERO, Vec3::Z)?;
/// let mvp = projection * below;
/// let lamp = Light::new(vec3!(0, -1, 0), fx!(0), fx!(1))?.two_sided(Viewer::of(&mvp));
/// let both = DrawOptions::new().with_cull(Cull::Nothing);
/// let mut pixels = [Gray8::BLACK; 1];
/// Canvas::new(&mut pixels, 1, 1)?.draw_with(&both, &SHEET, &mvp, &Flat::new(Gray8::WHITE).lit(lamp));
/// assert_eq!(pixels, [Gray8::WHITE]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TwoSided<L> {
    pub(super) light: L,
    pub(super) viewer: Viewer,
}

impl<L: Lighting> Lighting for TwoSided<L> {
    type Diffuse = L::Diffuse;
    type Specular = L::Specular;

    fn at(&self, point: &SurfacePoint) -> Illumination {
        let mut seen = *point;
        if self.viewer.sees_back(point.face, point.position) {
            let [x, y, z] = point.normal.to_bits();
            seen.normal = Direction::from_bits([-x, -y, -z]);
        }
        self.light.at(&seen)
    }
}
