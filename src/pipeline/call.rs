//! The inputs of a draw call, except shader and canvas.

use core::ops::Range;

use embedded_graphics::geometry::Size;

use super::cache::Slots;
use super::vertex::Projector;
use crate::Error;
use crate::mesh::{Indices, Mesh, Placement, Primitive};
use crate::raster::{Cull, Scissor};
use crate::view::{AsMvp, ProjectionKind, Viewport};

/// A frame, the part of it that is drawn to, and which faces are culled.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    pub(super) frame: Size,
    pub(super) viewport: Viewport,
    pub(super) cull: Cull,
    /// Whether depths are [biased](crate::canvas::Biased).
    pub(super) is_biased: bool,
}

impl Screen {
    /// The pixels that a draw call may write in some rows.
    #[inline]
    pub(super) fn scissor(&self, rows: &Range<u32>) -> Scissor {
        Scissor::new(&self.viewport, self.frame.width, rows)
    }

    /// Returns an error if `given`, the frame size of a canvas, is not the size of this frame.
    pub(super) fn check(&self, given: Size) -> Result<(), Error> {
        let needed = self.frame;
        if given == needed {
            return Ok(());
        }
        Err(Error::Frame {
            width: given.width,
            height: given.height,
            needed_width: needed.width,
            needed_height: needed.height,
        })
    }
}

/// Where a draw call draws to: some rows of a frame.
pub(super) type Region<'s> = (&'s Screen, &'s Range<u32>);

/// The data that all primitives of a draw call share once they are on the screen.
#[derive(Clone, Debug)]
pub(super) struct Shared<'m> {
    pub(super) mesh: &'m Mesh<'m>,
    pub(super) placement: Placement<'m>,
    pub(super) cull: Cull,
    pub(super) scissor: Scissor,
}

impl Shared<'_> {
    /// A triangle, edge or point in the form that shaders receive, with twice its area on the screen.
    #[inline]
    pub(super) fn primitive(&self, indices: Indices, area: i64) -> Primitive<'_> {
        Primitive {
            mesh: self.mesh,
            placement: &self.placement,
            indices,
            area: (area >> 32) as i32,
            slope_beside: 0,
        }
    }
}

/// A mesh, and the transform that takes it to the screen.
#[derive(Clone, Debug)]
pub(super) struct Call<'m, K> {
    pub(super) slots: Slots,
    /// Whether depths are [biased](crate::canvas::Biased).
    pub(super) is_biased: bool,
    pub(super) shared: Shared<'m>,
    pub(super) projector: Projector<'m, K>,
}

impl<'m, K: ProjectionKind> Call<'m, K> {
    /// A draw call to `rows` of a frame.
    #[inline(never)]
    pub(super) fn new<V: AsMvp<Kind = K>>(
        (screen, rows): Region<'_>,
        mesh: &'m Mesh<'m>,
        mvp: &'m V,
    ) -> Self {
        let view = mvp.model_view_of();
        let viewport = &screen.viewport;
        Self {
            slots: Slots::new(mesh.faces()),
            is_biased: screen.is_biased,
            projector: Projector::new(mesh.positions(), mvp.projection_of(), &view, viewport),
            shared: Shared {
                mesh,
                cull: screen.cull.mirrored(view.is_mirror),
                placement: Placement::new(mvp.model_of(), view),
                scissor: screen.scissor(rows),
            },
        }
    }
}
