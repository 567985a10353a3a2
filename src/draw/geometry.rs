//! The geometry of a draw call: where a mesh's elements come to lie on the screen, and what of them is to be seen.

use super::Pass;
use crate::geometry::{Cull, Element, Face, Index, Mesh, Outline, Projected, Projector, clip};
use crate::linear::Transform;
use crate::view::{Chain, Kind, Viewport};

/// A mesh on its way to the screen: what is the same for all of its elements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Geometry<'m, K> {
    pub(super) mesh: &'m Mesh<'m>,
    /// From model to eye space.
    view: Transform,
    pub(super) projector: Projector<K>,
    pub(super) cull: Cull,
}

/// What of a triangle is to be seen.
pub(super) enum Seen {
    /// Nothing.
    Nothing,
    /// All of it.
    All,
    /// What is inside these planes, a bit each.
    Inside(u8),
}

impl<'m, K: Kind> Geometry<'m, K> {
    pub(super) fn new<I: Copy>(
        pass: &Pass<I>,
        mesh: &'m Mesh<'m>,
        chain: &Chain<K>,
        viewport: &Viewport,
    ) -> Self {
        let view = chain.model_view();
        Self {
            mesh,
            projector: Projector::new(&chain.projection, &view, viewport),
            view,
            cull: pass.cull,
        }
    }

    /// A position of the mesh on the screen.
    ///
    /// A call, so that finding a vertex in the cache is short.
    #[inline(never)]
    pub(super) fn project(&self, index: Index) -> Projected {
        let position = self.projector.clip_position(self.mesh.position(index));
        self.projector.project(&position)
    }

    /// A triangle, edge or point as fragments see it.
    #[inline]
    pub(super) fn face(&self, element: Element) -> Face<'_> {
        Face {
            mesh: self.mesh,
            view: &self.view,
            element,
        }
    }

    /// What of a triangle is to be seen, of the planes that its corners are outside of.
    #[inline]
    pub(super) fn seen([a, b, c]: [u8; 3]) -> Seen {
        if a | b | c == 0 {
            Seen::All
        } else if a & b & c != 0 {
            Seen::Nothing
        } else {
            Seen::Inside(a | b | c)
        }
    }

    /// The part inside the `planes` of a line or triangle, the element's first `corners` corners;
    /// empty if there is none.
    #[inline(never)]
    pub(super) fn clip(&self, element: Element, corners: usize, planes: u8) -> Outline {
        let positions = element.indices.map(|index| {
            let position = self.mesh.position(index);
            self.projector.clip_position(position)
        });
        let positions = positions.get(..corners).unwrap_or_default();
        clip(&self.projector, positions, planes)
    }
}
