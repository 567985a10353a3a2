//! Block floating point: a few numbers that share one exponent.
//!
//! Every value is mantissa · 2^−exponent. Mantissas have 30 bits and a sign, so that the product of
//! two fits in 60 bits and three products are summed in an `i64` without a thought.

/// Bits of a mantissa: magnitudes stay below 2^30.
pub(crate) const BITS: u32 = 30;
/// Lowest exponent: values reach up to 2^62, beyond that they saturate.
pub(crate) const MIN_EXP: i32 = -32;
/// Highest exponent: values below 2^-33 have fewer than 30 bits, below 2^-63 they are zero.
pub(crate) const MAX_EXP: i32 = 62;

const LIMIT: i64 = (1 << BITS) - 1;

/// `value · 2^shift`, rounded to nearest (half up); saturates.
#[allow(clippy::cast_possible_wrap)] // at most 64
pub(crate) const fn shift(value: i64, shift: i32) -> i64 {
    if shift >= 0 {
        // A bit is kept for the sign.
        if value == 0 || shift < magnitude(value).leading_zeros() as i32 {
            value << (shift & 63)
        } else if value < 0 {
            -i64::MAX
        } else {
            i64::MAX
        }
    } else if shift > -64 {
        // Half is added after the next to last bit is dropped, where it cannot overflow.
        ((value >> (-shift - 1)) + 1) >> 1
    } else {
        0
    }
}

const fn magnitude(value: i64) -> u64 {
    value.unsigned_abs()
}

/// The largest magnitude.
fn largest(values: &[i64]) -> u64 {
    values.iter().fold(0, |max, &v| max.max(magnitude(v)))
}

/// Mantissas and exponent of `values · 2^-exp`, rounded to nearest.
///
/// The largest mantissa has bit 29 set, except where the exponent is at [`MAX_EXP`]: all zero, or
/// too small to be represented fully. At [`MIN_EXP`], mantissas saturate at ±(2^30 − 1).
pub(crate) fn normalise<const N: usize>(values: [i64; N], exp: i32) -> ([i32; N], i32) {
    let size = largest(&values);
    if size == 0 {
        return ([0; N], MAX_EXP);
    }
    #[allow(clippy::cast_possible_wrap)] // at most 64
    let mut down = 64 - size.leading_zeros() as i32 - BITS as i32;
    if down > 0 && (size >> (down - 1)) == (1 << (BITS + 1)) - 1 {
        // Rounding carries into the next bit.
        down += 1;
    }
    // Saturating, as the exponent may come from anywhere.
    let down = exp
        .saturating_sub(exp.saturating_sub(down).clamp(MIN_EXP, MAX_EXP))
        .clamp(-64, 64);
    let mantissas = values.map(|v| shift(v, -down).clamp(-LIMIT, LIMIT) as i32);
    (mantissas, exp.saturating_sub(down).clamp(MIN_EXP, MAX_EXP))
}

/// The sum of two blocks that have been computed in 64 bits, in 61 bits.
pub(crate) fn add<const N: usize>(
    (a, a_exp): ([i64; N], i32),
    (b, b_exp): ([i64; N], i32),
) -> ([i64; N], i32) {
    // The finest exponent at which a block stays below 2^61. Zero fits at any.
    let finest = |values: &[i64], exp: i32| match largest(values) {
        0 => i32::MAX,
        #[allow(clippy::cast_possible_wrap)] // at most 63
        size => exp + size.leading_zeros() as i32 - 3,
    };
    let exp = match finest(&a, a_exp).min(finest(&b, b_exp)) {
        i32::MAX => return ([0; N], 0),
        exp => exp,
    };
    let mut sum = [0; N];
    for (sum, (a, b)) in sum.iter_mut().zip(a.into_iter().zip(b)) {
        *sum = shift(a, exp - a_exp) + shift(b, exp - b_exp);
    }
    (sum, exp)
}

/// Numbers with an exponent each as a block, in 61 bits.
pub(crate) fn join<const N: usize>(values: [(i64, i32); N]) -> ([i64; N], i32) {
    values
        .into_iter()
        .enumerate()
        .fold(([0; N], 0), |block, (i, (value, exp))| {
            let mut one = [0; N];
            one[i] = value;
            add(block, (one, exp))
        })
}

/// `value · 2^-exp` in units of 2^-`fraction`, rounded to nearest; saturates.
pub(crate) const fn fixed(value: i64, exp: i32, fraction: i32) -> i32 {
    let value = shift(value, fraction - exp);
    if value > i32::MAX as i64 {
        i32::MAX
    } else if value < i32::MIN as i64 {
        i32::MIN
    } else {
        value as i32
    }
}

/// The quotient rounded to nearest, half away from zero; `None` if the denominator is zero or the
/// quotient needs more than 32 bits. For magnitudes below 2^62.
pub(crate) fn divide(numerator: i64, denominator: i64) -> Option<i32> {
    if denominator == 0 {
        return None;
    }
    let half = denominator.abs() / 2 * numerator.signum();
    i32::try_from((numerator + half) / denominator).ok()
}

