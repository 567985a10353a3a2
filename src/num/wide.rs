//! Everything that differs on cores without 64-bit products, a divider or an instruction that counts leading zeros.
//!
//! No other file asks which core it runs on. Each function here gives the same bits on all of them.

/// Whether the core's products have only 32 bits, as on Armv6-M and the baseline of Armv8-M: Cortex-M0, M0+, M1 and M23.
/// `src/build.rs` tells from the target's name.
///
/// On these cores the compiler calls a routine that multiplies 64 bits by 64. Four products of 16 bits take half as
/// long.
const IS_NARROW: bool = cfg!(narrow_core);

/// Whether the core divides. Armv6-M does not, and Cortex-M23 takes up to 34 cycles, longer than the code without a
/// division.
pub(crate) const DIVIDES: bool = !IS_NARROW;

/// Whether the core counts leading zeros: the narrow ones do not, nor does RISC-V without Zbb.
pub(crate) const COUNTS_ZEROS: bool =
    !IS_NARROW && !cfg!(all(target_arch = "riscv32", not(target_feature = "zbb")));

/// Whether [`short_dot`] is faster than [`dot`].
pub(crate) const PREFERS_SHORT: bool = IS_NARROW;

/// Returns the exact product.
#[inline]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    if IS_NARROW {
        narrow_product(a, b)
    } else {
        a as i64 * b as i64
    }
}

/// Returns the upper half of an unsigned product; `b` must be below 2^31.
#[inline]
pub(crate) const fn upper(a: u32, b: u32) -> u32 {
    if IS_NARROW {
        upper_of_signed(a, b)
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// Returns [`upper`] by a signed product.
#[inline]
const fn upper_of_signed(a: u32, b: u32) -> u32 {
    let product = product(a.cast_signed(), b.cast_signed()).cast_unsigned();
    let upper = (product >> 32) as u32;
    // If the top bit of `a` is set, the signed `a` is 2^32 too small.
    upper.wrapping_add(b & (a.cast_signed() >> 31).cast_unsigned())
}

/// Returns a · d − c · b, twice the area between the sides (a, b) and (c, d), of 21 bits each.
#[inline]
pub(crate) fn cross([a, b]: [i32; 2], [c, d]: [i32; 2]) -> i64 {
    if IS_NARROW && are_short([a, b], [c, d]) {
        return short_cross([a, b], [c, d]);
    }
    product(a, d) - product(c, b)
}

/// Whether sides are shorter than 64 pixels of 256 units, as most are.
#[inline]
fn are_short([a, b]: [i32; 2], [c, d]: [i32; 2]) -> bool {
    let raised = |side: i32| side.wrapping_add(1 << 14).cast_unsigned();
    raised(a) | raised(b) | raised(c) | raised(d) < 1 << 15
}

/// Returns [`cross`] of sides that [are short](are_short): they take 15 bits, and twice the area then takes 31.
#[inline]
fn short_cross([a, b]: [i32; 2], [c, d]: [i32; 2]) -> i64 {
    i64::from(a * d - c * b)
}

/// Returns a quotient, rounded down, and its remainder; the divisor must be above 0.
#[inline]
pub(crate) fn divide(numerator: i32, divisor: i32) -> (i32, i32) {
    if IS_NARROW {
        return narrow_divide(numerator, divisor);
    }
    let divisor = divisor.max(1);
    let (quotient, remainder) = (numerator / divisor, numerator % divisor);
    // Rounded towards zero so far.
    let below = remainder >> 31;
    (quotient + below, remainder + (divisor & below))
}

/// Returns [`divide`] by subtraction if the quotient is small: a division takes as long as twenty of them.
#[inline]
fn narrow_divide(numerator: i32, divisor: i32) -> (i32, i32) {
    let (mut quotient, mut remainder) = (0, numerator);
    for _ in 0..16 {
        if remainder < 0 {
            remainder += divisor;
            quotient -= 1;
        } else if remainder >= divisor {
            remainder -= divisor;
            quotient += 1;
        } else {
            return (quotient, remainder);
        }
    }
    let (more, remainder) = (
        remainder.div_euclid(divisor.max(1)),
        remainder.rem_euclid(divisor.max(1)),
    );
    (quotient + more, remainder)
}

/// Multiplies by a number of 16 bits; wraps.
#[inline]
pub(crate) const fn times_short(a: i64, b: i32) -> i64 {
    if IS_NARROW {
        by_halves(a, b)
    } else {
        a.wrapping_mul(b as i64)
    }
}

/// Adds the product of a number and another one of 15 bits without a sign; wraps.
#[inline]
pub(crate) const fn plus_times_short(sum: i64, a: i64, b: i32) -> i64 {
    if IS_NARROW || cfg!(target_pointer_width = "64") {
        sum.wrapping_add(times_short(a, b))
    } else {
        plus_by_halves(sum, a, b.cast_unsigned())
    }
}

/// Returns [`plus_times_short`] by the halves of `a`, the lower one first: some cores add a product of 32 bits to 64 bits
/// in one instruction.
#[inline]
const fn plus_by_halves(sum: i64, a: i64, b: u32) -> i64 {
    let low = (a.cast_unsigned() as u32 as u64) * b as u64;
    let high = ((a.cast_unsigned() >> 32) as u32).wrapping_mul(b);
    sum.wrapping_add(low.cast_signed())
        .wrapping_add(((high as u64) << 32).cast_signed())
}

/// Returns [`times_short`] by products of 32 bits.
#[inline]
const fn by_halves(a: i64, b: i32) -> i64 {
    let (high, low) = ((a >> 32) as i32, a.cast_unsigned() as u32);
    let [first, second] = [(low & 0xffff).cast_signed(), (low >> 16).cast_signed()];
    let low = first.wrapping_mul(b) as i64 + ((second.wrapping_mul(b) as i64) << 16);
    let high = high.wrapping_mul(b).cast_unsigned();
    low.wrapping_add(((high as u64) << 32).cast_signed())
}

/// Returns a · b / 2^14, rounded down, for a `b` of up to 17 bits and a product of up to 45 bits.
#[inline]
pub(crate) fn times_17_bits(a: i32, b: u32) -> i32 {
    let b = b.cast_signed();
    if IS_NARROW {
        narrow_times_17_bits(a, b)
    } else {
        ((i64::from(a) * i64::from(b)) >> 14) as i32
    }
}

/// Returns [`times_17_bits`] by products of 32 bits.
#[inline]
fn narrow_times_17_bits(a: i32, b: i32) -> i32 {
    (a >> 14)
        .wrapping_mul(b)
        .wrapping_add((a & 0x3fff).wrapping_mul(b) >> 14)
}

/// Returns the dot product, which must fit in 64 bits: mantissas of 30 bits times numbers of 31 bits do.
#[inline]
pub(crate) fn dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    if IS_NARROW {
        narrow_dot(a, b)
    } else {
        product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2])
    }
}

