//! Points: one pixel each.

use super::{Window, align, span, weights};
use crate::geometry::Projected;
use crate::interpolate::{Interpolate, Run, Weighted};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};

/// Draws the pixel that a point lies in.
pub(crate) fn point<I, F, O, D, const N: usize>(
    canvas: &mut Canvas<'_, F::Color, O, D>,
    window: &Window,
    at: &Projected,
    varyings: [i32; N],
    (fragment, depth_shift): (&F, impl Fn(i32) -> u32),
) where
    I: Interpolate,
    F: Fragment<N>,
    O: Storage<F::Color>,
    D: DepthBuffer,
{
    let [x, y] = at.screen.map(|position| position >> 8);
    if !window.columns.contains(&x) || !window.rows.contains(&y) {
        return;
    }
    let ([q], exponent) = align(&[*at]);
    let weighted = Weighted::new(&[varyings], weights::<I, 1>([q]));
    let run = Run {
        q,
        dq: 0,
        p: weighted.p.map(|[p]| p),
        dp: [0; N],
        bits: weighted.bits,
    };
    span::<I, F, O, D, N>(
        canvas,
        (y, x..x + 1),
        |_| run,
        (fragment, depth_shift(exponent)),
    );
}
