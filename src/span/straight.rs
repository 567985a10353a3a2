//! Interpolants that are linear along the span: only additions.

use embedded_graphics::geometry::Point;

use super::pixels::{Count, Numbers, Pixels, Scales, Span, rolled};
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, Storage};
use crate::num::wide::seldom;
use crate::shade::Lanes;

impl<S: Shading, O: Storage<S::Color>, D: DepthBuffer> Pixels<S, O, D> {
    /// Draws a span; `restore` turns a pixel's 1/w and interpolants into varyings. With `SKIP`, hidden pixels at the start
    /// of the span are skipped: not with a `restore` that divides or beside the kernel for pieces, which need the
    /// registers.
    #[inline(always)]
    pub(super) fn straight<const SKIP: bool>(
        mut self,
        span: Span<Count<S>>,
        mut cells: Cells<'_, S::Color, O, D>,
        restore: impl Fn(Point, u32, &Numbers<S>) -> Numbers<S>,
    ) {
        let (mut q, mut p) = (span.q, span.p);
        let (dq, dp, down) = (span.dq, span.dp, span.down);
        if SKIP && Self::SKIPS {
            let mut at = 0;
            while let Some(cell) = cells.at(at) {
                if self.visible(&cell.1, q, down) {
                    let numbers = restore(self.point, q, &p);
                    self.shade(cell, numbers);
                } else if at == 0 && Self::is_long(&cells) {
                    at = self.skip(&cells, q, (dq, down));
                    let steps = (at as u32).cast_signed();
                    q = q.wrapping_add_signed(dq.wrapping_mul(steps));
                    p = Count::<S>::zip(&p, &dp, |p, step| {
                        p.wrapping_add(step.wrapping_mul(steps))
                    });
                    continue;
                } else {
                    seldom();
                }
                rolled();
                at += 1;
                q = q.wrapping_add_signed(dq);
                p = Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(*step));
            }
            return;
        }
        for cell in cells.first(usize::MAX) {
            if self.visible(&cell.1, q, down) {
                let numbers = restore(self.point, q, &p);
                self.shade(cell, numbers);
            } else {
                seldom();
            }
            rolled();
            q = q.wrapping_add_signed(dq);
            p = Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(*step));
        }
    }

    /// The same as [`straight`](Self::straight), for varyings that are fractions in units of 2^-30, each with its own
    /// scale. It is out of line because it is rarely needed.
    #[inline(never)]
    pub(super) fn scaled(
        self,
        span: &Span<Count<S>>,
        cells: Cells<'_, S::Color, O, D>,
        scales: Scales<S>,
    ) {
        self.straight::<true>(span.reloaded(), cells, |_, _, p| {
            Count::<S>::zip(p, &scales, |p, scale| scale.restore(*p))
        });
    }

    /// Draws a span of pixels that differ only in their position. Depths are neither tested nor stored.
    #[inline]
    pub(super) fn solid(&mut self, mut cells: Cells<'_, S::Color, O, D>, numbers: Numbers<S>) {
        // Unrolled by hand, because the compiler unrolls no loop when it optimizes for size. Blending takes too many
        // registers for an unrolled loop.
        while !S::READS_COLOR && cells.len() >= 8 {
            rolled();
            self.four(&mut cells, numbers);
            self.four(&mut cells, numbers);
        }
        if !S::READS_COLOR {
            self.four(&mut cells, numbers);
        }
        for cell in cells.first(usize::MAX) {
            rolled();
            self.one(cell.0, numbers);
        }
    }

    /// Draws the first four pixels of a span, if it has four.
    #[inline(always)] // otherwise, each pixel computes the values that all four share
    fn four(&mut self, cells: &mut Cells<'_, S::Color, O, D>, numbers: Numbers<S>) {
        if let Some([a, b, c, d]) = cells.colors() {
            self.one(a, numbers);
            self.one(b, numbers);
            self.one(c, numbers);
            self.one(d, numbers);
        }
    }

    #[inline(always)]
    fn one(&mut self, color: &mut O::Cell, numbers: Numbers<S>) {
        if self.visible(&None, 0, 0) {
            self.shade((color, None), numbers);
        }
    }
}
