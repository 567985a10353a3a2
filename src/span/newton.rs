//! The reciprocal of 1/w at a pixel, from the reciprocals at the two pixels before it.

use super::pixels::{Count, Pixels, Span, rolled};
use super::scale::Scale;
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, Storage};
use crate::num::reciprocal;
use crate::num::wide::{Word, high, newton_step, product, seldom};
use crate::shade::Lanes;

/// The number of bits of every varying's scale in this kernel: p / q is a varying with this many fraction bits.
pub(super) const FRACTION: u32 = Scale::AFFINE.bits();

impl<S: Shading, O: Storage<S::Color>, D: DepthBuffer> Pixels<S, O, D> {
    /// Draws a span with one Newton step per pixel; the initial guess is on the line through the last two reciprocals.
    ///
    /// The span must meet two conditions: 1/w is from 2^29 to 2^31 at all pixels and changes by at most 2^-6 of itself
    /// per pixel, and all scales have [`FRACTION`] bits.
    #[inline(always)]
    pub(super) fn newton(mut self, span: Span<Count<S>>, mut cells: Cells<'_, S::Color, O, D>) {
        let first = inverse(span.q.cast_signed());
        let Span { dq, dp, down, .. } = span;
        // q is from 2^29 to 2^31, and so is r = 2^60 / q; p is the varying times q · 2^-28.
        let wide = |n: &i32| Word::from(*n);
        let (mut q, mut p) = (wide(&span.q.cast_signed()), Count::<S>::map(&span.p, wide));
        let (dq, dp) = (wide(&dq), Count::<S>::map(&dp, wide));
        let mut r = wide(&first);
        // r changes by about −dq · r² / 2^60 per pixel, so adding dq · r² / 2^60 gives r one pixel before the span.
        let change = high(r, dq);
        let mut guess = r;
        r = r.wrapping_add(high(r, change) << 4);
        // One Newton step: next = guess · (2 − q · guess / 2^60).
        let refine = |q, guess: &mut Word, r: &mut Word| {
            let next = newton_step(q, *guess);
            *guess = (next << 1).wrapping_sub(*r);
            *r = next;
        };
        if Self::SKIPS {
            let mut at = 0;
            while let Some(cell) = cells.at(at) {
                refine(q, &mut guess, &mut r);
                if self.visible(&cell.1, (q as i32).cast_unsigned(), down) {
                    self.shade(cell, Count::<S>::map(&p, |p| high(*p, r) as i32));
                } else if at == 0 && Self::is_long(&cells) {
                    let step = (dq as i32, down);
                    at = self.skip(&cells, (q as i32).cast_unsigned(), step);
                    if at == cells.len() {
                        return;
                    }
                    let steps = Word::from((at as u32).cast_signed());
                    p = Count::<S>::zip(&p, &dp, |p, step| {
                        p.wrapping_add(step.wrapping_mul(steps))
                    });
                    for _ in 1..at {
                        rolled();
                        q = q.wrapping_add(dq);
                        refine(q, &mut guess, &mut r);
                    }
                    q = q.wrapping_add(dq);
                    continue;
                } else {
                    seldom();
                }
                rolled();
                at += 1;
                q = q.wrapping_add(dq);
                p = Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(*step));
            }
            return;
        }
        for cell in cells.first(usize::MAX) {
            refine(q, &mut guess, &mut r);
            if self.visible(&cell.1, (q as i32).cast_unsigned(), down) {
                self.shade(cell, Count::<S>::map(&p, |p| high(*p, r) as i32));
            } else {
                seldom();
            }
            rolled();
            q = q.wrapping_add(dq);
            p = Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(*step));
        }
    }
}

