//! Light that falls on a surface: where it comes from, how strong it is, and in which color.
//!
//! Lights are in world space. [`Light`] is sun and sky in one; [`PointLight`] and [`SpotLight`] shine from a point. All
//! lights are white unless you make them [`colored`](Lighting::colored). Arrays, slices and tuples of lights are
//! lights, too.

mod adapters;
mod illumination;
mod lamp;
mod point;
mod spot;
mod sun;
mod together;
mod viewer;

pub use adapters::{Colored, Shine, Shiny, TwoSided};
pub use illumination::Illumination;
pub(super) use illumination::Packed;
pub use lamp::Lamp;
pub use point::PointLight;
pub use spot::SpotLight;
pub use sun::Light;
pub use viewer::Viewer;

use core::ops::Bound::Included;

use embedded_graphics::pixelcolor::Rgb888;

use crate::error::{Error, check_range, ok};
use crate::math::{Direction, Vec3};
use crate::num::Scalar;
use crate::shade::Channels;
use crate::shade::format::fractions;

/// Full brightness.
pub(super) const FULL: i32 = 1 << 16;

/// Converts a brightness to units of 2⁻¹⁶; an error unless the brightness lies between 0 and 1.
const fn brightness(value: Scalar) -> Result<i32, Error> {
    ok!(check_range(
        "brightness",
        value,
        (Included(Scalar::ZERO), Included(Scalar::ONE))
    ));
    Ok(value.to_bits())
}

/// A point of a surface in world space: the values from which [`Lighting`] computes the light.
///
/// ```
/// use fixel::math::Direction;
/// use fixel::prelude::*;
/// use fixel::shade::{Lighting, SurfacePoint};
/// let up = Direction::of(Vec3::Y);
/// let point = SurfacePoint { normal: up, face: up, position: vec3!(1, 0, 0) };
/// let sun = Light::new(vec3!(0, 4, 3), fx!(0.25), fx!(0.5))?;
/// assert_eq!(sun.at(&point).diffuse, 42_598); // 0.25 + 0.5 · 0.8 = 0.65
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SurfacePoint {
    /// The normal of the surface at this point.
    pub normal: Direction,
    /// The normal of the triangle; [`Direction::NONE`] on edges and points, and if no light
    /// [reads it](Lighting::READS_FACE).
    pub face: Direction,
    /// The position; zero if no light [reads it](Lighting::READS_POSITION).
    pub position: Vec3,
}

impl SurfacePoint {
    /// Makes the point that light `L` reads. If `L` does not read the position, the position is not computed.
    #[inline]
    pub(super) fn new<L: Lighting>(
        normal: Direction,
        face: Direction,
        position: impl FnOnce() -> Vec3,
    ) -> Self {
        Self {
            normal,
            face,
            position: if L::READS_POSITION {
                position()
            } else {
                Vec3::ZERO
            },
        }
    }
}

/// Light that falls on a surface: a [`Light`], [`PointLight`] or [`SpotLight`], or several lights in an array, a slice
/// or a tuple of two to four.
///
#[cfg_attr(doc, doc = page_picture!("colored", "A ball between a red and a blue lamp"))]
/// [`Shader::lit`](crate::Shader::lit) and [`Shader::lit_faces`](crate::Shader::lit_faces) put a surface under a light.
/// You can write a light of your own in ten lines:
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::Window;
/// use fixel::shade::{Illumination, SurfacePoint};
///
/// /// Dark below, bright above.
/// #[derive(Clone, Copy)]
/// struct Sky;
///
/// impl Lighting for Sky {
///     type Diffuse = i32;
///     type Specular = ();
///     const READS_POSITION: bool = false;
///     const READS_FACE: bool = false;
///
///     fn at(&self, point: &SurfacePoint) -> Illumination {
///         // Components are in units of 2^-30.
///         let [_, y, _] = point.normal.components();
///         Illumination::white(32_768 + (y.to_bits() >> 15))
///     }
/// }
///
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::new(0); 4];
/// Canvas::new(&mut pixels, 2, 2)?.draw(&SQUARE, &mvp, &Flat::new(Gray8::new(200)).lit(Sky));
/// assert_eq!(pixels, [Gray8::new(200); 4]);
/// # Ok::<(), Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a light",
    note = "lights are `Light`, `PointLight`, `SpotLight`, and arrays, slices and tuples of lights"
)]
pub trait Lighting: Copy {
    /// The type of [`Illumination::diffuse`]: `i32` for white light, `[i32; 3]` for light in a color.
    type Diffuse: Channels;

