//! Light from a point.

use super::{Illumination, Lamp, Lighting, SurfacePoint, brightness};
use crate::error::{Error, check_above, ok};
use crate::math::{Direction, Vec3};
use crate::num::rsqrt::{measure, short_root};
use crate::num::wide::times_half;
use crate::num::{Scalar, reciprocal};

/// White light from a point in world space, up to a range.
///
#[cfg_attr(doc, doc = page_picture!("point_light", "A floor and a ball beside a lamp"))]
/// A surface with unit normal n at the distance d has the brightness b · (1 − d²/r²)² · max(0, n·l): b is the lamp's
/// brightness, r is its range, and l is the unit vector toward the lamp. So the light is bright around the lamp, and
/// has no visible edge at the range. The error is at most 9.2e-4, a quarter of a step of an 8-bit channel. Very near
/// the lamp, the direction is less accurate because positions are in steps of 2⁻¹⁶; at the lamp itself, the brightness
/// is 0.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::Window;
/// use fixel::shade::PointLight;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::new(0); 1];
/// // The middle of each triangle is at a distance of 2.055: (1 − 2.055²/4²)² · 2/2.055 = 0.527.
/// let lamp = PointLight::new(vec3!(0, 2, 0), fx!(1), fx!(4))?;
/// Canvas::new(&mut pixels, 1, 1)?.draw(&SQUARE, &mvp, &Flat::new(Gray8::new(160)).lit_faces(lamp));
/// assert_eq!(pixels, [Gray8::new(84)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointLight {
    position: Vec3,
    /// The brightness in units of 2⁻¹⁶.
    brightness: u32,
    /// The range in units of 2⁻¹⁶.
    range: i32,
    /// 2⁶¹ / (`range` · 2^`up`), from 2³⁰ to 2³¹; the divisor has 31 bits.
    inverse: u32,
    /// 2⁷⁴ / (`range` · 2^`up`)², from 2¹² to 2¹⁴. The number is raised by 2⁻¹⁴ of itself, because its other factor, a
    /// number of 13 bits or more, is rounded down.
    inverse_square: u16,
    /// The negative brightness in units of 2⁻¹⁵.
    short_brightness: i16,
    up: u8,
}

impl PointLight {
    /// A lamp at `position` in world space, of a `brightness` from 0 to 1, that lights surfaces nearer than `range`.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `brightness` is not between 0 and 1, or if `range` is not above 0.
    pub const fn new(position: Vec3, brightness: Scalar, range: Scalar) -> Result<Self, Error> {
        let brightness = ok!(self::brightness(brightness));
        ok!(check_above("range of the light", range, Scalar::ZERO));
        let bits = range.to_bits().cast_unsigned();
        let up = bits.leading_zeros() - 1;
        let inverse = reciprocal(bits << up);
        // 2^90 / (`range` · 2^`up`)², which is `inverse_square` times 2^16.
        let square = (inverse as u64 * inverse as u64) >> 32;
        Ok(Self {
            position,
            brightness: brightness.cast_unsigned(),
            range: range.to_bits(),
            inverse,
            inverse_square: ((square + (square >> 14) + (1 << 15)) >> 16) as u16,
            short_brightness: (-brightness >> 1) as i16,
            up: up as u8,
        })
    }

    /// The light at a distance whose square, divided by the square of the range, is `square`. Both numbers are in units
    /// of 2⁻¹⁶.
    #[inline]
    fn light(&self, square: u32) -> u32 {
        let rest = FULL.saturating_sub(square);
        times(self.brightness, times(rest, rest))
    }
}

/// Full brightness, in units of 2⁻¹⁶.
const FULL: u32 = super::FULL.cast_unsigned();

impl Lighting for PointLight {
    type Diffuse = i32;
    type Specular = ();

    const READS_FACE: bool = false;

    fn at(&self, point: &SurfacePoint) -> Illumination {
        Illumination::white(self.diffuse(point))
    }
}

impl Lamp for PointLight {
    fn ray(&self, point: &SurfacePoint) -> (Direction, i32) {
        let way = point.position.way_to(self.position);
        let range = i64::from(self.range);
        let [x, y, z] = way.map(i64::abs);
        if x >= range || y >= range || z >= range {
            return (Direction::NONE, 0);
        }
        let Some(of) = measure(way) else {
            return (Direction::NONE, 0);
        };
        // The product fits into 64 bits: the distance is below √3 · 2^31, and the reciprocal is at most 2^31.
        let part = (of.length(self.up.into()) * u64::from(self.inverse)) >> 45;
        let square = (part * part) >> 16;
        (
            Direction::from_bits(of.unit()),
            self.light(square as u32).cast_signed(),
        )
    }

    /// Uses only products that take one instruction on Cortex-M4; tests/accuracy/lights.rs derives the error.
    fn diffuse(&self, point: &SurfacePoint) -> i32 {
        // A difference may saturate. It then counts as at least 1 − 2^-15 of the longest range, where (1 − d²/r²)² is at
        // most 2^-28, and the light is 0.
        let [x, y, z] = (point.position - self.position).to_bits();
        // A bit of the result is set where a bit and its lower neighbor differ. So the leading zeros of the result are
        // the bits that only repeat the sign.
        let edges = |way: i32| way ^ way << 1;
        let up = (edges(x) | edges(y) | edges(z)).leading_zeros() & 31;
        // The number of bits by which the distance is shorter than the range.
        let shorter = up.cast_signed() - i32::from(self.up);
        if shorter < 0 {
            return 0;
        }
        // A mantissa has 15 bits and a sign. The greatest mantissa is at least 2^14, unless the distance is 0.
        let mantissa = |way: i32| way << up >> 16;
        let (x, y, z) = (mantissa(x), mantissa(y), mantissa(z));
        let [i, j, k] = point.normal.to_bits();
        let facing = (i >> 16) * x + (j >> 16) * y + (k >> 16) * z;
        // The sum of the squares is from 2^28 to 3 · 2^30.
        let squared = |x: i32| (x * x).cast_unsigned();
        let square = squared(x) + squared(y) + squared(z);
        let root = short_root(square);
        // The upper half of the root is 2^29 / √square, so the cosine is in units of 2^-27. The vector leads away from
        // the lamp, so the cosine of a lit point is negative.
        let cosine = times_half(facing, root >> 16).min(0);
        // d²/r² in units of 2^-27, before it is shifted by `shorter`; it is at most 12, which takes 31 bits.
        let share = (square >> 15) * u32::from(self.inverse_square);
        let rest = ((1 << 27) - (share >> shorter >> shorter).cast_signed()).max(0);
        let brightness = i32::from(self.short_brightness);
        // `rest` is now in units of 2^-15. As an `i16`, 1 wraps to −1, which has the same square.
        let rest = i32::from((rest >> 12) as i16);
        let light = ((rest * brightness) >> 16) * rest;
        times_half(cosine, light >> 16) >> 8
    }
}

/// The product of numbers from 0 to 1 in units of 2⁻¹⁶.
#[inline]
fn times(a: u32, b: u32) -> u32 {
    // One factor loses a bit, so that 1 · 1 fits into 32 bits.
    (a * (b >> 1)) >> 15
}