/// Makes a span linear: replaces each p by four times the varying at the first pixel, and each step of p by four times
/// the varying's change per pixel. The linear values are the tangent to the exact varying in the middle of the span.
/// Rounding adds an error of up to 12½ units to a varying.
#[inline(always)]
pub(super) fn tangent<L: Lanes>(span: &mut Span<L>) {
    let middle = (span.count as u32 >> 1).cast_signed();
    let q = span
        .q
        .cast_signed()
        .wrapping_add(span.dq.wrapping_mul(middle));
    let (r, dq) = (inverse(q), span.dq);
    // The varyings p / q in the middle of the span, in units of 2^-30.
    let values = L::zip(&span.p, &span.dp, |p, gain| {
        multiply_30(p.wrapping_add(gain.wrapping_mul(middle)), r)
    });
    // f' = (p' - f · q') / q, where a prime marks a change per pixel.
    span.dp = L::zip(&span.dp, &values, |gain, value| {
        multiply_30(gain.wrapping_sub(multiply_30(*value, dq)), r)
    });
    span.p = L::zip(&values, &span.dp, |value, gain| {
        value.wrapping_sub(gain.wrapping_mul(middle))
    });
}

/// a · b / 2^30, rounded to nearest.
#[inline]
fn multiply_30(a: i32, b: i32) -> i32 {
    ((product(a, b) + (1 << 29)) >> 30) as i32
}

/// 2^60 / q, for a `q` from 2^29 to 2^31.
#[inline]
fn inverse(q: i32) -> i32 {
    let up = q.cast_unsigned().leading_zeros().wrapping_sub(1) & 31;
    (reciprocal(q.cast_unsigned() << up) << up >> 1).cast_signed()
}

#[cfg(test)]
mod tests {
    use super::super::mode::is_level;
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    /// At the ends of a span, the tangent deviates by up to 16 units (and by 2^-16 of 16 units more, because 1/w
    /// changes by up to 2^-16 of itself between the middle and an end). Rounding adds up to 12½ units, as derived in
    /// `bounds`, a module of the tests of accuracy. The error is greatest where 1/w is near 2^29, as in most cases
    /// here.
    #[test]
    fn the_error_of_a_level_row_is_at_most_28_and_a_half_units() {
        cases(256, |random| {
            let size = random.random_range(0_u32..30);
            let rest = random.random_range(0_i32..1 << 30);
            let dq = random.random_range(-255_i32..=255);
            let gain = random.random_range(-1_i32..=1);
            let p = random.random_range(-(1_i32 << 27)..1 << 27);
            let (pixels, middle) = (64, 32);
            // 1/w is at least 2^29 at all pixels.
            let q = (1 << 29) + (64 << 8) + (rest & ((1 << size) - 1));
            // Varyings over w stay within half of 1/w.
            let most = ((1 << 24) / dq.abs().max(1)).min(1 << 22) - dq.abs() - 1;
            let step = if gain == 0 { rest % most } else { gain * most };
            let mut span: Span<[(); 1]> = Span {
                q: q.cast_unsigned(),
                p: [p - middle * step],
                dq,
                dp: [step],
                down: 15,
                count: pixels,
            };
            assert!(is_level(&span));
            let at = |pixel: i32| {
                let [p, q, step, dq, pixel] = [span.p[0], q, step, dq, pixel].map(f64::from);
                (p + step * pixel) / (q + dq * pixel) * 2_f64.powi(28)
            };
            let exact = [0, 63].map(at);
            tangent(&mut span);
            for (pixel, exact) in [0, 63].into_iter().zip(exact) {
                let straight = span.p[0].wrapping_add(span.dp[0].wrapping_mul(pixel));
                let straight = f64::from(straight) / 4.;
                assert!(
                    (straight - exact).abs() <= 28.51,
                    "{straight} is not {exact} at {pixel}"
                );
            }
        });
    }

    #[test]
    fn no_number_out_of_range_panics() {
        for q in [i32::MIN, -1, 0, 1, (1 << 29) - 1] {
            let _ = inverse(q);
        }
        for (q, exact) in [
            (1 << 29, i32::MAX),
            (1 << 30, 1 << 30),
            (3 << 29, 715_827_882),
        ] {
            // The result lacks up to one unit, because the reciprocal is rounded down.
            assert!((exact - inverse(q)).abs() <= 1, "{q}");
        }
    }
}
