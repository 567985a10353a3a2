//! Angles from floats.

use super::{Angle, HALF, TURN};
use crate::error::Error;
use crate::num::Scalar;
use crate::num::float::Parts;
use crate::num::wide::unsigned_product;

/// A unit of angles that are given as floats: degrees or radians.
#[derive(Clone, Copy)]
pub struct Unit {
    /// A turn in this unit.
    pub(super) turn: f64,
    /// 2^-22 / `turn`. The first word is the whole part, and the others are the fraction.
    reciprocal: [u32; 8],
}

impl Unit {
    pub(super) const DEGREES: Self = Self {
        turn: 360.0,
        reciprocal: {
            let mut words = [0; 8];
            // Long division. Of 2^32 · 2^-22, the first word of the fraction is the quotient.
            let mut i = 1;
            let mut dividend = 1_u64 << 10;
            while i < 8 {
                words[i] = (dividend / 360) as u32;
                dividend = (dividend % 360) << 32;
                i += 1;
            }
            words
        },
    };
    /// The bits of 1 / 2π are a quarter of those of 2 / π, which begin with a2f9836e in hexadecimal digits.
    pub(super) const RADIANS: Self = Self {
        turn: core::f64::consts::TAU,
        reciprocal: [
            0,
            0xa2,
            0xf983_6e4e,
            0x4415_29fc,
            0x2757_d1f5,
            0x34dd_c0db,
            0x6295_993c,
            0x4390_41fe,
        ],
    };

    /// Returns the angle nearest to a float in this unit, for every float: the error is at most half a unit of the
    /// angle. Halves are rounded away from zero.
    #[inline(never)]
    fn nearest(&self, value: f32) -> Result<Angle, Error> {
        /// The exponent of floats from 2^-31 to 2^-30. Floats below are less than half a unit of the angle.
        const LEAST: i32 = 96;
        let Parts {
            is_negative,
            mantissa,
            exponent,
        } = Parts::of(value)?;
        let Ok(at) = u32::try_from(exponent - LEAST) else {
            return Ok(Angle::ZERO);
        };
        // The angle is the mantissa times 2^-22 / turn · 2^at, in units of 2^-32 of a turn. Three words of the factor are
        // enough: the words before them would add whole turns, and those after them less than 2^-40 of a unit.
        let (word, bit) = ((at >> 5) as usize, at & 31);
        let [a, b, c, d, ..] = self.reciprocal[word..] else {
            return Ok(Angle::ZERO); // never: `at` is at most 158
        };
        let shifted = |high: u32, low: u32| high << bit | low >> 1 >> (31 - bit);
        let (units, upper, lower) = (shifted(a, b), shifted(b, c), shifted(c, d));
        // In units of 2^-32, and too small by less than 1.1. So 1 is added, and a half does not fall below a half. No
        // other float comes as close to a half as 2^-31.
        let fraction =
            unsigned_product(mantissa, upper) + (unsigned_product(mantissa, lower) >> 32) + 1;
        let units = mantissa
            .wrapping_mul(units)
            .wrapping_add(((fraction + (1 << 31)) >> 32) as u32);
        Ok(Angle(if is_negative {
            units.wrapping_neg()
        } else {
            units
        }))
    }
}

/// A float or an integer, which [`Angle::try_from_degrees`] and [`Angle::try_from_radians`] convert.
pub trait Real {
    /// Returns the angle nearest to this number of units.
    fn angle(self, unit: &Unit) -> Result<Angle, Error>;
}

impl Real for f32 {
    fn angle(self, unit: &Unit) -> Result<Angle, Error> {
        unit.nearest(self)
    }
}

macro_rules! real {
    ($($Number:ident)+) => {$(
        impl Real for $Number {
            fn angle(self, unit: &Unit) -> Result<Angle, Error> {
                Angle::nearest(self.into(), unit.turn)
            }
        }
    )+};
}

real!(f64 i8 i16 i32 u8 u16 u32 Scalar);

