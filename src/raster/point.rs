//! Points: one pixel each.

use super::{Blitter, Patch, Scissor, ScreenVertex};

/// Draws the pixel that contains a point.
pub(crate) fn point(blitter: &mut dyn Blitter, scissor: &Scissor, at: &ScreenVertex) {
    let [x, y] = at.screen.map(|position| position >> 8);
    if scissor.columns.contains(&x) && scissor.rows.contains(&y) {
        let [left, top] = [x << 8, y << 8];
        // All three values are the point's, so any triangle that begins in the pixel will do.
        blitter.set_up(&Patch {
            vertices: [at; 3],
            barycentric: None,
            screen: &[[left, top], [left + 256, top], [left, top + 1]],
            area: 256,
        });
        blitter.span(y, x..x + 1, 0, 0);
    }
}
