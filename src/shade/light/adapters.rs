//! Adapters of lights: a color, highlights, and light on both sides of a sheet.

use super::{Illumination, Lamp, Lighting, SurfacePoint, Viewer};
use crate::math::Direction;
use crate::shade::Channels;
use crate::shade::format::zip;

/// A light in a color; see [`Lighting::colored`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Colored<L> {
    pub(super) light: L,
    /// Red, green and blue, in units of 2⁻¹⁶.
    pub(super) color: [i32; 3],
}

impl<L: Lighting> Lighting for Colored<L> {
    type Diffuse = [i32; 3];
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination<[i32; 3], L::Specular> {
        let light = self.light.at(point);
        Illumination {
            diffuse: zip(light.diffuse.rgb(), self.color, share),
            specular: light.specular,
        }
    }
}

/// The product of two numbers in units of 2⁻¹⁶, the second at most 1; rounded down.
#[inline]
pub(super) fn share(light: i32, part: i32) -> i32 {
    ((i64::from(light) * i64::from(part)) >> 16) as i32
}

/// A light that makes highlights; see [`Lighting::shiny`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shiny<L> {
    pub(super) lamp: L,
    pub(super) viewer: Viewer,
    pub(super) exponent: u8,
    /// The brightness of the highlight, in units of 2⁻¹⁶.
    pub(super) strength: i32,
}

/// A light that can make highlights: a lamp, also in a color or on both sides of a sheet. See [`Lighting::shiny`].
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a single lamp",
    note = "make each `Light`, `PointLight` and `SpotLight` shiny before you put them together"
)]
pub trait Shine: Lighting {
    /// The light with highlights.
    type Shiny: Lighting;

    fn shine(self, viewer: Viewer, exponent: u8, strength: i32) -> Self::Shiny;
}

impl<L: Lamp> Shine for L {
    type Shiny = Shiny<L>;

    #[inline]
    fn shine(self, viewer: Viewer, exponent: u8, strength: i32) -> Shiny<L> {
        Shiny {
            lamp: self,
            viewer,
            exponent,
            strength,
        }
    }
}

impl<L: Shine> Shine for Colored<L> {
    type Shiny = Colored<L::Shiny>;

    #[inline]
    fn shine(self, viewer: Viewer, exponent: u8, strength: i32) -> Self::Shiny {
        let Self { light, color } = self;
        Colored {
            light: light.shine(viewer, exponent, strength),
            color,
        }
    }
}

impl<L: Shine> Shine for TwoSided<L> {
    type Shiny = TwoSided<L::Shiny>;

    #[inline]
    fn shine(self, viewer: Viewer, exponent: u8, strength: i32) -> Self::Shiny {
        TwoSided {
            light: self.light.shine(viewer, exponent, strength),
            viewer: self.viewer,
        }
    }
}

impl<L: Lamp> Lighting for Shiny<L> {
    type Diffuse = i32;
    type Specular = i32;

    const READS_FACE: bool = false;

    fn at(&self, point: &SurfacePoint) -> Illumination<i32, i32> {
        let (toward, light) = self.lamp.ray(point);
        let facing = point.normal.dot(toward).to_bits().max(0);
        let highlight = if facing > 0 {
            let viewer = self.viewer.direction_from(point.position);
            let cosine = point.normal.dot_halfway(toward, viewer);
            let shine = power(cosine.max(0), self.exponent);
            share(share(self.strength, light), shine >> 14)
        } else {
            0
        };
        Illumination {
            // The sum saturates, so that no value of a user's lamp causes a panic.
            diffuse: self
                .lamp
                .ambient()
                .saturating_add(share(light, facing >> 14)),
            specular: highlight,
        }
    }
}

/// Raises a number from 0 to 1, in units of 2⁻³⁰, to a power. Raising the number takes up to 15 products. Each product
/// is rounded by at most 2⁻³¹, and later products multiply this error by at most the exponent. So the error of the
/// result is less than 2⁻¹⁹.
fn power(base: i32, exponent: u8) -> i32 {
    let times = |a: i32, b: i32| ((i64::from(a) * i64::from(b) + (1 << 29)) >> 30) as i32;
    let (mut result, mut square, mut rest) = (1 << 30, base.min(1 << 30), exponent);
    loop {
        if rest & 1 != 0 {
            result = times(result, square);
        }
        rest >>= 1;
        if rest == 0 {
            return result;
        }
        square = times(square, square);
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Direction;
    use crate::{Vec3, fx};
    use embedded_graphics::pixelcolor::Rgb888;

    /// A user's lamp, with the greatest brightness that an `i32` holds.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Brightest;

    impl Lighting for Brightest {
        type Diffuse = i32;
        type Specular = ();

        fn at(&self, _: &SurfacePoint) -> Illumination {
            Illumination::white(i32::MAX)
        }
    }

    impl Lamp for Brightest {
        fn ray(&self, _: &SurfacePoint) -> (Direction, i32) {
            (Direction::of(Vec3::Y), i32::MAX)
        }

        fn ambient(&self) -> i32 {
            i32::MAX
        }
    }

    /// The types are equal as well: otherwise this test does not compile.
    #[test]
    fn adapters_of_a_lamp_come_in_any_order() {
        let color = Rgb888::new(255, 128, 0);
        let [eye, other] = [Vec3::Y, Vec3::Z].map(Viewer::at);
        let shiny = Brightest.shiny(eye, 8, fx!(0.5)).unwrap();
        let found = Brightest.colored(color).shiny(eye, 8, fx!(0.5));
        assert_eq!(found, Ok(shiny.colored(color)));
        let found = Brightest.two_sided(other).shiny(eye, 8, fx!(0.5));
        assert_eq!(found, Ok(shiny.two_sided(other)));
        let found = Brightest.two_sided(other).colored(color);
        let expected = shiny.two_sided(other).colored(color);
        assert_eq!(found.shiny(eye, 8, fx!(0.5)), Ok(expected));
        assert!(found.shiny(eye, 8, fx!(1.5)).is_err());
    }

    #[test]
    fn the_brightest_lamp_saturates() {
        let normal = Direction::of(Vec3::Y);
        let point = SurfacePoint {
            normal,
            face: normal,
            position: Vec3::ZERO,
        };
        let viewer = Viewer::at(Vec3::Y);
        let shiny = Brightest.shiny(viewer, 8, fx!(1)).unwrap();
        assert_eq!(shiny.at(&point).diffuse, i32::MAX);
        assert_eq!(
            shiny.colored(Rgb888::new(255, 0, 0)).at(&point).diffuse,
            [i32::MAX, 0, 0]
        );
    }
}
