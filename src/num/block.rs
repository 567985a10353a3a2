//! Block floating point: a few numbers that share one exponent.
//!
//! Every value is mantissa · 2^−exponent. A mantissa has 30 bits and a sign, so a product has 60 bits
//! and an `i64` holds the sum of three products.

use crate::num::reciprocal;
use crate::num::wide::product;

/// The bits of a mantissa: magnitudes stay below 2^30.
const BITS: i32 = 30;
/// The lowest exponent. It is used for values of up to 2^62; larger values saturate.
pub(crate) const MIN_EXP: i32 = -32;
/// The highest exponent. Values below 2^-33 have fewer than 30 bits, and values below 2^-63 are zero.
pub(crate) const MAX_EXP: i32 = 62;

const LIMIT: i64 = (1 << BITS) - 1;

// In a build for size, the functions below stay out of line and take slices: they run a few dozen times per draw call,
// and copies of them would be most of a small program's code.

/// Returns `value` · 2^`shift`, rounded to nearest (half up); saturates.
#[inline(never)]
pub(crate) const fn shift(value: i64, shift: i32) -> i64 {
    if shift >= 0 {
        // One bit is left for the sign.
        if value == 0 || shift < leading_zeros(value) {
            value << (shift & 63)
        } else if value < 0 {
            -i64::MAX
        } else {
            i64::MAX
        }
    } else if shift > -64 {
        // A half is added when only one bit is left to drop, because then the sum cannot overflow.
        ((value >> (-shift - 1)) + 1) >> 1
    } else {
        0
    }
}

/// Returns the number of leading zeros of the magnitude.
#[cfg_attr(for_size, inline(never))]
const fn leading_zeros(value: i64) -> i32 {
    value.unsigned_abs().leading_zeros().cast_signed()
}

/// A number `value` · 2^−`exp` of up to 62 bits, before it is rounded to a mantissa.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BlockFloat {
    pub(crate) value: i64,
    pub(crate) exp: i32,
}

impl BlockFloat {
    pub(crate) const ZERO: Self = Self::new(0, 0);

    #[inline]
    pub(crate) const fn new(value: i64, exp: i32) -> Self {
        Self { value, exp }
    }

    /// Returns the highest exponent at which the value stays below 2^`bits`; `i32::MAX` for zero.
    #[inline]
    pub(crate) const fn finest(self, bits: i32) -> i32 {
        if self.value == 0 {
            return i32::MAX;
        }
        // The sum saturates, because the exponent may be any number.
        self.exp
            .saturating_add(leading_zeros(self.value) + bits - 64)
    }

    /// Returns the value at another exponent, rounded to nearest (half up); saturates.
    #[inline]
    pub(crate) const fn at(self, exp: i32) -> i64 {
        shift(self.value, exp.saturating_sub(self.exp))
    }

    /// Rounds to a mantissa and its exponent.
    #[inline(never)]
    pub(crate) fn rounded(self) -> (i32, i32) {
        if cfg!(for_size) {
            let mut mantissa = [0];
            let exp = normalize(&mut mantissa, &[self]);
            return (mantissa[0], exp);
        }
        let exp = self.finest(BITS).clamp(MIN_EXP, MAX_EXP);
        (self.mantissa(exp), exp)
    }

    /// Rounds to a mantissa with an exponent from [`MIN_EXP`] to the [`finest`](Self::finest) for a mantissa.
    #[inline]
    fn mantissa(self, exp: i32) -> i32 {
        if cfg!(for_size) || exp == MIN_EXP {
            return far_mantissa(self, exp);
        }
        let down = self.exp.saturating_sub(exp);
        if down <= 0 {
            // Either the value is zero, or the shift is below 30.
            return (self.value as i32) << (-down & 31);
        }
        // Above the least exponent, every mantissa has at most 30 bits. One more bit, for rounding, fits into 32 bits.
        let twice = if down <= 32 {
            (self.value >> ((down - 1) & 31)) as i32
        } else {
            (self.value >> 32) as i32 >> (down - 33).min(31)
        };
        ((twice >> 1) + (twice & 1)).clamp(-(LIMIT as i32), LIMIT as i32)
    }

    #[inline]
    pub(crate) const fn negated(self) -> Self {
        Self::new(-self.value, self.exp)
    }

    /// Rounds both numbers to mantissas and multiplies them; the product has 60 bits.
    #[inline(never)]
    pub(crate) fn times(self, other: Self) -> Self {
        let (a, a_exp) = self.rounded();
        let (b, b_exp) = other.rounded();
        Self::new(i64::from(a) * i64::from(b), a_exp + b_exp)
    }

