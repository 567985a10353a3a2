//! Attributes that are linear along the span: only additions.

use super::pixels::{Cell, Count, Numbers, Pixels, Scales, Span, rolled};
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, DepthTest, Storage};
use crate::num::wide::seldom;
use crate::shade::Lanes;

/// Draws a span; `restore` turns interpolants into attributes.
#[inline(always)]
pub(super) fn straight<S: Shading, O: Storage<S::Color>, D: DepthBuffer, Z: DepthTest>(
    span: Span<Count<S>>,
    restore: impl Fn(&Numbers<S>) -> Numbers<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    mut pixels: Pixels<S, Z>,
) {
    let (mut q, mut p) = (span.q, span.p);
    let (dq, dp, down) = (span.dq, span.dp, span.down);
    for cell in cells.first(usize::MAX) {
        if pixels.visible::<D>(&cell.1, q, down) {
            pixels.shade::<O>(cell, restore(&p));
        } else {
            seldom();
        }
        rolled();
        q = q.wrapping_add_signed(dq);
        p = Count::<S>::zip(&p, &dp, |p, step| p.wrapping_add(*step));
    }
}

/// [`straight`] for attributes that are fractions in units of 2^-30, each with its own scale; out of line because it is
/// the exception.
#[inline(never)]
pub(super) fn scaled<S: Shading, O: Storage<S::Color>, D: DepthBuffer, Z: DepthTest>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    cells: Cells<'_, S::Color, O, D>,
    pixels: Pixels<S, Z>,
) {
    let restore = |p: &Numbers<S>| Count::<S>::zip(p, &scales, |p, scale| scale.restore(*p));
    straight(span.anew(), restore, cells, pixels);
}

/// Draws a span whose pixels differ in nothing but their position.
#[inline]
pub(super) fn solid<S: Shading, O: Storage<S::Color>, D: DepthBuffer, Z: DepthTest>(
    numbers: Numbers<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    pixels: &mut Pixels<S, Z>,
) {
    let draw = |pixels: &mut Pixels<S, Z>, cell: Cell<'_, S::Color, O>| {
        if pixels.visible::<D>(&cell.1, 0, 0) {
            pixels.shade::<O>(cell, numbers);
        }
    };
    // By hand, because the compiler unrolls no loop when it optimizes for size.
    let four = |pixels: &mut Pixels<S, Z>, cells: &mut Cells<'_, S::Color, O, D>| {
        let mut cells = cells.first(4);
        if let (Some(a), Some(b), Some(c), Some(d)) =
            (cells.next(), cells.next(), cells.next(), cells.next())
        {
            draw(pixels, a);
            draw(pixels, b);
            draw(pixels, c);
            draw(pixels, d);
        }
    };
    // What blends takes too many registers for that.
    while !S::READS_COLOR && cells.len() >= 8 {
        rolled();
        four(pixels, &mut cells);
        four(pixels, &mut cells);
    }
    if !S::READS_COLOR && cells.len() >= 4 {
        four(pixels, &mut cells);
    }
    for cell in cells.first(usize::MAX) {
        rolled();
        draw(pixels, cell);
    }
}
