//! Interpolants that are linear along the span: only additions.

use embedded_graphics::geometry::Point;

use super::pixels::{Cell, Count, Numbers, Pixels, Scales, Span, rolled};
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, Storage};
use crate::num::wide::seldom;
use crate::shade::Lanes;

/// Draws a span; `restore` turns a pixel's 1/w and interpolants into attributes.
#[inline(always)]
pub(super) fn straight<S: Shading, O: Storage<S::Color>, D: DepthBuffer>(
    span: Span<Count<S>>,
    restore: impl Fn(Point, u32, &Numbers<S>) -> Numbers<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    mut pixels: Pixels<S>,
) {
    let (mut q, mut p) = (span.q, span.p);
    let (dq, dp, down) = (span.dq, span.dp, span.down);
    for cell in cells.first(usize::MAX) {
        if pixels.visible::<D>(&cell.1, q, down) {
            let numbers = restore(pixels.point, q, &p);
            pixels.shade::<O>(cell, numbers);
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
pub(super) fn scaled<S: Shading, O: Storage<S::Color>, D: DepthBuffer>(
    span: &Span<Count<S>>,
    scales: Scales<S>,
    cells: Cells<'_, S::Color, O, D>,
    pixels: Pixels<S>,
) {
    let restore = |_, _, p: &Numbers<S>| Count::<S>::zip(p, &scales, |p, scale| scale.restore(*p));
    straight(span.anew(), restore, cells, pixels);
}

/// Draws a span whose pixels differ in nothing but their position.
#[inline]
pub(super) fn solid<S: Shading, O: Storage<S::Color>, D: DepthBuffer>(
    numbers: Numbers<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    pixels: &mut Pixels<S>,
) {
    let draw = |pixels: &mut Pixels<S>, cell: Cell<'_, S::Color, O>| {
        if pixels.visible::<D>(&cell.1, 0, 0) {
            pixels.shade::<O>(cell, numbers);
        }
    };
    // By hand, because the compiler unrolls no loop when it optimizes for size.
    let four = |pixels: &mut Pixels<S>, cells: &mut Cells<'_, S::Color, O, D>| {
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
