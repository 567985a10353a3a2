//! A cache of projected vertices.

use super::vertex::Projector;
use crate::mesh::Index;
use crate::raster::ScreenVertex;
use crate::view::ProjectionKind;

/// Recently projected vertices, because neighboring triangles share them.
pub(super) struct VertexCache {
    entries: [ScreenVertex; SIZE],
}

/// A power of two. Vertices of a mesh whose rows are up to 31 vertices apart are projected only once. The cache takes
/// 1 KiB of stack.
pub(super) const SIZE: usize = 64;

impl VertexCache {
    #[inline]
    pub(super) const fn new() -> Self {
        // All bits 0 but one, which is set in place: any other array is built twice, and copied, on the stack.
        let mut cache = Self {
            entries: [ScreenVertex::UNSET; SIZE],
        };
        // Index 1 never maps to slot 0, so it marks slot 0 as empty; index 0 marks the others.
        cache.entries[0].index = 1;
        cache
    }

    /// Forgets all vertices, if their indices are below `count`.
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
        // The remainder is below `SIZE`, so there is no bounds check.
        let entry = &mut self.entries[usize::from(index) % SIZE];
        if entry.index != index {
            projector.project(index, None, entry);
        }
        entry
    }

    /// The corners of a triangle, from the cache or projected now; `None` if two of them share a slot.
    #[inline]
    pub(super) fn corners<K: ProjectionKind>(
        &mut self,
        projector: &Projector<'_, K>,
        [a, b, c]: [Index; 3],
    ) -> Option<[&ScreenVertex; 3]> {
        self.vertex(projector, a);
        self.vertex(projector, b);
        self.vertex(projector, c);
        let slot = |index| usize::from(index) % SIZE;
        let (a, b, c) = (slot(a), slot(b), slot(c));
        // Destructured by hand, as in `ScreenVertex::screens`.
        let entries = &self.entries;
        (a != b && b != c && c != a).then(|| [&entries[a], &entries[b], &entries[c]])
    }

    /// The corners of any triangle.
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
