//! Decimal text to the nearest fixed-point number, exactly and without floats.

use crate::{Scalar, TexCoord};

/// The bits of the nearest number and the text after it, or a message that says why the text is refused.
pub(super) type Decimal<'a> = Result<(i32, &'a [u8]), &'static str>;

pub(super) const MALFORMED: &str = "a number is malformed: it must be like 1, -0.25 or 2.5e-3";

/// A fixed-point format of 32 bits.
#[derive(Clone, Copy)]
pub(super) struct Format {
    /// Fraction bits; 20 at most.
    fraction: u32,
    /// The message for a number outside the format.
    pub(super) range: &'static str,
}

pub(super) const SCALAR: Format = Format {
    fraction: Scalar::FRAC_NBITS,
    range: "a number is out of range: it must lie between -32768 and 32767.99999",
};

/// The bounds hold for 1 − v, too, which is what the mesh stores.
pub(super) const TEX_COORD: Format = Format {
    fraction: TexCoord::FRAC_NBITS,
    range: "a texture coordinate is out of range: u, v and 1 - v must lie between -2048 and 2047.99999",
};

/// Fraction bits that are computed before rounding: the 20 of the finest format, and one more for its halves.
const BITS: u32 = 21;

/// Decimal places that are read. A multiple of 2⁻²¹ has at most 21 places, so later ones cannot take a number across
/// such a multiple. They are dropped, because halves round away from zero. The 21 digits do not fit into 64 bits, so
/// they are kept as two integers.
const PLACES: usize = HIGH + LOW;
const HIGH: usize = 17;
const LOW: usize = 4;

/// 10^17 / 2^17.
const HIGH_FIVES: u64 = 5_u64.pow(17);

/// 10^21 / 2^21.
const FIVES: u64 = 5_u64.pow(21);

/// Greater than any magnitude in range: the whole part stops growing here.
const LARGE: u64 = 1 << 16;

const POWERS: [u64; HIGH + 1] = {
    let mut powers = [1; HIGH + 1];
    let mut i = 1;
    while i <= HIGH {
        powers[i] = powers[i - 1] * 10;
        i += 1;
    }
    powers
};

/// Reads digits, if there are any. Yields their value, which is `$limit` or any greater number if it is not below that,
/// and the text after them. A macro, because a compile-time call takes as long as a dozen operations.
macro_rules! digits {
    ($text:expr, $limit:expr) => {{
        let (mut text, mut value): (&[u8], u64) = ($text, 0);
        while let [digit @ b'0'..=b'9', rest @ ..] = text {
            if value < $limit {
                value = value * 10 + (*digit - b'0') as u64;
            }
            text = rest;
        }
        (value, text)
    }};
}
pub(super) use digits;

/// A fraction given by its first 17 decimal places and the next 4, in units of 2⁻²¹, rounded down.
const fn bits(high: u64, low: u64) -> u64 {
    // 10⁻¹⁷ = 2⁻¹⁷ / 5¹⁷, so `high` has `whole` units of 2⁻¹⁷ and a remainder `rest`. In units of 2⁻²¹, the remainder
    // is rest · 2⁴ / 5¹⁷ = rest · 10⁴ / 5²¹, and `low` is low · 2²¹ / 10²¹ = low / 5²¹.
    let (whole, rest) = (high / HIGH_FIVES, high % HIGH_FIVES);
    (whole << (BITS - 17)) + (rest * POWERS[LOW] + low) / FIVES
}

/// Reads the number that a text begins with: sign, digits with or without a point, exponent. Halves round away from
/// zero.
pub(super) const fn decimal(text: &[u8], format: Format) -> Decimal<'_> {
    let (negative, start) = sign(text);
    if !matches!(start, [b'0'..=b'9', ..] | [b'.', b'0'..=b'9', ..]) {
        return Err(MALFORMED);
    }
    let (mut whole, mut text) = digits!(start, LARGE);
    let (mut high, mut low, mut places) = (0, 0, 0);
    if let [b'.', rest @ ..] = text {
        text = rest;
        while let [digit @ b'0'..=b'9', rest @ ..] = text {
            if places < HIGH {
                high = high * 10 + (*digit - b'0') as u64;
            } else if places < PLACES {
                low = low * 10 + (*digit - b'0') as u64;
            }
            places += 1;
            text = rest;
        }
    }
    if let [b'e' | b'E', exponent @ ..] = text {
        let (negative, exponent) = sign(exponent);
        if !matches!(exponent, [b'0'..=b'9', ..]) {
            return Err(MALFORMED);
        }
        let power;
        // No text has this many digits, so a greater value does not matter.
        (power, text) = digits!(exponent, 1 << 40);
        let power = power.cast_signed();
        (whole, high, low) = shifted(start, if negative { -power } else { power });
    } else if places < HIGH {
        high *= POWERS[HIGH - places];
    } else if places < PLACES {
        low *= POWERS[PLACES - places];
    }
    // In half units, then rounded to whole units.
    let halves = bits(high, low) >> (BITS - 1 - format.fraction);
    let magnitude = (whole << format.fraction) + ((halves + 1) >> 1);
    let limit = if negative { 1 << 31 } else { (1 << 31) - 1 };
    if whole >= LARGE || magnitude > limit {
        return Err(format.range);
    }
    #[allow(clippy::cast_possible_wrap)] // at most 2^31
    let bits = if negative {
        -(magnitude as i64) as i32
    } else {
        magnitude as i32
    };
    Ok((bits, text))
}

/// Whether a number is negative, and its text after the sign.
const fn sign(text: &[u8]) -> (bool, &[u8]) {
    match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] | rest => (false, rest),
    }
}

/// Moves the point of the number that a text begins with by `exponent` digits to the right. Returns the whole part, the
/// first 17 decimal places and the next 4.
const fn shifted(mut text: &[u8], exponent: i64) -> (u64, u64, u64) {
    let (mut whole, mut high, mut low) = (0, 0, 0);
    // The digits up to the point, once it is moved.
    let mut left = exponent;
    let mut digits = text;
    while let [b'0'..=b'9', rest @ ..] = digits {
        left += 1;
        digits = rest;
    }
    while let [c @ (b'0'..=b'9' | b'.'), rest @ ..] = text {
        text = rest;
        if *c == b'.' {
            continue;
        }
        let digit = (*c - b'0') as u64;
        if left > 0 {
            if whole < LARGE {
                whole = whole * 10 + digit;
            }
        } else {
            // `usize` may be too small for the place of a digit.
            let place = left.unsigned_abs();
            if place < HIGH as u64 {
                high += digit * POWERS[HIGH - 1 - place as usize];
            } else if place < PLACES as u64 {
                low += digit * POWERS[PLACES - 1 - place as usize];
            }
        }
        left -= 1;
    }
    while left > 0 && whole > 0 && whole < LARGE {
        whole *= 10;
        left -= 1;
    }
    (whole, high, low)
}

// The compiler checks this for each target, because `usize` has 64 bits where the tests run.
const _: () = assert!(matches!(decimal(b"1e-4294967297", SCALAR), Ok((0, _))));
