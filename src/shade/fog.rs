//! Fog: surfaces fade to a color with their distance.

use core::marker::PhantomData;
use core::ops::Bound::Included;

use embedded_graphics::geometry::Point;

use super::adapters::cached;
use super::ramp::Ramp;
use super::{Adapted, Effect, Output, PixelFormat, Precise, Within};
use crate::error::{Error, check_above, check_range, ok};
use crate::mesh::{Primitive, Reads};
use crate::num::Scalar;
use crate::num::wide::clamp_negative;
use crate::sealed::Sealed;

/// Fog that hides distant surfaces; see [`Shader::in_fog`](super::Shader::in_fog). It has a color, and a density: how
/// much of a surface remains visible at each distance.
///
#[cfg_attr(doc, doc = page_picture!("in_fog", "A row of rings that fade into gray"))]
/// The distance z is measured from the eye along the view direction, like
/// [`Corner::distance`](crate::Corner::distance). The distance is interpolated in correct perspective.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray8, Gray4, GrayColor}};
/// use fixel::prelude::*;
/// static FLOOR: Mesh = shape!(plane(1, 1));
/// let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.5), fx!(20))?;
/// let mvp = projection * Transform::translate(vec3!(0, -1, 0)) * Transform::scale(fx!(9));
/// let mut pixels = [Gray4::BLACK; 48];
/// let mut canvas = Canvas::new(&mut pixels, 4, 12)?;
/// let fog = Fog::linear(Gray8::WHITE, fx!(1), fx!(6))?;
/// canvas.draw(&FLOOR, &mvp, &Flat::new(Gray8::BLACK).in_fog(fog).converted());
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "0000", "0000", "0000", "0000", "0000", "0000",
///     "0000", "A999", "4444", "2232", "1111", "1010",
/// ]);
/// # Ok::<(), Error>(())
/// ```
///
/// # Accuracy
///
/// The share of the surface that remains visible has an error of at most 1/100 in each triangle that meets the condition
/// of this table ([derived](crate::guide::modes#fog) in the guide):
///
/// | mode | [`Fog::linear`] | [`Fog::exponential`] |
/// |---|---|---|
/// | [`Newton`](crate::mode::Newton) (the default), [`Exact`](crate::mode::Exact), [`Compact`](crate::mode::Compact) | R · far / (far − near) ≤ 30,000 | R ≤ 100,000 |
/// | [`Fast`](crate::mode::Fast), any tolerance | R · far / (far − near) ≤ 1,000, and near ≤ ¾ far | R ≤ 1,000 |
/// | [`Affine`](crate::mode::Affine) | no bound | no bound |
/// | any, under a parallel projection | \|z − far\| ≤ 30,000 · (far − near) at all corners | density · \|z\| ≤ 40,000 at all corners |
///
/// R is the triangle's ratio of distances, (a + b) / c. Here, a is the distance of the farthest corner, b is how far
/// the rearmost corner lies behind the eye (0 if none does), and c is the least distance that is drawn. For example, a
/// floor from the near plane at 0.1 to a distance of 300 has an R of 3,000. In linear fog from 10 to 100, R · far /
/// (far − near) is then 3,333. If the left side of a condition is n times its limit, the error is at most n/100. In
/// linear fog, the error is greater if a corner lies more than 65,536 · (far − near) beyond `far`, because the
/// interpolated number saturates there. Divide a triangle that exceeds the limit into smaller triangles.
///
/// For a plain color of 15 or 16 bits, such as a [`Flat`](crate::Flat) or [`Textured`](crate::Textured) surface in
/// [`Rgb565`](embedded_graphics::pixelcolor::Rgb565), the share is rounded to 1/32. Rounding adds an error of at most
/// 1/64, and halves the time to blend the surface and the fog. If another adapter comes before or after the fog, such
/// as a light or [`dithered`](super::Shader::dithered), the share is not rounded.
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Fog<C, D = LinearFog> {
    color: C,
    density: D,
}

/// How thick a fog is: `LinearFog` or `ExponentialFog`.
#[doc(hidden)]
pub trait Density: Copy + Sealed {
    /// The number that is interpolated. This number is linear in the distance. If `in_32nds`, it may be raised for
    /// [`left_32`](Self::left_32).
    #[doc(hidden)]
    fn varying(&self, distance: Scalar, in_32nds: bool) -> i32;

    /// The share of the surface that remains visible, from 0 to 1 in units of 2^-14.
    #[doc(hidden)]
    fn left(varying: i32, in_32nds: bool) -> i32;

