//! The reciprocal that every division by depth goes through.

/// ⌊(2⁶³ − 1) / q⌋ for a `q` whose top bit is set; 32 bits, the top one set.
///
/// Exact in every bit and the same on every target: a core with a 64-bit divider divides, others
/// take 16 bits from a 32-bit divider, one Newton step and a correction from the remainder.
#[inline]
#[must_use]
pub const fn reciprocal(q: u32) -> u32 {
    // Tells the compiler that the divisor is not zero; the caller has normalised it anyway.
    let q = q | TOP;
    if cfg!(target_pointer_width = "64") {
        by_division(q)
    } else {
        by_newton(q)
    }
}

const TOP: u32 = 1 << 31;

const fn by_division(q: u32) -> u32 {
    (((1 << 63) - 1) / (q | TOP) as u64) as u32
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]
const fn by_newton(q: u32) -> u32 {
    // q to the nearest 16 bits, off by at most 2^-16 of itself.
    let coarse = (q >> 16) + (q >> 15 & 1);
    // 2^32 / coarse, 17 bits, in the middle of its last unit: off by another 2^-17 at most.
    let seed = ((u32::MAX / (coarse | 1 << 15)) << 15) + (1 << 14);
    // One step squares the error, to less than 2.3 * 2^-32. `left` stays under 2^48.
    let left = (1u64 << 63).wrapping_sub(seed as u64 * q as u64) as i64;
    let step = (seed as i64 * (left >> 16)) >> 47;
    let mut r = (seed as i64 + step) as u32;
    // Every rounding so far went down, so r is at most 3 short and never over.
    let mut left = ((1u64 << 63) - 1).wrapping_sub(r as u64 * q as u64);
    if left >= 2 * q as u64 {
        left -= 2 * q as u64;
        r += 2;
    }
    if left >= q as u64 {
        r += 1;
    }
    r
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_are_the_specification() {
        let mut q: u32 = 1 << 31;
        loop {
            let exact = ((1u128 << 63) - 1) / u128::from(q);
            assert_eq!(u128::from(by_division(q)), exact, "{q}");
            assert_eq!(u128::from(by_newton(q)), exact, "{q}");
            // Prime steps: every residue of the 16-bit seed is met.
            match q.checked_add(9973) {
                Some(next) => q = next,
                None => break,
            }
        }
        for q in (1 << 31..(1 << 31) + 200_000).chain(u32::MAX - 200_000..=u32::MAX) {
            assert_eq!(by_newton(q), by_division(q), "{q}");
        }
    }
}
