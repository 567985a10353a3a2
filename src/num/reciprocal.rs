//! The reciprocal by which attributes are multiplied, in place of a division by 1/w.

use crate::num::wide::{DIVIDES, IS_WIDE, product, unsigned_product};

/// Returns ⌊(2⁶¹ − 1) / q⌋ for a `q` from 2³⁰ to 2³¹ − 1; the result has the same range.
///
/// The result is exact in every bit and the same on every target. A core with a 64-bit divider divides. Other cores
/// take the first 17 bits from a 32-bit divider or, without one, from a table of 32 bytes and two short Newton steps;
/// one more Newton step doubles the number of correct bits, and the remainder corrects the last bit. For any other `q`
/// the result has no meaning, but there is no panic.
#[inline]
pub(crate) const fn reciprocal(q: u32) -> u32 {
    if IS_WIDE {
        by_division(q)
    } else if DIVIDES {
        by_newton(q, divided_seed(q))
    } else {
        by_newton(q, seed(q))
    }
}

/// The top bit of every `q`. Setting it again tells the compiler that `q` is not zero.
const TOP: u32 = 1 << 30;

#[inline]
const fn by_division(q: u32) -> u32 {
    (((1 << 61) - 1) / (q | TOP) as u64) as u32
}

/// Rounds q to 16 bits. The relative error is at most 2^-17; it is greatest for the smallest q.
#[inline]
const fn coarse(q: u32) -> u32 {
    (q >> 15 & 0xffff | 1 << 15) + (q >> 14 & 1)
}

/// Returns 2^48 / q to 17 or 18 bits, by a division.
#[inline]
const fn divided_seed(q: u32) -> u32 {
    // The quotient leaves an interval of 17 bits, and the lowest bit takes the middle of this interval. The relative
    // error is 2^-18 for the smallest q, 2^-17 for the largest.
    ((u32::MAX / coarse(q)) << 1) | 1
}

/// 2^8 / c, rounded to nearest, for the middle c of each of the 32 equal intervals from 1 to 2.
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

/// Returns 2^48 / q to 17 or 18 bits, without a division and in products of 32 bits.
#[inline]
const fn seed(q: u32) -> u32 {
    let coarse = coarse(q);
    let seed = SEEDS[(q >> 25 & 31) as usize] as u32;
    // The table's relative error is at most 2^-5.8. This step squares the error to 2^-11.6, in 16 bits.
    let lacks = (1 << 23) - (coarse * seed).cast_signed();
    let seed = (seed * ((1 << 23) + lacks).cast_unsigned()) >> 15;
    // This step squares the error to 2^-23, far below a unit.
    let lacks = (1_u32 << 31).wrapping_sub(coarse * seed).cast_signed();
    // The correction is rounded down, so the result stays below 2^18.
    let more = (seed.cast_signed() * (lacks >> 5)) >> 24;
    (seed << 2).wrapping_add_signed(more)
}

#[inline]
const fn by_newton(q: u32, seed: u32) -> u32 {
    // With q's rounding, the seed's relative error is below 1.25 * 2^-16. A Newton step squares this error: the result
    // is too small by less than 0.8 units, and never too large. seed * q is within 2^33 of 2^48, so the lowest 34 bits
    // of the product determine the residual. The product's halves are shifted separately, because a shift of both takes
    // one more instruction.
    let upper = (unsigned_product(seed, q) >> 32) as u32;
    let residual = !(upper << 30 | seed.wrapping_mul(q) >> 2);
    let seed = (seed << 13).cast_signed();
    // The sum wraps only for a `q` out of range.
    let r = seed.wrapping_add((product(seed, residual.cast_signed()) >> 46) as i32);
    let r = r.cast_unsigned();
    // Because r was rounded down, it is exact or one too small. The remainder is below 2q < 2^32, so 32 bits hold it.
    let remainder = !r.wrapping_mul(q);
    r.wrapping_add((remainder >= q) as u32)
}

/// Returns ⌊2³¹ / d⌋ for a `d` of 15 or 16 bits.
#[inline]
pub(crate) const fn short_reciprocal(d: u32) -> u32 {
    if DIVIDES {
        // The lower bound tells the compiler that the divisor is not zero.
        (1 << 31) / if d < 1 << 14 { 1 << 14 } else { d }
    } else {
        short_by_table(d)
    }
}

#[inline]
const fn short_by_table(d: u32) -> u32 {
    // The seed uses all bits of d. So the seed is exact or one unit too small, and so is r.
    let up = d >> 15 & 1 ^ 1;
    let r = seed(d << 15 << up) >> (2 - up);
    r + ((1_u32 << 31).wrapping_sub(r.wrapping_mul(d)) >= d) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_path_meets_the_specification() {
        // The step is a prime, so that every residue of the seed occurs. Both ends are tested value by value.
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

    /// This test runs in a debug build, which checks for overflow.
    #[test]
    fn a_number_out_of_range_does_not_panic() {
        let ends = (0..32).flat_map(|bit| [(1 << bit) - 1, 1 << bit, (1 << bit) + 1]);
        for q in ends.chain((0..=u32::MAX).step_by(0xf_4241)) {
            let _ = [by_division(q), by_newton(q, seed(q))];
            let _ = by_newton(q, divided_seed(q));
        }
    }

    #[test]
    fn short_reciprocals_are_exact() {
        for d in 1 << 14..1 << 16 {
            let exact = (1 << 31) / d;
            assert_eq!([short_by_table(d), short_reciprocal(d)], [exact; 2], "{d}");
        }
        // Smaller numbers count as the smallest allowed number, because no division by zero may occur.
        for d in [0, 1, (1 << 14) - 1] {
            assert_eq!(short_reciprocal(d), 1 << 17, "{d}");
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
