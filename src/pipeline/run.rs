//! The stages of a draw call, in order.
//!
//! ```text
//! mesh ─▶ vertex ─▶ assemble ─▶ raster ─▶ blit ─▶ canvas
//! ```
//!
//! Vertices are projected once and kept for neighboring triangles ([`vertex`](super::vertex), [`VertexCache`]).
//! Triangles are culled and clipped ([`assemble`]). The remaining triangles become spans of pixels ([`raster`]), and
//! the spans become colors ([`Blitter`]).

use super::Drawn;
use super::assemble::{self, Assembly};
use super::cache::VertexCache;
use super::call::{Call, Shared};
use crate::mesh::{Index, Indices, Primitive};
use crate::raster::{self, Blitter, ClippedVertex, Polygon, Rasterizer, ScreenVertex, Triangle};
use crate::view::ProjectionKind;

/// Runs all triangles of a mesh through the vertex and assembly stages; `to` draws them or keeps them in a list.
#[inline]
pub(super) fn triangles<K: ProjectionKind>(call: &Call<'_, K>, to: &mut impl Assembly) {
    // The cache is made before the faces are found, because this takes fewer registers on Cortex-M0+.
    let mut vertices = VertexCache::new(call.slots);
    triangles_from(call, (0, call.shared.mesh.faces()), &mut vertices, to);
}

/// Runs triangles through the stages, with the caller's cache. `first` is the index of the first triangle. (This is a
/// function of its own, because otherwise each triangle takes a call in programs that also draw quads.)
#[inline]
fn triangles_from<K: ProjectionKind>(
    call: &Call<'_, K>,
    (first, faces): (usize, &[[Index; 3]]),
    vertices: &mut VertexCache,
    to: &mut impl Assembly,
) {
    for (face, indices) in (first..).zip(faces) {
        assemble::triangle(call, vertices, (face, indices), to);
    }
}

/// Draws all triangles of a mesh, in code that exists once for all shaders and canvases.
#[inline(never)]
pub(super) fn draw<K: ProjectionKind>(call: &Call<'_, K>, blitter: &mut dyn Blitter) -> Drawn {
    let mut draw = Draw::new(blitter, &call.shared, call.shared.mesh.faces().len());
    triangles(call, &mut draw);
    draw.drawn()
}