    /// The share of the surface that remains visible, in units of 1/32, rounded to nearest, from a varying `in_32nds`.
    #[doc(hidden)]
    fn left_32(varying: i32) -> u32;
}

impl Sealed for LinearFog {}
impl Sealed for ExponentialFog {}

/// The density of linear fog. Up to a first distance, a surface is wholly visible; beyond a second distance, it is
/// hidden. Between these distances, its visible share falls linearly.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinearFog {
    /// The second distance, at which a surface becomes hidden, in units of 2⁻¹⁶.
    far: i32,
    range: Ramp,
}

/// The density of exponential fog: at the distance z, the share e^(−density · z) of the surface remains visible.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExponentialFog {
    density: Scalar,
}

/// The fraction bits of shares, and of the varying of linear fog.
const BITS: u32 = 14;

/// The fraction bits of the varying of exponential fog. Each bit more would halve [`MOST_DENSITY`]. With a bit less, the
/// rounding error in mode [`Fast`](crate::mode::Fast), 65 units, would be more than 1/100.
const LOG_BITS: u32 = 13;

/// log₂ e in units of 2^-14.
const LOG2_E: i64 = 23_637;

/// The greatest density whose varying fits at every distance, so that the varying is linear in the distance.
const MOST_DENSITY: Scalar = crate::fx!(5);

/// Interpolation may move a varying beyond this number, to leave room for rounding.
const MOST_VARYING: i64 = i32::MAX as i64 - (1 << 27);
const _: () = assert!(binary_logarithm(Scalar::MIN, MOST_DENSITY) >= -MOST_VARYING);

/// Half of 1/32.
const HALF: i32 = 1 << (BITS - 6);

/// The coefficient c of the parabola in [`ExponentialFog::left`], 0.1715, with [`BITS`] fraction bits.
const C: u32 = 2810;

/// The greatest error of the varying that cannot be seen. It changes the share by 1/256 in linear fog, and by at most
/// 1/185 in exponential fog: by ln 2 · 2^-7.
const UNSEEN: u32 = 1 << 6;

/// The binary logarithm of 1 / e^(−density · distance), with [`LOG_BITS`] fraction bits, rounded down.
const fn binary_logarithm(distance: Scalar, density: Scalar) -> i64 {
    // A product of 51 bits is cut to 35 bits, and then multiplied by log₂ e.
    let product = distance.to_bits() as i64 * density.to_bits() as i64;
    ((product >> 16) * LOG2_E) >> (30 - LOG_BITS)
}

impl Density for LinearFog {
    /// Returns the negative share that remains visible, in units of 2^-[`BITS`]. If `in_32nds`, half of 1/32 is added, so
    /// that a shift alone rounds the share at a pixel.
    fn varying(&self, distance: Scalar, in_32nds: bool) -> i32 {
        // The difference has 33 bits: it may be greater than the greatest `Scalar`.
        let beyond = i64::from(distance.to_bits()) - i64::from(self.far);
        let half = if in_32nds { HALF } else { 0 };
        let hidden = self.range.share(beyond) + i64::from(half);
        // In a triangle for which fog promises its error, no number is cut.
        hidden.clamp(-(1 << 30), (1 << 30) - 1) as i32
    }

    #[inline]
    fn left(varying: i32, in_32nds: bool) -> i32 {
        let half = if in_32nds { HALF } else { 0 };
        clamp_negative(varying.wrapping_sub(half), BITS).wrapping_neg()
    }

    #[inline]
    fn left_32(varying: i32) -> u32 {
        clamp_negative(varying >> (BITS - 5), 5)
            .wrapping_neg()
            .cast_unsigned()
    }
}

impl Density for ExponentialFog {
    fn varying(&self, distance: Scalar, _: bool) -> i32 {
        binary_logarithm(distance, self.density) as i32
    }

    #[inline]
    fn left(varying: i32, _: bool) -> i32 {
        // The code computes 2^-x for x from 0 to less than 16. The whole part of x becomes a right shift. For the
        // fraction f of x, 2^-f is replaced by the parabola 1 − (½ + c) f + c f², which is exact at f = 0 and f = 1.
        // With c = 0.1715, its error is at most 0.0019.
        let x = varying.clamp(0, (16 << LOG_BITS) - 1).cast_unsigned();
        let fraction = x & ((1 << LOG_BITS) - 1);
        let slope = (1 << (BITS - 1)) + C - ((C * fraction) >> LOG_BITS);
        (((1 << BITS) - ((slope * fraction) >> LOG_BITS)) >> (x >> LOG_BITS)).cast_signed()
    }

