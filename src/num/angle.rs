//! Angles as fractions of a turn, and their sines.

use core::fmt;
use core::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::error::Error;
use crate::message::{Message, Piece};
use crate::num::convert::HALF;
use crate::num::number::operators;
use crate::num::rsqrt as unit;
use crate::num::wide::product;
use crate::num::{Fraction, Scalar};

mod floats;
use floats::{Real, Unit};

/// An angle in units of 2⁻³² of a turn: 8.4e-8 degrees, 1.5e-9 radians.
///
/// Arithmetic wraps at a whole turn: −90° and 270° are the same angle. [`deg!`](crate::deg) makes an angle from a
/// literal in degrees.
///
/// In a product with a [`Scalar`] or a [`Fraction`], the angle counts as a value from 0° to below 360°, so a gauge can
/// sweep more than half a turn. The product is rounded to the nearest unit, halves up, and whole turns are dropped:
///
/// ```
/// use fixel::prelude::*;
/// // The needle turns clockwise by up to 270 degrees.
/// let needle = |value: Scalar| deg!(225) - deg!(270) * value;
/// assert_eq!(needle(fx!(0.5)), deg!(90));
/// assert_eq!(needle(fx!(1)), deg!(-45));
/// ```
///
/// So half of −90° is half of 270°: 135°. For a clockwise sweep, subtract the product from the start (as above), or
/// multiply the angle by a negative number. A sweep of a whole turn is `Angle::from_turns(value)`, because `deg!(360)`
/// is 0.
///
/// ```
/// use fixel::prelude::*;
/// use fixel::Fraction;
/// const QUARTER: Angle = deg!(90);
/// assert_eq!(QUARTER, Angle::from_turns(fx!(0.25)));
/// assert_eq!(QUARTER * 3, -QUARTER);
/// assert_eq!(QUARTER.sin_cos(), (Fraction::ONE, Fraction::ZERO));
/// assert_eq!(Angle::try_from_degrees(62.5)?, deg!(62.5));
/// assert_eq!(deg!(62.5).to_string(), "62.5 degrees");
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Angle(u32);

/// The number of units in a turn.
const TURN: f64 = 4_294_967_296.0;

/// Coefficients of sin(πx/2) / x in powers of x² over \[−1, 1\], lowest first, with their fraction
/// bits.
///
/// Each coefficient has 31 significant bits, so its rounding adds nothing to the error. The polynomial is minimax under
/// the condition that the coefficients sum to 1 (Remez exchange), with a relative error of 2.4e-11.
const SINE: [(i32, u32); 6] = [
    (1_686_629_713, 30),
    (-1_387_197_331, 31),
    (1_369_108_436, 34),
    (-643_440_516, 37),
    (704_746_150, 42),
    (-60_272_190, 44),
];

/// Coefficients of (f(u) − f(0)) / u in powers of u, lowest first, with their fraction bits.
///
/// At (x, y) on the unit circle, in the first quadrant, the angle is an eighth of a turn plus (y − x) · f(√2 − x − y)
/// units. From the diagonal to an axis, u = √2 − x − y grows from 0 to √2 − 1. f(0) is [`SLOPE`]. The polynomial equals
/// f at seven points, with both ends of this range among them. Elsewhere, the angle has an error of at most 0.08 units.
const ARC: [(i32, u32); 6] = [
    (911_420_325, 3),
    (1_031_164_240, 5),
    (1_249_285_350, 7),
    (1_590_552_319, 9),
    (875_007_132, 10),
    (1_095_399_711, 11),
];

/// f(0) of [`ARC`], in units of 2^-2.
const SLOPE: i32 = 1_933_414_567;

