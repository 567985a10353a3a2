//! The exact reciprocal of 1/w at every pixel.

use embedded_graphics::geometry::Point;

use super::pixels::{CellsOf, Count, Numbers, Pixels, Scales, Span, Target};
use super::shading::Shading;
use crate::num::reciprocal;
use crate::num::wide::product;
use crate::shade::Lanes;

impl<S: Shading<Color = T::Color>, T: Target> Pixels<S, T> {
    /// Draws a span. At each pixel, an attribute is p / q · 2^bits, rounded down.
    #[inline(always)]
    pub(super) fn divide(self, span: &Span<Count<S>>, cells: CellsOf<'_, T>, scales: Scales<S>) {
        self.straight(span.clone(), cells, |_, q, p| quotients::<S>(q, p, &scales));
    }

    /// [`divide`](Self::divide) out of line, for modes that rarely divide. Inlined, the division would take registers
    /// from the mode's own kernel.
    #[inline(never)]
    pub(super) fn divide_apart(
        self,
        span: &Span<Count<S>>,
        cells: CellsOf<'_, T>,
        scales: Scales<S>,
    ) {
        self.divide(span, cells, scales);
    }

    /// The same as [`divide`](Self::divide), but `at` computes the interpolants of each pixel. In triangles of great
    /// depth, stepping the interpolants would add up too much rounding. Depths are stepped, like in all modes.
    #[cold]
    #[inline(never)]
    pub(super) fn divide_anew(
        self,
        span: &Span<Count<S>>,
        cells: CellsOf<'_, T>,
        scales: Scales<S>,
        at: impl Fn(Point) -> (u32, Numbers<S>),
    ) {
        self.straight(span.clone(), cells, |pixel, _, _| {
            let (q, p) = at(pixel);
            quotients::<S>(q, &p, &scales)
        });
    }
}

#[inline]
fn quotients<S: Shading>(q: u32, p: &Numbers<S>, scales: &Scales<S>) -> Numbers<S> {
    let up = (q | 1).leading_zeros();
    // The reciprocal of 31 bits of q, so that the factors of the product below can be signed numbers.
    let r = reciprocal((q << up) >> 1).cast_signed();
    Count::<S>::zip(p, scales, |p, scale| {
        // Let p' = p << up and q' = q << up. p' is at most half of q' and so below 2^31, and r = 2^62 / q'. So the
        // product p' · r is p/q in units of 2^-62, and the product's upper half is p/q in units of 2^-30.
        scale.restore((product(*p << up, r) >> 32) as i32)
    })
}
