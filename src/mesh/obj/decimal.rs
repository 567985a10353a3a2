//! Decimal numbers to the nearest in fixed point, exactly and without floats.

use crate::{Scalar, TexCoord};

/// The bits of the nearest number and the place after it in the text.
pub(super) type Decimal = Result<(i32, usize), &'static str>;

pub(super) const MALFORMED: &str = "a number is malformed: it must be like 1, -0.25 or 2.5e-3";

/// A format of 32 bits.
#[derive(Clone, Copy)]
pub(super) struct Format {
    /// Fraction bits; 20 at most.
    fraction: u32,
    /// What to say of a number beyond its ends.
    pub(super) range: &'static str,
}

pub(super) const SCALAR: Format = Format {
    fraction: Scalar::FRAC_NBITS,
    range: "a number is out of range: it must lie between -32768 and 32767.99999",
};

/// For v there must be 1 − v, too.
pub(super) const TEX_COORD: Format = Format {
    fraction: TexCoord::FRAC_NBITS,
    range: "a texture coordinate is out of range: u, v and 1 - v must lie between -2048 and 2047.99999",
};

/// Fraction bits that decide: half a unit of the finest format.
const BITS: u32 = 21;

/// Decimal places that decide: as many as the last of those bits has. Places beyond may be dropped,
/// as halves are rounded up in magnitude. They are in two numbers, as 64 bits cannot hold them all.
const PLACES: usize = HIGH + LOW;
const HIGH: usize = 17;
const LOW: usize = 4;

/// 10^17 / 2^17.
const HIGH_FIVES: u64 = 5_u64.pow(17);

/// 10^21 / 2^21.
const FIVES: u64 = 5_u64.pow(21);

/// Greater than any magnitude in range, so large enough to stop at.
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

/// The byte at a place; a line's end after the text.
///
/// A macro, as a compiler that runs this takes as long for a call as for a dozen operations.
macro_rules! byte {
    ($text:expr, $at:expr) => {
        if $at < $text.len() { $text[$at] } else { b'\n' }
    };
}
pub(super) use byte;

/// A fraction of 21 decimal places, the first 17 and the last 4, in units of 2⁻²¹, rounded down.
const fn bits(high: u64, low: u64) -> u64 {
    // 10^-17 = 2^-17 / 5^17; of the rest, 2^4 · 10^-4 / 5^17 = 1 / 5^21.
    let (whole, rest) = (high / HIGH_FIVES, high % HIGH_FIVES);
    (whole << (BITS - 17)) + (rest * POWERS[LOW] + low) / FIVES
}

/// Reads the number that starts at `at`: sign, digits with or without a point, exponent.
/// Halves round away from zero.
pub(super) const fn decimal(text: &[u8], mut at: usize, format: Format) -> Decimal {
    let first = byte!(text, at);
    let negative = first == b'-';
    if negative || first == b'+' {
        at += 1;
    }
    let start = at;
    let mut whole = 0;
    while at < text.len() {
        let c = text[at];
        if c < b'0' || c > b'9' {
            break;
        }
        if whole < LARGE {
            whole = whole * 10 + (c - b'0') as u64;
        }
        at += 1;
    }
    let point = at - start;
    let mut places = 0;
    let (mut high, mut low) = (0, 0);
    if byte!(text, at) == b'.' {
        at += 1;
        while at < text.len() {
            let c = text[at];
            if c < b'0' || c > b'9' {
                break;
            }
            if places < HIGH {
                high = high * 10 + (c - b'0') as u64;
            } else if places < PLACES {
                low = low * 10 + (c - b'0') as u64;
            }
            places += 1;
            at += 1;
        }
    }
    if point + places == 0 {
        return Err(MALFORMED);
    }
    if let b'e' | b'E' = byte!(text, at) {
        let end = at;
        let exponent;
        match power(text, at + 1) {
            Ok(power) => (exponent, at) = power,
            Err(problem) => return Err(problem),
        }
        #[allow(clippy::cast_possible_wrap)] // no text is as long
        let point = point as i64;
        (whole, high, low) = shifted(text, start, end, point + exponent);
    } else if places < HIGH {
        high *= POWERS[HIGH - places];
    } else if places < PLACES {
        low *= POWERS[PLACES - places];
    }
    // In half units, then rounded to whole ones.
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
    Ok((bits, at))
}

/// Reads an exponent, saturated, and the place after it.
const fn power(text: &[u8], mut at: usize) -> Result<(i64, usize), &'static str> {
    let negative = byte!(text, at) == b'-';
    if negative || byte!(text, at) == b'+' {
        at += 1;
    }
    let start = at;
    let mut power = 0;
    while byte!(text, at).is_ascii_digit() {
        // Beyond a text's possible number of digits, it may be anything.
        if power < 1 << 40 {
            power = power * 10 + (byte!(text, at) - b'0') as i64;
        }
        at += 1;
    }
    if at == start {
        return Err(MALFORMED);
    }
    Ok((if negative { -power } else { power }, at))
}

/// Whole part, 17 decimal places and 4 more of the digits from `start` to `end` with the point moved
/// to `point` digits after the first.
const fn shifted(text: &[u8], start: usize, end: usize, point: i64) -> (u64, u64, u64) {
    let (mut whole, mut high, mut low) = (0, 0, 0);
    let mut left = point;
    let mut at = start;
    while at < end {
        let c = byte!(text, at);
        at += 1;
        if c == b'.' {
            continue;
        }
        let digit = (c - b'0') as u64;
        if left > 0 {
            if whole < LARGE {
                whole = whole * 10 + digit;
            }
        } else {
            let place = left.unsigned_abs() as usize;
            if place < HIGH {
                high += digit * POWERS[HIGH - 1 - place];
            } else if place < PLACES {
                low += digit * POWERS[PLACES - 1 - place];
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
