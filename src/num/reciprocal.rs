//! The reciprocal that every division by depth goes through.

use crate::num::wide::{IS_NARROW, product, upper};

/// ⌊(2⁶¹ − 1) / q⌋, for a `q` of 31 bits: from 2³⁰ to 2³¹ − 1, as is the result.
///
/// Exact in every bit and the same on every target: a core with a 64-bit divider divides. Others begin with the
/// 17 bits that a 32-bit divider gives, or where there is none a table of 32 bytes and two short Newton steps; one more
/// step doubles these bits, and the remainder corrects the last one. Of any other `q` the result has no meaning.
///
/// ```
/// use fixel::num::reciprocal;
/// assert_eq!(reciprocal(3 << 29), 0x5555_5555); // 2^61 / (3 · 2^29)
/// ```
#[inline]
#[must_use]
pub const fn reciprocal(q: u32) -> u32 {
    if cfg!(target_pointer_width = "64") {
        by_division(q)
    } else if IS_NARROW {
        by_newton(q, seed(q))
    } else {
        by_newton(q, divided_seed(q))
    }
}

/// The bit that is set in any `q`; to say so again spares a check for division by zero.
const TOP: u32 = 1 << 30;

const fn by_division(q: u32) -> u32 {
    (((1 << 61) - 1) / (q | TOP) as u64) as u32
}

/// q to the nearest 16 bits, off by at most 2^-17 of itself where it is least.
const fn coarse(q: u32) -> u32 {
    (q >> 15 & 0xffff | 1 << 15) + (q >> 14 & 1)
}

/// 2^48 / q to 17 or 18 bits, by a division.
const fn divided_seed(q: u32) -> u32 {
    // In the middle of 17 bits: off by 2^-18 where q is least, by 2^-17 where it is greatest.
    ((u32::MAX / coarse(q)) << 1) | 1
}

/// 2^8 / c in the middle of each 32nd of c from 1 to 2, to the nearest.
const SEEDS: [u8; 32] = {
    let mut seeds = [0; 32];
    let mut i = 0;
    while i < 32 {
        let twice_middle = 65 + 2 * i;
        seeds[i] = ((512 * 32 + twice_middle / 2) / twice_middle) as u8;
        i += 1;
    }
    seeds
};

/// 2^48 / q to 17 or 18 bits, without a division and in products of 32 bits.
const fn seed(q: u32) -> u32 {
    let coarse = coarse(q);
    let seed = SEEDS[(q >> 25 & 31) as usize] as u32;
    // Off by up to 2^-5.8; squared that is 2^-11.6, in 16 bits.
    let lacks = (1 << 23) - (coarse * seed).cast_signed();
    let seed = (seed * ((1 << 23) + lacks).cast_unsigned()) >> 15;
    // Squared once more 2^-23, far below a unit.
    let lacks = (1_u32 << 31).wrapping_sub(coarse * seed).cast_signed();
    // Rounded down, so that it stays below 2^18.
    let more = (seed.cast_signed() * (lacks >> 5)) >> 24;
    (seed << 2).wrapping_add_signed(more)
}

const fn by_newton(q: u32, seed: u32) -> u32 {
    // Together with q's rounding off by less than 1.25 * 2^-16; a Newton step squares that, to less than 0.8 units of the
    // result and never above it. seed * q is 2^48 but for less than 2^33, so modulo 2^34 will do.
    let residual = !(upper(seed, q) << 30 | seed.wrapping_mul(q) >> 2);
    let seed = (seed << 13).cast_signed();
    // No sum wraps, but of a `q` that is out of range.
    let r = seed.wrapping_add((product(seed, residual.cast_signed()) >> 46) as i32);
    let r = r.cast_unsigned();
    // Rounded down, r is right or one short. The remainder is then below 2q < 2^32, and need not
    // be known but modulo that.
    let remainder = !r.wrapping_mul(q);
    r.wrapping_add((remainder >= q) as u32)
}

/// ⌊2³¹ / d⌋, for a `d` of 15 or 16 bits.
#[inline]
pub(crate) const fn short_reciprocal(d: u32) -> u32 {
    if IS_NARROW {
        short_by_table(d)
    } else {
        // Said so, that no division by zero need be looked out for.
        (1 << 31) / if d < 1 << 14 { 1 << 14 } else { d }
    }
}

const fn short_by_table(d: u32) -> u32 {
    // A seed is right to a unit and never above, as all bits of d are in it; r is then right or one short.
    let up = d >> 15 & 1 ^ 1;
    let r = seed(d << 15 << up) >> (2 - up);
    r + ((1_u32 << 31).wrapping_sub(r.wrapping_mul(d)) >= d) as u32
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
            assert_eq!(u128::from(by_newton(q, divided_seed(q))), exact, "{q}");
            assert_eq!(u128::from(by_newton(q, seed(q))), exact, "{q}");
        }
    }

    /// On every target, with the checks for overflow that a build for development has.
    #[test]
    fn a_number_out_of_range_is_survived() {
        let ends = (0..32).flat_map(|bit| [(1 << bit) - 1, 1 << bit, (1 << bit) + 1]);
        for q in ends.chain((0..=u32::MAX).step_by(0xf_4241)) {
            let _ = [by_division(q), by_newton(q, seed(q))];
            let _ = by_newton(q, divided_seed(q));
        }
    }

    #[test]
    fn short_ones_are_right() {
        for d in 1 << 14..1 << 16 {
            let exact = (1 << 31) / d;
            assert_eq!([short_by_table(d), short_reciprocal(d)], [exact; 2], "{d}");
        }
    }

    #[test]
    #[ignore = "all 2^30 values take a minute"]
    fn newton_is_exact_for_every_value() {
        for q in 1 << 30..1 << 31 {
            let exact = by_division(q);
            assert_eq!(by_newton(q, divided_seed(q)), exact, "{q}");
            assert_eq!(by_newton(q, seed(q)), exact, "{q}");
        }
    }
}