    /// The type of [`Illumination::specular`]: `i32` for a light that makes highlights, else `()`.
    type Specular: Channels;

    /// Whether [`at`](Self::at) reads [`SurfacePoint::position`]. If this is `false`, the corners' positions in world
    /// space are not computed.
    const READS_POSITION: bool = true;

    /// Whether [`at`](Self::at) reads [`SurfacePoint::face`]. If this is `false`, the triangles' normals are not
    /// computed for this purpose.
    const READS_FACE: bool = true;

    /// The light that falls on a point of a surface: at most a thousand times full brightness. Full brightness is
    /// 65,536.
    fn at(&self, point: &SurfacePoint) -> Illumination<Self::Diffuse, Self::Specular>;

    /// The same light, in a color. Highlights keep their brightness, and stay white. On a canvas that is not gray,
    /// colored light takes three of the eight [varyings](crate::shade::Varyings) that a shader may have.
    ///
    #[cfg_attr(doc, doc = page_picture!("colored", "A ball between a red and a blue lamp"))]
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Rgb888::BLACK; 1];
    /// let evening = Light::new(Vec3::Y, fx!(0), fx!(0.5))?.colored(Rgb888::new(255, 128, 0));
    /// Canvas::new(&mut pixels, 1, 1)?.draw(&SQUARE, &mvp, &Flat::rgb(Rgb888::WHITE).lit(evening));
    /// assert_eq!(pixels, [Rgb888::new(128, 64, 0)]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn colored(self, color: Rgb888) -> Colored<Self> {
        Colored {
            light: self,
            color: fractions::<Rgb888>(color),
        }
    }

    /// The same light for thin sheets that are seen from both sides: triangles that turn their back to the viewer are
    /// lit as if their normals pointed the other way.
    ///
    #[cfg_attr(doc, doc = page_picture!("two_sided", "Two bowls: the inside is dark without the adapter, and lit with it"))]
    /// A triangle turns its back to the viewer if its normal points to one side of its plane, and the viewer is on the
    /// other side. Edges and points have no back.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
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
    #[must_use]
    #[inline]
    fn two_sided(self, viewer: Viewer) -> TwoSided<Self> {
        TwoSided {
            light: self,
            viewer,
        }
    }

    /// Adds a white highlight (Blinn–Phong) as the `viewer` sees it. The highlight's brightness is `strength` ·
    /// (n·h)^`exponent` times the strength of the light at the point, where n is the normal, and h is the direction
    /// halfway between the directions toward the light and toward the viewer.
    ///
    /// An exponent of 8 makes a wide highlight; an exponent of 100 makes a small one. Highlights are computed at the
    /// corners and interpolated, so a mesh must be fine enough to show them. Highlights take one of the eight
    /// [varyings](crate::shade::Varyings) that a shader may have.
    ///
    /// Only a [`Lamp`] can be shiny. [`colored`](Self::colored) and [`two_sided`](Self::two_sided) may come before or
    /// after `shiny`. Make each of several lights shiny before you put them together.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `strength` is not between 0 and 1.
    ///
    #[cfg_attr(doc, doc = page_picture!("shiny", "A ring with highlights"))]
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static BALL: Mesh = shape!(sphere(24, 16));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::front(Vec3::ZERO, fx!(1));
    /// let sun = Light::new(vec3!(1, 1, 2), fx!(0.2), fx!(0.4))?;
    /// let sun = sun.shiny(Viewer::of(&mvp), 30, fx!(0.8))?;
    /// let mut pixels = [Gray4::BLACK; 144];
    /// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
    /// canvas.draw(&BALL, &mvp, &Flat::rgb(Rgb888::WHITE).lit(sun));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "000067780000",
    ///     "005678989700",
    ///     "045779899970",
    ///     "056789BBA990",
    ///     "35677ABDA987",
    ///     "346789BCB997",
    ///     "3456788A9977",
    ///     "345577888876",
    ///     "034556676760",
    ///     "033455666550",
    ///     "003334454400",
    ///     "000033330000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    /// ```compile_fail
    /// use fixel::prelude::*;
    /// fn both(sun: Light, moon: Light, viewer: Viewer) {
    ///     // error: `[Light; 2]` is not a single lamp; note: make each `Light`, … shiny before …
    ///     let _ = [sun, moon].shiny(viewer, 30, fx!(0.5));
    /// }
    /// ```
    #[inline]
    fn shiny(
        self,
        viewer: Viewer,
        exponent: u8,
        strength: Scalar,
    ) -> Result<<Self as Shine>::Shiny, Error>
    where
        Self: Shine,
    {
        Ok(self.shine(viewer, exponent, brightness(strength)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::shader::{IDENTITY, face};
    use crate::shade::{FaceLit, Flat, Shader};
    use crate::{Angle, Mesh, fx, vec3};
    use core::ops::Bound::{Excluded, Unbounded};
    use embedded_graphics::pixelcolor::Gray8;

    /// A light that is as bright as the position's x coordinate, in units of 2⁻¹⁶.
    #[derive(Clone, Copy)]
    struct BrightAsX;

    impl Lighting for BrightAsX {
        type Diffuse = i32;
        type Specular = ();

        fn at(&self, point: &SurfacePoint) -> Illumination {
            Illumination::white(point.position.x.to_bits())
        }
    }

    #[test]
    fn faces_are_lit_at_their_middle_and_corners_where_they_are() {
        for (xs, mean) in [([0, 3, 6], 3), ([1, 1, 3], 2), ([60_000, 2, 9_000], 23_001)] {
            let [a, b, c] = xs.map(|x| Vec3::from_bits([x, 1, 2]));
            let positions = [a, b + vec3!(0, 1, 0), c + vec3!(0, 0, 1)];
            let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
            let white = Flat::new(Gray8::new(255));
            let (_, corners) = face(white.lit_faces(BrightAsX), &IDENTITY, &mesh, 0);
            assert_eq!(corners.map(|((), light)| light.0.0), [mean; 3], "{xs:?}");
            let (_, corners) = face(white.lit(BrightAsX), &IDENTITY, &mesh, 0);
            assert_eq!(corners.map(|((), light)| light.0.0), xs);
        }
    }

    #[test]
    fn several_lights_add_up_to_full_brightness() {
        let up = Direction::of(Vec3::Y);
        let point = SurfacePoint {
            normal: up,
            face: up,
            position: Vec3::ZERO,
        };
        let sun = |diffuse| Light::new(Vec3::Y, fx!(0.125), diffuse).unwrap();
        let near = PointLight::new(vec3!(0, 4, 0), fx!(0.5), fx!(8)).unwrap();
        let (quarter, three) = (sun(fx!(0.25)), [sun(fx!(0.25)), sun(fx!(0.5)), sun(fx!(0))]);
        let none: [Light; 0] = [];
        let diffuse = |light: Illumination| light.diffuse;
        let lamp = diffuse(near.at(&point));
        // The brightness is (1 − ¼)² of a half, with an error of at most 9.2e-4.
        assert!(lamp.abs_diff(18_432) <= 60, "{lamp}");
        assert_eq!(diffuse((quarter, near).at(&point)), 24_576 + lamp);
        assert_eq!(diffuse(three.at(&point)), 3 * 8_192 + 49_152);
        assert_eq!(diffuse((&three[1..]).at(&point)), 2 * 8_192 + 32_768);
        assert_eq!(diffuse(none.at(&point)), 0);
        // If the light is beyond full brightness, the surface has its own color.
        let bright = [sun(fx!(1)); 3];
        let ground = [Vec3::ZERO, Vec3::Z, Vec3::X];
        let mesh = Mesh::new(&ground, &[[0, 1, 2]]).unwrap();
        let shader: FaceLit<_, _> = Flat::new(Gray8::new(200)).lit_faces(bright);
        let (_, [((), light), ..]) = face(shader, &IDENTITY, &mesh, 0);
        assert_eq!(light.0.0, FULL);
    }

    /// At a distance of one or two units, a lamp with the longest range still has its full brightness.
    #[test]
    fn a_lamp_with_a_long_range_lights_what_is_close() {
        for range in [fx!(1), fx!(16_383), fx!(16_384), Scalar::MAX] {
            let lamp = PointLight::new(Vec3::ZERO, fx!(1), range).unwrap();
            for x in [1_i32, -1, 2, -2] {
                let away = Direction::of(Vec3::from_bits([-x.signum() << 16, 0, 0]));
                let point = SurfacePoint {
                    normal: away,
                    face: away,
                    position: Vec3::from_bits([x, 0, 0]),
                };
                // The tolerance is less than 9.2e-4, the greatest error of a lamp.
                let light = lamp.at(&point).diffuse;
                assert!(light >= FULL - 54, "{light} at {x} of {range}");
            }
        }
    }

    /// At 256 times the range, the square of the distance has its lowest 32 bits 0, as at no distance.
    #[test]
    fn beyond_its_range_a_lamp_is_dark() {
        for (range, times) in [
            (fx!(1), 1),
            (fx!(1), 2),
            (fx!(1), 256),
            (fx!(0.125), 65_536),
        ] {
            let lamp = PointLight::new(Vec3::ZERO, fx!(1), range).unwrap();
            let far = range * times;
            for position in [Vec3::X * far, Vec3::Y * -far, Vec3::new(far, far, -far)] {
                let toward = Direction::of(-position);
                let point = SurfacePoint {
                    normal: toward,
                    face: toward,
                    position,
                };
                let lights = [lamp.at(&point).diffuse, lamp.ray(&point).1];
                assert_eq!(lights, [0; 2], "{position:?}, {range}");
            }
        }
    }

    #[test]
    fn bad_lamps_are_refused() {
        let lamp = |brightness, range| PointLight::new(Vec3::ZERO, brightness, range);
        let value = fx!(1.5);
        let too_bright = Error::OutOfRange {
            of: "brightness",
            given: value,
            range: (Included(fx!(0)), Included(fx!(1))),
        };
        assert_eq!(lamp(value, fx!(1)), Err(too_bright));
        for range in [fx!(0), fx!(-1)] {
            assert_eq!(
                lamp(fx!(1), range),
                Err(Error::OutOfRange {
                    of: "range of the light",
                    given: range,
                    range: (Excluded(fx!(0)), Unbounded),
                })
            );
        }
        let spot =
            |axis, inner, outer| SpotLight::new(Vec3::ZERO, axis, (inner, outer), fx!(1), fx!(1));
        let degrees = Angle::from_degrees;
        assert!(spot(Vec3::X, degrees(0), degrees(90)).is_ok());
        assert_eq!(
            spot(Vec3::ZERO, degrees(0), degrees(9)),
            Err(Error::ZERO_DIRECTION)
        );
        for (inner, outer) in [(9, 9), (10, 9), (0, 91)] {
            let [inner, outer] = [inner, outer].map(degrees);
            let error = Error::Angle {
                of: "outer angle of the cone",
                given: outer,
                range: (Excluded(inner), Included(degrees(90))),
            };
            assert_eq!(spot(Vec3::X, inner, outer), Err(error));
        }
        for (inner, outer) in [(-1, 9), (90, 90), (95, 99)] {
            let [inner, outer] = [inner, outer].map(degrees);
            let error = Error::Angle {
                of: "inner angle of the cone",
                given: inner,
                range: (Included(degrees(0)), Excluded(degrees(90))),
            };
            assert_eq!(spot(Vec3::X, inner, outer), Err(error));
        }
        let sun = Light::new(Vec3::X, fx!(0), fx!(1)).unwrap();
        let viewer = Viewer::at(Vec3::Z);
        assert_eq!(sun.shiny(viewer, 3, value), Err(too_bright));
        assert_eq!(Viewer::toward(Vec3::ZERO), Err(Error::ZERO_DIRECTION));
    }
}
