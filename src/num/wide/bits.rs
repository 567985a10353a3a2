//! Comparing, clamping and shifting.

use super::{COUNTS_ZEROS, IS_NARROW, IS_WIDE, SATURATES};

/// Whether `a`, a number of 16 bits, is at least `b`.
#[inline]
pub(crate) const fn at_least(a: u32, b: u16) -> bool {
    // A 64-bit core compares 16 bits directly with a number in memory.
    if IS_WIDE {
        a as u16 >= b
    } else {
        a >= b as u32
    }
}

/// Clamps a number to the range from -2^`bits` to 0.
#[inline]
pub(crate) fn clamp_negative(value: i32, bits: u32) -> i32 {
    if SATURATES {
        saturate_negative(value, bits)
    } else {
        value.clamp(-1 << bits, 0)
    }
}

/// Does what [`clamp_negative`] does, in two instructions. The first instruction saturates to a signed number with one
/// bit more than `bits`. In the result, bit `bits` repeats the sign, so a shift by `bits` makes a mask that clears
/// positive numbers. (The compiler would turn a shift by 31 back into a comparison.)
#[inline]
fn saturate_negative(value: i32, bits: u32) -> i32 {
    let limited = value.clamp(-1 << bits, (1 << bits) - 1);
    limited & limited >> bits
}

/// Shifts left by up to 16 bits. On a core without long shifts, this function shifts the two halves, because the
/// compiler would call a routine for a shift of 64 bits.
#[inline]
pub(crate) const fn up(value: i64, up: u32) -> i64 {
    if IS_NARROW {
        up_by_halves(value, up)
    } else {
        value << up
    }
}

#[inline]
const fn up_by_halves(value: i64, up: u32) -> i64 {
    let (upper, lower) = ((value >> 32) as i32, value.cast_unsigned() as u32);
    let upper =
        (upper << (up & 31)).cast_unsigned() | (lower >> 1 >> (31u32.wrapping_sub(up) & 31));
    ((upper as u64) << 32 | (lower << (up & 31)) as u64).cast_signed()
}

/// Shifts `q` left until its top bit is set, and lowers an exponent by the number of shifted bits less one. The
/// exponent is in the bits above the lowest `mantissa` bits.
#[inline]
pub(crate) fn normalize(q: u32, exponent: u32, mantissa: u32) -> (u32, u32) {
    if !COUNTS_ZEROS {
        return normalize_by_steps(q, exponent, mantissa);
    }
    // The lowest bit is set, so that a zero is shifted by at most 31.
    let zeros = (q | 1).leading_zeros();
    let exponent = exponent.wrapping_sub(zeros << mantissa);
    (q << zeros, exponent.wrapping_add(1 << mantissa))
}

/// Returns [`normalize`] on cores that cannot count zeros. Most `q` of a triangle have 30 or 31 bits, because each
/// triangle has its own scale, so shifting by single bits is fast.
#[inline]
fn normalize_by_steps(q: u32, mut exponent: u32, mantissa: u32) -> (u32, u32) {
    let mut normal = q << 1;
    if normal.cast_signed() >= 0 {
        normal |= 1;
        while normal >> 24 == 0 {
            normal <<= 8;
            exponent = exponent.wrapping_sub(8 << mantissa);
        }
        while normal.cast_signed() >= 0 {
            normal <<= 1;
            exponent = exponent.wrapping_sub(1 << mantissa);
        }
    }
    (normal, exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn numbers_are_clamped_to_negative_ones_alike() {
        for bits in 1..30 {
            let limit = 1 << bits;
            for value in [
                i32::MIN,
                -limit - 1,
                -limit,
                1 - limit,
                -1,
                0,
                1,
                limit - 1,
                limit,
                i32::MAX,
            ] {
                let limited = value.clamp(-limit, 0);
                assert_eq!(clamp_negative(value, bits), limited, "{value}");
                assert_eq!(saturate_negative(value, bits), limited, "{value}");
            }
        }
    }

    #[test]
    fn halves_are_shifted_alike() {
        cases(256, |random| {
            let value = random.random::<i64>() >> random.random_range(0..64);
            let by = random.random_range(0_u32..=16);
            assert_eq!(up_by_halves(value, by), value << by);
        });
    }

    #[test]
    fn normalizing_by_steps_agrees() {
        for bit in 0..31 {
            for q in [0, 1, 0x5555_5555, u32::MAX].map(|rest| 1 << bit | rest & ((1 << bit) - 1)) {
                for mantissa in [11, 12] {
                    let code = |(normal, exponent): (u32, u32)| {
                        (normal >> (31 - mantissa))
                            .wrapping_add(exponent)
                            .cast_signed()
                            .max(0)
                    };
                    for down in 15..64 {
                        let exponent = 29u32.wrapping_sub(down) << mantissa;
                        let [a, b] = [normalize, normalize_by_steps]
                            .map(|normalize| code(normalize(q, exponent, mantissa)));
                        assert_eq!(a, b, "{q} >> {down}, {mantissa} bits");
                    }
                }
            }
        }
    }
}
