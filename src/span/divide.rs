//! The exact reciprocal of 1/w at every pixel.

use embedded_graphics::geometry::Point;

use super::pixels::{Count, Numbers, Pixels, Scales, Span};
use super::shading::Shading;
use super::straight::straight;
use crate::canvas::{Cells, DepthBuffer, Storage};
use crate::num::reciprocal;
use crate::num::wide::product;
use crate::shade::Lanes;

/// Draws a span whose attributes are p / q · 2^bits at each pixel, rounded down.
#[inline(always)]
pub(super) fn divide<S: Shading, O: Storage<S::Color>, D: DepthBuffer>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    cells: Cells<'_, S::Color, O, D>,
    pixels: Pixels<S>,
) {
    let restore = |_, q, p: &Numbers<S>| quotients::<S>(q, p, &scales);
    straight(span.clone(), restore, cells, pixels);
}

/// [`divide`], out of line for modes where it is the exception: inlined, it would take registers from the mode's own
/// kernel.
#[inline(never)]
pub(super) fn divide_apart<S: Shading, O: Storage<S::Color>, D: DepthBuffer>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    cells: Cells<'_, S::Color, O, D>,
    pixels: Pixels<S>,
) {
    divide(span, scales, cells, pixels);
}

/// [`divide`] with interpolants that `at` computes anew for each pixel: for triangles of great depth, where steps would
/// accumulate too much rounding. Depths are stepped, as in all modes.
#[cold]
#[inline(never)]
pub(super) fn divide_anew<S: Shading, O: Storage<S::Color>, D: DepthBuffer>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    at: impl Fn(Point) -> (u32, Numbers<S>),
    cells: Cells<'_, S::Color, O, D>,
    pixels: Pixels<S>,
) {
    let restore = |pixel, _, _: &Numbers<S>| {
        let (q, p) = at(pixel);
        quotients::<S>(q, &p, &scales)
    };
    straight(span.clone(), restore, cells, pixels);
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
