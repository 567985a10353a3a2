//! Attributes that are linear along the span: only additions.

use super::pixels::{Count, Numbers, Pixels, Span, rolled};
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

/// If nothing varies between pixels, this many are drawn without a check for the end of the span.
const BLOCK: usize = 16;

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
    let mut draw = |cells: &mut Cells<'_, S::Color, O, D>| {
        for cell in cells.first(BLOCK) {
            if pixels.visible::<D>(&cell.1, 0, 0) {
                pixels.shade::<O, D>(cell, numbers);
            }
        }
    };
    while cells.len() >= BLOCK {
        draw(&mut cells);
    }
    draw(&mut cells);
}
