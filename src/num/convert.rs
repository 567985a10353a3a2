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

/// Returns the bits of the nearest number with `fraction` fraction bits, below 31.
const fn nearest(value: f64, fraction: u32) -> Result<i32, Error> {
    // Half away from zero; in range, the cast drops the fraction and nothing else.
    let scaled = value * (1_u32 << fraction) as f64;
    let rounded = if scaled < 0.0 {
        scaled - 0.5
    } else {
        scaled + 0.5
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
