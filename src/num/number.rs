//! The fixed-point numbers: one rule for all of them, and for the vectors made of them.

use core::fmt;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::block;

/// Implements operators such as `+`, and assignments such as `+=`; or a product in the other order.
macro_rules! operators {
    ($($(#[$about:meta])* $Trait:ident $method:ident, $Assign:ident $assign:ident:
        |$a:ident: $A:ty, $b:ident: $B:ty| $result:expr;)+) => {$(
        impl $Trait<$B> for $A {
            type Output = Self;

            $(#[$about])*
            fn $method(self, $b: $B) -> Self {
                let $a = self;
                $result
            }
        }

        impl $Assign<$B> for $A {
            $(#[$about])*
            fn $assign(&mut self, other: $B) {
                *self = $Trait::$method(*self, other);
            }
        }
    )+};
    ($($Factor:ident * $A:ident),+) => {$(
        impl Mul<$A> for $Factor {
            type Output = $A;

            /// The same as the product in the other order.
            #[inline]
            fn mul(self, value: $A) -> $A {
                value * self
            }
        }
    )+};
}
pub(crate) use operators;

/// `a · b / 2^fraction`, rounded to nearest (half up); saturates.
#[inline]
pub(crate) const fn multiply(a: i32, b: i32, fraction: u32) -> i32 {
    block::saturated((a as i64 * b as i64 + (1 << fraction >> 1)) >> fraction)
}

/// `a · 2^fraction / b`, rounded to nearest (half away from zero); saturates, and 0/0 is 0.
#[inline]
pub(crate) const fn divide(a: i32, b: i32, fraction: u32) -> i32 {
    // The sum is at most 2^31 · 2^30 plus half of a divisor, which fits into 64 bits.
    let (top, bottom) = (a.unsigned_abs() as u64, b.unsigned_abs() as u64);
    let quotient = match ((top << fraction) + bottom / 2).checked_div(bottom) {
        Some(quotient) => quotient.cast_signed(),
        None if top == 0 => 0,
        None => i64::MAX,
    };
    block::saturated(if (a < 0) == (b < 0) {
        quotient
    } else {
        -quotient
    })
}

/// Declares a number of 32 bits.
macro_rules! number {
    ($(#[$about:meta])+ pub struct $Number:ident like $Fixed:ident, $fraction:literal fraction bits) => {
        $(#[$about])+
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $Number(i32);

        impl $Number {
            /// Zero.
            pub const ZERO: Self = Self(0);
            /// One.
            pub const ONE: Self = Self(1 << $fraction);
            /// The smallest number above zero: one unit of [`to_bits`](Self::to_bits).
            pub const DELTA: Self = Self(1);
            /// The largest number.
            pub const MAX: Self = Self(i32::MAX);
            /// The lowest number.
            pub const MIN: Self = Self(i32::MIN);
            /// The number of fraction bits.
            pub const FRAC_BITS: u32 = $fraction;

            #[doc = concat!("Makes a number from its bits, in units of 2^-", $fraction, ".")]
            #[must_use]
            #[inline]
            pub const fn from_bits(bits: i32) -> Self {
                Self(bits)
            }

            #[doc = concat!("Returns the bits, in units of 2^-", $fraction, ".")]
            #[must_use]
            #[inline]
            pub const fn to_bits(self) -> i32 {
                self.0
            }

            #[doc = concat!("Returns the magnitude, which is [`MAX`](Self::MAX) for [`MIN`](Self::MIN).")]
            #[must_use]
            #[inline]
            pub const fn abs(self) -> Self {
                Self(self.0.saturating_abs())
            }

            /// Returns the greatest whole number that is not above this one.
            #[must_use]
            #[inline]
            pub const fn floor(self) -> i32 {
                self.0 >> $fraction
            }

            /// Returns the nearest whole number; halves are rounded up.
            #[must_use]
            #[inline]
            pub const fn round(self) -> i32 {
                (self.0 >> ($fraction - 1)).wrapping_add(1) >> 1
            }
        }

        impl fmt::Display for $Number {
            /// Writes as many decimals as are needed to tell the number from its neighbors, or as many as the format
            /// asks for.
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fixed::types::$Fixed::from(*self).fmt(f)
            }
        }

        impl fmt::Debug for $Number {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }

        // Without this attribute, the compiler's messages would name the parameters of `fixed` in place of a number.
        #[diagnostic::do_not_recommend]
        impl From<fixed::types::$Fixed> for $Number {
            #[inline]
            fn from(number: fixed::types::$Fixed) -> Self {
                Self(number.to_bits())
            }
        }

        impl From<$Number> for fixed::types::$Fixed {
            #[inline]
            fn from(number: $Number) -> Self {
                Self::from_bits(number.0)
            }
        }

        impl Neg for $Number {
            type Output = Self;

            #[inline]
            fn neg(self) -> Self {
                Self(self.0.saturating_neg())
            }
        }

        operators! {
            #[inline]
            Add add, AddAssign add_assign: |a: $Number, b: $Number| Self(a.0.saturating_add(b.0));
            #[inline]
            Sub sub, SubAssign sub_assign: |a: $Number, b: $Number| Self(a.0.saturating_sub(b.0));
            #[inline]
            Mul mul, MulAssign mul_assign: |a: $Number, b: $Number| Self(multiply(a.0, b.0, $fraction));
            #[inline]
            Div div, DivAssign div_assign: |a: $Number, b: $Number| Self(divide(a.0, b.0, $fraction));
            #[inline]
            Mul mul, MulAssign mul_assign: |a: $Number, b: i32| Self(a.0.saturating_mul(b));
            #[inline]
            Div div, DivAssign div_assign: |a: $Number, b: i32| Self(divide(a.0, b, 0));
        }

        operators!(i32 * $Number);

        impl Sum for $Number {
            /// Adds all numbers; each partial sum saturates.
            fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
                numbers.fold(Self::ZERO, Add::add)
            }
        }
    };
}

number! {
    /// Coordinates and distances: signed, 16 integer and 16 fraction bits.
    ///
    /// The range is −32768 to 32768 − 2⁻¹⁶, and the resolution is 2⁻¹⁶ ≈ 1.5e-5. [`fx!`](crate::fx) writes a literal;
    /// `From` and `TryFrom` convert floats and integers at run time. A conversion from or to an `f32` uses integers only,
    /// so a core without a floating point unit links no float routine for it. Operators never panic; [`num`](crate::num)
    /// says how they round and saturate.
    ///
    /// ```
    /// use fixel::{Error, Scalar, fx};
    /// assert_eq!(fx!(1.5).to_bits(), 3 << 15);
    /// assert_eq!(fx!(30000) + fx!(30000), Scalar::MAX);
    /// // Numbers known at run time.
    /// let (sensor, count): (f32, i32) = (0.25, -3);
    /// assert_eq!(Scalar::try_from(sensor)? * count, fx!(-0.75));
    /// assert_eq!(Scalar::try_from(count)?, fx!(-3));
    /// assert_eq!(Scalar::from(200_u8).floor(), 200);
    /// assert_eq!(f64::from(fx!(0.5)), 0.5);
    /// assert_eq!(f32::from(Scalar::MAX), 32_768.0); // a float keeps 24 bits
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// The crate [`fixed`] has a number of the same format, and more functions:
    ///
    /// ```
    /// use fixel::{Scalar, fx};
    /// use fixed::types::I16F16;
    /// assert_eq!(Scalar::from(I16F16::from(fx!(9)).sqrt()), fx!(3));
    /// ```
    ///
    /// A float is not accepted in place of a number, because its conversion may fail:
    ///
    /// ```compile_fail,E0308
    /// use fixel::prelude::*;
    /// let _ = Vec3::new(1.0, fx!(0), fx!(0)); // error: expected `Scalar`, found floating-point number
    /// ```
    /// ```compile_fail,E0277
    /// let _ = fixel::fx!(1) * 2.0; // error: cannot multiply `Scalar` by `{float}`
    /// ```
    pub struct Scalar like I16F16, 16 fraction bits
}

number! {
    /// Texture coordinates in repeats of the texture: signed, 12 integer and 20 fraction bits.
    ///
    /// The range is −2048 to 2048 − 2⁻²⁰, and the resolution is 2⁻²⁰ ≈ 9.5e-7. Rounding to this resolution moves a
    /// texture of 256 texels by at most 1.2e-4 texel; rounding to a [`Scalar`] would move it by up to 2e-3 texel.
    /// [`vec2!`](crate::vec2) writes a pair of literals. `TexCoord` has the same operators and conversions as
    /// [`Scalar`]. `try_from` converts a `Scalar` to a `TexCoord`, and a `TexCoord` can be multiplied or divided by a
    /// `Scalar`.
    ///
    /// ```
    /// use fixel::{Error, TexCoord, Vec2, fx, vec2};
    /// let repeats = TexCoord::try_from(fx!(2.5))?;
    /// assert_eq!(Vec2::new(repeats, repeats * fx!(0.5)), vec2!(2.5, 1.25));
    /// let [u, v]: [f32; 2] = [0.5, 0.25];
    /// assert_eq!(Vec2::new(u.try_into()?, v.try_into()?), vec2!(0.5, 0.25));
    /// let error = TexCoord::try_from(3000_i32).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "3000 cannot be represented: it must lie between -2048 and 2047.99999",
    /// );
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// ```compile_fail,E0308
    /// use fixel::prelude::*;
    /// let _ = Vec2::new(fx!(1), fx!(0)); // error: expected `TexCoord`, found `Scalar`
    /// ```
    pub struct TexCoord like I12F20, 20 fraction bits
}

number! {
    /// Screen coordinates in pixels: signed, 24 integer and 8 fraction bits.
    ///
    /// From the top left corner of the frame, x increases to the right, and y increases downward. The center of a pixel
    /// has the fraction 1/2, so [`floor`](Self::floor) returns the pixel's column or row.
    ///
    /// ```
    /// use fixel::num::Subpixel;
    /// // The center of the second column.
    /// let x = Subpixel::from_bits(384);
    /// assert_eq!((x.to_string().as_str(), x.floor()), ("1.5", 1));
    /// ```
    pub struct Subpixel like I24F8, 8 fraction bits
}

number! {
    /// Sines, cosines, components of unit vectors and parts of a whole: signed, 2 integer and 30 fraction bits.
    ///
    /// The range is from −2 to 2, and results beyond it saturate. A [`Scalar`] times a fraction, in either order, is a
    /// [`Scalar`]. An integer times a fraction is a fraction, so a product above 2 saturates: write
    /// `fx!(3) * angle.sin()`, not `3 * angle.sin()`.
    ///
    /// ```
    /// use fixel::{Fraction, deg, fx};
    /// let half: Fraction = deg!(30).sin();
    /// assert!((half - Fraction::ONE / 2).abs() <= 2 * Fraction::DELTA);
    /// assert_eq!(fx!(3) * half, fx!(1.5));
    /// ```
    pub struct Fraction like I2F30, 30 fraction bits
}

operators! {
    /// Rounds to nearest, halves up.
    #[inline]
    Mul mul, MulAssign mul_assign: |a: Scalar, b: Fraction| Self(multiply(a.0, b.0, Fraction::FRAC_BITS));
    /// Rounds to nearest, halves up, and saturates.
    #[inline]
    Mul mul, MulAssign mul_assign: |a: TexCoord, b: Scalar| Self(multiply(a.0, b.0, Scalar::FRAC_BITS));
    /// Rounds to nearest, halves away from zero, and saturates.
    #[inline]
    Div div, DivAssign div_assign: |a: TexCoord, b: Scalar| Self(divide(a.0, b.0, Scalar::FRAC_BITS));
}

operators!(Scalar * TexCoord, Fraction * Scalar);
