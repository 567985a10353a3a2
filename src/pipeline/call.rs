//! The inputs of a draw call, except shader and canvas.

use core::ops::Range;

use embedded_graphics::geometry::Size;

use super::DrawOptions;
use super::vertex::Projector;
use crate::mesh::{Element, Mesh, Placement, Primitive};
use crate::raster::{Cull, DepthShift, Scissor};
use crate::view::{ModelToPicture, ProjectionKind};

/// The data that all primitives of a draw call share once they are on the screen.
#[derive(Clone, Debug)]
pub(super) struct Shared<'m> {
    pub(super) mesh: &'m Mesh<'m>,
    pub(super) placement: Placement<'m>,
    pub(super) cull: Cull,
    pub(super) scissor: Scissor,
}

impl Shared<'_> {
    /// A triangle, edge or point in the form that shaders receive.
    #[inline]
    pub(super) fn primitive(&self, element: Element) -> Primitive<'_> {
        Primitive {
            mesh: self.mesh,
            placement: &self.placement,
            element,
        }
    }
}

/// A mesh, and the transform that takes it to the screen.
#[derive(Clone, Debug)]
pub(super) struct Call<'m, K> {
    pub(super) shared: Shared<'m>,
    pub(super) projector: Projector<'m, K>,
}

impl<'m, K: ProjectionKind> Call<'m, K> {
    /// A draw call to `rows` of a frame.
    #[inline(never)]
    pub(super) fn new<M: Copy, Z: Copy, B: Copy, V: ModelToPicture<Kind = K>>(
        options: &DrawOptions<M, Z, B>,
        mesh: &'m Mesh<'m>,
        mvp: &'m V,
        (frame, rows): (Size, &Range<u32>),
    ) -> Self {
        let viewport = options.viewport_in(frame);
        let view = mvp.model_view_of();
        Self {
            projector: Projector::new(mesh.positions(), mvp.projection_of(), &view, &viewport),
            shared: Shared {
                mesh,
                placement: Placement::new(mvp.model_of(), view),
                cull: options.cull,
                scissor: Scissor::new(&viewport, frame.width, rows),
            },
        }
    }

    #[inline]
    pub(super) fn depth_shift(&self) -> DepthShift {
        self.projector.depth_shift()
    }
}
