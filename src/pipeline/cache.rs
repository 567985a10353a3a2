//! A cache of projected vertices.

use core::hint::black_box;

use super::vertex::Projector;
use crate::mesh::Index;
use crate::raster::ScreenVertex;
use crate::view::ProjectionKind;

/// Recently projected vertices, kept because neighboring triangles share vertices.
///
/// A vertex of a grid is projected once if the rows have up to 124 vertices (in a build for size, 60). In longer rows,
/// it is overwritten before the next row needs it, and is projected twice.
pub(super) struct VertexCache<'c, const N: usize = SIZE> {
    /// Borrowed, because the compiler would build an owned array twice on the stack, and copy it.
    entries: &'c mut [ScreenVertex; N],
    slots: Slots,
}

/// The number of slots, a power of two. A slot takes 16 bytes of stack, so a build for size has fewer.
pub(super) const SIZE: usize = if cfg!(for_size) { 64 } else { 128 };

/// The number of slots for the vertices of an outline, twice as many, because an edge has the vertices of two faces,
/// from three rows of a grid.
pub(super) const OUTLINE_SIZE: usize = 128;

/// Which of the slots a vertex has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slots {
    /// The distance between the slots of neighboring indices, in units of 2^-10.
    step: u32,
}

impl Slots {
    /// The slots of a mesh's vertices. Usually, vertices with indices 128 apart share a slot. In a grid with rows of 127
    /// to 129 vertices (or 255 to 257, and so on), these vertices are neighbors: they would push each other out of the
    /// slot, and be projected up to ten times. In such a grid, the slots of consecutive indices are 75/64 apart. A face
    /// in the middle of the mesh tells how long the rows are.
    #[inline]
    pub(super) fn new(faces: &[[Index; 3]]) -> Self {
        let [a, b, c] = faces.get(faces.len() / 2).copied().unwrap_or_default();
        // Of three corners, two are neighbors in a row, and the third is in the next row. If `apart` is 0 to 4, the
        // indices of a and b differ by −2 to 2. Then a and b are in one row, and c is in the next row.
        let mut apart = a.wrapping_sub(b).wrapping_add(2);
        if apart < 5 {
            apart = b.wrapping_sub(c).wrapping_add(2);
        }
        let step = if apart as usize % SIZE < 5 && apart >= 5 {
            1200
        } else {
            1024
        };
        Self { step }
    }

    /// The slot of an index among `N` slots. Of the first 54 indices, only index 0 has slot 0.
    #[inline]
    pub(super) fn slot<const N: usize>(self, index: Index) -> usize {
        // The remainder is below `N`, so the compiler adds no bounds check.
        ((u32::from(index) * self.step) >> 10) as usize % N
    }
}

/// The entries of an empty cache.
#[inline(always)]
#[allow(clippy::inline_always)] // so that the caller's array is filled in place, without a copy
pub(super) fn empty<const N: usize>() -> [ScreenVertex; N] {
    // An array of zeros would be cleared by a function that stores word by word. This array is filled by instructions
    // that store several words each.
    let (x, y, q) = (black_box(0), black_box(0), black_box(0));
    let screen = [x, y];
    [ScreenVertex {
        screen,
        q,
        ..ScreenVertex::UNSET
    }; N]
}

impl<'c, const N: usize> VertexCache<'c, N> {
    /// A cache in the memory of [`empty`] entries.
    #[inline]
    pub(super) const fn new(entries: &'c mut [ScreenVertex; N], slots: Slots) -> Self {
        // Index 1 never maps to slot 0, so index 1 marks slot 0 as empty. Index 0 marks the other slots as empty.
        entries[0].index = 1;
        Self { entries, slots }
    }

    /// Forgets all vertices. The indices of these vertices must be below `count`, and each index must be the number of
    /// its own slot.
    #[inline]
    pub(super) fn forget(&mut self, count: usize) {
        for entry in self.entries.iter_mut().take(count) {
            entry.index = 0;
        }
        self.entries[0].index = 1;
    }

    /// A vertex, from the cache or projected now.
    #[inline]
    pub(super) fn vertex<K: ProjectionKind>(
        &mut self,
        projector: &Projector<'_, K>,
        index: Index,
    ) -> &ScreenVertex {
        let entry = &mut self.entries[self.slots.slot::<N>(index)];
        if entry.index != index {
            projector.project(index, None, entry);
        }
        entry
    }

    /// Projects a vertex if it is not in its slot. Returns whether it was projected.
    #[inline]
    fn refresh<K: ProjectionKind>(&mut self, projector: &Projector<'_, K>, index: Index) -> bool {
        let entry = &mut self.entries[self.slots.slot::<N>(index)];
        let is_new = entry.index != index;
        if is_new {
            projector.project(index, None, entry);
        }
        is_new
    }

