//! Fog: surfaces fade to a color with their distance.

use super::ramp::Ramp;
use super::{Fragment, Shader, Source, Within};
use crate::error::{check_range, ok};
use crate::mesh::Primitive;
use crate::num::wide::clamp_negative;
use crate::sealed::{Sealed, sealed};
use crate::texture::Blend;
use crate::{Error, Scalar};

/// Air that hides distant surfaces: a color, and how much of a surface is left at a distance; see
/// [`Shader::in_fog`](super::Shader::in_fog).
///
#[cfg_attr(doc, doc = page_picture!("in_fog", "A row of rings that fade into gray"))]
/// The distance z is measured from the eye along the view direction, as [`Corner::distance`](crate::Corner::distance)
/// is. It is interpolated in correct perspective. Colors of 16 bits are blended in 32 steps, others in 256
/// ([`Blend::WEIGHT_BITS`]). The share of the surface that remains has an error of at most half of such a step plus
/// 1/100.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray8, Gray4, GrayColor}};
/// use fixel::prelude::*;
/// use fixel::shade::Fog;
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
///     "0000", "9999", "4444", "2232", "1111", "1010",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Fog<C, D = Linear> {
    color: C,
    density: D,
}

/// How thick a fog is: [`Linear`] or [`Exponential`]. Sealed.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// use fixel::shade::{Density, Fog};
/// fn hidden<D: Density>(fog: Fog<Rgb565, D>) -> impl Shader<Color = Rgb565> {
///     Flat::new(Rgb565::RED).in_fog(fog)
/// }
/// hidden(Fog::linear(Rgb565::WHITE, fx!(1), fx!(2))?);
/// # Ok::<(), Error>(())
/// ```
pub trait Density: Copy + Sealed {
    /// The number that is interpolated, which is linear in the distance.
    #[doc(hidden)]
    fn varying(&self, distance: Scalar, weight_bits: u32) -> i32;

    /// The part of the surface that fog leaves, from 0 to 2^`weight_bits` in units of 2^-`weight_bits`, rounded to
    /// nearest.
    #[doc(hidden)]
    fn weight(varying: i32, weight_bits: u32) -> u32;
}

sealed!(Linear, Exponential);

/// A [`Density`]: the whole surface is left up to a first distance, and nothing from a second one on. Between them,
/// what is left falls linearly.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::prelude::*;
/// use fixel::shade::{Fog, Linear};
/// let fog: Fog<Gray8, Linear> = Fog::linear(Gray8::WHITE, fx!(2), fx!(30))?;
/// # let _ = fog;
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Linear {
    /// In units of 2⁻¹⁶.
    far: i32,
    range: Ramp,
}

/// A [`Density`]: what is left of the surface at the distance z is e^(−density · z).
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::prelude::*;
/// use fixel::shade::{Exponential, Fog};
/// let fog: Fog<Gray8, Exponential> = Fog::exponential(Gray8::WHITE, fx!(0.1))?;
/// # let _ = fog;
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exponential {
    /// In units of 2⁻¹⁶.
    density: i32,
}

/// The fraction bits of the varying. Interpolation rounds it by at most 57 units, which is 0.35 %.
const BITS: u32 = 14;

/// c of the parabola, 0.1715, with as many bits.
const C: u32 = 2810;

/// Error of the remaining share that cannot be seen: 1/256.
const UNSEEN: u32 = 1 << (BITS - 8);

/// The bits of a color's weight that fog computes: no more than it interpolates.
const fn weight_bits<C: Blend>() -> u32 {
    if C::WEIGHT_BITS < BITS {
        C::WEIGHT_BITS
    } else {
        BITS
    }
}

/// The weight of a surface of color `C` in the blend with the fog's color, from 0 to 2^[`Blend::WEIGHT_BITS`].
#[inline]
fn weight<C: Blend, D: Density>(varying: i32) -> u32 {
    let bits = weight_bits::<C>();
    D::weight(varying, bits) << (C::WEIGHT_BITS - bits)
}

/// A number of 64 bits, limited to the range of varyings.
fn limited(value: i64) -> i32 {
    value.clamp(-(1 << 30), (1 << 30) - 1) as i32
}

impl Density for Linear {
    /// Returns minus the part that fog leaves, in units of 2^-[`BITS`], plus half a step of the weight, so that a pixel
    /// rounds the weight by a shift alone.
    fn varying(&self, distance: Scalar, weight_bits: u32) -> i32 {
        // Of 33 bits: the range may be longer than the greatest number.
        let beyond = i64::from(distance.to_bits()) - i64::from(self.far);
        let half = 1 << (BITS - weight_bits) >> 1;
        limited(self.range.share(beyond) + half)
    }