impl Angle {
    pub(in crate::num) const fn nearest(value: f64, turn: f64) -> Result<Self, Error> {
        if !value.is_finite() {
            return Err(Error::NotFinite);
        }
        let units = value % turn / turn * TURN;
        let half = if units < 0.0 { -HALF } else { HALF };
        // Whole turns are dropped.
        Ok(Self(((units + half) as i64).cast_unsigned() as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use core::f64::consts::TAU;
    use rand::Rng;

    /// Calls with floats of every exponent, and of both signs.
    fn floats(check: impl Fn(f32)) {
        for exponent in 0..0xff_u32 {
            let of = |mantissa: u32| f32::from_bits(exponent << 23 | mantissa);
            let ends = [0, 1, 0x3f_ffff, 0x40_0000, 0x7f_ffff].map(of);
            for value in ends {
                check(value);
                check(-value);
            }
            cases(64, |random| {
                let value = of(random.random_range(0..1 << 23));
                check(value);
                check(-value);
            });
        }
    }

    /// The nearest angle, computed exactly: a float of at least 2^-26 is a multiple of 2^-49 degrees, and smaller floats
    /// are less than half a unit.
    fn exact_degrees(value: f32) -> u32 {
        let parts = Parts::of(value).unwrap();
        // The float, mod 360, in units of 2^-49.
        let mut units = u128::from(parts.mantissa);
        match parts.exponent - 150 + 49 {
            up @ 0.. => (0..up).for_each(|_| units = 2 * units % (360 << 49)),
            down => units >>= -down.max(-127),
        }
        let angle = ((units << 32) + (180 << 49)) / (360 << 49);
        let angle = angle as u32;
        if parts.is_negative {
            angle.wrapping_neg()
        } else {
            angle
        }
    }

    #[test]
    fn degrees_of_every_exponent_are_rounded_to_nearest() {
        floats(|value| {
            let found = Angle::try_from_degrees(value).unwrap();
            assert_eq!(found.to_bits(), exact_degrees(value), "{value:e}");
            // No float is so close to a half that the errors of `f64` arithmetic change the result.
            assert_eq!(
                Ok(found),
                Angle::try_from_degrees(f64::from(value)),
                "{value:e}"
            );
        });
    }

    #[test]
    #[allow(clippy::cast_precision_loss)] // of 23 bits
    fn halves_of_a_unit_are_rounded_away_from_zero() {
        // An odd number of 45 · 2^-30 degrees is a half.
        cases(256, |random| {
            let odd = random.random_range(0..1_u32 << 17) | 1;
            let half = (odd * 45) as f32 * f32::exp2(-30.);
            let found = Angle::try_from_degrees(half).unwrap();
            assert_eq!(found.to_bits(), odd.div_ceil(2), "{odd}");
            assert_eq!(Angle::try_from_degrees(-half), Ok(-found));
        });
    }

    /// The sine and the cosine of the standard library are accurate for every float. The angle between them has an error of
    /// a few units of 2^-53, less than 2^-17 units of the angle.
    #[test]
    fn radians_of_every_exponent_are_rounded_to_nearest() {
        floats(|value| {
            let found = Angle::try_from_radians(value).unwrap();
            let (sin, cos) = f64::from(value).sin_cos();
            let exact = sin.atan2(cos) / TAU * TURN;
            let error = (f64::from(found.to_bits()) - exact).rem_euclid(TURN);
            let error = error.min(TURN - error);
            assert!(error <= 0.5 + f64::exp2(-17.), "{value:e}: {error}");
        });
    }

    /// Of all floats of their exponents, these are closest to a half of a unit: the seventh is closest of all, 5e-10 above.
    /// The angles were computed with 200 digits.
    #[test]
    fn radians_closest_to_a_half_are_rounded_to_nearest() {
        for (float, angle) in [
            (0x3049_0fdb, 0x0000_0001),
            (0x3f8f_fd14, 0x2dd5_3ede),
            (0x405b_d32f, 0x8bf1_e503),
            (0x4ffc_8720, 0x0a52_0a42),
            (0x5064_112c, 0xda9e_cad3),
            (0x5f68_2b9c, 0xc5dd_a5f7),
            (0x5ff9_be45, 0xf28f_dd4b),
            (0x600a_3cc8, 0xc84d_1b8e),
            (0x6205_82ef, 0xf14a_f036),
            (0x6ffe_2485, 0x8db8_81ec),
            (0x700e_5a38, 0xf109_753a),
            (0x763c_4bad, 0xe8c0_b527),
            (0x7b79_0866, 0x42a4_f126),
            (0x7e17_9009, 0x859a_e557),
            (0x7e93_e9ab, 0xbc54_2366),
            (0x7f31_dc3d, 0xa090_a99c),
        ] {
            let (value, angle) = (f32::from_bits(float), Angle::from_bits(angle));
            assert_eq!(Angle::try_from_radians(value), Ok(angle), "{value:e}");
            assert_eq!(Angle::try_from_radians(-value), Ok(-angle), "{value:e}");
        }
    }

    /// Up to ten turns, the `f64` nearest to 2π adds an error below 2^-18 units: 64 · 4e-17 · 2^32 / 2π is 2^-19.1. So `f64`
    /// arithmetic gives the same bits, except next to a half.
    #[test]
    fn radians_are_those_of_f64() {
        cases(4096, |random| {
            let value = random.random_range(-64.0..64.0_f32);
            let units = f64::from(value) % TAU / TAU * TURN;
            if (units - units.floor() - 0.5).abs() > f64::exp2(-18.) {
                let found = Angle::try_from_radians(value);
                assert_eq!(
                    found,
                    Angle::try_from_radians(f64::from(value)),
                    "{value:e}"
                );
            }
        });
    }

    #[test]
    fn floats_that_are_not_finite_are_refused() {
        for value in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(Angle::try_from_degrees(value), Err(Error::NotFinite));
            assert_eq!(Angle::try_from_radians(value), Err(Error::NotFinite));
        }
    }
}