/// Returns the dot product of coefficients of at most 2^29 with 16-bit numbers shifted left by `up`, from
/// 0 to 16.
///
/// It works in 32 bits: twice as fast as [`dot`] on a core that multiplies to 32 bits only.
#[inline]
pub(crate) fn short_dot(a: &[i32; 3], b: [i16; 3], up: u32) -> i64 {
    // Each coefficient is split into high · 2^15 + low, both at most 2^14 in magnitude. Three products
    // with 2^15 sum to at most 3 · 2^29.
    let (mut high, mut low) = (0, 0);
    for (&a, b) in a.iter().zip(b) {
        let a_high = (a + (1 << 14)) >> 15;
        high += a_high * i32::from(b);
        low += (a - (a_high << 15)) * i32::from(b);
    }
    let sum = (i64::from(high) << 15) + i64::from(low);
    // By halves, because a 64-bit shift is a call.
    let (upper, lower) = ((sum >> 32) as i32, sum.cast_unsigned() as u32);
    let upper =
        (upper << (up & 31)).cast_unsigned() | (lower >> 1 >> (31u32.wrapping_sub(up) & 31));
    ((u64::from(upper) << 32) | u64::from(lower << (up & 31))).cast_signed()
}

// Out of line: a copy would be longer than the call.

#[inline(never)]
const fn narrow_product(a: i32, b: i32) -> i64 {
    of_halves(a, b)
}

#[inline(never)]
fn narrow_dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    a.iter().zip(b).map(|(&a, &b)| of_halves(a, b)).sum()
}

