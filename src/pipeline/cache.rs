//! Vertices that need not be projected again.

use super::geometry::Geometry;
use crate::view::ProjectionKind as Kind;
use crate::{mesh::Index, pipeline::Projected};

/// Vertices that were projected lately, as neighbouring triangles share them, each with a note.
pub(super) struct Cache<T> {
    entries: [Entry<T>; SIZE],
}

/// A power of two. Rows of a mesh up to 31 vertices apart are projected once; 1 KiB of stack without notes.
const SIZE: usize = 64;

/// A vertex in the cache.
#[derive(Clone, Copy)]
pub(super) struct Entry<T> {
    /// What is known of it besides; the default when it is projected.
    pub(super) note: T,
    pub(super) projected: Projected,
}

impl<T: Copy + Default> Cache<T> {
    pub(super) fn new() -> Self {
        // Entry 0 is for multiples of the size, so 1 marks it as empty; the others may begin with 0.
        let empty = Entry {
            note: T::default(),
            projected: Projected::NONE,
        };
        let mut entries = [empty; SIZE];
        entries[0].projected.index = 1;
        Self { entries }
    }

    /// A vertex, projected now or lately.
    #[inline]
    pub(super) fn vertex<K: Kind>(
        &mut self,
        geometry: &Geometry<'_, K>,
        index: Index,
    ) -> &mut Entry<T> {
        // Never more than the size less one.
        let entry = &mut self.entries[usize::from(index) % SIZE];
        if entry.projected.index != index {
            entry.note = T::default();
            geometry.project(index, &mut entry.projected);
        }
        entry
    }

    /// Where a vertex is on the screen, and which planes it is outside of.
    #[inline]
    pub(super) fn place<K: Kind>(
        &mut self,
        geometry: &Geometry<'_, K>,
        index: Index,
    ) -> ([i32; 2], u8) {
        let vertex = self.vertex(geometry, index).projected;
        (vertex.screen, vertex.outside)
    }

    /// The corners of a triangle.
    #[inline]
    pub(super) fn corners<K: Kind>(
        &mut self,
        geometry: &Geometry<'_, K>,
        indices: [Index; 3],
    ) -> [Projected; 3] {
        indices.map(|index| self.vertex(geometry, index).projected)
    }
}
