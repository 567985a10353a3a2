//! Primitive assembly: from a mesh's indices to triangles and lines on the screen, which are whole, clipped or
//! rejected.

use super::cache::VertexCache;
use super::call::Call;
use super::clip::{ClippedPolygon, clip};
use crate::mesh::{Index, Indices};
use crate::raster::{self, Barycentric, ClippedVertex, Polygon, ScreenVertex};
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

/// Assembles one edge of the mesh: `each` receives its indices, the two ends of the part that is inside all planes, and
/// whether it was clipped.
#[inline(always)]
#[allow(clippy::inline_always)] // a call takes 30 to 40 instructions, and the compiler's choice depends on the build's path
pub(super) fn edge<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache,
    indices: Indices,
    each: &mut impl FnMut(Indices, [&ClippedVertex; 2], bool),
) {
    let [first, second, _] = Barycentric::CORNERS;
    let mut end = |index: Index, barycentric: Barycentric| ClippedVertex {
        vertex: *vertices.vertex(&call.projector, index),
        barycentric,
    };
    let [a, b, _] = indices.corners;
    let (from, to) = (&end(a, first), &end(b, second));
    let mut clipped = ClippedPolygon::new();
    let any = from.vertex.outcode | to.vertex.outcode;
    let ends = if any == 0 {
        [from, to]
    } else {
        if from.vertex.outcode & to.vertex.outcode == 0 {
            clip(&call.projector, &[a, b], any, &mut clipped);
        }
        let [from, to] = &*clipped else {
            return;
        };
        [from, to]
    };
    each(indices, ends, any != 0);
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