    /// Rounds both numbers to 61 bits and adds them.
    #[inline(never)]
    pub(crate) fn plus(self, other: Self) -> Self {
        // A sum with a zero needs no common exponent. Most translations of a product of transforms are such sums.
        if !cfg!(for_size) && other.value == 0 && (-(1 << 61) + 1..1 << 61).contains(&self.value) {
            return self;
        }
        let exp = self.finest(61).min(other.finest(61));
        Self::new(self.at(exp) + other.at(exp), exp)
    }

    /// Divides by the magnitude of `divisor`. A divisor of zero counts as half of its unit.
    ///
    /// Both operands are rounded to 31 bits; the relative error is at most 1.3 · 2^-30.
    #[inline(never)]
    pub(crate) fn over(self, divisor: Self) -> Self {
        let (top, top_exp) = operand(self.value);
        let (bottom, bottom_exp) = operand(divisor.value);
        let bottom = bottom.saturating_abs().max(1 << 30);
        let r = reciprocal(bottom.cast_unsigned()).cast_signed();
        // `lacks` is the reciprocal's relative deficit, (2^61 − r · bottom) / 2^61, times r, in units of 2^-30.
        // `deficit` is 2^61 − r · bottom; it is at most `bottom`, so 32 bits hold it.
        let deficit = r.wrapping_mul(bottom).wrapping_neg();
        let lacks = (product(deficit, r) >> 31) as i32;
        Self::new(
            product(top, r) + (product(top, lacks) >> 30),
            61 + self.exp + top_exp - divisor.exp - bottom_exp,
        )
    }
}

/// Rounds a value to 31 bits and a sign; returns the rounded value and its exponent.
///
/// Bit 30 is set unless the value is zero. Values that round up to 2^31 become 2^31 − 1.
#[inline(never)]
fn operand(value: i64) -> (i32, i32) {
    let up = leading_zeros(value) - 33;
    (saturated(shift(value, up)), up)
}

/// Rounds numbers to mantissas of one common exponent, and returns the exponent.
///
/// Mantissas are rounded to nearest; a mantissa that would round up to 2^30 becomes 2^30 − 1. The largest mantissa has
/// bit 29 set. Only if the exponent is [`MAX_EXP`], all mantissas can be smaller or zero. At [`MIN_EXP`], mantissas
/// saturate at ±(2^30 − 1).
#[inline(never)]
pub(crate) fn normalize(mantissas: &mut [i32], numbers: &[BlockFloat]) -> i32 {
    let finest = |exp: i32, number: &BlockFloat| exp.min(number.finest(BITS));
    let exp = numbers.iter().fold(MAX_EXP, finest).max(MIN_EXP);
    for (mantissa, number) in mantissas.iter_mut().zip(numbers) {
        *mantissa = number.mantissa(exp);
    }
    exp
}

/// Rounds the rows of a matrix, as [`normalize`] does. The numbers of a row have one exponent.
#[cfg_attr(not(for_size), inline(never))]
pub(crate) fn normalize_rows(
    mantissas: &mut [[i32; 3]; 3],
    rows: &[[i64; 3]; 3],
    exps: &[i32; 3],
) -> i32 {
    if cfg!(for_size) {
        return normalize_each(mantissas, rows, exps);
    }
    let upper = |value: i64| (value >> 32) as i32;
    let (mut common, mut is_plain) = (MAX_EXP, true);
    for (row, exp) in rows.iter().zip(exps) {
        // The magnitudes' upper halves. If a negative number is a power of two, all bits below it are set instead.
        let [x, y, z] = row.map(|value| (upper(value) ^ upper(value) >> 31).cast_unsigned());
        let bits = x | y | z;
        // Also if a number would round up to one bit more, all bits are set.
        is_plain &= bits & (bits + 1) != 0;
        let up = bits.leading_zeros().cast_signed() + BITS - 64;
        common = common.min(exp.saturating_add(up));
    }
    if !is_plain || common <= MIN_EXP {
        return normalize_each(mantissas, rows, exps);
    }
    for (to, (row, exp)) in mantissas.iter_mut().zip(rows.iter().zip(exps)) {
        // At least 3, because the upper half of some number is not 0.
        let down = exp.saturating_sub(common) - 1;
        let round = |twice: i32| (twice >> 1) + (twice & 1);
        *to = if down < 32 {
            let (up, down) = (!down & 31, down & 31);
            row.map(|value| {
                let lower = value.cast_unsigned() as u32 >> down;
                round((upper(value) << 1 << up) | lower.cast_signed())
            })
        } else {
            let down = (down - 32).min(31);
            row.map(|value| round(upper(value) >> down))
        };
    }
    common
}

