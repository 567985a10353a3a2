//! The inputs of a draw call, except shader and canvas.

use core::ops::Range;

use embedded_graphics::geometry::Size;

use super::cache::Slots;
use super::vertex::Projector;
use crate::error::Error;
use crate::mesh::{Mesh, Placement};
use crate::raster::{Blitter, Cull, Rasterizer, Scissor};
use crate::view::{AsMvp, ProjectionKind, Viewport};

/// A frame, the part of it that is drawn to, and which faces are culled.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    pub(super) frame: Size,
    pub(super) viewport: Viewport,
    pub(super) cull: Cull,
    /// Whether depths are [biased](crate::canvas::Biased): then the edges of an outline need a slope.
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
        Err(Error::SizeDiffers {
            of: "the canvas's frame",
            given: [given.width, given.height],
            needed: [needed.width, needed.height],
            like: "the frame of the list",
        })
    }
}

/// Where a draw call draws to: some rows of a frame.
pub(super) type Region<'s> = (&'s Screen, &'s Range<u32>);

/// A draw call: a mesh, where it is placed, and which of its triangles and pixels are left out.
#[derive(Clone, Debug)]
pub(super) struct Call<'m, K> {
    pub(super) projector: Projector<'m, K>,
    pub(super) placement: Placement<'m>,
    pub(super) slots: Slots,
    pub(super) cull: Cull,
    pub(super) scissor: Scissor,
    pub(super) screen: &'m Screen,
}

/// How many pixels lines may reach beyond their ends: half of their greatest width, and half a pixel if they are smooth.
const REACH: i32 = 33;

impl<'m, K: ProjectionKind> Call<'m, K> {
    /// A draw call to `rows` of a frame.
    #[inline(never)]
    pub(super) fn new<V: AsMvp<Kind = K>>(
        (screen, rows): Region<'m>,
        mesh: &'m Mesh<'m>,
        mvp: &'m V,
    ) -> Self {
        let view = mvp.model_view_of();
        let viewport = &screen.viewport;
        let positions = mesh.positions();
        Self {
            slots: Slots::new(mesh.faces()),
            scissor: screen.scissor(rows),
            cull: screen.cull.mirrored(view.is_mirror),
            placement: Placement::new(mesh, mvp.model_of(), view),
            screen,
            // Last, so that it is made in place.
            projector: Projector::new(positions, mvp.projection_of(), &view, viewport),
        }
    }

    /// Whether the mesh is certain to have no pixel in the frame, because the box around it is known and out of view.
    /// No box is known in a program that is optimized for size.
    #[cfg_attr(not(for_size), inline(never))]
    pub(super) fn is_outside(&self) -> bool {
        let positions = self.placement.mesh.positions();
        let Some(bounds) = positions.known_bounds() else {
            return false;
        };
        // The box is tested against all rows of the frame, so that a band counts like the frame.
        let Scissor { columns, rows } = self.screen.scissor(&(0..self.screen.frame.height));
        let reached = Scissor {
            columns: columns.start - REACH..columns.end + REACH,
            rows: rows.start - REACH..rows.end + REACH,
        };
        self.projector.misses(bounds, &reached)
    }

    /// The rasterizer of this call, which draws primitives once they are on the screen.
    #[inline]
    pub(super) fn rasterizer<'c>(&'c self, blitter: &'c mut dyn Blitter) -> Rasterizer<'c> {
        let shift = self.projector.depth_shift();
        Rasterizer::new(blitter, shift, &self.placement, &self.scissor)
    }
}
