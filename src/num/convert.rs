//! Conversions of floats and integers to fixed-point numbers, and back.

use super::float::{Parts, float};
use super::{Fraction, Scalar, Subpixel, TexCoord};
use crate::error::Error;
use crate::error::ok;

/// The greatest `f64` below a half. It is added to a float before the float is cut to an integer. A half itself would
/// be wrong: the sum of 0.5 − 2^-54 and a half would be rounded to 1. For floats of a half or more, both sums are cut
/// to the same integer.
pub(super) const HALF: f64 = 0.5 - f64::EPSILON / 4.0;

/// Returns the bits of the nearest number with `fraction` fraction bits; halves are rounded away from zero. `fraction`
/// must be below 31.
const fn nearest(value: f64, fraction: u32) -> Result<i32, Error> {
    // If the number is in range, the cast drops only the fraction.
    let scaled = value * (1_u32 << fraction) as f64;
    let rounded = if scaled < 0.0 {
        scaled - HALF
    } else {
        scaled + HALF
    };
    if rounded > -2_147_483_649.0 && rounded < 2_147_483_648.0 {
        Ok(rounded as i32)
    } else if value.is_finite() {
        // The cast saturates.
        Err(not_representable((value * 1000.0) as i64, fraction))
    } else {
        Err(Error::NotFinite)
    }
}

/// Returns [`nearest`] for a float of 32 bits, by integers.
fn nearest_f32(value: f32, fraction: u32) -> Result<i32, Error> {
    let parts = Parts::of(value)?;
    match parts.nearest(fraction) {
        Some(bits) => Ok(bits),
        None => Err(not_representable(parts.thousandths(), fraction)),
    }
}

/// The error for a number beyond the range of the format with `fraction` fraction bits.
const fn not_representable(thousandths: i64, fraction: u32) -> Error {
    let limit = 1 << (31 - fraction);
    Error::NotRepresentable { thousandths, limit }
}

/// Returns the bits of a whole number with `fraction` fraction bits.
fn whole(value: i64, fraction: u32) -> Result<i32, Error> {
    let bits = value.checked_mul(1 << fraction);
    bits.and_then(|bits| i32::try_from(bits).ok())
        .ok_or(not_representable(value.saturating_mul(1000), fraction))
}

macro_rules! conversions {
    ($Number:ident: From $($Small:ident)*; TryFrom $($Large:ident)+) => {
        impl $Number {
            /// Converts from a float; a constant can call this function.
            #[doc(hidden)]
            pub const fn nearest(value: f64) -> Result<Self, Error> {
                Ok(Self::from_bits(ok!(nearest(value, Self::FRAC_BITS))))
            }
        }

        impl TryFrom<f64> for $Number {
            type Error = Error;

            /// Rounds to nearest, halves away from zero.
            ///
            /// # Errors
            ///
            /// [`Error::NotRepresentable`] if `value`, rounded, is out of range; [`Error::NotFinite`] if it is
            /// infinite or not a number.
            fn try_from(value: f64) -> Result<Self, Error> {
                Self::nearest(value)
            }
        }

        impl TryFrom<f32> for $Number {
            type Error = Error;

            /// Rounds to nearest, halves away from zero. The conversion uses integers only: a core without a floating
            /// point unit links no float routine for it.
            ///
            /// # Errors
            ///
            /// [`Error::NotRepresentable`] if `value`, rounded, is out of range; [`Error::NotFinite`] if it is
            /// infinite or not a number.
            fn try_from(value: f32) -> Result<Self, Error> {
                nearest_f32(value, Self::FRAC_BITS).map(Self::from_bits)
            }
        }

        impl From<$Number> for f64 {
            /// Converts without rounding.
            fn from(number: $Number) -> Self {
                f64::from(number.to_bits()) / f64::from(1_u32 << $Number::FRAC_BITS)
            }
        }

        impl From<$Number> for f32 {
            /// Rounds to the nearest float, halves to even: a float keeps 24 bits. The conversion uses integers only.
            fn from(number: $Number) -> Self {
                float(number.to_bits(), $Number::FRAC_BITS)
            }
        }

        // `try_from` of a wrong type would otherwise be answered by this short list, not by the list of `TryFrom`.
        $(#[diagnostic::do_not_recommend]
        impl From<$Small> for $Number {
            /// Converts without rounding.
            #[inline]
            fn from(value: $Small) -> Self {
                Self::from_bits(i32::from(value) << Self::FRAC_BITS)
            }
        })*

        $(impl TryFrom<$Large> for $Number {
            type Error = Error;

            /// Converts without rounding.
            ///
            /// # Errors
            ///
            /// [`Error::NotRepresentable`] if `value` is out of range.
            fn try_from(value: $Large) -> Result<Self, Error> {
                // A number that does not fit into 64 bits is refused like the largest number of 64 bits.
                let value = i64::try_from(value).unwrap_or(i64::MAX);
                whole(value, Self::FRAC_BITS).map(Self::from_bits)
            }
        })+
    };
    (@scalar $($Number:ident)+) => {$(
        impl TryFrom<Scalar> for $Number {
            type Error = Error;

            /// Converts without rounding.
            ///
            /// # Errors
            ///
            /// [`Error::NotRepresentable`] if `value` is out of range.
            fn try_from(value: Scalar) -> Result<Self, Error> {
                let (bits, from, to) = (value.to_bits(), Scalar::FRAC_BITS, Self::FRAC_BITS);
                let error = not_representable(i64::from(bits) * 1000 / (1 << from), to);
                bits.checked_mul(1 << (to - from)).map(Self::from_bits).ok_or(error)
            }
        }
    )+};
}