/// Multiplies two numbers by the products of their halves.
#[inline]
const fn of_halves(a: i32, b: i32) -> i64 {
    let ([a_high, a_low], [b_high, b_low]) = ([a >> 16, a & 0xffff], [b >> 16, b & 0xffff]);
    let low = a_low.cast_unsigned() * b_low.cast_unsigned();
    // A signed half times an unsigned half is at most 2^31 - 2^15 in magnitude: adding 16 bits does
    // not overflow.
    let cross = a_high * b_low + (low >> 16).cast_signed();
    let other = a_low * b_high + (cross & 0xffff);
    let high = a_high * b_high + (cross >> 16) + (other >> 16);
    let low = (other << 16).cast_unsigned() | (low & 0xffff);
    ((high as i64) << 32) | low as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn products_of_halves_are_exact_at_the_ends() {
        let ends = [
            0,
            1,
            -1,
            0x7fff,
            0x8000,
            0xffff,
            0x1_0000,
            -0x8000,
            -0xffff,
            -0x1_0000,
            0x7fff_0000,
            i32::MAX,
            i32::MIN,
            i32::MIN + 0xffff,
        ];
        for a in ends {
            for b in ends {
                assert_eq!(of_halves(a, b), i64::from(a) * i64::from(b), "{a} · {b}");
                let (a, b) = (a.cast_unsigned(), b.cast_unsigned() & (u32::MAX >> 1));
                let upper = (u64::from(a) * u64::from(b)) >> 32;
                assert_eq!(u64::from(upper_of_signed(a, b)), upper, "{a} · {b}");
            }
        }
    }

    #[test]
    fn short_products_are_exact_at_the_ends() {
        for a in [
            0,
            1,
            -1,
            1 << 14,
            (1 << 14) - 1,
            -(1 << 14),
            1 << 29,
            -(1 << 29),
        ] {
            for b in [0, 1, -1, i16::MAX, i16::MIN] {
                for up in [0, 1, 15, 16] {
                    let expected = 3 * i64::from(a) * (i64::from(b) << up);
                    assert_eq!(
                        short_dot(&[a; 3], [b; 3], up),
                        expected,
                        "{a} · {b} << {up}"
                    );
                }
            }
        }
    }

    /// Sides at both ends of the short range, and one unit beyond them.
    #[test]
    fn short_sides_have_15_bits() {
        let (least, most) = (-(1 << 14), (1 << 14) - 1);
        let ends = [least, -1, 0, 1, most];
        for a in ends {
            for b in ends {
                for c in ends {
                    for d in ends {
                        assert!(are_short([a, b], [c, d]));
                        let exact = i64::from(a) * i64::from(d) - i64::from(c) * i64::from(b);
                        assert_eq!(short_cross([a, b], [c, d]), exact);
                        assert_eq!(cross([a, b], [c, d]), exact);
                    }
                }
            }
        }
        for beyond in [least - 1, most + 1, i32::MIN, i32::MAX] {
            for at in 0..4 {
                let mut sides = [0; 4];
                sides[at] = beyond;
                let [a, b, c, d] = sides;
                assert!(!are_short([a, b], [c, d]), "{sides:?}");
            }
        }
    }

    proptest! {
        #[test]
        fn narrow_dot_products_are_exact(
            a in prop::array::uniform3(-(1 << 29)..=1 << 29),
            b in any::<[i32; 3]>(),
        ) {
            let exact: i64 = a.iter().zip(b).map(|(&a, b)| i64::from(a) * i64::from(b)).sum();
            prop_assert_eq!(narrow_dot(&a, &b), exact);
            prop_assert_eq!(dot(&a, &b), exact);
        }

        #[test]
        fn narrow_products_with_17_bits_are_exact(a in any::<i32>(), b in 0_u32..=1 << 17, cut in 0_u32..17) {
            let b = b >> cut;
            // A product of 45 bits with its sign.
            let a = (i64::from(a) % ((1 << 44) / i64::from(b.max(1)))) as i32;
            let exact = (i64::from(a) * i64::from(b)) >> 14;
            prop_assert_eq!(i64::from(times_17_bits(a, b)), exact);
            prop_assert_eq!(i64::from(narrow_times_17_bits(a, b.cast_signed())), exact);
        }

        #[test]
        fn short_dot_products_equal_long_ones(
            a in prop::array::uniform3(-(1 << 29)..=1 << 29),
            b in any::<[i16; 3]>(),
            up in 0_u32..=16,
        ) {
            prop_assert_eq!(short_dot(&a, b, up), dot(&a, &b.map(|b| i32::from(b) << up)));
        }

        #[test]
        fn quotients_are_rounded_down(
            numerator in -(1_i32 << 20)..=1 << 20,
            divisor in 1_i32..=1 << 20,
            size in 0_u32..20,
        ) {
            let divisor = i32::max(divisor >> size, 1);
            let exact = (numerator.div_euclid(divisor), numerator.rem_euclid(divisor));
            prop_assert_eq!(divide(numerator, divisor), exact);
            prop_assert_eq!(narrow_divide(numerator, divisor), exact);
        }

        #[test]
        fn products_with_short_numbers_are_exact(a in any::<i64>(), b in any::<i16>()) {
            let b = i32::from(b);
            prop_assert_eq!(by_halves(a, b), a.wrapping_mul(b.into()));
        }

        #[test]
        fn sums_with_short_products_are_exact(sum in any::<i64>(), a in any::<i64>(), b in 0_i32..1 << 15) {
            let exact = sum.wrapping_add(a.wrapping_mul(b.into()));
            prop_assert_eq!(plus_times_short(sum, a, b), exact);
            prop_assert_eq!(plus_by_halves(sum, a, b.cast_unsigned()), exact);
        }

        #[test]
        fn products_of_halves_are_exact(a in any::<i32>(), b in any::<i32>()) {
            prop_assert_eq!(of_halves(a, b), i64::from(a) * i64::from(b));
            let (a, b) = (a.cast_unsigned(), b.cast_unsigned() & (u32::MAX >> 1));
            let upper = (u64::from(a) * u64::from(b)) >> 32;
            prop_assert_eq!(u64::from(upper_of_signed(a, b)), upper);
        }
    }
}