    #[inline]
    fn weight(varying: i32, weight_bits: u32) -> u32 {
        clamp_negative(varying >> (BITS - weight_bits), weight_bits)
            .wrapping_neg()
            .cast_unsigned()
    }
}

impl Density for Exponential {
    fn varying(&self, distance: Scalar, _: u32) -> i32 {
        // 62 bits, cut to 46, times log₂ e in units of 2^-14.
        let product = i64::from(distance.to_bits()) * i64::from(self.density);
        limited(((product >> 16) * 23_637) >> (30 - BITS))
    }

    #[inline]
    fn weight(varying: i32, weight_bits: u32) -> u32 {
        let down = BITS - weight_bits;
        (Self::left(varying) + (1 << down >> 1)) >> down
    }
}

impl Exponential {
    /// What is left of the surface, in units of 2^-[`BITS`].
    #[inline]
    fn left(varying: i32) -> u32 {
        // 2^-x for x up to 15: in the whole part a shift, and in the fraction f the parabola 1 − (½ + c) f + c f²,
        // which is exact at both ends. With c = 0.1715 its error is at most 0.0019.
        let x = varying.clamp(0, (16 << BITS) - 1).cast_unsigned();
        let fraction = x & ((1 << BITS) - 1);
        let slope = (1 << (BITS - 1)) + C - ((C * fraction) >> BITS);
        ((1 << BITS) - ((slope * fraction) >> BITS)) >> (x >> BITS)
    }
}

impl<C: Blend> Fog<C> {
    /// Fog that begins at the distance `near` and hides everything from `far` on.
    ///
    /// If `far` − `near` is less than a unit, a triangle that reaches beyond `far` by 65,536 times that length fades at
    /// the wrong place.
    ///
    /// # Errors
    ///
    /// [`Error::Empty`] if `far` is not beyond `near`.
    pub const fn linear(color: C, near: Scalar, far: Scalar) -> Result<Self, Error> {
        let Some(range) = Ramp::new(near, far, BITS) else {
            let (of, low, high) = ("fog", near, far);
            return Err(Error::Empty { of, low, high });
        };
        let far = far.to_bits();
        Ok(Self {
            color,
            density: Linear { far, range },
        })
    }
}

impl<C: Blend> Fog<C, Exponential> {
    /// Fog that is equally thick everywhere: at the distance z, e^(−`density` · z) is left of a surface.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `density` is below 0.
    pub const fn exponential(color: C, density: Scalar) -> Result<Self, Error> {
        ok!(check_range(
            "density of the fog",
            density,
            [Scalar::ZERO, Scalar::MAX]
        ));
        Ok(Self {
            color,
            density: Exponential {
                density: density.to_bits(),
            },
        })
    }
}

/// A surface in fog; see [`Shader::in_fog`](super::Shader::in_fog).
///
#[cfg_attr(doc, doc = page_picture!("in_fog", "A row of rings that fade into gray"))]
/// Put light on the surface first, and fog around both: `.lit(sun).in_fog(fog)`.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::prelude::*;
/// use fixel::shade::Fog;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(8))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(4));
/// let mut pixels = [Gray8::BLACK; 1];
/// // At a distance of 4, e^(-0.25 · 4) is left: 37 % of 100, and 63 % of 200.
/// let fog = Fog::exponential(Gray8::new(200), fx!(0.25))?;
/// Canvas::new(&mut pixels, 1, 1)?.draw(&SQUARE, &mvp, &Flat::new(Gray8::new(100)).in_fog(fog));
/// assert_eq!(pixels, [Gray8::new(163)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct InFog<S, C, D = Linear> {
    pub(super) surface: S,
    pub(super) fog: Fog<C, D>,
}

impl<S: Shader<Color: Source<Color = C>>, C: Blend, D: Density> Shader for InFog<S, C, D> {
    type Color = S::Color;
    type Varyings = (S::Varyings, Within<UNSEEN, [i32; 1]>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let [a, b, c] = self.surface.varyings(primitive);
        let density = &self.fog.density;
        let [x, y, z] = primitive
            .corners(|corner| Within([density.varying(corner.distance(), weight_bits::<C>())]));
        [(a, x), (b, y), (c, z)]
    }

