//! Conversions from floats at run time.

use super::{Scalar, TexCoord};
use crate::Error;
use crate::error::{RefusedFloat, ok};
use crate::sealed::{Sealed, sealed};

/// Converts a float to the nearest [`Scalar`], halves away from zero.
///
/// # Errors
///
/// [`Error::NotRepresentable`] if `value` is not a number, or lies outside −32768 to 32768 − 2⁻¹⁶ when rounded.
///
/// ```
/// use fixel::{Scalar, num::scalar};
/// assert_eq!(scalar(1.5), Ok(Scalar::lit("1.5")));
/// assert!(scalar(40_000.0).is_err());
/// ```
pub const fn scalar(value: f64) -> Result<Scalar, Error> {
    let bits = ok!(nearest(value, Scalar::FRAC_NBITS));
    Ok(Scalar::from_bits(bits))
}

/// Converts a float to the nearest [`TexCoord`], halves away from zero.
///
/// # Errors
///
/// [`Error::NotRepresentable`] if `value` is not a number, or lies outside −2048 to 2048 − 2⁻²⁰ when rounded.
///
/// ```
/// use fixel::num::{TexCoord, tex_coord};
/// assert_eq!(tex_coord(1.5), Ok(TexCoord::lit("1.5")));
/// let error = tex_coord(3000.0).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "3000 cannot be represented: it must lie between -2048 and 2047.99999",
/// );
/// ```
pub const fn tex_coord(value: f64) -> Result<TexCoord, Error> {
    let bits = ok!(nearest(value, TexCoord::FRAC_NBITS));
    Ok(TexCoord::from_bits(bits))
}

/// The number below a half, which takes the place of a half where a sum is cut to an integer: the sum of 0.5 − 2^-54
/// and a half would be rounded to 1. From a half on, both sums are cut to the same integer.
pub(super) const HALF: f64 = 0.5 - f64::EPSILON / 4.0;

/// Returns the bits of the nearest number with `fraction` fraction bits, below 31.
const fn nearest(value: f64, fraction: u32) -> Result<i32, Error> {
    // Half away from zero; in range, the cast drops the fraction and nothing else.
    let scaled = value * (1_u32 << fraction) as f64;
    let rounded = if scaled < 0.0 {
        scaled - HALF
    } else {
        scaled + HALF
    };
    if rounded > -2_147_483_649.0 && rounded < 2_147_483_648.0 {
        Ok(rounded as i32)
    } else {
        Err(Error::NotRepresentable {
            value: RefusedFloat::new(value),
            limit: Some(1 << (31 - fraction)),
        })
    }
}

sealed!(Scalar);

/// A bound that only [`Scalar`] meets. The compiler's message for other types says how to write a `Scalar`.
///
/// With a parameter of type `Scalar`, the compiler's message for a float would show a long type name of
/// the package `fixed`. The bound converts nothing and costs nothing.
///
/// ```compile_fail
/// // error: expected a `Scalar`, found `{float}`; note: for a literal write `fx!(0.5)`; …
/// let _ = fixel::Transform::scale(0.5);
/// ```
#[diagnostic::on_unimplemented(
    message = "expected a `Scalar`, found `{Self}`",
    label = "not a `Scalar`",
    note = "for a literal write `fx!(0.5)`; for a float known at run time, `num::scalar(value)?`"
)]
pub trait IntoScalar: Sealed {
    /// Returns the number itself.
    fn into_scalar(self) -> Scalar;
}

// Keeps the spelled-out type of `Scalar` out of the message.
#[diagnostic::do_not_recommend]
impl IntoScalar for Scalar {
    #[inline]
    fn into_scalar(self) -> Scalar {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Angle;
    use crate::random::cases;
    use rand::Rng;

    /// The nearest integer to a number, by its bits.
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
                    let found = scalar(value / 65_536.0).unwrap();
                    assert_eq!(i64::from(found.to_bits()), nearest_of(value));
                    let found = Angle::try_from_turns(value / 4_294_967_296.0).unwrap();
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
        assert_eq!(scalar(f64::next_down(most)), Ok(Scalar::MAX));
        assert_eq!(scalar(f64::next_up(least)), Ok(Scalar::MIN));
        assert!(scalar(most).is_err() && scalar(least).is_err());
    }
}