/// `numerator / denominator` as a number and its exponent, to 33 significant bits rounded down;
/// the denominator is taken for its magnitude, and zero for the smallest there is.
///
/// Operands are rounded to 31 bits first. Bit by bit: this is for constructors, where the code of a
/// 64-bit division would cost more flash than its speed is worth.
pub(crate) fn ratio(numerator: i64, denominator: i64) -> (i64, i32) {
    let sign = numerator.signum();
    let (top, top_exp) = mantissa(magnitude(numerator));
    let (bottom, bottom_exp) = mantissa(magnitude(denominator).max(1));
    // Both mantissas have bit 30 set, unless the numerator is zero: the quotient is below 2, and
    // the remainder stays below twice the denominator.
    let mut rest = top;
    let mut quotient = 0;
    for _ in 0..34 {
        quotient <<= 1;
        if rest >= bottom {
            rest -= bottom;
            quotient |= 1;
        }
        rest <<= 1;
    }
    (sign * quotient, 33 + top_exp - bottom_exp)
}

/// A magnitude as 31 bits, the upper one set unless it is zero, rounded to nearest, and its
/// exponent.
#[allow(clippy::cast_possible_wrap)] // 31 bits, and at most 64
fn mantissa(value: u64) -> (u32, i32) {
    let up = value.leading_zeros() as i32 - 33;
    let rounded = if up >= 0 {
        value << (up & 63)
    } else {
        ((value >> (-up - 1)) + 1) >> 1
    };
    if rounded >> 31 == 0 {
        (rounded as u32, up)
    } else {
        (1 << 30, up - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[allow(clippy::cast_precision_loss)]
    fn real(value: i64, exp: i32) -> f64 {
        value as f64 * f64::from(-exp).exp2()
    }

    #[test]
    fn mantissas_are_thirty_bits_and_exponents_bounded() {
        assert_eq!(normalise([1 << 16], 16), ([1 << 29], 29));
        assert_eq!(normalise([0, 0], 3), ([0, 0], MAX_EXP));
        assert_eq!(normalise([-(1 << 62)], 0), ([-(1 << 30) + 1], MIN_EXP));
        assert_eq!(normalise([i64::MIN, 1], i32::MAX), ([0, 0], MAX_EXP));
        // Rounding up to a power of two takes one more bit.
        assert_eq!(normalise([(1 << 31) - 1], 0), ([1 << 29], -2));
    }

    proptest! {
        #[test]
        fn normalising_rounds_to_nearest(
            v in any::<[i64; 3]>(),
            cut in [0_u32..64, 0..64, 0..64],
            exp in -20..70,
        ) {
            let v: [i64; 3] = core::array::from_fn(|i| v[i] >> cut[i]);
            let (m, e) = normalise(v, exp);
            prop_assert!((MIN_EXP..=MAX_EXP).contains(&e));
            for (&v, &m) in v.iter().zip(&m) {
                prop_assert!(m.unsigned_abs() < 1 << 30);
                if e > MIN_EXP {
                    // Half a unit of the last place, and f64's own rounding.
                    let error = (real(v, exp) - real(m.into(), e)).abs();
                    prop_assert!(error <= 0.500_001 * f64::from(-e).exp2());
                }
            }
            if e < MAX_EXP {
                prop_assert!(m.iter().any(|m| m.unsigned_abs() >= 1 << 29));
            }
        }

        #[test]
        fn any_exponent_is_survived(
            v in any::<[i64; 3]>(),
            w in any::<[i64; 3]>(),
            exp in any::<i32>(),
            other in -200..200,
        ) {
            let (m, e) = normalise(v, exp);
            prop_assert!((MIN_EXP..=MAX_EXP).contains(&e));
            prop_assert!(m.iter().all(|m| m.unsigned_abs() < 1 << 30));
            let _ = add((v, 100), (w, other));
            let _ = fixed(v[0], other, 16);
        }

        #[test]
        fn sums_keep_sixty_bits(
            a in any::<i64>(),
            b in any::<i64>(),
            cut in 0_u32..64,
            a_exp in -99..99,
            b_exp in -99..99,
        ) {
            let b = b >> cut;
            let ([sum], exp) = add(([a], a_exp), ([b], b_exp));
            let expected = real(a, a_exp) + real(b, b_exp);
            let size = real(a, a_exp).abs() + real(b, b_exp).abs();
            prop_assert!((real(sum, exp) - expected).abs() <= size * f64::from(-50).exp2());
        }

        #[test]
        fn ratios_have_thirty_bits(
            a in any::<i64>(),
            b in any::<i64>(),
            cut in [0_u32..63, 0..63],
        ) {
            let (a, b) = (a >> cut[0], (b >> cut[1]).saturating_abs().max(1));
            let (q, exp) = ratio(a, b);
            #[allow(clippy::cast_precision_loss)]
            let expected = a as f64 / b as f64;
            // Two operands of 31 bits and a quotient of 33.
            let error = (real(q, exp) - expected).abs();
            prop_assert!(error <= 1.3 * f64::from(-30).exp2() * expected.abs());
        }
    }
}
