//! Straight pieces. At their ends, varyings are correct in perspective.

use super::pixels::{Count, Numbers, Pixels, Scales, Span, rolled};
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, Storage};
use crate::num::short_reciprocal;
use crate::num::wide::{product, times_17_bits};
use crate::shade::Lanes;

impl<S: Shading, O: Storage<S::Color>, D: DepthBuffer> Pixels<S, O, D> {
    /// Draws a span in straight pieces of 2^`length` pixels, where `length` is 1 to 6.
    ///
    /// 1/w must be from 2^29 to 2^31 at all pixels. The reciprocals at the ends of pieces have 16 bits; two Newton
    /// steps compute each reciprocal from the one before.
    #[inline(always)]
    pub(super) fn pieces(
        mut self,
        span: &Span<Count<S>>,
        mut cells: Cells<'_, S::Color, O, D>,
        scales: Scales<S>,
        length: u32,
    ) {
        let mut span = span.clone();
        // Removes two bits, so that a product with a reciprocal of up to 17 bits has no more than 45 bits.
        span.p = Count::<S>::map(&span.p, |p| p >> 2);
        span.dp = Count::<S>::map(&span.dp, |p| p >> 2);
        let (dq, dp, down) = (span.dq, span.dp, span.down);
        let (mut q, mut p, mut left) = (span.q, span.p, span.count as u32);
        let mut inverse = short_reciprocal(q >> 15);
        let mut values = varyings::<S>(&p, &scales, inverse);
        loop {
            // A piece ends where the next piece begins. The last piece ends at the span's last pixel, because varyings
            // may have any value beyond the span.
            let count = 1 << length;
            let is_last = left <= count;
            let pixels_on = if is_last { left.wrapping_sub(1) } else { count };
            let ahead = pixels_on.cast_signed();
            let q_end = q.wrapping_add_signed(dq.wrapping_mul(ahead));
            let p_end =
                Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(step.wrapping_mul(ahead)));
            inverse = refined(q_end, inverse);
            let at_end = varyings::<S>(&p_end, &scales, inverse);
            let gains = Count::<S>::zip(&at_end, &values, |end, value| {
                let change = end.wrapping_sub(*value);
                if is_last {
                    divided(change, pixels_on)
                } else {
                    change >> length
                }
            });
            let first = if is_last { left } else { count };
            for cell in cells.first(first as usize) {
                rolled();
                if self.visible(&cell.1, q, down) {
                    self.shade(cell, values);
                }
                q = q.wrapping_add_signed(dq);
                values = Count::<S>::zip(&values, &gains, |value, gain| value.wrapping_add(*gain));
            }
            if is_last {
                return;
            }
            left -= count;
            (q, p, values) = (q_end, p_end, at_end);
        }
    }
}

/// 2^31 / (q / 2^15), from an `inverse` with a relative error of up to 1/16. Two Newton steps reduce the error to
/// 2^-16.
#[inline]
fn refined(q: u32, mut inverse: u32) -> u32 {
    let q = q >> 15;
    for _ in 0..2 {
        // q · inverse is near 2^31. The difference has 28 bits.
        let residual = (1_u32 << 31)
            .wrapping_sub(q.wrapping_mul(inverse))
            .cast_signed();
        let more = inverse.cast_signed().wrapping_mul(residual >> 13) >> 18;
        inverse = inverse.wrapping_add_signed(more);
    }
    inverse
}

/// Entry n is 2^30 / n, rounded down. Entry 0 is for a piece of a single pixel.
const RECIPROCALS: [i32; 64] = {
    let mut parts = [0; 64];
    let (mut at, mut n) = (1, 1);
    while at < parts.len() {
        parts[at] = (1 << 30) / n;
        (at, n) = (at + 1, n + 1);
    }
    parts
};

/// `change` / n for an n below 64, rounded down. If `change` is large, the rounding of the table adds an error of up to
/// two units.
#[inline]
fn divided(change: i32, n: u32) -> i32 {
    (product(change, RECIPROCALS[(n & 63) as usize]) >> 30) as i32
}

/// The varyings at a pixel, where `inverse` is the reciprocal of 1/w.
#[inline]
fn varyings<S: Shading>(p: &Numbers<S>, scales: &Scales<S>, inverse: u32) -> Numbers<S> {
    Count::<S>::zip(p, scales, |p, scale| {
        // `inverse` is 2^46 / q, and p is already divided by 4, so the product is p / q in units of 2^-44.
        times_17_bits(*p, inverse) >> (30u32.wrapping_sub(scale.bits()) & 31)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tests all lengths of a piece, with changes up to the largest.
    #[test]
    fn a_divided_change_is_rounded_down() {
        for n in 1..64_u32 {
            for change in [0, 1, 63, -1, -64, 1_000_003, -(1 << 28), i32::MAX, i32::MIN] {
                let exact = f64::from(change) / f64::from(n);
                let lacks = exact - f64::from(divided(change, n));
                // An entry of the table is too small by up to one unit, 2^-30, so the quotient of a change of 31 bits
                // lacks up to two units more.
                assert!((-2.0..3.).contains(&lacks), "{change} / {n}: {lacks}");
            }
        }
    }

    /// Tests every divisor, with guesses that have a relative error of up to a sixteenth.
    ///
    /// The first step leaves a relative error of 2^-8, and its products cut off one unit and 2^-18. The second step
    /// leaves the square of this error, 1.02 · 2^-16, and its products cut off as much again. The result of a step
    /// never exceeds the exact value, so no guess has more than 17 bits.
    #[test]
    fn two_steps_refine_every_reciprocal_to_16_bits() {
        for q in 1_u32 << 14..1 << 16 {
            let exact = 2_f64.powi(31) / f64::from(q);
            let allowed = exact * (1.02 * 2_f64.powi(-16) + 2_f64.powi(-18)) + 1.;
            let least = (15_u32 << 27).div_ceil(q);
            let most = ((17 << 27) / q).min(1 << 17);
            // Apart from rounding, the error is greatest for the least or the greatest guess. Because of the rounding,
            // every eighth guess between these two is tested as well.
            for guess in (least..=most).step_by(8).chain([most]) {
                let residual = exact - f64::from(refined(q << 15 | q & 0x7fff, guess));
                assert!(
                    (0. ..=allowed).contains(&residual),
                    "{q} from {guess}: {residual}"
                );
            }
        }
    }
}
