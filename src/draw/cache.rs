//! Vertices that need not be projected again.

use super::call::Call;
use crate::geometry::{Index, Projected};
use crate::view::Kind;

/// Vertices that were projected lately, as neighbouring triangles share them.
pub(super) struct Cache {
    entries: [(Index, Projected); Self::SIZE],
}

impl Cache {
    /// A power of two. Rows of a mesh up to 31 vertices apart are projected once; 1 KiB of stack.
    const SIZE: usize = 64;

    pub(super) const fn new() -> Self {
        // Entry 0 is for multiples of the size, so 1 marks it as empty; the others may begin with 0.
        let mut entries = [(0, Projected::NONE); Self::SIZE];
        entries[0].0 = 1;
        Self { entries }
    }

    #[inline]
    pub(super) fn project<K: Kind, F>(&mut self, call: &Call<'_, K, F>, index: Index) -> Projected {
        // Never more than the size less one.
        let (entry, projected) = &mut self.entries[usize::from(index) % Self::SIZE];
        if *entry != index {
            *entry = index;
            let position = call.projector.clip_position(call.mesh.position(index));
            *projected = call.projector.project(position);
        }
        *projected
    }
}
