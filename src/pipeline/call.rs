//! A draw call, but for what it draws with.

use super::DrawOptions;
use super::vertex::Projector;
use crate::mesh::{Element, Mesh, Placement, Primitive};
use crate::raster::{Cull, DepthShift};
use crate::view::{ModelToPicture, ProjectionKind, Viewport};

/// A mesh on its way to the screen: what all of its primitives share.
#[derive(Clone, Debug)]
pub(super) struct Call<'m, K> {
    pub(super) mesh: &'m Mesh<'m>,
    pub(super) placement: Placement<'m>,
    pub(super) projector: Projector<'m, K>,
    pub(super) cull: Cull,
}

impl<'m, K: ProjectionKind> Call<'m, K> {
    pub(super) fn new<M: Copy, Z: Copy, V: ModelToPicture<Kind = K>>(
        options: &DrawOptions<M, Z>,
        mesh: &'m Mesh<'m>,
        mvp: &'m V,
        viewport: &Viewport,
    ) -> Self {
        let view = mvp.model_view_of();
        Self {
            mesh,
            projector: Projector::new(mesh.positions(), mvp.projection_of(), &view, viewport),
            placement: Placement::new(mvp.model_of(), view),
            cull: options.cull,
        }
    }

    /// A triangle, edge or point as shaders see it.
    #[inline]
    pub(super) fn primitive(&self, element: Element) -> Primitive<'_> {
        Primitive {
            mesh: self.mesh,
            placement: &self.placement,
            element,
        }
    }

    pub(super) fn depth_shift(&self) -> DepthShift {
        self.projector.depth_shift()
    }
}
