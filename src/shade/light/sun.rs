//! Directional and ambient light.

use super::{FULL, Illumination, Lamp, Lighting, SurfacePoint, brightness};
use crate::error::{Error, ok};
use crate::math::{Direction, Vec3};
use crate::num::Scalar;
use crate::num::wide::dot;

/// White light from all sides (ambient) and, like sunlight, from one direction in world space (diffuse).
///
#[cfg_attr(doc, doc = page_picture!("light", "A floor and a ball, lit from the left"))]
/// A surface with unit normal n has the brightness ambient + diffuse · max(0, n·l), saturated at 1, where l is the unit
/// vector toward the light (Lambert's law). The brightness is computed in fixed point, with an error of at most 1e-5.
///
/// [`Shader::lit`](crate::Shader::lit) and [`Shader::lit_faces`](crate::Shader::lit_faces) put any surface under a
/// light.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::{Window, math::Direction, prelude::*};
///
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::new(0); 4];
/// let mut canvas = Canvas::new(&mut pixels, 2, 2)?;
/// let sun = Light::new(vec3!(0, 4, 3), fx!(0.25), fx!(0.5))?;
/// canvas.draw(&SQUARE, &mvp, &Flat::new(Gray8::new(200)).lit(sun));
/// assert!(canvas.pixels().all(|pixel| pixel == Gray8::new(130))); // 0.65 of 200
///
/// assert_eq!(sun.brightness(Direction::of(vec3!(0, 7, 0))), 42598); // 0.25 + 0.5 · 0.8 = 0.65
/// assert_eq!(sun.brightness(Direction::of(vec3!(0, -1, 0))), 16384);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light {
    /// The unit vector toward the light times the diffuse brightness, in units of 2⁻³⁰. The light on a matte surface
    /// needs no other vector.
    direction: [i32; 3],
    /// The unit vector toward the light.
    toward: Direction,
    /// The diffuse brightness, in units of 2⁻¹⁶.
    diffuse: i32,
    /// The ambient brightness, in units of 2⁻¹⁶.
    ambient: i32,
}

impl Light {
    /// A light from `direction`, a vector of any length in world space that points from the surface toward the light.
    ///
    /// Every surface gets the brightness `ambient`. A surface that squarely faces the light also gets the brightness
    /// `diffuse`. Both numbers are between 0 and 1.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if `direction` is zero; [`Error::OutOfRange`] if `ambient` or `diffuse` is not
    /// between 0 and 1.
    pub const fn new(direction: Vec3, ambient: Scalar, diffuse: Scalar) -> Result<Self, Error> {
        let ambient = ok!(brightness(ambient));
        let diffuse = ok!(brightness(diffuse));
        let toward = ok!(Direction::checked(direction));
        let [x, y, z] = toward.to_bits();
        // The components fit into 32 bits, because `diffuse` is at most 1, so the product is no longer than a unit
        // vector.
        let direction = [
            ((x as i64 * diffuse as i64) >> 16) as i32,
            ((y as i64 * diffuse as i64) >> 16) as i32,
            ((z as i64 * diffuse as i64) >> 16) as i32,
        ];
        Ok(Self {
            direction,
            toward,
            diffuse,
            ambient,
        })
    }

    /// The brightness of a surface with this normal in world space, from 0 to 65,536 (full brightness).
    ///
    /// If the normal is [`Direction::NONE`], the brightness is the ambient light.
    #[must_use]
    pub fn brightness(&self, normal: Direction) -> i32 {
        let normal = normal.to_bits();
        // Both vectors are in units of 2^-30 and have a length of about 1 or less, so the product is about 2^60 or
        // less. The shift by 44 converts it to units of 2^-16: at most 65,537.
        let facing = ((dot(&normal, &self.direction) + (1 << 43)) >> 44) as i32;
        (self.ambient + facing.max(0)).min(FULL)
    }
}

impl Lighting for Light {
    type Diffuse = i32;
    type Specular = ();