/// Returns the value of a polynomial at `x` / 2^30, which is from 0 to 1. The value has the fraction bits of the lowest
/// coefficient.
#[allow(clippy::inline_always)] // a call would make every sine slower
#[inline(always)]
const fn polynomial(coefficients: &[(i32, u32)], x: i32) -> i32 {
    let mut i = coefficients.len() - 1;
    let (mut sum, mut bits) = coefficients[i];
    while i > 0 {
        i -= 1;
        let (next, next_bits) = coefficients[i];
        // Coefficients have 31 bits, and x has at most 30. The bits that are dropped here are worth less than the half
        // that is added below.
        let more = (product(sum, x) >> 30) as i32;
        sum = next + (((more >> (bits - next_bits - 1)) + 1) >> 1);
        bits = next_bits;
    }
    sum
}

/// `units` · `factor` / 2^`fraction`, rounded to nearest (half up). Whole turns are dropped.
///
/// The magnitude of `units` must be below 2^32.
const fn times(units: i64, factor: i32, fraction: u32) -> u32 {
    // The product and a half are less than 2^63.
    let product = (units * factor as i64 + (1 << fraction >> 1)) >> fraction;
    product.cast_unsigned() as u32
}

impl Angle {
    /// Zero degrees.
    pub const ZERO: Self = Self(0);
    /// A quarter of a turn, 90 degrees.
    pub const QUARTER: Self = Self(1 << 30);
    /// Half a turn, 180 degrees.
    pub const HALF: Self = Self(1 << 31);

    /// Makes an angle from its bits, in units of 2⁻³² of a turn.
    #[must_use]
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// Returns the bits, in units of 2⁻³² of a turn.
    #[must_use]
    pub const fn to_bits(self) -> u32 {
        self.0
    }

    /// Makes an angle from whole degrees, rounded to the nearest unit; multiples of 45° are exact.
    ///
    /// For a fraction of a degree write [`deg!`](crate::deg) or call
    /// [`try_from_degrees`](Self::try_from_degrees).
    #[must_use]
    pub const fn from_degrees(degrees: i32) -> Self {
        let degrees = degrees.rem_euclid(360) as u64;
        // The quotient is below one turn, 2^32.
        Self((((degrees << 32) + 180) / 360) as u32)
    }

    /// Returns degrees in units of 1/10000, rounded to nearest.
    pub(crate) const fn ten_thousandths(self) -> i64 {
        (self.0 as i64 * 3_600_000 + (1 << 31)) >> 32
    }

    /// Makes an angle from turns; exact. Whole turns are dropped.
    #[must_use]
    pub const fn from_turns(turns: Scalar) -> Self {
        #[allow(clippy::cast_sign_loss)] // whole turns drop out
        Self((turns.to_bits() as u32) << 16)
    }

    /// Interpolates along the shorter way: the result is `self` at `t` = 0 and `other` at `t` = 1. If `t` is below 0 or
    /// above 1, the result is extrapolated.
    ///
    /// The result is rounded to the nearest unit, halves up. Between opposite angles, the interpolation turns
    /// clockwise. To turn from `a` to `b` counter-clockwise, even if this way is longer, write `a + (b - a) * t`; to
    /// turn clockwise, write `a - (a - b) * t`.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let (a, b) = (deg!(315), deg!(45));
    /// assert_eq!(a.lerp(b, fx!(0.5)), deg!(0));
    /// assert_eq!(a - (a - b) * fx!(0.5), deg!(180));
    /// ```
    #[must_use]
    pub const fn lerp(self, other: Self, t: Scalar) -> Self {
        let way = other.0.wrapping_sub(self.0).cast_signed();
        let part = times(way as i64, t.to_bits(), Scalar::FRAC_BITS);
        Self(self.0.wrapping_add(part))
    }

    /// Makes an angle from radians, accurate to one unit. Whole turns are dropped.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let one = Angle::from_radians(fx!(1));
    /// assert_eq!(one.to_string(), "57.2958 degrees");
    /// ```
    #[must_use]
    pub const fn from_radians(radians: Scalar) -> Self {
        // A unit of a `Scalar` is 2^16 / 2π units of an angle. These constants are the whole part of this factor, and
        // its fraction in units of 2^-32.
        const WHOLE: i64 = 10_430;
        const FRACTION: i64 = 1_625_002_897;
        let bits = radians.to_bits() as i64;
        let units = bits * WHOLE + ((bits * FRACTION + (1 << 31)) >> 32);
        // Whole turns are dropped.
        Self(units.cast_unsigned() as u32)
    }

