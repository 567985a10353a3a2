//! Block floating point: a few numbers that share one exponent.
//!
//! Every value is mantissa · 2^−exponent. Mantissas have 30 bits and a sign, so that the product of
//! two fits in 60 bits and three products are summed in an `i64` without a thought.

/// Bits of a mantissa: magnitudes stay below 2^30.
const BITS: i32 = 30;
/// Lowest exponent: values reach up to 2^62, beyond that they saturate.
pub(crate) const MIN_EXP: i32 = -32;
/// Highest exponent: values below 2^-33 have fewer than 30 bits, below 2^-63 they are zero.
pub(crate) const MAX_EXP: i32 = 62;

const LIMIT: i64 = (1 << BITS) - 1;

// The functions below are calls, not copies, and take slices: they run a few dozen times a draw
// call, and would else be most of a small program's code.

/// `value · 2^shift`, rounded to nearest (half up); saturates.
#[inline(never)]
pub(crate) const fn shift(value: i64, shift: i32) -> i64 {
    if shift >= 0 {
        // A bit is kept for the sign.
        if value == 0 || shift < magnitude(value).leading_zeros().cast_signed() {
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

#[inline]
const fn magnitude(value: i64) -> u64 {
    value.unsigned_abs()
}

/// The finest exponent at which `values · 2^-exp` stay below 2^`bits`; `i32::MAX` if all are zero.
#[inline(never)]
pub(crate) fn finest(values: &[i64], exp: i32, bits: i32) -> i32 {
    // As many bits as the largest has.
    let all = values.iter().fold(0, |all, &v| all | magnitude(v));
    if all == 0 {
        return i32::MAX;
    }
    exp.saturating_add(all.leading_zeros().cast_signed() - 64 + bits)
}

/// Mantissas and exponent of `values · 2^-exp`, rounded to nearest, but that a mantissa of 2^30 − ½
/// and more is 2^30 − 1.
///
/// The largest mantissa has bit 29 set, except where the exponent is at [`MAX_EXP`]: all zero, or
/// too small to be represented fully. At [`MIN_EXP`], mantissas saturate at ±(2^30 − 1).
#[inline]
pub(crate) fn normalise<const N: usize>(values: [i64; N], exp: i32) -> ([i32; N], i32) {
    let mut mantissas = [0; N];
    let exp = normalise_into(&mut mantissas, &values, exp);
    (mantissas, exp)
}

/// [`normalise`] of as many values as there are mantissas; gives the exponent.
#[inline(never)]
pub(crate) fn normalise_into(mantissas: &mut [i32], values: &[i64], exp: i32) -> i32 {
    let to = finest(values, exp, BITS).clamp(MIN_EXP, MAX_EXP);
    for (mantissa, &value) in mantissas.iter_mut().zip(values) {
        // Saturating, as the exponent may come from anywhere.
        let value = shift(value, to.saturating_sub(exp));
        *mantissa = value.clamp(-LIMIT, LIMIT) as i32;
    }
    to
}

/// The sum of two blocks that have been computed in 64 bits, in 61 bits.
#[inline]
pub(crate) fn add<const N: usize>(
    (mut a, a_exp): ([i64; N], i32),
    (b, b_exp): ([i64; N], i32),
) -> ([i64; N], i32) {
    let exp = add_to(&mut a, a_exp, &b, b_exp);
    (a, exp)
}

/// [`add`] of `b` to `a`; gives the exponent.
#[inline(never)]
fn add_to(a: &mut [i64], a_exp: i32, b: &[i64], b_exp: i32) -> i32 {
    let exp = finest(a, a_exp, 61).min(finest(b, b_exp, 61));
    // Zeros fit at any exponent.
    let exp = if exp == i32::MAX { 0 } else { exp };
    for (a, &b) in a.iter_mut().zip(b) {
        *a = shift(*a, exp.saturating_sub(a_exp)) + shift(b, exp.saturating_sub(b_exp));
    }
    exp
}

/// Numbers with an exponent each as a block, in 61 bits.
pub(crate) fn join<const N: usize>(numbers: [(i64, i32); N]) -> ([i64; N], i32) {
    let exp = numbers
        .iter()
        .fold(i32::MAX, |exp, &(v, e)| exp.min(finest(&[v], e, 61)));
    let exp = if exp == i32::MAX { 0 } else { exp };
    let values = numbers.map(|(value, from)| shift(value, exp.saturating_sub(from)));
    (values, exp)
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
        // Rounding up to a power of two would take one more bit.
        assert_eq!(normalise([(1 << 31) - 1], 0), ([(1 << 30) - 1], -1));
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
                    // Half a unit of the last place, or one at the end; and f64's own rounding.
                    let error = (real(v, exp) - real(m.into(), e)).abs();
                    let units = if i64::from(m.abs()) == LIMIT { 1.0 } else { 0.5 };
                    prop_assert!(error <= (units + 1e-6) * f64::from(-e).exp2());
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
