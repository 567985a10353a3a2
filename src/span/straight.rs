//! Attributes that are linear along the span: only additions.

use super::pixels::{Cell, Count, Numbers, Pixels, Span, rolled};
use crate::shade::Shader;
use crate::target::{Cells, DepthBuffer, DepthTest, Storage};

/// Draws a span; `restore` turns interpolants into attributes.
#[inline(always)]
pub(super) fn straight<S, O, D, Z>(
    mut span: Span<Count<S>>,
    restore: impl Fn(&Numbers<S>) -> Numbers<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    mut pixels: Pixels<S, Z>,
) where
    S: Shader,
    O: Storage<S::Color>,
    D: DepthBuffer,
    Z: DepthTest,
{
    for cell in cells.first(usize::MAX) {
        rolled();
        if pixels.visible::<D>(&cell.1, span.q, span.down) {
            pixels.shade::<O, D>(cell, restore(&span.p));
        }
        span.step();
    }
}

/// Draws a span whose pixels differ in nothing but their position.
#[inline]
pub(super) fn solid<S, O, D, Z>(
    numbers: Numbers<S>,
    mut cells: Cells<'_, S::Color, O, D>,
    mut pixels: Pixels<S, Z>,
) where
    S: Shader,
    O: Storage<S::Color>,
    D: DepthBuffer,
    Z: DepthTest,
{
    let mut draw = |cell: Cell<'_, S::Color, O, D>| {
        if pixels.visible::<D>(&cell.1, 0, 0) {
            pixels.shade::<O, D>(cell, numbers);
        }
    };
    // By hand, because the compiler unrolls no loop when it optimizes for size.
    let mut four = |cells: &mut Cells<'_, S::Color, O, D>| {
        let mut cells = cells.first(4);
        if let (Some(a), Some(b), Some(c), Some(d)) =
            (cells.next(), cells.next(), cells.next(), cells.next())
        {
            draw(a);
            draw(b);
            draw(c);
            draw(d);
        }
    };
    while cells.len() >= 8 {
        rolled();
        four(&mut cells);
        four(&mut cells);
    }
    if cells.len() >= 4 {
        four(&mut cells);
    }
    for cell in cells.first(usize::MAX) {
        rolled();
        draw(cell);
    }
}