    #[inline]
    fn left_32(varying: i32) -> u32 {
        (Self::left(varying, true) + HALF).cast_unsigned() >> (BITS - 5)
    }
}

impl<C: PixelFormat> Fog<C> {
    /// Fog that begins at the distance `near` and hides everything at the distance `far` and beyond.
    ///
    /// If `near` and `far` are close together, the fog needs small triangles. Let R be the greatest distance in a
    /// triangle divided by the least. If R · `far` / (`far` − `near`) is at most 30,000, the visible share has an error
    /// of at most 1/100. The table of [`Fog`](Fog#accuracy) has the exact condition for each mode.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `far` is not beyond `near`.
    pub const fn linear(color: C, near: Scalar, far: Scalar) -> Result<Self, Error> {
        let range = Ramp::new(ok!(check_above("far end of the fog", far, near)), BITS);
        let far = far.to_bits();
        Ok(Self {
            color,
            density: LinearFog { far, range },
        })
    }
}

impl<C: PixelFormat> Fog<C, ExponentialFog> {
    /// Fog that is equally thick everywhere: at the distance z, the share e^(−`density` · z) of a surface remains
    /// visible.
    ///
    /// At the greatest density, 5, only 1/100 of a surface remains visible at a distance of 0.92 units. For a denser
    /// fog, scale the whole scene up.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `density` is below 0 or above 5.
    pub const fn exponential(color: C, density: Scalar) -> Result<Self, Error> {
        ok!(check_range(
            "density of the fog",
            density,
            (Included(Scalar::ZERO), Included(MOST_DENSITY))
        ));
        Ok(Self {
            color,
            density: ExponentialFog { density },
        })
    }
}

/// A surface in fog; see [`Shader::in_fog`].
///
/// [`Shader::in_fog`]: super::Shader::in_fog
pub type InFog<S, C, D = LinearFog> = Adapted<S, Fog<C, D>>;

impl<O: Output<Color = C>, C: PixelFormat, D: Density> Effect<O> for Fog<C, D> {
    type Color = Fogged<O, D>;
    type Varyings = Within<UNSEEN, i32>;

    const KEEPS_CORNERS: bool = true;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>, keeps: bool) -> [Self::Varyings; 3] {
        cached(primitive, (keeps, Reads::Position), |corner| {
            Within(self.density.varying(corner.distance(), O::IS_PLAIN))
        })
    }

    #[inline]
    fn apply(&self, output: O, Within(varying): Self::Varyings) -> Self::Color {
        Fogged {
            output,
            fog: self.color,
            varying,
            density: PhantomData,
        }
    }
}

/// A surface's output and the fog's share at a pixel, before the two are blended. If no other adapter follows, a plain
/// color of 15 or 16 bits is blended in 32 steps, by one product for all channels. This takes half as long as a blend
/// in full precision.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Fogged<O: Output, D> {
    output: O,
    fog: O::Color,
    varying: i32,
    density: PhantomData<D>,
}

impl<O: Output<Color: PixelFormat>, D: Density> Output for Fogged<O, D> {
    type Color = O::Color;
    type With<T: PixelFormat> = O::With<T>;

    const IS_OPAQUE: bool = O::IS_OPAQUE;

    #[inline]
    fn map<T: PixelFormat>(self, f: impl FnOnce(Precise<O::Color>) -> Precise<T>) -> O::With<T> {
        let left = D::left(self.varying, O::IS_PLAIN) << (16 - BITS);
        let fog = Precise::from(self.fog);
        self.output.map(|color| f(fog.mix(color, left)))
    }

    #[inline]
    fn finish(self, at: Point) -> O::Color {
        if O::IS_PLAIN {
            let (color, left) = (self.output.finish(at), D::left_32(self.varying));
            if let Some(mixed) = self.fog.mix_32(color, left) {
                return mixed;
            }
        }
        self.map(|color| color).finish(at)
    }

    #[inline]
    fn opacity(self) -> u8 {
        self.output.opacity()
    }