    #[inline]
    fn shade(&self, at: &Fragment, (inside, Within([x])): Self::Varyings) -> Option<S::Color> {
        let source = self.surface.shade(at, inside)?;
        let weight = weight::<C, D>(x);
        Some(source.map(|color| self.fog.color.mix(color, weight)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fx;
    use embedded_graphics::pixelcolor::{Gray8, GrayColor};

    #[test]
    fn bad_fog_is_refused() {
        let white = Gray8::WHITE;
        for (low, high) in [(fx!(2), fx!(2)), (fx!(3), fx!(2))] {
            let (of, refused) = ("fog", Fog::linear(white, low, high));
            assert_eq!(refused, Err(Error::Empty { of, low, high }));
        }
        let refused = Fog::exponential(white, fx!(-0.1));
        assert!(matches!(refused, Err(Error::OutOfRange { .. })));
        assert!(Fog::linear(white, Scalar::MIN, Scalar::MAX).is_ok());
        assert!(Fog::exponential(white, fx!(0)).is_ok());
    }

    #[test]
    fn exponential_weights_are_powers_of_two() {
        for x in 0..20 << BITS {
            let one = f64::from(1 << BITS);
            let exact = (-f64::from(x) / one).exp2();
            let left = f64::from(Exponential::left(x)) / one;
            // Two products and the shift are cut.
            assert!((left - exact).abs() <= 0.0019 + 3. / one, "{x}: {left}");
        }
    }

    /// At every distance from before the nearest to beyond the farthest, for colors of 16 and of 24 bits.
    #[test]
    fn linear_weights_are_rounded_to_nearest() {
        let [near, far] = [fx!(1), fx!(3)];
        let fog = Fog::linear(Gray8::WHITE, near, far).unwrap();
        for distance in (0..4 << 16).map(Scalar::from_bits) {
            let left = f64::from(far - distance) / 2.;
            for bits in [5, 8] {
                let weight = Linear::weight(fog.density.varying(distance, bits), bits);
                let exact = left.clamp(0., 1.) * f64::from(1 << bits);
                // The varying is cut to 2^-BITS.
                let tolerance = 0.5 + f64::from(1 << bits) / f64::from(1 << BITS);
                let error = f64::from(weight) - exact;
                assert!(
                    error.abs() <= tolerance,
                    "{distance}: {weight}, not {exact}"
                );
            }
        }
        for bits in [5, 8] {
            let weight = |distance| Linear::weight(fog.density.varying(distance, bits), bits);
            assert_eq!([weight(near), weight(far)], [1 << bits, 0]);
        }
    }

    /// A color may have weights of 15 bits, more than fog interpolates.
    #[test]
    fn the_finest_weights_reach_from_nothing_to_the_whole() {
        #[derive(Clone, Copy)]
        struct Fine;
        impl Blend for Fine {
            const WEIGHT_BITS: u32 = 15;

            fn blend([[first, _], _]: [[Self; 2]; 2], _: [u32; 2]) -> Self {
                first
            }
        }
        let [near, far] = [fx!(1), fx!(3)];
        let linear = Fog::linear(Fine, near, far).unwrap().density;
        let at = |distance| weight::<Fine, Linear>(linear.varying(distance, weight_bits::<Fine>()));
        assert_eq!([at(near), at(fx!(2)), at(far)], [1 << 15, 1 << 14, 0]);
        let exponential = Fog::exponential(Fine, fx!(1)).unwrap().density;
        let varying = exponential.varying(fx!(0), weight_bits::<Fine>());
        assert_eq!(weight::<Fine, Exponential>(varying), 1 << 15);
    }

    #[test]
    fn extremes_saturate() {
        for (near, far) in [(Scalar::MIN, Scalar::MAX), (fx!(0), Scalar::DELTA)] {
            let fog = Fog::linear(Gray8::WHITE, near, far).unwrap();
            for distance in [Scalar::MIN, fx!(0), Scalar::MAX] {
                // In units of 2^-14, of which 32 are half a step of the weight.
                let varying = fog.density.varying(distance, Gray8::WEIGHT_BITS);
                let exact = (f64::from(distance) - f64::from(far))
                    / (f64::from(far) - f64::from(near))
                    * 16_384.
                    + 32.;
                let exact = exact.clamp(-(2_f64.powi(30)), 2_f64.powi(30));
                assert!(
                    (f64::from(varying) - exact).abs() <= 1.01,
                    "{varying}, not {exact}"
                );
            }
        }
        let fog = Fog::exponential(Gray8::WHITE, Scalar::MAX).unwrap();
        assert_eq!(fog.density.varying(Scalar::MAX, 8), (1 << 30) - 1);
        assert_eq!(fog.density.varying(Scalar::MIN, 8), -(1 << 30));
    }
}
