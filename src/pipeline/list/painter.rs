//! Painter's order: the elements of a list from back to front.

use super::prepared::Objects;
use super::{Corners, Entry, Listed};
use crate::raster::{DepthShift, ScreenVertex};

/// Sorts triangles or edges back to front: by their farthest corners and, if these are equally far away, by their
/// indices.
///
/// The farthest corner is found without a division, and it keeps a floor behind the things that stand on it. (If
/// triangles were compared by the middle of their corners, slightly more pixels would be right among triangles of
/// similar size, but more pixels would be wrong if one triangle is much larger than another.)
#[inline(never)]
pub(super) fn sort<G: Listed, T>(
    entries: &mut [Entry],
    vertices: &[ScreenVertex],
    objects: &Objects<'_, G, T>,
) {
    for entry in &mut *entries {
        if let Some(listing) = objects.listing(entry.element) {
            let corners = corners(entry.corners, vertices);
            let farthest = corners.map(|corner| nearness(corner, listing.depth_shift));
            // The rows are found again below.
            let nearness = farthest.min().unwrap_or_default();
            entry.rows_or_nearness = [(nearness >> 16) as i16, nearness as i16];
        }
    }
    heap_sort(entries);
    for entry in entries {
        // All rows between the corners. In some of them, a clipped triangle may have no pixel.
        let (mut least, mut most) = (i32::MAX, i32::MIN);
        for &ScreenVertex { screen: [_, y], .. } in corners(entry.corners, vertices) {
            (least, most) = (least.min(y), most.max(y));
        }
        entry.rows_or_nearness = G::rows(least, most);
    }
}

/// How near a corner is; a greater number is nearer. The number is 1/w or, under a parallel projection, the depth, with
/// 26 bits and an exponent. Corners of different objects can be compared.
fn nearness(corner: &ScreenVertex, shift: DepthShift) -> u32 {
    // A depth is q shifted right by 15 to 47. In perspective, all q have the same top bit, so that the shift decides
    // first; under a parallel projection, all shifts are equal.
    (47 - shift.right_shift(corner.exponent)) << 26 | corner.q >> 5
}

/// The corners of a triangle or edge, which may be clipped.
fn corners(corners: Corners, vertices: &[ScreenVertex]) -> impl Iterator<Item = &ScreenVertex> {
    let (whole, clipped) = match corners {
        Corners::Whole(numbers) => (numbers, 0..0),
        Corners::Edge { ends: [a, b], .. } => ([a, b, 0], 0..0),
        // The barycentric weights of a vertex follow the vertex.
        Corners::Clipped { first, count, .. } => ([0; 3], first..first.saturating_add(2 * count)),
    };
    let numbers = whole.into_iter().chain(clipped.step_by(2));
    numbers.filter_map(|number| vertices.get(usize::from(number).wrapping_sub(1)))
}

impl Entry {
    /// The entry's rank in the order: the [`nearness`] of its farthest corner, then its index.
    fn rank(&self) -> u64 {
        let [high, low] = self
            .rows_or_nearness
            .map(|bits| u64::from(bits.cast_unsigned()));
        high << 48 | low << 32 | u64::from(self.element)
    }
}

/// Sorts entries by rank. Heap sort needs no memory, at most 2 n log₂ n comparisons, and little code.
fn heap_sort(entries: &mut [Entry]) {
    for root in (0..entries.len() / 2).rev() {
        sift_down(entries, root);
    }
    let mut heap = entries;
    // The heap's first entry is the greatest. It goes to the end, and the heap shrinks.
    while let [first, .., last] = heap {
        core::mem::swap(first, last);
        let Some((_, rest)) = heap.split_last_mut() else {
            return;
        };
        sift_down(rest, 0);
        heap = rest;
    }
}

/// Moves the entry at `at` down the heap until neither of its children has a higher rank.
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