    #[inline]
    fn onto(self, below: impl FnOnce() -> O::Color, at: Point) -> O::Color {
        if O::IS_OPAQUE {
            self.finish(at)
        } else {
            self.map(|color| color).onto(below, at)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fx;
    use core::ops::Bound::{Excluded, Unbounded};
    use embedded_graphics::pixelcolor::{Gray8, GrayColor};

    #[test]
    fn bad_fog_is_refused() {
        let white = Gray8::WHITE;
        for (low, high) in [(fx!(2), fx!(2)), (fx!(3), fx!(2))] {
            let refused = Fog::linear(white, low, high);
            let error = Error::OutOfRange {
                of: "far end of the fog",
                given: high,
                range: (Excluded(low), Unbounded),
            };
            assert_eq!(refused, Err(error));
        }
        for given in [fx!(-0.1), MOST_DENSITY + Scalar::DELTA, Scalar::MAX] {
            let refused = Error::OutOfRange {
                of: "density of the fog",
                given,
                range: (Included(fx!(0)), Included(fx!(5))),
            };
            assert_eq!(Fog::exponential(white, given), Err(refused));
        }
        assert!(Fog::exponential(white, MOST_DENSITY).is_ok());
        assert!(Fog::linear(white, Scalar::MIN, Scalar::MAX).is_ok());
        assert!(Fog::exponential(white, fx!(0)).is_ok());
    }

    #[test]
    fn exponential_weights_are_powers_of_two() {
        for x in 0..20 << LOG_BITS {
            let exact = (-f64::from(x) / f64::from(1 << LOG_BITS)).exp2();
            let one = f64::from(1 << BITS);
            let left = f64::from(ExponentialFog::left(x, false)) / one;
            // Two products and the shift are rounded down.
            assert!((left - exact).abs() <= 0.0019 + 3. / one, "{x}: {left}");
        }
    }

    /// Checks every distance, from before the distance where the fog begins to beyond the distance where it hides
    /// everything.
    #[test]
    fn linear_weights_are_rounded_to_nearest() {
        let [near, far] = [fx!(1), fx!(3)];
        let fog = Fog::linear(Gray8::WHITE, near, far).unwrap();
        for distance in (0..4 << 16).map(Scalar::from_bits) {
            let left = f64::from(far - distance) / 2.;
            let varying = fog.density.varying(distance, true);
            let parts = f64::from(1 << BITS);
            // The varying is rounded down to a multiple of 2^-BITS.
            let found = LinearFog::left(varying, true);
            let plain = LinearFog::left(fog.density.varying(distance, false), false);
            assert_eq!(found, plain, "{distance}");
            let found = f64::from(found);
            assert!(
                (found - left.clamp(0., 1.) * parts).abs() <= 1.,
                "{distance}: {found}"
            );
            let found = f64::from(LinearFog::left_32(varying));
            let error = found - left.clamp(0., 1.) * 32.;
            assert!(error.abs() <= 0.5 + 32. / parts, "{distance}: {found}");
        }
        for (distance, whole) in [(near, 1), (far, 0)] {
            let varying = fog.density.varying(distance, true);
            assert_eq!(LinearFog::left(varying, true), whole << BITS);
            assert_eq!(LinearFog::left_32(varying), 32 * whole.cast_unsigned());
        }
    }

    #[test]
    fn extremes_saturate() {
        for (near, far) in [(Scalar::MIN, Scalar::MAX), (fx!(0), Scalar::DELTA)] {
            let fog = Fog::linear(Gray8::WHITE, near, far).unwrap();
            for distance in [Scalar::MIN, fx!(0), Scalar::MAX] {
                // The varying is in units of 2^-14; half of 1/32 is 256 units.
                let varying = fog.density.varying(distance, true);
                let exact = (f64::from(distance) - f64::from(far))
                    / (f64::from(far) - f64::from(near))
                    * 16_384.
                    + 256.;
                let exact = exact.clamp(-(2_f64.powi(30)), 2_f64.powi(30));
                assert!(
                    (f64::from(varying) - exact).abs() <= 1.01,
                    "{varying}, not {exact}"
                );
            }
        }
    }

    /// The varying of the greatest density is linear over all distances: its error is the two roundings, and the error
    /// of the factor, below 5e-6 of the varying.
    #[test]
    fn no_distance_is_cut_in_exponential_fog() {
        let fog = Fog::exponential(Gray8::WHITE, MOST_DENSITY).unwrap();
        for distance in [
            Scalar::MIN,
            fx!(-1),
            fx!(0),
            fx!(1),
            fx!(20_000),
            Scalar::MAX,
        ] {
            let varying = fog.density.varying(distance, true);
            let exact = f64::from(distance) * 5. * core::f64::consts::LOG2_E * 8192.;
            let error = (f64::from(varying) - exact).abs();
            assert!(error <= 1.1 + 5e-6 * exact.abs(), "{varying}, not {exact}");
        }
    }
}
