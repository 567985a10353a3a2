//! The reciprocal of one pixel from those of the two before it.

use super::affine::Affine;
use super::mode::{Exact, Interpolate};
use super::reciprocal::reciprocal;
use super::run::{Cells, FAR, Pixels, Run, Steps, rolled};
use crate::linear::product;

/// Perspective-correct at every pixel, by one Newton step from the two pixels before it: the default.
///
/// Two pixels' reciprocals of 1/w, extended in a line, are off at the third by 2δ² of it, where 1/w changes by
/// δ of itself from pixel to pixel; a Newton step squares that, and δ is at most 2⁻⁶: the reciprocal is
/// right to 2⁻²¹ of itself. Where 1/w changes faster, or to less than half along a run, the run is
/// [`Exact`]. An attribute is off by up to 30 of its units besides (a texture coordinate by a two-thousandth of a
/// texel) and by what [`Exact`] may be.
///
/// A run begins with the exact reciprocal, every 64 pixels and at every triangle's edge, so that
/// bands and frames are alike.
///
/// ```
/// use fixel::{Pass, interpolate::Newton};
/// let default: Pass<Newton> = Pass::new();
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Newton;

/// 1/w may change by 2^-6 of itself from a pixel to the next.
const STEEPEST: u32 = 6;
/// Bits of a fraction p/q as it comes out.
const FRACTION: u32 = 28;

impl Interpolate for Newton {
    const PERSPECTIVE: bool = true;
    const LEAST_BITS: u32 = FRACTION;

    type Parallel = Affine;
    /// Whether all of a triangle's runs are gentle.
    type Plan = bool;

    #[inline]
    fn parallel(self) -> Affine {
        Affine
    }

    #[inline]
    fn plan<const N: usize>(&self, steps: &Steps<N>) -> bool {
        // The largest has bit 30 set.
        steps.least > FAR
            && steps.q.unsigned_abs() <= steps.least >> STEEPEST
            && steps.scale.iter().all(|scale| scale.bits() == FRACTION)
    }

    #[inline]
    fn run<T, const N: usize>(
        &self,
        is_gentle: bool,
        mut run: Run<N>,
        steps: &Steps<N>,
        mut cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        let (mut dq, mut dp, mut down) = (steps.q, steps.p, steps.depth);
        if !is_gentle {
            let is_fine = steps.scale.iter().all(|scale| scale.bits() <= FRACTION);
            let Some(up) = room(run.q, steps.q, cells.count()).filter(|_| is_fine) else {
                return Exact.run((), run, steps, cells, pixels);
            };
            (run.q, dq, down) = (run.q << up, dq << up, (down + up).min(31));
            for ((p, dp), scale) in run.p.iter_mut().zip(&mut dp).zip(steps.scale) {
                let (left, right) = scale.to(FRACTION, up);
                *p = nearest(*p << left, right);
                *dp = nearest(*dp << left, right);
            }
        }
        // q from 2^29 to 2^31, r = 2^60 / q from 2^29 to 2^31; p is 2^-28 q times the attribute.
        let (mut q, mut p) = (run.q.cast_signed(), run.p);
        let mut r = inverse(q);
        // r changes by -dq · r² / 2^60.
        let change = high(r, dq);
        let mut guess = r;
        r = r.wrapping_add(high(r, change) << 4);
        for cell in cells.first(usize::MAX) {
            rolled();
            let lacks = (1 << FRACTION) - high(q, guess);
            let next = guess.wrapping_add(high(guess, lacks << 4));
            guess = (next << 1).wrapping_sub(r);
            r = next;
            if pixels.visible(&cell, q.cast_unsigned(), down) {
                pixels.shade(cell, p.map(|p| high(p, r)));
            }
            q = q.wrapping_add(dq);
            for (p, step) in p.iter_mut().zip(dp) {
                *p = p.wrapping_add(step);
            }
        }
    }
}

#[inline]
fn high(a: i32, b: i32) -> i32 {
    (product(a, b) >> 32) as i32
}

/// 2^60 / q, for a `q` from 2^29 to 2^31.
#[inline]
fn inverse(q: i32) -> i32 {
    let up = q.cast_unsigned().leading_zeros().wrapping_sub(1) & 31;
    (reciprocal(q.cast_unsigned() << up) << up >> 1).cast_signed()
}

/// `value` / 2^`down`, to the nearest.
#[inline]
fn nearest(value: i32, down: u32) -> i32 {
    value.wrapping_add(1 << down >> 1) >> down
}

/// By how much the interpolants of a run can be shifted up so that 1/w is from 2^29 to 2^31; `None` if
/// it changes too much along the run, or too fast.
#[inline(never)]
pub(super) fn room(q: u32, step: i32, length: usize) -> Option<u32> {
    let others = (length as u32).cast_signed().wrapping_sub(1);
    let last = q.wrapping_add_signed(step.wrapping_mul(others));
    let (least, most) = (q.min(last), q.max(last));
    let is_gentle =
        step.unsigned_abs() <= least >> STEEPEST && least > most >> 1 && most >> 31 == 0;
    is_gentle.then(|| (most | 1).leading_zeros().wrapping_sub(1) & 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_out_of_range_is_survived() {
        for q in [i32::MIN, -1, 0, 1, (1 << 29) - 1] {
            let _ = inverse(q);
        }
        for (q, exact) in [
            (1 << 29, i32::MAX),
            (1 << 30, 1 << 30),
            (3 << 29, 715_827_882),
        ] {
            // The reciprocal is rounded down, to 31 bits of 2^61 / q.
            assert!((exact - inverse(q)).abs() <= 1, "{q}");
        }
    }
}
