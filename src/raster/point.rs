//! Points: one pixel each.

use super::{Planes, Window, align, span, weights};
use crate::geometry::Projected;
use crate::interpolate::{Interpolate, Slope, Weighted};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};

/// Draws the pixel that a point lies in.
pub(crate) fn point<I, F, O, D, const N: usize>(
    canvas: &mut Canvas<'_, F::Color, O, D>,
    window: &Window,
    at: &Projected,
    varyings: [i32; N],
    (fragment, depth_shift): (&F, impl Fn(u8) -> u32),
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
    // Level planes, so that a point is drawn as a span of one pixel.
    let slope = Slope::along(x << 8, 256);
    let planes = Planes::new(
        slope,
        slope.line([q.cast_signed(); 2]),
        weighted.p.map(|[p]| slope.line([p; 2])),
        weighted.scale,
    );
    let paint = (fragment, depth_shift(exponent));
    span::<I, F, O, D, N>(canvas, (y, x..x + 1), &planes, [0; 2], paint);
}
