//! The exact reciprocal of 1/w at every pixel.

use super::pixels::{Count, Numbers, Pixels, Scales, Span};
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, DepthTest, Storage};
use crate::num::reciprocal;
use crate::num::wide::product;
use crate::shade::Lanes;

/// Draws a span whose attributes are p / q · 2^bits at each pixel, rounded down.
#[inline(always)]
pub(super) fn divide<S: Shading, O: Storage<S::Color>, D: DepthBuffer, Z: DepthTest>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    mut pixels: Pixels<S, Z>,
) {
    let (mut q, mut p) = (span.q, span.p);
    let (dq, dp, down) = (span.dq, span.dp, span.down);
    for cell in cells.first(usize::MAX) {
        if pixels.visible::<D>(&cell.1, q, down) {
            pixels.shade::<O>(cell, quotients::<S>(q, &p, &scales));
        }
        q = q.wrapping_add_signed(dq);
        p = Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(*step));
    }
}

/// [`divide`], out of line for modes where it is the exception: inlined, it would take registers from the mode's own
/// kernel.
#[inline(never)]
pub(super) fn divide_apart<S: Shading, O: Storage<S::Color>, D: DepthBuffer, Z: DepthTest>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    cells: Cells<'_, S::Color, O, D>,
    pixels: Pixels<S, Z>,
) {
    divide(span, scales, cells, pixels);
}

/// [`divide`] with interpolants that `at` computes anew for each pixel, counted from 0: for triangles of great depth,
/// where steps would accumulate too much rounding. Depths are stepped, as in all modes.
#[cold]
#[inline(never)]
pub(super) fn divide_anew<S: Shading, O: Storage<S::Color>, D: DepthBuffer, Z: DepthTest>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    at: impl Fn(i32) -> (u32, Numbers<S>),
    mut cells: Cells<'_, S::Color, O, D>,
    mut pixels: Pixels<S, Z>,
) {
    let mut span = span.clone();
    for (x, cell) in (0..).zip(cells.first(usize::MAX)) {
        if pixels.visible::<D>(&cell.1, span.q, span.down) {
            let (q, p) = at(x);
            pixels.shade::<O>(cell, quotients::<S>(q, &p, &scales));
        }
        span.step();
    }
}

#[inline]
fn quotients<S: Shading>(q: u32, p: &Numbers<S>, scales: &Scales<S>) -> Numbers<S> {
    let up = (q | 1).leading_zeros();
    // 31 bits, so that the product below is one of signed numbers.
    let r = reciprocal((q << up) >> 1).cast_signed();
    Count::<S>::zip(p, scales, |p, scale| {
        // Let p' = p << up and q' = q << up. p' is at most half of q' and so below 2^31, and r = 2^62 / q'. So p' · r
        // is p/q in units of 2^-62, and its upper half is p/q in units of 2^-30.
        scale.restore((product(*p << up, r) >> 32) as i32)
    })
}
