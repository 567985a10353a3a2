//! Points: one pixel each.

use super::{Planes, Window, align, span, varies};
use crate::geometry::{DepthShift, Projected};
use crate::interpolate::{Interpolate, Slope};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};

/// Draws the pixel that a point lies in.
pub(crate) fn point<I, F, O, D, const N: usize>(
    canvas: &mut Canvas<'_, F::Color, O, D>,
    window: &Window,
    at: &Projected,
    varyings: [i32; N],
    (fragment, depth_shift): (&F, DepthShift),
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
    // Level planes, so that a point is drawn as a span of one pixel.
    let planes = if varies::<F, D, N>() {
        let slope = Slope::along(x << 8, 256);
        Planes::new::<I, 2>(slope, [q; 2], &[varyings; 2], Slope::line)
    } else {
        Planes::EVEN
    };
    let paint = (fragment, depth_shift.of(exponent));
    span::<I, F, O, D, N>(canvas, (y, x..x + 1), &planes, [0; 2], paint);
}
