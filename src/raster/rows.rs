//! A triangle row by row.

use core::ops::Range;

use super::Window;
use super::edge::{Edge, first_center};

/// The rows of a triangle in a window, from the top, each with the columns whose centres are the
/// triangle's.
///
/// A centre on a left or top edge belongs to it, one on a right or bottom edge does not. The same
/// code for all fragments.
pub(super) struct Rows<'w> {
    window: &'w Window,
    /// From the top corner to the bottom one.
    long: Edge,
    /// From the top to the middle, then from there to the bottom.
    short: Edge,
    /// Whether the short edges are to the right of the long one.
    right: bool,
    /// The next row, the first one of the lower short edge, and the end.
    row: i32,
    turn: i32,
    end: i32,
    /// The lower short edge.
    lower: [[i32; 2]; 2],
}

impl<'w> Rows<'w> {
    /// Those of a triangle whose corners run clockwise as seen, in units of 1/256 pixel.
    pub(super) fn new(
        [mut top, mut middle, mut bottom]: [[i32; 2]; 3],
        window: &'w Window,
    ) -> Self {
        // Sorting from the top; every exchange turns the triangle over.
        let mut right = true;
        if middle[1] < top[1] {
            (top, middle, right) = (middle, top, !right);
        }
        if bottom[1] < middle[1] {
            (middle, bottom, right) = (bottom, middle, !right);
            if middle[1] < top[1] {
                (top, middle, right) = (middle, top, !right);
            }
        }
        // With positive area and no exchange, the middle corner is to the right of the long edge.
        let row = first_center(top[1]).max(window.rows.start);
        let end = first_center(bottom[1]).min(window.rows.end);
        let turn = first_center(middle[1]).max(row);
        let long = Edge::new(top, bottom, row);
        Self {
            window,
            long,
            // If the lower one is the only one it is made when its row comes.
            short: if row < turn {
                Edge::new(top, middle, row)
            } else {
                long
            },
            right,
            row,
            turn,
            end,
            lower: [middle, bottom],
        }
    }
}

impl Iterator for Rows<'_> {
    type Item = (i32, Range<i32>);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        while self.row < self.end {
            let row = self.row;
            self.row += 1;
            if row == self.turn {
                let [from, to] = self.lower;
                self.short = Edge::new(from, to, row);
            }
            let (left, end) = if self.right {
                (self.long.column(), self.short.column())
            } else {
                (self.short.column(), self.long.column())
            };
            self.long.step();
            self.short.step();
            let left = left.max(self.window.columns.start);
            let end = end.min(self.window.columns.end);
            if left < end {
                return Some((row, left..end));
            }
        }
        None
    }
}
