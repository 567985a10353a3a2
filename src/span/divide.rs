//! The exact reciprocal of 1/w at every pixel.

use embedded_graphics::geometry::Point;

use super::pixels::{Count, Numbers, Pixels, Scales, Span};
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, Storage};
use crate::num::reciprocal;
use crate::num::wide::product;
use crate::shade::Lanes;

impl<S: Shading, O: Storage<S::Color>, D: DepthBuffer> Pixels<S, O, D> {
    /// Draws a span with a reciprocal at every pixel. A varying is p / q · 2^bits, rounded down, where p and q are
    /// interpolants of the [`Span`], and 2^bits is the varying's [`Scale`](super::scale::Scale).
    #[inline(always)]
    pub(super) fn divide(
        self,
        span: &Span<Count<S>>,
        cells: Cells<'_, S::Color, O, D>,
        scales: Scales<S>,
    ) {
        self.straight::<false>(span.clone(), cells, |_, q, p| quotients::<S>(q, p, &scales));
    }

    /// The same as [`divide`](Self::divide), but out of line, for modes that rarely divide. If the division were
    /// inlined, it would take registers from the mode's own kernel.
    #[inline(never)]
    pub(super) fn divide_apart(
        self,
        span: &Span<Count<S>>,
        cells: Cells<'_, S::Color, O, D>,
        scales: Scales<S>,
    ) {
        self.divide(span, cells, scales);
    }

    /// The same as [`divide`](Self::divide), but `at` computes the interpolants of each pixel. In triangles with a
    /// great range of depths, too many rounding errors would add up from step to step. Depths are still stepped, as in
    /// all modes.
    #[cold]
    #[inline(never)]
    pub(super) fn divide_per_pixel(
        self,
        span: &Span<Count<S>>,
        cells: Cells<'_, S::Color, O, D>,
        scales: Scales<S>,
        at: impl Fn(Point) -> (u32, Numbers<S>),
    ) {
        self.straight::<false>(span.clone(), cells, |pixel, _, _| {
            let (q, p) = at(pixel);
            quotients::<S>(q, &p, &scales)
        });
    }
}

#[inline]
fn quotients<S: Shading>(q: u32, p: &Numbers<S>, scales: &Scales<S>) -> Numbers<S> {
    let up = (q | 1).leading_zeros();
    // The reciprocal of the upper 31 bits of q, because the product below takes signed factors.
    let r = reciprocal((q << up) >> 1).cast_signed();
    Count::<S>::zip(p, scales, |p, scale| {
        // Let p' = p << up and q' = q << up. p' is at most half of q' and so below 2^31, and r = 2^62 / q'. So the
        // product p' · r is p/q in units of 2^-62, and the product's upper half is p/q in units of 2^-30.
        scale.restore((product(*p << up, r) >> 32) as i32)
    })
}
