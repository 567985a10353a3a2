//! Literals, rounded at compile time.

use super::{Angle, Scalar, TexCoord, scalar, tex_coord};

/// Rounds a literal to a [`Scalar`] at compile time, for [`fx!`](crate::fx) and
/// [`vec3!`](crate::vec3).
///
/// # Panics
///
/// At compile time, if the literal is beyond ±32768.
#[doc(hidden)]
#[must_use]
pub const fn literal(value: f64) -> Scalar {
    match scalar(value) {
        Ok(number) => number,
        Err(_) => panic!("literal is not a number between -32768 and 32768"),
    }
}

/// Rounds a literal to a [`TexCoord`] at compile time, for [`vec2!`](crate::vec2).
///
/// # Panics
///
/// At compile time, if the literal is beyond ±2048.
#[doc(hidden)]
#[must_use]
pub const fn literal_tex_coord(value: f64) -> TexCoord {
    match tex_coord(value) {
        Ok(number) => number,
        Err(_) => panic!("literal is not a number between -2048 and 2048"),
    }
}

/// Rounds a literal to an [`Angle`] at compile time, for [`deg!`](crate::deg).
///
/// # Panics
///
/// At compile time, if the literal is infinite or not a number.
#[doc(hidden)]
#[must_use]
pub const fn literal_degrees(value: f64) -> Angle {
    match Angle::try_from_degrees(value) {
        Ok(angle) => angle,
        Err(_) => panic!("angle is not a finite number of degrees"),
    }
}

/// A [`Scalar`](crate::Scalar) from a literal, rounded to nearest at compile time.
///
/// `fx!(const …)` takes a constant expression of any primitive number. A value out of range does
/// not compile. For a value known at run time, call [`num::scalar`](crate::num::scalar).
///
/// ```
/// use fixel::fx;
/// const WIDTH: u32 = 320;
/// assert_eq!(fx!(0.25) + fx!(2), fx!(2.25));
/// assert_eq!(fx!(const WIDTH / 2), fx!(160));
/// ```
/// ```compile_fail
/// let _ = fixel::fx!(40000);
/// ```
/// ```compile_fail
/// let x = 0.5;
/// let _ = fixel::fx!(-x); // error: fx! takes a literal, such as fx!(0.5); …
/// ```
#[macro_export]
macro_rules! fx {
    (const $value:expr) => {
        const {
            #[allow(clippy::cast_lossless, clippy::unnecessary_cast)]
            $crate::num::literal($value as f64)
        }
    };
    (@ $value:literal) => {
        $crate::fx!(const $value)
    };
    // An expression first: `literal` alone would take the minus of `-x`, and then stop at x with a message of its own.
    ($value:expr) => {
        $crate::fx!(@ $value)
    };
    ($($other:tt)*) => {
        ::core::compile_error!(
            "fx! takes a literal, such as fx!(0.5); write fx!(const X) for a constant, and \
             num::scalar(x)? for a float known at run time"
        )
    };
}

/// An [`Angle`](crate::Angle) from a literal in degrees, rounded to the nearest unit at compile time.
///
/// Whole turns drop out. `deg!(const …)` takes a constant expression of any primitive number. A value
/// that is infinite or not a number does not compile. For a value known at run time, call
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
/// let _ = fixel::deg!(-x); // error: deg! takes a literal, such as deg!(62.5); …
/// ```
#[macro_export]
macro_rules! deg {
    (const $value:expr) => {
        const {
            #[allow(clippy::cast_lossless, clippy::unnecessary_cast)]
            $crate::num::literal_degrees($value as f64)
        }
    };
    (@ $value:literal) => {
        $crate::deg!(const $value)
    };
    // An expression first: `literal` alone would take the minus of `-x`, and then stop at x with a message of its own.
    ($value:expr) => {
        $crate::deg!(@ $value)
    };
    ($($other:tt)*) => {
        ::core::compile_error!(
            "deg! takes a literal, such as deg!(62.5); write deg!(const X) for a constant, and \
             Angle::try_from_degrees(x)? for a float known at run time"
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