    /// Makes an angle from a float or an integer in degrees, rounded to the nearest unit, halves away from zero. Whole
    /// turns are dropped.
    ///
    /// The conversion of an `f32` uses integers only: a core without a floating point unit links no float routine for it.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] if `degrees` is infinite or not a number.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let sensor: f32 = 62.5;
    /// assert_eq!(Angle::try_from_degrees(sensor)?, deg!(62.5));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn try_from_degrees(degrees: impl Real) -> Result<Self, Error> {
        degrees.angle(&Unit::DEGREES)
    }

    /// Does the same as [`try_from_degrees`](Self::try_from_degrees), and can also be called in constants.
    #[doc(hidden)]
    pub const fn nearest_degrees(degrees: f64) -> Result<Self, Error> {
        Self::nearest(degrees, Unit::DEGREES.turn)
    }

    /// Makes an angle from a float or an integer in radians, rounded to the nearest unit. Whole turns are dropped.
    ///
    /// The conversion of an `f32` uses integers only, and is accurate to one unit for every float. The conversion of an
    /// `f64` uses the `f64` nearest to 2π in place of 2π, which adds an error of 4e-17 times `radians`. So the angle is
    /// accurate to one unit for up to ten million radians.
    ///
    /// If your own code needs float functions such as `sin` without the standard library, the crate [`micromath`] has
    /// them, with errors of about 1e-3. fixel itself uses only integers.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// use micromath::F32Ext;
    /// // How far a board leans, from the forces along two axes of its accelerometer.
    /// let forces: [f32; 2] = [0.5, 0.866];
    /// let lean = Angle::try_from_radians(F32Ext::atan2(forces[0], forces[1]))?;
    /// assert_eq!(lean.to_string(), "30.1624 degrees"); // exactly: 30.0007
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] if `radians` is infinite or not a number.
    pub fn try_from_radians(radians: impl Real) -> Result<Self, Error> {
        radians.angle(&Unit::RADIANS)
    }

    /// Returns the angle from the x axis to the point (x, y), counter-clockwise; 0 for the origin.
    ///
    /// The error is at most 2.3e-9 radians; multiples of 45° are exact.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// assert_eq!(Angle::atan2(fx!(3), fx!(-3)), Angle::from_degrees(135));
    /// ```
    #[must_use]
    pub fn atan2(y: Scalar, x: Scalar) -> Self {
        Self::atan2_bits(y.to_bits().into(), x.to_bits().into())
    }

    /// Returns [`atan2`](Self::atan2) of integers in any common unit.
    pub(crate) fn atan2_bits(y: i64, x: i64) -> Self {
        /// √2 in units of 2^-30.
        const DIAGONAL: i32 = 1_518_500_250;
        let Some([x, y, _]) = unit::unit([x, y, 0]) else {
            return Self::ZERO;
        };
        let [right, up] = [x.abs(), y.abs()];
        // In radians, near an axis, where the errors are greatest: if the unit vector is too long by 2^-30, the angle
        // changes by 0.57 times as much, 5.3e-10. The rounding of its components, by 2^-31 each, adds 7.3e-10. The
        // polynomial adds 1.2e-10, the rounding of `curve` 0.9e-10, and the rounding to a unit 7.3e-10.
        let [aside, below] = [up - right, DIAGONAL - right - up];
        let curve = (product(polynomial(&ARC, below), below) + (1 << 29)) >> 30;
        let arc = (product(aside, SLOPE) << 1) + product(aside, curve as i32);
        let arc = ((arc + (1 << 32)) >> 33) as i32;
        let first = Self(1 << 29) + Self(arc.cast_unsigned());
        let upper = if x < 0 { Self::HALF - first } else { first };
        if y < 0 { -upper } else { upper }
    }

    /// Returns the sine.
    ///
    /// The error is at most 1.6e-9; 0, 1 and −1 are exact at multiples of 90°, and the sine's symmetries hold to the
    /// last bit. An odd polynomial of degree 11 covers a quarter of a turn. In a picture of 320x240, an error of 1.6e-9
    /// is invisible. The error of `micromath`'s sine, 1.1e-3, would move vertices of the benchmarks' cube by up to 0.35
    /// pixels, and of their sphere by up to 0.26 pixels.
    ///
    /// ```
    /// use fixel::{Angle, Fraction};
    /// assert_eq!(Angle::from_degrees(-90).sin(), -Fraction::ONE);
    /// ```
    #[must_use]
    #[inline(never)]
    pub const fn sin(self) -> Fraction {
        let wide = self.wide_sine();
        // The magnitude is rounded, and not the signed number, so the sine stays symmetric. The magnitude is at most
        // 2^30.
        let sine = ((wide.abs() + (1 << 29)) >> 30) as i32;
        Fraction::from_bits(if wide < 0 { -sine } else { sine })
    }

    /// Returns the sine in units of 2^-60, with a relative error of 2e-9, however small the sine is.
    const fn wide_sine(self) -> i64 {
        /// 2^30: a quarter of a turn, and also the number one.
        const ONE: u32 = 1 << 30;
        #[allow(clippy::cast_possible_wrap)] // to −1/2..1/2 of a turn
        let signed = self.0 as i32;
        let mut x = signed.unsigned_abs();
        if x > ONE {
            // The sine is symmetric about a quarter turn.
            x = 2 * ONE - x;
        }
        let x = x.cast_signed();
        let squared = ((product(x, x) + (1 << 29)) >> 30) as i32;
        let sum = polynomial(&SINE, squared);
        // The product is greatest at a quarter turn: 2^60.
        product(sum, if signed < 0 { -x } else { x })
    }

    /// Returns the sine and the cosine of half this angle, in units of 2^-60.
    ///
    /// Half a unit of an odd angle is dropped: 7e-10 radians.
    pub(crate) const fn half_wide(self) -> (i64, i64) {
        let half = Self(self.0 >> 1);
        (half.wide_sine(), Self(half.0 + (1 << 30)).wide_sine())
    }

    /// Returns the cosine, as accurate as the [sine](Self::sin).
    #[must_use]
    pub const fn cos(self) -> Fraction {
        Self(self.0.wrapping_add(1 << 30)).sin()
    }

    /// Returns the sine and the cosine.
    #[must_use]
    pub const fn sin_cos(self) -> (Fraction, Fraction) {
        (self.sin(), self.cos())
    }
}