/// Rounds the rows of a matrix with zeros, powers of two or numbers far from 1.
#[cfg_attr(not(for_size), cold, inline(never))]
fn normalize_each(mantissas: &mut [[i32; 3]; 3], rows: &[[i64; 3]; 3], exps: &[i32; 3]) -> i32 {
    let mut numbers = [BlockFloat::ZERO; 9];
    for (numbers, (row, exp)) in numbers.chunks_exact_mut(3).zip(rows.iter().zip(exps)) {
        for (number, value) in numbers.iter_mut().zip(row) {
            *number = BlockFloat::new(*value, *exp);
        }
    }
    normalize(mantissas.as_flattened_mut(), &numbers)
}

/// Rounds a number to a mantissa with an exponent that may be far from its own.
#[cfg_attr(not(for_size), cold, inline(never))]
fn far_mantissa(number: BlockFloat, exp: i32) -> i32 {
    number.at(exp).clamp(-LIMIT, LIMIT) as i32
}

/// Saturates to 32 bits.
#[inline]
pub(crate) const fn saturated(value: i64) -> i32 {
    if value > i32::MAX as i64 {
        i32::MAX
    } else if value < i32::MIN as i64 {
        i32::MIN
    } else {
        value as i32
    }
}

/// Returns `value` · 2^-`exp` in units of 2^-`fraction`, rounded to nearest (half up); saturates.
pub(crate) const fn fixed(value: i64, exp: i32, fraction: i32) -> i32 {
    saturated(shift(value, fraction - exp))
}

