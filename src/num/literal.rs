//! Literals, rounded at compile time.

/// Rounds a literal or, after `const`, a constant expression by the function `$nearest` of the type `$Number`. `$help`
/// answers any other expression.
#[doc(hidden)]
#[macro_export]
macro_rules! __rounded {
    ($Number:ident::$nearest:ident, $help:literal, const $value:expr) => {
        const {
            #[allow(clippy::cast_lossless, clippy::unnecessary_cast)]
            $crate::num::checked($crate::$Number::$nearest($value as f64), "literal")
        }
    };
    ($Number:ident::$nearest:ident, $help:literal, $value:literal) => {
        $crate::__rounded!($Number::$nearest, $help, const $value)
    };
    ($Number:ident::$nearest:ident, $help:literal, $other:expr) => {
        ::core::compile_error!($help)
    };
}

/// A [`Scalar`](crate::Scalar) from a literal, rounded to nearest at compile time.
///
/// `fx!(const …)` accepts a constant expression of any primitive number type. A value out of range does not compile.
/// For a number known at run time, call `Scalar::try_from`.
///
/// ```
/// use fixel::fx;
/// const WIDTH: u32 = 320;
/// assert_eq!(fx!(0.25) + fx!(2), fx!(2.25));
/// assert_eq!(fx!(const WIDTH / 2), fx!(160));
/// ```
///
/// The literal is rounded to a multiple of 1/65536, by at most 7.6e-6: for a literal below 0.0076, this can be more
/// than 0.1 %. To keep the digits, divide by the reciprocal, multiply by a [`Fraction`](crate::Fraction), or choose a
/// smaller unit of length: millimeters in place of meters.
///
/// ```
/// use fixel::{Fraction, fx};
/// let tiny = fx!(0.003125); // 1/320
/// assert_eq!(tiny.to_bits(), 205); // 205/65536 = 0.003128: 0.1 % too large
/// assert_eq!(fx!(8000) * tiny, fx!(25.02441));
/// assert_eq!(fx!(8000) / 320, fx!(25));
/// assert_eq!(fx!(8000) * (Fraction::ONE / 320), fx!(25));
/// ```
/// ```compile_fail
/// let _ = fixel::fx!(40000); // error: literal: 40000 cannot be represented: it must lie …
/// ```
/// ```compile_fail
/// let x = 0.5;
/// let _ = fixel::fx!(-x); // error: expected a literal, such as 0.5; …
/// ```
#[macro_export]
macro_rules! fx {
    (const $value:expr) => {
        $crate::__rounded!(Scalar::nearest, "", const $value)
    };
    // This pattern accepts any expression. A pattern for a literal would accept the minus of `-x`, and the compiler
    // would then stop at `x` with a message of its own.
    ($value:expr) => {
        $crate::__rounded!(
            Scalar::nearest,
            "expected a literal, such as 0.5; for a constant X write fx!(const X), and for a number x known at run \
             time Scalar::try_from(x)?",
            $value
        )
    };
}

/// An [`Angle`](crate::Angle) from a literal in degrees, rounded to the nearest unit at compile time.
///
/// Whole turns are dropped. `deg!(const …)` accepts a constant expression of any primitive number type. A value that is
/// infinite or not a number does not compile. For a value known at run time, call
/// [`Angle::try_from_degrees`](crate::Angle::try_from_degrees).
///
/// ```
/// use fixel::{Angle, deg};
/// const TILT: Angle = deg!(62.5);
/// assert_eq!(TILT.to_string(), "62.5 degrees");
/// assert_eq!(deg!(-90), deg!(270));
/// ```
/// ```compile_fail
/// let _ = fixel::deg!(const f64::INFINITY);
/// ```
/// ```compile_fail
/// let x = 0.5;
/// let _ = fixel::deg!(-x); // error: expected a literal, such as 62.5; …
/// ```
#[macro_export]
macro_rules! deg {
    (const $value:expr) => {
        $crate::__rounded!(Angle::nearest_degrees, "", const $value)
    };
    ($value:expr) => {
        $crate::__rounded!(
            Angle::nearest_degrees,
            "expected a literal, such as 62.5; for a constant X write deg!(const X), and for degrees x known at run \
             time Angle::try_from_degrees(x)?",
            $value
        )
    };
}

#[cfg(test)]
mod tests {
    use crate::{Angle, Scalar, vec2, vec3};

    macro_rules! negative {
        ($value:literal) => {
            vec3!(-$value, -$value, $value)
        };
    }

    #[test]
    fn constants_are_rounded_like_literals() {
        const THIRD: f64 = 1.0 / 3.0;
        // 65,536 / 3 is 21,845.33.
        assert_eq!(fx!(const THIRD).to_bits(), 21_845);
        assert_eq!(fx!(const -2 * 3), fx!(-6));
        assert_eq!(fx!(const u8::MAX), fx!(255));
        // Literals pass through other macros, with their signs.
        assert_eq!(vec3!(-1, -0.5, 2).to_bits(), [-1 << 16, -1 << 15, 2 << 16]);
        assert_eq!(vec2!(-1, 0.5).to_bits(), [-1 << 20, 1 << 19]);
        assert_eq!(negative!(0.5), vec3!(-0.5, -0.5, 0.5));
        assert_eq!(fx!(-32768), Scalar::MIN);
    }

    #[test]
    fn degrees_are_rounded_to_the_nearest_unit() {
        // 62.5 · 2^32 / 360 is 745,654,044.4; a millionth of a degree is 11.93.
        assert_eq!(deg!(62.5).to_bits(), 745_654_044);
        assert_eq!(deg!(0.000_001).to_bits(), 12);
        assert_eq!(deg!(-0.000_001), -deg!(0.000_001));
        assert_eq!(deg!(60), Angle::from_degrees(60));
        assert_eq!(deg!(1e9), Angle::from_degrees(1_000_000_000 % 360));
        assert_eq!(deg!(const f64::MIN_POSITIVE), Angle::ZERO);
    }
}
