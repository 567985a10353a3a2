//! The reciprocal of one pixel from those of the two before it, or none where none is needed.

use super::affine::{Affine, straight};
use super::mode::{Exact, Interpolate};
use super::run::{Cells, FAR, Pixels, Run, Scale, Steps, rolled};
use super::tolerance::Tolerance;
use crate::num::reciprocal;
use crate::num::wide::product;

/// Perspective-correct at every pixel, by one Newton step from the two pixels before it: the default.
///
/// Two pixels' reciprocals of 1/w, extended in a line, are off at the third by 2δ² of it, where 1/w changes by
/// δ of itself from pixel to pixel; a Newton step squares that, and δ is at most 2⁻⁶: the reciprocal is
/// right to 2⁻²¹ of itself. Where 1/w changes faster, or to less than half along a run, the run is
/// [`Exact`]. An attribute is off by up to 57 of its units besides (a texture coordinate by less than 0.0008 texels)
/// and by what [`Exact`] may be.
///
/// Where it makes no difference, nothing is divided: a row in which 1/w hardly changes, such as of a floor under
/// a camera that does not roll, is drawn straight where that is off by 16 units at most, and a triangle that hardly changes
/// in depth where that is off by what its shader allows ([`TOLERANCES`](crate::Shader::TOLERANCES)): 16 units of a texture
/// coordinate, an eighth of a step of colours, so that nearly all triangles of a model are that have a colour at each vertex.
///
/// A run begins with the exact reciprocal, every 64 pixels and at every triangle's edge, so that
/// bands and frames are alike.
///
/// ```
/// use fixel::{DrawOptions, interpolate::Newton};
/// let default: DrawOptions<Newton> = DrawOptions::new();
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Newton;

/// 1/w may change by 2^-6 of itself from a pixel to the next.
const STEEPEST: u32 = 6;
/// Bits of a fraction p/q as it comes out.
const FRACTION: u32 = Scale::AFFINE.bits();
/// Bits of the step of a 1/w that hardly changes along a row.
const LEVEL: u32 = 8;

/// What a texture coordinate may be off by where nothing is divided: 1/4096 of a texel.
const TEXEL_TOLERANCE: u32 = 16;

/// How a triangle is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plan {
    /// Each run as it is found to be.
    #[default]
    Runs,
    /// All runs are gentle: 1/w has room for Newton steps.
    Gentle,
    /// Without regard to 1/w.
    Affine,
}

impl Interpolate for Newton {
    const PERSPECTIVE: bool = true;
    const LEAST_BITS: u32 = FRACTION;

    type Parallel = Affine;
    type Plan = Plan;

    #[inline]
    fn parallel(self) -> Affine {
        Affine
    }

    #[inline]
    fn affine_within(&self, tolerance: Tolerance) -> u32 {
        match tolerance {
            Tolerance::Texels => TEXEL_TOLERANCE,
            Tolerance::Units(units) => units,
        }
    }

    #[inline]
    fn plan<const N: usize>(&self, steps: &Steps<N>) -> Plan {
        if steps.is_affine {
            return Plan::Affine;
        }
        // The largest has bit 30 set.
        let is_gentle = steps.least > FAR
            && steps.q.unsigned_abs() <= steps.least >> STEEPEST
            && steps.scale.iter().all(|scale| scale.bits() == FRACTION);
        if is_gentle { Plan::Gentle } else { Plan::Runs }
    }

