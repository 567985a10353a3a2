//! Points: one pixel each.

use super::{Brush, Triangle, Window};
use crate::pipeline::Projected;

/// Draws the pixel that a point lies in.
pub(crate) fn point(brush: &mut dyn Brush, window: &Window, at: &Projected) {
    let [x, y] = at.screen.map(|position| position >> 8);
    if window.columns.contains(&x) && window.rows.contains(&y) {
        // The planes are level, so any triangle that begins in the pixel will do.
        let corner = |x, y| Projected {
            screen: [x, y],
            ..*at
        };
        let [left, top] = [x << 8, y << 8];
        let corners = [
            corner(left, top),
            corner(left + 256, top),
            corner(left, top + 1),
        ];
        brush.triangle(&Triangle {
            corners: &corners,
            weights: None,
            area: 256,
        });
        brush.span(y, x..x + 1, 0, 0);
    }
}