    const READS_POSITION: bool = false;
    const READS_FACE: bool = false;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination {
        Illumination::white(self.brightness(point.normal))
    }
}

impl Lamp for Light {
    #[inline]
    fn ray(&self, _: &SurfacePoint) -> (Direction, i32) {
        (self.toward, self.diffuse)
    }

    fn ambient(&self) -> i32 {
        self.ambient
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::shader::scale;
    use crate::{fx, vec3};
    use core::ops::Bound::Included;

    /// Brightness is rounded to 2⁻¹⁶; the error of directions is 2⁻²⁸.
    fn close(light: &Light, normal: Vec3, expected: f64) {
        let got = f64::from(light.brightness(Direction::of(normal))) / 65536.0;
        assert!(
            (got - expected).abs() < 1e-5,
            "{normal:?}: {got}, not {expected}"
        );
    }

    #[test]
    fn brightness_follows_lambert() {
        let sun = Light::new(vec3!(1, 2, 2), fx!(0.125), fx!(0.75)).unwrap();
        close(&sun, vec3!(1, 2, 2), 0.875);
        close(&sun, vec3!(0, 0, 300), 0.125 + 0.75 * 2.0 / 3.0);
        close(&sun, Vec3::from_bits([3, 0, 0]), 0.125 + 0.25);
        close(&sun, vec3!(0, 1, -1), 0.125);
        close(&sun, vec3!(-1, -2, -2), 0.125);
        close(&sun, Vec3::ZERO, 0.125);
        let max = Vec3::from_bits([i32::MAX; 3]);
        close(&sun, max, 0.125 + 0.75 * 5.0 / 27_f64.sqrt());
        close(&sun, Vec3::from_bits([i32::MIN; 3]), 0.125);
    }

    #[test]
    fn brightness_saturates() {
        let sun = Light::new(Vec3::from_bits([0, 1, 0]), fx!(1), fx!(1)).unwrap();
        assert_eq!(sun.brightness(Direction::of(Vec3::Y)), 65536);
        let sun = Light::new(vec3!(0, 0, -32768), fx!(0.5), fx!(0.5)).unwrap();
        assert_eq!(sun.brightness(Direction::of(-Vec3::Z)), 65536);
    }

    #[test]
    fn normals_stay_perpendicular_on_stretched_and_mirrored_models() {
        let sun = Light::new(vec3!(0, 1, 0), fx!(0), fx!(1)).unwrap();
        let on = |model: crate::Transform, normal| {
            sun.brightness(model.normal_matrix().direction(normal))
        };
        let close = |found: i32, expected: f64| {
            assert!(
                (f64::from(found) / 65536.0 - expected).abs() < 1e-5,
                "{found}"
            );
        };
        // If the plane x + y = 0 is stretched fourfold along x, it becomes x + 4y = 0.
        let wide = scale([1 << 29, 1 << 27, 1 << 27]);
        close(on(wide, vec3!(1, 1, 0)), 4.0 / 17_f64.sqrt());
        // In a mirrored model, a surface that faced up faces down.
        let mirrored = scale([1 << 29, -(1 << 29), 1 << 29]);
        close(on(mirrored, vec3!(0, -1, 0)), 1.0);
        close(on(mirrored, vec3!(0, 1, 0)), 0.0);
        // A model that is flattened to a point causes no panic.
        close(on(scale([0; 3]), Vec3::Y), 0.0);
        assert_eq!(on(scale([1, 0, 1]), Vec3::Y), 65536);
    }

    #[test]
    fn bad_arguments_are_refused() {
        let half = fx!(0.5);
        assert_eq!(
            Light::new(Vec3::ZERO, half, half),
            Err(Error::ZERO_DIRECTION)
        );
        for value in [fx!(-0.1), fx!(1.5)] {
            let error = Err(Error::OutOfRange {
                of: "brightness",
                given: value,
                range: (Included(fx!(0)), Included(fx!(1))),
            });
            assert_eq!(Light::new(Vec3::X, value, half), error);
            assert_eq!(Light::new(Vec3::X, half, value), error);
        }
    }
}