/// Divides, rounded to nearest (half away from zero); `None` if the denominator is zero or the
/// quotient needs more than 32 bits.
///
/// Magnitudes must not exceed 2^62.
pub(crate) fn divide(numerator: i64, denominator: i64) -> Option<i32> {
    if denominator == 0 {
        return None;
    }
    let half = denominator.abs() / 2 * numerator.signum();
    i32::try_from((numerator + half) / denominator).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{cases, within};
    use rand::Rng;

    #[allow(clippy::cast_precision_loss)]
    fn real(value: i64, exp: i32) -> f64 {
        value as f64 * f64::from(-exp).exp2()
    }

    fn normalized<const N: usize>(values: [i64; N], exp: i32) -> ([i32; N], i32) {
        let mut mantissas = [0; N];
        let exp = normalize(&mut mantissas, &values.map(|v| BlockFloat::new(v, exp)));
        (mantissas, exp)
    }

    #[test]
    fn mantissas_are_thirty_bits_and_exponents_bounded() {
        assert_eq!(normalized([1 << 16], 16), ([1 << 29], 29));
        assert_eq!(normalized([0, 0], 3), ([0, 0], MAX_EXP));
        assert_eq!(normalized([-(1 << 62)], 0), ([-(1 << 30) + 1], MIN_EXP));
        assert_eq!(normalized([i64::MIN, 1], i32::MAX), ([0, 0], MAX_EXP));
        // This number would round up to a mantissa of 2^30, which takes one more bit.
        assert_eq!(normalized([(1 << 31) - 1], 0), ([(1 << 30) - 1], -1));
    }

    #[test]
    fn normalizing_rounds_to_nearest() {
        cases(256, |random| {
            let v = random.random::<[i64; 3]>();
            let cut = within(random, [0_u32..64, 0..64, 0..64]);
            let exp = random.random_range(-20..70);
            let v: [i64; 3] = core::array::from_fn(|i| v[i] >> cut[i]);
            let (m, e) = normalized(v, exp);
            assert!((MIN_EXP..=MAX_EXP).contains(&e));
            for (&v, &m) in v.iter().zip(&m) {
                assert!(m.unsigned_abs() < 1 << 30);
                if e > MIN_EXP {
                    // The error is at most half a unit of the last place, or a whole unit if the mantissa is clamped,
                    // plus the rounding of f64.
                    let error = (real(v, exp) - real(m.into(), e)).abs();
                    let units = if i64::from(m.abs()) == LIMIT {
                        1.0
                    } else {
                        0.5
                    };
                    assert!(error <= (units + 1e-6) * f64::from(-e).exp2());
                }
            }
            if e < MAX_EXP {
                assert!(m.iter().any(|m| m.unsigned_abs() >= 1 << 29));
            }
        });
    }

    /// Tests magnitudes next to powers of two, where rounding carries, zeros, and exponents at both ends.
    #[test]
    fn rows_are_normalized_as_their_numbers_are() {
        cases(1 << 14, |random| {
            let spread = [0, 3, 40, 200][random.random_range(0..4)];
            let middle = random.random_range(-200..200);
            let exps = [(); 3].map(|()| middle + random.random_range(-spread..=spread));
            let numbers: [BlockFloat; 9] = core::array::from_fn(|at| {
                let value = match random.random_range(0..5) {
                    0 => 0,
                    1 => {
                        let edge = 1_i64 << random.random_range(0..63);
                        let beside = edge + random.random_range(-2..=2) * ((edge >> 31).max(2) / 2);
                        if random.random() { beside } else { -beside }
                    }
                    _ => random.random::<i64>() >> random.random_range(0..64),
                };
                BlockFloat::new(value, exps[at / 3])
            });
            let (mut rows, mut one_by_one) = ([[0; 3]; 3], [0; 9]);
            let values = [0, 3, 6].map(|at| [0, 1, 2].map(|i| numbers[at + i].value));
            let exp = normalize_rows(&mut rows, &values, &exps);
            let expected = normalize(&mut one_by_one, &numbers);
            assert_eq!(
                (rows.as_flattened(), exp),
                (&one_by_one[..], expected),
                "{numbers:?}"
            );
        });
    }

    /// A sum with a zero is the other number, rounded to 61 bits. Some numbers lie just below the middle between two
    /// mantissas, and at the middle once they are rounded.
    #[test]
    fn adding_zero_rounds_to_61_bits() {
        cases(1 << 12, |random| {
            let value = if random.random() {
                random.random_range(1_i64 << 29..1 << 30) << 33 | ((1 << 32) - 1)
            } else {
                random.random::<i64>() >> random.random_range(0..64)
            };
            let number = BlockFloat::new(value, random.random_range(-20..70));
            let exp = number.finest(61);
            let expected = BlockFloat::new(number.at(exp), exp).rounded();
            let zero = BlockFloat::new(0, random.random_range(-200..200));
            for sum in [number.plus(zero), zero.plus(number)] {
                assert_eq!(sum.rounded(), expected, "{number:?}");
            }
        });
    }

    #[test]
    fn no_exponent_panics() {
        cases(256, |random| {
            let v = random.random::<[i64; 3]>();
            let w = random.random::<[i64; 3]>();
            let exp = random.random::<i32>();
            let other = random.random_range(-200..200);
            let (m, e) = normalized(v, exp);
            assert!((MIN_EXP..=MAX_EXP).contains(&e));
            assert!(m.iter().all(|m| m.unsigned_abs() < 1 << 30));
            for (v, w) in v.into_iter().zip(w) {
                let _ = BlockFloat::new(v, 100).plus(BlockFloat::new(w, other));
            }
            let _ = fixed(v[0], other, 16);
        });
    }

    #[test]
    fn sums_keep_sixty_bits() {
        cases(256, |random| {
            let a = random.random::<i64>();
            let b = random.random::<i64>();
            let cut = random.random_range(0_u32..64);
            let a_exp = random.random_range(-99..99);
            let b_exp = random.random_range(-99..99);
            let b = b >> cut;
            let sum = BlockFloat::new(a, a_exp).plus(BlockFloat::new(b, b_exp));
            let expected = real(a, a_exp) + real(b, b_exp);
            let size = real(a, a_exp).abs() + real(b, b_exp).abs();
            assert!((real(sum.value, sum.exp) - expected).abs() <= size * f64::from(-50).exp2());
        });
    }

    #[test]
    fn ratios_have_thirty_bits() {
        cases(256, |random| {
            let a = random.random::<i64>();
            let b = random.random::<i64>();
            let cut = [random.random_range(0_u32..63), random.random_range(0..63)];
            let (a, b) = (a >> cut[0], (b >> cut[1]).saturating_abs().max(1));
            let q = BlockFloat::new(a, 0).over(BlockFloat::new(b, 0));
            #[allow(clippy::cast_precision_loss)]
            let expected = a as f64 / b as f64;
            // Both operands are rounded to 31 bits; the rounding of the quotient is far smaller.
            let error = (real(q.value, q.exp) - expected).abs();
            assert!(error <= 1.3 * f64::from(-30).exp2() * expected.abs());
        });
    }
}
