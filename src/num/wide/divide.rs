//! A division, and a Newton step toward a reciprocal.

use super::product::product;
use super::{HAS_DSP, IS_NARROW, IS_WIDE, Word};

/// Returns the quotient, rounded down, and the remainder; the divisor must be above 0.
#[inline]
pub(crate) fn divide(numerator: i32, divisor: i32) -> (i32, i32) {
    if IS_NARROW {
        return narrow_divide(numerator, divisor);
    }
    let divisor = divisor.max(1);
    let (quotient, remainder) = (numerator / divisor, numerator % divisor);
    // So far, the quotient is rounded toward zero.
    let below = remainder >> 31;
    (quotient + below, remainder + (divisor & below))
}

/// Returns [`divide`] by subtraction if the quotient is small: a division takes as long as twenty subtractions.
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

/// Returns guess · (2 − q · guess / 2^60): one Newton step from a guess toward r = 2^60 / q. Both `q` and `guess` are
/// from 2^29 to 2^31.
///
/// The guess must be within a quarter of r.
#[inline]
#[allow(clippy::unnecessary_cast)] // necessary if a word has 32 bits
pub(crate) const fn newton_step(q: Word, guess: Word) -> Word {
    if IS_WIDE {
        wide_newton_step(q as i64, guess as i64) as Word
    } else if HAS_DSP {
        dsp_newton_step(q as i32, guess as i32) as Word
    } else {
        short_newton_step(q as i32, guess as i32) as Word
    }
}

#[inline]
const fn short_newton_step(q: i32, guess: i32) -> i32 {
    let residual = (1 << 28) - ((product(q, guess) >> 32) as i32);
    guess.wrapping_add((product(guess, residual << 4) >> 32) as i32)
}

/// Returns [`newton_step`] by the instruction `smmls`, which subtracts a product from a number times 2^32, and returns
/// the upper half of the difference.
#[inline]
#[allow(clippy::cast_lossless, clippy::cast_sign_loss)] // `u64::from` is not const
const fn dsp_newton_step(q: i32, guess: i32) -> i32 {
    let excess = ((product(q, guess) >> 32) as i32) << 4;
    // The guess is widened without its sign, which is shifted out anyway. If the guess were widened as in the product,
    // the compiler would make the guess a common factor.
    let raised = (guess.cast_unsigned() as u64) << 32;
    (raised.wrapping_sub(product(guess, excess).cast_unsigned()) >> 32) as i32
}

/// Returns [`newton_step`] in fewer instructions, for 64-bit cores. The shift discards less than a unit, so the guess
/// can be added before the shift.
#[inline]
const fn wide_newton_step(q: i64, guess: i64) -> i64 {
    let twice = (1_i64 << 29).wrapping_sub(q.wrapping_mul(guess) >> 32);
    guess.wrapping_mul(twice) >> 28
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn quotients_are_rounded_down() {
        cases(256, |random| {
            let numerator = random.random_range(-(1_i32 << 20)..=1 << 20);
            let divisor = random.random_range(1_i32..=1 << 20);
            let size = random.random_range(0_u32..20);
            let divisor = i32::max(divisor >> size, 1);
            let exact = (numerator.div_euclid(divisor), numerator.rem_euclid(divisor));
            assert_eq!(divide(numerator, divisor), exact);
            assert_eq!(narrow_divide(numerator, divisor), exact);
        });
    }

    #[test]
    fn newton_steps_are_alike() {
        cases(256, |random| {
            let q = random.random_range(1_i32 << 29..=i32::MAX);
            let part = random.random_range(-(1_i32 << 28)..=1 << 28);
            let cut = random.random_range(0..28);
            // The guess has a relative error of up to a quarter.
            let r = (1_i64 << 60) / i64::from(q);
            let guess = (r + ((r * i64::from(part >> cut)) >> 30)).min(i32::MAX.into());
            let short = short_newton_step(q, guess as i32);
            assert_eq!(dsp_newton_step(q, guess as i32), short);
            assert_eq!(wide_newton_step(q.into(), guess), i64::from(short));
        });
    }

    /// The residual is rounded by less than 2^-28, and this error is multiplied by 1 − e, which is at most 1.25. The
    /// result is rounded by less than a unit, which is at most 2^-29 of the result.
    #[test]
    fn a_newton_step_squares_the_error() {
        cases(256, |random| {
            let q = random.random_range(1_i32 << 29..=i32::MAX);
            let least = (3_i64 << 58) / i64::from(q);
            let most = ((5_i64 << 58) / i64::from(q)).min(i32::MAX.into());
            let guess = random.random_range(least..=most) as i32;
            let error = |r: i32| 1. - f64::from(q) * f64::from(r) / 2_f64.powi(60);
            let step = short_newton_step(q, guess);
            let off = error(step) - error(guess).powi(2);
            assert!(off.abs() <= 1.25 * 2_f64.powi(-28), "{q}, {guess}: {off}");
        });
    }
}