conversions!(Scalar: From i8 u8 i16; TryFrom u16 i32 u32 i64 u64 usize);
conversions!(TexCoord: From i8 u8; TryFrom i16 u16 i32 u32 i64 u64 usize);
conversions!(Subpixel: From i8 u8 i16 u16; TryFrom i32 u32 i64 u64 usize);
conversions!(Fraction: From; TryFrom i32);
conversions!(@scalar TexCoord Fraction);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Angle;
    use crate::random::{cases, number};
    use rand::Rng;

    /// The nearest integer to a number; halves are rounded away from zero.
    fn nearest_of(value: f64) -> i64 {
        let whole = value.trunc();
        #[allow(clippy::cast_possible_truncation)]
        let bits = whole as i64;
        let rest = (value - whole).abs();
        bits + if rest < 0.5 { 0 } else { value.signum() as i64 }
    }

    #[test]
    fn floats_next_to_a_half_are_rounded_to_nearest() {
        let check = |half: f64| {
            for value in [half.next_down(), half, half.next_up()] {
                for value in [value, -value] {
                    let found = Scalar::try_from(value / 65_536.0).unwrap();
                    assert_eq!(i64::from(found.to_bits()), nearest_of(value));
                    let found = Angle::nearest(value, 4_294_967_296.0).unwrap();
                    assert_eq!(i64::from(found.to_bits().cast_signed()), nearest_of(value));
                }
            }
        };
        check(0.5);
        cases(256, |random| {
            let whole = random.random::<u32>() >> random.random_range(1..32) >> 1;
            check(f64::from(whole) + 0.5);
        });
    }

    #[test]
    fn the_ends_of_the_range_are_next_to_a_half() {
        let [most, least] = [2_147_483_647.5, -2_147_483_648.5].map(|bits| bits / 65_536.0);
        assert_eq!(Scalar::try_from(f64::next_down(most)), Ok(Scalar::MAX));
        assert_eq!(Scalar::try_from(f64::next_up(least)), Ok(Scalar::MIN));
        assert!(Scalar::try_from(most).is_err() && Scalar::try_from(least).is_err());
    }

    #[test]
    fn integers_are_exact_or_refused() {
        for value in [-32_768, -1, 0, 1, 32_767] {
            assert_eq!(Scalar::try_from(value).map(Scalar::floor), Ok(value));
        }
        for value in [32_768, -32_769, i32::MAX, i32::MIN] {
            let error = Error::NotRepresentable {
                thousandths: i64::from(value) * 1000,
                limit: 32_768,
            };
            assert_eq!(Scalar::try_from(value), Err(error));
        }
        assert_eq!(Scalar::from(i16::MIN), Scalar::MIN);
        assert_eq!(Subpixel::from(u16::MAX).floor(), 65_535);
        assert_eq!(TexCoord::try_from(2047_u16), Ok(TexCoord::ONE * 2047));
        assert!(TexCoord::try_from(2048_u32).is_err() && Scalar::try_from(usize::MAX).is_err());
        assert_eq!(Fraction::try_from(-2), Ok(Fraction::MIN));
        assert!(Fraction::try_from(2).is_err());
        assert_eq!(Scalar::try_from(-32_768_i64), Ok(Scalar::MIN));
        assert!(Scalar::try_from(i64::MIN).is_err() && Scalar::try_from(u64::MAX).is_err());
    }

    #[test]
    fn scalars_are_exact_or_refused() {
        let check = |bits| {
            let scalar = Scalar::from_bits(bits);
            assert_eq!(
                TexCoord::try_from(scalar),
                TexCoord::try_from(f64::from(scalar))
            );
            assert_eq!(
                Fraction::try_from(scalar),
                Fraction::try_from(f64::from(scalar))
            );
        };
        // The ends of `TexCoord` and of `Fraction`.
        for end in [1 << 27, 1 << 17] {
            for bits in [-end - 1, -end, end - 1, end] {
                check(bits);
            }
        }
        cases(256, |random| check(number(random)));
    }
}
