//! The interpolation modes: how attributes are recovered along a run.

use super::reciprocal::reciprocal;
use super::run::{Pixels, Run};

/// A way to recover the attributes along a run of pixels.
///
/// The one seam at which speed is traded for accuracy. An implementation walks the run, asks
/// [`Pixels::visible`] of each pixel first, and recovers the attributes of those that are. It must
/// depend on nothing but the run, so that every band and every target draws the same.
pub trait Interpolate {
    /// Whether attributes are divided by 1/w; otherwise [`Run::p`] carries them alone, times 2³⁰.
    const PERSPECTIVE: bool;

    /// Draws `pixels` along `run`.
    fn run<T, const N: usize>(
        run: Run<N>,
        cells: impl Iterator<Item = T>,
        pixels: &mut impl Pixels<T, N>,
    );
}

/// Perspective-correct at every pixel, by the exact [`reciprocal`] of 1/w.
///
/// No pixel depends on one before it. Given the run's values, an attribute is rounded down to its
/// unit; the reciprocal adds less than 2⁻³¹ of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

impl Interpolate for Exact {
    const PERSPECTIVE: bool = true;

    #[inline]
    fn run<T, const N: usize>(
        mut run: Run<N>,
        cells: impl Iterator<Item = T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        for cell in cells {
            if pixels.visible(&cell, run.q) {
                pixels.shade(cell, run.q, divide(&run));
            }
            run.step();
        }
    }
}

/// The attributes at the run's present pixel: p / q · 2^bits, rounded down.
#[inline]
fn divide<const N: usize>(run: &Run<N>) -> [i32; N] {
    let up = (run.q | 1).leading_zeros();
    let r = i64::from(reciprocal(run.q << up));
    let mut varyings = [0; N];
    for ((value, p), bits) in varyings.iter_mut().zip(run.p).zip(run.bits) {
        // With q' = q << up, r = 2^63 / q' and p' = p/2 << up, whose last bit is below what steps
        // round: |p'| ≤ q'/4 ≤ 2^30 but for rounding, and p' · r is p/q in units of 2^-62.
        let quotient = ((i64::from((p >> 1) << up) * r) >> 32) as i32;
        *value = scaled(quotient, bits);
    }
    varyings
}

/// A value of at most half in units of 2⁻³⁰, times 2^`bits`, rounded down.
///
/// Saturates, as rounding may have taken it beyond a half, and twice the half wraps where `bits` is 32.
#[inline]
fn scaled(value: i32, bits: u32) -> i32 {
    let value = value.clamp(-(1 << 29), (1 << 29) - 1);
    (value >> 30u32.saturating_sub(bits)) << bits.saturating_sub(30)
}

/// Linear on the screen: exact under a parallel projection, which always takes this mode.
///
/// Under perspective it bends textures; [`Exact`] does not.
#[derive(Clone, Copy, Debug, Default)]
pub struct Linear;

impl Interpolate for Linear {
    const PERSPECTIVE: bool = false;

    #[inline]
    fn run<T, const N: usize>(
        mut run: Run<N>,
        cells: impl Iterator<Item = T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        for cell in cells {
            if pixels.visible(&cell, run.q) {
                let mut varyings = [0; N];
                for ((value, p), bits) in varyings.iter_mut().zip(run.p).zip(run.bits) {
                    *value = scaled(p, bits);
                }
                pixels.shade(cell, run.q, varyings);
            }
            run.step();
        }
    }
}
