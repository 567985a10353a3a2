//! Decimal numbers to the nearest `Scalar`, exactly and without floats.

/// The bits of the nearest `Scalar` and the place after the number.
pub(super) type Decimal = Result<(i32, usize), &'static str>;

pub(super) const MALFORMED: &str = "a number is malformed: it must be like 1, -0.25 or 2.5e-3";
pub(super) const RANGE: &str =
    "a number is out of range: it must lie between -32768 and 32767.99999";

/// Decimal places that decide: 2⁻¹⁷, half a unit, has as many. Places beyond may be dropped,
/// as halves are rounded up in magnitude.
const PLACES: usize = 17;

/// The last of them, as a power of ten.
const LAST: i64 = -17;

/// 10^17 / 2^17.
const FIVES: u64 = 762_939_453_125;

/// Greater than any magnitude in range, so large enough to stop at.
const LARGE: u64 = 1 << 16;

const POWERS: [u64; PLACES + 1] = {
    let mut powers = [1; PLACES + 1];
    let mut i = 1;
    while i <= PLACES {
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

/// Reads the number that starts at `at`: sign, digits with or without a point, exponent.
/// Halves round away from zero.
pub(super) const fn decimal(text: &[u8], mut at: usize) -> Decimal {
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
    let mut fraction = 0;
    if byte!(text, at) == b'.' {
        at += 1;
        while at < text.len() {
            let c = text[at];
            if c < b'0' || c > b'9' {
                break;
            }
            if places < PLACES {
                fraction = fraction * 10 + (c - b'0') as u64;
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
        (whole, fraction) = shifted(text, start, end, point + exponent);
    } else if places < PLACES {
        fraction *= POWERS[PLACES - places];
    }
    // fraction / 10^17 · 2^17, then rounded to 2^16.
    let magnitude = (whole << 16) + ((fraction / FIVES + 1) >> 1);
    let limit = if negative { 1 << 31 } else { (1 << 31) - 1 };
    if whole >= LARGE || magnitude > limit {
        return Err(RANGE);
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

/// Whole part and 17 decimal places of the digits from `start` to `end` with the point moved to
/// `point` digits after the first.
const fn shifted(text: &[u8], start: usize, end: usize, point: i64) -> (u64, u64) {
    let (mut whole, mut fraction) = (0, 0);
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
        } else if left > LAST {
            #[allow(clippy::cast_sign_loss)] // 0..17
            {
                fraction += digit * POWERS[PLACES - 1 - (-left) as usize];
            }
        }
        left -= 1;
    }
    while left > 0 && whole > 0 && whole < LARGE {
        whole *= 10;
        left -= 1;
    }
    (whole, fraction)
}
