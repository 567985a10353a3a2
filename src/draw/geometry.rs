//! The geometry of a draw call: where a mesh's elements come to lie on the screen, and what of them is to be seen.

use heapless::Vec;

use super::Pass;
use crate::geometry::{
    self, Cull, Element, Face, Index, MOST_CORNERS, Mesh, Projected, Projector, Weights,
};
use crate::linear::Transform;
use crate::view::{Chain, Kind, Viewport};

/// A corner of a clipped triangle, and where in the triangle it is.
pub(super) type Corner = (Projected, Weights);
/// A clipped triangle.
pub(super) type Outline = Vec<Corner, MOST_CORNERS>;

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
    pub(super) fn new<I>(
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
        self.projector.project(position)
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

    /// What of a triangle with these corners is to be seen.
    #[inline]
    pub(super) fn seen(corners: &[Projected; 3]) -> Seen {
        let [a, b, c] = corners.each_ref().map(|corner| corner.outside);
        if a & b & c != 0 {
            Seen::Nothing
        } else if a | b | c == 0 {
            Seen::All
        } else {
            Seen::Inside(a | b | c)
        }
    }

    /// The part of a triangle inside the `planes`; empty if there is none.
    pub(super) fn clip(&self, element: Element, planes: u8) -> Outline {
        let corners = element.indices.map(|index| self.clip_position(index));
        let mut outline = Outline::new();
        for corner in &geometry::clip_triangle(&self.projector, &corners, planes) {
            let projected = self.projector.project_inside(corner.position);
            // There is as much room as in the polygon.
            let _ = outline.push((projected, corner.weights));
        }
        outline
    }

    /// The part of a line inside the `planes`.
    pub(super) fn clip_line(&self, element: Element, planes: u8) -> Option<[Corner; 2]> {
        let [a, b, _] = element.indices;
        let ends = [a, b].map(|index| self.clip_position(index));
        geometry::clip_line(&self.projector, ends, planes).map(|ends| {
            ends.map(|end| {
                let projected = self.projector.project_inside(end.position);
                (projected, end.weights)
            })
        })
    }

    #[inline]
    fn clip_position(&self, index: Index) -> [i64; 3] {
        self.projector.clip_position(self.mesh.position(index))
    }
}
