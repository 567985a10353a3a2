//! The geometry of a draw call: where a mesh's elements come to lie on the screen, and what of them is to be seen.

use super::DrawOptions;
use super::cache::Cache;
use crate::math::Transform;
use crate::raster;
use crate::view::{Mvp, ProjectionKind as Kind, Viewport};
use crate::{
    mesh::{Element, Face, Index, Mesh},
    pipeline::{Cull, Outline, Projected, Projector, clip},
};

/// A mesh on its way to the screen: what is the same for all of its elements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Geometry<'m, K> {
    pub(super) mesh: &'m Mesh<'m>,
    /// From model to eye space.
    view: Transform,
    pub(super) projector: Projector<'m, K>,
    pub(super) cull: Cull,
}

impl<'m, K: Kind> Geometry<'m, K> {
    pub(super) fn new<I: Copy>(
        pass: &DrawOptions<I>,
        mesh: &'m Mesh<'m>,
        mvp: &Mvp<K>,
        viewport: &Viewport,
    ) -> Self {
        let view = mvp.model_view();
        Self {
            mesh,
            projector: Projector::new(mesh.positions(), &mvp.projection, &view, viewport),
            view,
            cull: pass.cull,
        }
    }

    /// Finds a position of the mesh on the screen.
    #[inline]
    pub(super) fn project(&self, index: Index, to: &mut Projected) {
        self.projector.project(index, to);
    }

    /// A triangle, edge or point as shaders see it.
    #[inline]
    pub(super) fn face(&self, element: Element) -> Face<'_> {
        Face {
            mesh: self.mesh,
            view: &self.view,
            element,
        }
    }

    /// Which planes corners of a triangle are outside of, a bit each, and if there are none its area;
    /// `None` if nothing of it is to be seen, as far as its corners tell.
    ///
    /// Of the back of things, half of most meshes, no more is looked at than this.
    #[inline]
    pub(super) fn planes<T: Copy + Default>(
        &self,
        cache: &mut Cache<T>,
        [a, b, c]: [Index; 3],
    ) -> Option<(u8, i64)> {
        let (a, a_outside) = cache.place(self, a);
        let (b, b_outside) = cache.place(self, b);
        let (c, c_outside) = cache.place(self, c);
        let planes = a_outside | b_outside | c_outside;
        if planes == 0 {
            let area = raster::area(&[a, b, c]);
            (!self.cull.leaves_out(area)).then_some((0, area))
        } else {
            (a_outside & b_outside & c_outside == 0).then_some((planes, 0))
        }
    }

    /// The part inside the `planes` of a line or triangle, the element's first `corners` corners;
    /// empty if there is none.
    #[inline]
    pub(super) fn clip(&self, element: Element, corners: usize, planes: u8) -> Outline {
        let corners = element.indices.get(..corners).unwrap_or_default();
        clip(&self.projector, corners, planes)
    }
}