    #[inline]
    fn run<T, const N: usize>(
        &self,
        plan: Plan,
        mut run: Run<N>,
        steps: &Steps<N>,
        mut cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        let (mut dq, mut dp, mut down) = (steps.q, steps.p, steps.depth);
        if N > 0 && plan == Plan::Runs {
            let is_fine = steps.scale.iter().all(|scale| scale.bits() <= FRACTION);
            let Some(up) = room(run.q, steps.q, cells.count()).filter(|_| is_fine) else {
                return Exact.run((), run, steps, cells, pixels);
            };
            (run.q, dq, down) = (run.q << up, dq << up, down.saturating_add(up));
            for ((p, dp), scale) in run.p.iter_mut().zip(&mut dp).zip(steps.scale) {
                let (left, right) = scale.to(FRACTION, up);
                *p = nearest(*p << left, right);
                *dp = nearest(*dp << left, right);
            }
        }
        if N == 0 || plan == Plan::Affine || is_level(dq, &dp) {
            if plan != Plan::Affine {
                chord(&mut run, dq, &mut dp, cells.count());
            }
            return straight(run, dq, dp, down, cells, pixels);
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

/// Whether 1/w changes so little along a row that attributes are straight to 2^-12 of a texel.
///
/// From the straight line that touches them in the middle of 64 pixels they deviate by |f'| · δ · 32² at the ends, where
/// an attribute changes by f' a pixel and 1/w by δ of itself.
#[inline]
fn is_level<const N: usize>(dq: i32, dp: &[i32; N]) -> bool {
    let step = dq.unsigned_abs();
    // f' = (p' - f · q') / q, where |f| is at most half in units of 2^28, and δ = q' / q, with q at least 2^29: the
    // product of the dividends is to be below 2^4 · 2^(58 - 28 - 10).
    step >> LEVEL == 0
        && dp.iter().all(|p| {
            let gain = p.unsigned_abs().saturating_add(step);
            gain >> (32 - LEVEL) == 0 && gain.wrapping_mul(step) < 1 << 24
        })
}

/// Makes of interpolants the attributes at the first of so many pixels and what a pixel adds to them, as
/// [`straight`] has them: the straight line that touches them in the middle, rounded by up to 12½ units of an attribute.
#[inline]
fn chord<const N: usize>(run: &mut Run<N>, dq: i32, gains: &mut [i32; N], pixels: usize) {
    let middle = (pixels as u32 >> 1).cast_signed();
    let r = inverse(run.q.cast_signed().wrapping_add(dq.wrapping_mul(middle)));
    for (p, gain) in run.p.iter_mut().zip(gains) {
        // p / q in units of 2^-30.
        let value = fine(p.wrapping_add(gain.wrapping_mul(middle)), r);
        // f' = (p' - f · q') / q.
        *gain = fine(gain.wrapping_sub(fine(value, dq)), r);
        *p = value.wrapping_sub(gain.wrapping_mul(middle));
    }
}

/// a · b / 2^30, to the nearest.
#[inline]
fn fine(a: i32, b: i32) -> i32 {
    ((product(a, b) + (1 << 29)) >> 30) as i32
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
    use proptest::prelude::*;

    proptest! {
        /// The line is 16 units away at its ends (and 2^-16 of that, as 1/w changes by up to 2^-16 from the middle), and 12½ are of
        /// rounding, as the tests' `bounds` have it. Most where 1/w is near 2^29, as it is in most cases here.
        #[test]
        fn a_level_row_is_off_by_28_units_and_a_half(
            size in 0_u32..30,
            rest in 0_i32..1 << 30,
            dq in -255_i32..=255,
            gain in -1_i32..=1,
            p in -(1_i32 << 27)..1 << 27,
        ) {
            let (pixels, middle) = (64, 32);
            // 1/w is from 2^29 in all pixels.
            let q = (1 << 29) + (64 << LEVEL) + (rest & ((1 << size) - 1));
            // Attributes over w stay within half of that.
            let most = ((1 << 24) / dq.abs().max(1)).min(1 << 22) - dq.abs() - 1;
            let step = if gain == 0 { rest % most } else { gain * most };
            prop_assert!(is_level(dq, &[step]));
            let mut gains = [step];
            let mut run = Run { q: q.cast_unsigned(), p: [p - middle * step] };
            let at = |pixel: i32| {
                let [p, q, step, dq, pixel] = [run.p[0], q, step, dq, pixel].map(f64::from);
                (p + step * pixel) / (q + dq * pixel) * 2_f64.powi(28)
            };
            let exact = [0, 63].map(at);
            chord(&mut run, dq, &mut gains, pixels);
            for (pixel, exact) in [0, 63].into_iter().zip(exact) {
                let straight = f64::from(run.p[0].wrapping_add(gains[0].wrapping_mul(pixel))) / 4.;
                prop_assert!((straight - exact).abs() <= 28.51, "{straight} is not {exact} at {pixel}");
            }
        }
    }

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
