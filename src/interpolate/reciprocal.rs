//! The reciprocal that every division by depth goes through.

use crate::linear::{product, upper};

/// ⌊(2⁶¹ − 1) / q⌋, for a `q` of 31 bits: from 2³⁰ to 2³¹ − 1, as is the result.
///
/// Exact in every bit and the same on every target: a core with a 64-bit divider divides, others
/// take 17 bits from a 32-bit divider, double them in one Newton step and correct the last one
/// from the remainder.
///
/// ```
/// use fixel::interpolate::reciprocal;
/// assert_eq!(reciprocal(3 << 29), 0x5555_5555); // 2^61 / (3 · 2^29)
/// ```
#[inline]
#[must_use]
pub const fn reciprocal(q: u32) -> u32 {
    if cfg!(target_pointer_width = "64") {
        by_division(q)
    } else {
        by_newton(q)
    }
}

/// The bit that is set in any `q`; to say so again spares a check for division by zero.
const TOP: u32 = 1 << 30;

const fn by_division(q: u32) -> u32 {
    (((1 << 61) - 1) / (q | TOP) as u64) as u32
}

const fn by_newton(q: u32) -> u32 {
    // q to the nearest 16 bits, off by at most 2^-16 of itself where it is least.
    let coarse = (q >> 15 | 1 << 15) + (q >> 14 & 1);
    // 2^33 / coarse, 18 bits, in the middle of 17: off by 2^-18 where coarse is least, by 2^-17
    // where it is greatest.
    let seed = ((u32::MAX / coarse) << 1) | 1;
    // Together less than 1.25 * 2^-16; a Newton step squares that, to less than 0.8 units of the
    // result and never above it. seed * q is 2^48 but for less than 2^33, so modulo 2^34 will do.
    let residual = !(upper(seed, q) << 30 | seed.wrapping_mul(q) >> 2);
    let seed = (seed << 13).cast_signed();
    let r = (seed + (product(seed, residual.cast_signed()) >> 46) as i32).cast_unsigned();
    // Rounded down, r is right or one short. The remainder is then below 2q < 2^32, and need not
    // be known but modulo that.
    let remainder = !r.wrapping_mul(q);
    r + (remainder >= q) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_are_the_specification() {
        // Prime steps meet every residue of the seed; both ends are tried one by one.
        let all = (1 << 30..1 << 31).step_by(1009);
        for q in all
            .chain(1 << 30..(1 << 30) + 200_000)
            .chain((1 << 31) - 200_000..1 << 31)
        {
            let exact = ((1u128 << 61) - 1) / u128::from(q);
            assert_eq!(u128::from(by_division(q)), exact, "{q}");
            assert_eq!(u128::from(by_newton(q)), exact, "{q}");
        }
    }

    #[test]
    #[ignore = "all 2^30 values take half a minute"]
    fn newton_is_exact_for_every_value() {
        for q in 1 << 30..1 << 31 {
            assert_eq!(by_newton(q), by_division(q), "{q}");
        }
    }
}
