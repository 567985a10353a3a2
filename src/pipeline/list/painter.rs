//! Painter's order: the triangles of a list from back to front.

use core::ops::Range;

use super::Slot;
use super::triangles::{Corners, Entry};
use crate::raster::{DepthShift, first_center};

/// Sorts a mesh's triangles back to front: by their farthest corners and, where these are equally far, by their faces'
/// numbers. `rows` are those of the frame that are drawn to.
///
/// The farthest corner needs no division, and it keeps a floor behind what stands on it. (The middle of the corners is
/// right in slightly more pixels where triangles are alike, and wrong in more where one is much larger than another.)
#[inline(never)]
pub(super) fn sort(entries: &mut [Entry], vertices: &[Slot], shift: DepthShift, rows: &Range<i32>) {
    for entry in &mut *entries {
        set_nearness(entry, vertices, shift);
    }
    heap_sort(entries);
    for entry in entries {
        set_rows(entry, vertices, rows);
    }
}

/// Stores the nearness of an entry's farthest corner, for [`heap_sort`]. It takes the place of the rows, so that an
/// entry needs no more memory; [`set_rows`] finds them again.
pub(super) fn set_nearness(entry: &mut Entry, vertices: &[Slot], shift: DepthShift) {
    let corners = corners(entry.corners, vertices);
    let farthest = corners.map(|corner| corner.nearness(shift)).min();
    let nearness = farthest.unwrap_or_default();
    entry.rows = [(nearness >> 16) as u16, nearness as u16];
}

/// Finds an entry's rows among those that are drawn to: all rows between its corners. In some of them, a clipped
/// triangle may have no pixel.
pub(super) fn set_rows(entry: &mut Entry, vertices: &[Slot], rows: &Range<i32>) {
    let (mut start, mut end) = (rows.end, rows.start);
    for Corner { y, .. } in corners(entry.corners, vertices) {
        let row = first_center(y);
        (start, end) = (start.min(row), end.max(row));
    }
    // Rows of a frame are 0 to 2048.
    let row = |row: i32| row.max(rows.start).min(rows.end).cast_unsigned() as u16;
    entry.rows = [row(start), row(end)];
}

/// A corner, as far as the order needs it.
struct Corner {
    /// In units of 1/256 row.
    y: i32,
    q: u32,
    exponent: u8,
}

impl Corner {
    /// Greater is nearer: 1/w or, under a parallel projection, the depth, each with 26 bits and an exponent. It is
    /// comparable between objects.
    fn nearness(&self, shift: DepthShift) -> u32 {
        // A depth is q shifted right by 15 to 47. In perspective, all q have the same top bit, so that the shift
        // decides first; under a parallel projection, all shifts are equal.
        (47 - shift.of(self.exponent)) << 26 | self.q >> 5
    }
}

/// The corners of a triangle, which may be clipped.
fn corners(corners: Corners, vertices: &[Slot]) -> impl Iterator<Item = Corner> {
    let (whole, clipped) = match corners {
        Corners::Whole(numbers) => (numbers, 0..0),
        // Each vertex is followed by its barycentric weights.
        Corners::Clipped { first, count } => ([0; 3], first..first.saturating_add(2 * count)),
    };
    let slot = |number: u16| vertices.get(usize::from(number).wrapping_sub(1));
    let numbers = whole.into_iter().chain(clipped);
    numbers.filter_map(move |number| match *slot(number)? {
        Slot::Vertex {
            screen: [_, y],
            q,
            exponent,
        } => Some(Corner { y, q, exponent }),
        Slot::Barycentric(_) => None,
    })
}

impl Entry {
    /// Its rank in the order: the [nearness](set_nearness), then the face.
    fn rank(&self) -> u64 {
        let [high, low] = self.rows.map(u64::from);
        high << 48 | low << 32 | u64::from(self.face)
    }
}

/// Sorts entries by rank. Heap sort needs no memory, at most 2 n log₂ n comparisons, and little code.
pub(super) fn heap_sort(entries: &mut [Entry]) {
    for root in (0..entries.len() / 2).rev() {
        sift_down(entries, root);
    }
    let mut heap = entries;
    // The heap's greatest entry is its first; it goes to the end, and the heap shrinks.
    while let [first, .., last] = heap {
        core::mem::swap(first, last);
        let Some((_, rest)) = heap.split_last_mut() else {
            return;
        };
        sift_down(rest, 0);
        heap = rest;
    }
}

/// Moves the entry at `at` down the heap until both of its children are less.
fn sift_down(heap: &mut [Entry], mut at: usize) {
    let Some(&moved) = heap.get(at) else {
        return;
    };
    loop {
        let child = 2 * at + 1;
        let Some(&left) = heap.get(child) else {
            break;
        };
        let (child, greater) = match heap.get(child + 1) {
            Some(&right) if right.rank() > left.rank() => (child + 1, right),
            _ => (child, left),
        };
        if greater.rank() <= moved.rank() {
            break;
        }
        if let Some(entry) = heap.get_mut(at) {
            *entry = greater;
        }
        at = child;
    }
    if let Some(entry) = heap.get_mut(at) {
        *entry = moved;
    }
}
