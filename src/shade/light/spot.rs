//! Light in a cone.

use core::ops::Bound::{Excluded, Included};

use super::adapters::share;
use super::{Illumination, Lamp, Lighting, PointLight, SurfacePoint};
use crate::error::{Error, check_angle};
use crate::math::{Direction, Vec3};
use crate::num::{Angle, Scalar};
use crate::shade::ramp::Ramp;

/// White light from a point in world space, in a cone: a lamp like [`PointLight`] that shines in one direction.
///
#[cfg_attr(doc, doc = page_picture!("spot_light", "A floor and a ball in a cone of light"))]
/// Let θ be the angle between the cone's axis and the direction from the lamp to a surface. If θ is at most the inner
/// angle, the surface gets as much light as from a [`PointLight`]; if θ is at least the outer angle, the surface gets
/// no light. Between these angles, the light falls smoothly: the light of the [`PointLight`] is multiplied by
/// t²(3 − 2t), where t = (cos θ − cos outer) / (cos inner − cos outer).
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
/// use fixel::prelude::*;
/// use fixel::Window;
/// use fixel::shade::SpotLight;
/// static FLOOR: Mesh = shape!(plane(16, 16));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray4::BLACK; 64];
/// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let spot = SpotLight::new(vec3!(0, 1, 0), vec3!(0, -1, 0), (deg!(20), deg!(40)), fx!(1), fx!(3))?;
/// canvas.draw(&FLOOR, &mvp, &Flat::new(Gray4::WHITE).lit(spot));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "00000000",
///     "00244100",
///     "017BA810",
///     "04BBCA40",
///     "04ACBB30",
///     "018AB720",
///     "00143100",
///     "00000000",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SpotLight {
    /// The lamp before the cone limits its light.
    pub lamp: PointLight,
    axis: Direction,
    /// The cosine of the outer angle, in units of 2⁻³⁰.
    outer: i32,
    /// The cosine of the inner angle minus the cosine of the outer angle, in units of 2⁻³⁰: 1 to 2³⁰.
    edge: i32,
    /// Converts a cosine minus `outer` to a share of `edge`, with 16 fraction bits.
    ramp: Ramp,
}

impl SpotLight {
    /// A lamp at `position` that shines along `axis`, with an inner and an outer angle, both measured from the axis.
    /// Position and axis are in world space. Brightness and range have the same meaning as in [`PointLight::new`].
    ///
    /// # Errors
    ///
    /// The errors of [`PointLight::new`]; [`Error::NoDirection`] if `axis` is zero; [`Error::Angle`] unless 0 ≤ inner
    /// < outer ≤ 90 degrees.
    pub fn new(
        position: Vec3,
        axis: Vec3,
        (inner, outer): (Angle, Angle),
        brightness: Scalar,
        range: Scalar,
    ) -> Result<Self, Error> {
        let lamp = PointLight::new(position, brightness, range)?;
        let axis = Direction::checked(axis)?;
        let inner_range = (Included(Angle::ZERO), Excluded(Angle::QUARTER));
        check_angle("inner angle of the cone", inner, inner_range)?;
        let outer_range = (Excluded(inner), Included(Angle::QUARTER));
        check_angle("outer angle of the cone", outer, outer_range)?;
        let [most, least] = [inner, outer].map(|angle| angle.cos().to_bits());
        // If the angles differ by little, their cosines may be equal, but `edge` must not be 0.
        let edge = (most - least).max(1);
        Ok(Self {
            lamp,
            axis,
            outer: least,
            edge,
            ramp: Ramp::new(edge.into(), 16),
        })
    }
}

impl Lighting for SpotLight {
    type Diffuse = i32;
    type Specular = ();

    const READS_FACE: bool = false;

    fn at(&self, point: &SurfacePoint) -> Illumination {
        Illumination::white(self.diffuse(point))
    }
}

impl Lamp for SpotLight {
    fn ray(&self, point: &SurfacePoint) -> (Direction, i32) {
        let (toward, light) = self.lamp.ray(point);
        let inside = -self.axis.dot(toward).to_bits() - self.outer;
        if light == 0 || inside <= 0 {
            return (toward, 0);
        }
        // t is in units of 2^-16, t² (3 − 2t) in units of 2^-48.
        let t = self.ramp.share(inside.min(self.edge).into());
        let part = (t * t * ((3 << 16) - 2 * t)) >> 32;
        (toward, share(light, part as i32))
    }
}