impl fmt::Display for Angle {
    /// Writes degrees from 0 to 360, rounded to four decimals.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(Message::new("{} degrees", &[Piece::Degrees(*self)]).text())
    }
}

impl fmt::Debug for Angle {
    /// Writes degrees as `Display` does, and the bits, because neighboring angles can have the same decimals.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self} ({:#010x})", self.0)
    }
}

operators! {
    Add add, AddAssign add_assign: |a: Angle, b: Angle| Self(a.0.wrapping_add(b.0));
    Sub sub, SubAssign sub_assign: |a: Angle, b: Angle| Self(a.0.wrapping_sub(b.0));
    // Whole turns are dropped.
    Mul mul, MulAssign mul_assign: |a: Angle, b: i32| Self(a.0.wrapping_mul(b.cast_unsigned()));
    /// Multiplies an angle from 0 to below 360°; rounds to nearest, halves up. Whole turns are dropped.
    Mul mul, MulAssign mul_assign: |a: Angle, b: Scalar| Self(times(a.0.into(), b.to_bits(), Scalar::FRAC_BITS));
    /// Multiplies an angle from 0 to below 360°; rounds to nearest, halves up. Whole turns are dropped.
    Mul mul, MulAssign mul_assign: |a: Angle, b: Fraction| Self(times(a.0.into(), b.to_bits(), Fraction::FRAC_BITS));
}

operators!(i32 * Angle, Scalar * Angle, Fraction * Angle);

impl Neg for Angle {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.wrapping_neg())
    }
}

#[cfg(test)]
mod tests;