/// Whether one plane goes through the varyings of both triangles of a rectangle.
pub(super) type IsPlane<'p> = &'p dyn Fn([&Primitive<'_>; 2]) -> bool;

/// Draws quads: the triangles of a mesh in pairs. `first` is the index of the first triangle. The cache must hold no
/// vertices of other meshes. If quads are upright rectangles on the screen, each at one depth, `is_plane` tells which
/// quads to draw as one primitive.
#[inline(never)]
pub(super) fn quads<K: ProjectionKind>(
    call: &Call<'_, K>,
    first: usize,
    vertices: &mut VertexCache,
    is_plane: Option<IsPlane<'_>>,
    blitter: &mut dyn Blitter,
) -> Drawn {
    let faces = call.shared.mesh.faces();
    let mut draw = Draw::new(blitter, &call.shared, faces.len());
    let pairs = faces.chunks_exact(2);
    for (at, pair) in (first..).step_by(2).zip(pairs) {
        let is_done =
            is_plane.is_some_and(|is_plane| rectangle(call, (at, pair), is_plane, &mut draw));
        if !is_done {
            triangles_from(call, (at, pair), vertices, &mut draw);
        }
    }
    draw.drawn()
}

/// Fast path for two triangles that form an axis-aligned rectangle at one depth. The rectangle reaches from the first
/// corner of the first triangle to the last corner of the second. Returns false if the rectangle must be drawn as two
/// triangles.
#[inline]
fn rectangle<K: ProjectionKind>(
    call: &Call<'_, K>,
    (first, faces): (usize, &[[Index; 3]]),
    is_plane: IsPlane<'_>,
    draw: &mut Draw<'_>,
) -> bool {
    let &[one, other] = faces else {
        return false;
    };
    let ([a, ..], [.., d]) = (one, other);
    let [mut from, mut to] = [ScreenVertex::UNSET; 2];
    call.projector.project(a, None, &mut from);
    call.projector.project(d, None, &mut to);
    // The other two corners have the same coordinates as these two.
    if from.outcode | to.outcode != 0 {
        return from.outcode & to.outcode != 0;
    }
    let ([left, bottom], [right, top]) = (from.screen, to.screen);
    let corner = |screen| ScreenVertex { screen, ..from };
    let (b, c) = (corner([right, bottom]), corner([left, top]));
    let area = raster::area(&[from.screen, b.screen, c.screen]);
    let Some(half) = &Triangle::new([&from, &b, &c], None, area, &call.shared.scissor) else {
        return true;
    };
    let shared = &call.shared;
    let (one, other) = (
        Indices::of_face(first, one),
        Indices::of_face(first + 1, other),
    );
    let is_plane = is_plane([&shared.primitive(one, area), &shared.primitive(other, area)]);
    if is_plane {
        draw.raster.begin_primitive(one, area).rectangle(half);
        draw.drawn += 2;
    }
    is_plane
}

/// Draws assembled triangles.
pub(super) struct Draw<'d> {
    raster: Rasterizer<'d>,
    shared: &'d Shared<'d>,
    submitted: usize,
    drawn: u32,
    clipped: u32,
}

impl<'d> Draw<'d> {
    #[inline]
    pub(super) fn new(
        blitter: &'d mut dyn Blitter,
        shared: &'d Shared<'d>,
        submitted: usize,
    ) -> Self {
        Self {
            raster: Rasterizer::new(
                blitter,
                shared.primitive(Indices::of_point(0), 0),
                &shared.scissor,
            ),
            shared,
            submitted,
            drawn: 0,
            clipped: 0,
        }
    }

    /// The result of the draw call.
    #[inline]
    pub(super) fn drawn(self) -> Drawn {
        Drawn {
            submitted: self.submitted as u32,
            drawn: self.drawn,
            clipped: self.clipped,
            missing: self.shared.placement.missing.get(),
        }
    }

    /// Whether a line or point may have pixels in the scissor. The line or point lies between the positions a and b, in
    /// units of 1/256 row, and reaches up to `reach` rows beyond them.
    #[inline]
    pub(super) fn meets(&self, [a, b]: [i32; 2], reach: i32) -> bool {
        let rows = &self.shared.scissor.rows;
        (a.min(b) >> 8) - reach < rows.end && (a.max(b) >> 8) + reach >= rows.start
    }

    /// Draws an edge or a point by `line`. `slope_beside` is how steep the faces beside an outline's edge are.
    #[inline]
    pub(super) fn draw_thin(
        &mut self,
        (indices, slope_beside): (Indices, u16),
        is_clipped: bool,
        line: impl FnOnce(&mut Rasterizer<'d>),
    ) {
        line(self.raster.begin_thin(indices, slope_beside));
        self.drawn += 1;
        self.clipped += u32::from(is_clipped);
    }
}

impl Assembly for Draw<'_> {
    #[cfg_attr(not(for_size), inline(never))] // so that the loop over faces, half of them rejected, has its registers
    fn whole(&mut self, indices: Indices, corners: [&ScreenVertex; 3], area: i64) {
        // Borrowed, because a move would copy the triangle.
        if let Some(triangle) = &Triangle::new(corners, None, area, &self.shared.scissor) {
            self.raster
                .begin_primitive(indices, area)
                .triangle(triangle, None);
            self.drawn += 1;
        }
    }

    #[inline(never)]
    fn clipped(&mut self, indices: Indices, polygon: &[ClippedVertex]) {
        if let Some(polygon) = Polygon::new(polygon, self.shared.cull) {
            let drawn = u32::from(polygon.draw(self.raster.begin_primitive(indices, polygon.area)));
            self.drawn += drawn;
            self.clipped += drawn;
        }
    }
}
