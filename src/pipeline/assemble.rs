//! Primitive assembly: from a mesh's indices to triangles on the screen, which are whole, clipped or
//! rejected.

use super::cache::VertexCache;
use super::call::Call;
use super::clip::{ClippedPolygon, clip};
use crate::mesh::{Index, Indices};
use crate::raster::{self, ClippedVertex, Polygon, ScreenVertex};
use crate::view::ProjectionKind;

/// Receives assembled triangles, to draw them or to list them.
pub(super) trait Assembly {
    /// Receives a triangle that is inside all planes and not culled, and twice its area.
    fn whole(&mut self, indices: Indices, corners: [&ScreenVertex; 3], area: i64);

    /// Receives the part of a triangle that is inside all planes; it may be empty or face away.
    fn clipped(&mut self, indices: Indices, polygon: &[ClippedVertex]);
}

/// Assembles one triangle of the mesh: rejects it, passes it on whole, or clips it.
#[inline]
pub(super) fn triangle<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache,
    (face, corners): (usize, &[Index; 3]),
    to: &mut impl Assembly,
) {
    let copies;
    let [a, b, c] = if let Some(vertices) = vertices.corners(&call.projector, *corners) {
        vertices
    } else {
        copies = vertices.copies(&call.projector, *corners);
        let [a, b, c] = &copies;
        [a, b, c]
    };
    let outcode = a.outcode | b.outcode | c.outcode;
    if outcode == 0 {
        // Back faces, half of most meshes, are rejected here, before any attribute is read.
        let area = raster::area(&[a.screen, b.screen, c.screen]);
        if !call.shared.cull.leaves_out(area) {
            to.whole(Indices::of_face(face, *corners), [a, b, c], area);
        }
    } else if a.outcode & b.outcode & c.outcode == 0 {
        let mut polygon = ClippedPolygon::new();
        clip(&call.projector, corners, outcode, &mut polygon);
        to.clipped(Indices::of_face(face, *corners), &polygon);
    }
}

/// Twice the area of the part of a triangle that is inside all planes; 0 if there is none. [`triangle`] culls by its
/// sign.
#[inline(never)]
pub(super) fn area<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache,
    indices: [Index; 3],
) -> i64 {
    let (mut any, mut all) = (0, !0);
    let screens = indices.map(|index| {
        let vertex = vertices.vertex(&call.projector, index);
        any |= vertex.outcode;
        all &= vertex.outcode;
        vertex.screen
    });
    if any == 0 {
        return raster::area(&screens);
    }
    if all != 0 {
        return 0;
    }
    let mut polygon = ClippedPolygon::new();
    clip(&call.projector, &indices, any, &mut polygon);
    Polygon::area(&polygon)
}