    /// The corners of a triangle, from the cache or projected now; `None` if two of them share a slot.
    #[inline(always)]
    #[allow(clippy::inline_always)] // a call takes 39 instructions on x86-64
    pub(super) fn corners<K: ProjectionKind>(
        &mut self,
        projector: &Projector<'_, K>,
        [a, b, c]: [Index; 3],
    ) -> Option<[&ScreenVertex; 3]> {
        // Only a vertex that is projected now can take the slot of another vertex.
        self.refresh(projector, a);
        if self.refresh(projector, b) && self.slots.slot::<N>(b) == self.slots.slot::<N>(a) {
            return None;
        }
        if self.refresh(projector, c) {
            let slot = self.slots.slot::<N>(c);
            if slot == self.slots.slot::<N>(a) || slot == self.slots.slot::<N>(b) {
                return None;
            }
        }
        // Destructured by hand, because a `map` over references compiles to arrays and loops.
        let (entries, slots) = (&*self.entries, self.slots);
        let entry = |index| &entries[slots.slot::<N>(index)];
        Some([entry(a), entry(b), entry(c)])
    }

    /// Copies of a triangle's corners, even of corners that share a slot.
    #[cold]
    #[inline(never)]
    pub(super) fn copies<K: ProjectionKind>(
        &mut self,
        projector: &Projector<'_, K>,
        indices: [Index; 3],
    ) -> [ScreenVertex; 3] {
        indices.map(|index| *self.vertex(projector, index))
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    /// The triangles of a grid of about 1000 quads with rows of `length` vertices. The bits of `order` say how the
    /// quads are cut, and in which order their triangles and corners come.
    fn grid(length: Index, order: u32) -> Vec<[Index; 3]> {
        let mut faces = Vec::new();
        for row in 0..=1000 / (length - 1) {
            for column in 0..length - 1 {
                let corner = row * length + column;
                let mut quad = [corner, corner + length, corner + length + 1, corner + 1];
                quad.rotate_left(order as usize & 3);
                if order & 4 != 0 {
                    quad.reverse();
                }
                let [a, b, c, d] = quad;
                let mut halves = [[a, b, c], [a, c, d]];
                if order & 8 != 0 {
                    halves.reverse();
                }
                faces.extend(halves);
            }
        }
        faces
    }

    /// How often vertices are projected, and how many triangles have corners that share a slot.
    fn costs(faces: &[[Index; 3]]) -> [usize; 2] {
        let slots = Slots::new(faces);
        let (mut entries, mut projected, mut shared) = ([None; SIZE], 0, 0);
        for corners in faces {
            let of = corners.map(|index| slots.slot::<SIZE>(index));
            let is_shared = of[0] == of[1] || of[1] == of[2] || of[2] == of[0];
            // `corners` looks up the three vertices. If a slot is shared, `copies` looks them up again.
            for _ in 0..=usize::from(is_shared) {
                for (&index, slot) in corners.iter().zip(of) {
                    projected += usize::from(entries[slot].replace(index) != Some(index));
                }
            }
            shared += usize::from(is_shared);
        }
        [projected, shared]
    }

    /// If vertices with indices 128 apart shared a slot in every mesh, vertices in rows of 128 would be projected ten
    /// times.
    #[test]
    fn no_number_of_vertices_in_a_row_is_a_cliff() {
        for length in 3..=300 {
            for order in 0..16 {
                let faces = grid(length, order);
                let [projected, shared] = costs(&faces);
                let most = usize::from(faces.iter().flatten().copied().max().unwrap()) + 1;
                // A twentieth more is allowed, because of the places where slots begin again.
                let times = if usize::from(length) <= SIZE - 4 {
                    1
                } else {
                    2
                };
                let case = std::format!("rows of {length}, order {order}");
                assert!(
                    20 * projected <= 21 * times * most,
                    "{projected} of {most} in {case}"
                );
                assert!(40 * shared <= faces.len(), "{shared} in {case}");
            }
        }
    }

    /// Index 1 marks slot 0 as empty, and index 0 marks the other slots.
    #[test]
    fn index_0_alone_of_the_first_has_slot_0() {
        for length in [9, SIZE as Index] {
            let slots = Slots::new(&grid(length, 0));
            let in_slot_0: Vec<_> = (0..54)
                .filter(|&index| slots.slot::<SIZE>(index) == 0)
                .collect();
            assert_eq!(in_slot_0, [0]);
        }
    }
}
