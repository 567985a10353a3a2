//! Edges: from a mesh's indices to lines on the screen, and what an outline asks about the triangles beside them.

use super::cache::VertexCache;
use super::call::Call;
use super::clip::{ClippedPolygon, clip};
use crate::canvas::{DepthBuffer, WideFloatDepth};
use crate::mesh::{Index, Indices};
use crate::num::reciprocal;
use crate::num::wide::{cross, product, unsigned_product};
use crate::raster::{self, Barycentric, ClippedVertex, Polygon, ScreenVertex};
use crate::view::ProjectionKind;

/// Assembles one edge of the mesh. `each` receives the edge's indices, the two ends of the part that is inside all
/// planes, whether the edge was clipped, and how steep the faces beside it are.
#[inline(always)]
#[allow(clippy::inline_always)] // a call takes 30 to 40 instructions, and the compiler's choice depends on the build's path
pub(super) fn edge<K: ProjectionKind, const N: usize>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache<'_, N>,
    (indices, beside): (Indices, u16),
    each: &mut impl FnMut(Indices, [&ClippedVertex; 2], bool, u16),
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
    each(indices, ends, any != 0, beside);
}

/// Twice the areas on the screen of the two faces beside an outline's edge, where they are inside all planes: of a b c
/// and, with the opposite sign, of b a d. A border has no second face; then d equals a, and the second area is 0. Drawn
/// triangles are culled by the signs of the same areas.
#[inline(always)]
#[allow(clippy::inline_always)] // a call takes as long as the rest of the function
pub(super) fn areas<K: ProjectionKind, const N: usize>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache<'_, N>,
    &[a, b, c, d]: &[Index; 4],
) -> [i64; 2] {
    let mut any = 0;
    let mut screen = |index| {
        let vertex = vertices.vertex(&call.projector, index);
        any |= vertex.outcode;
        vertex.screen
    };
    let from = screen(a);
    let mut to = |index| {
        let [x, y] = screen(index);
        [x - from[0], y - from[1]]
    };
    let along = to(b);
    let areas = [cross(along, to(c)), cross(along, to(d))];
    if any == 0 {
        return areas;
    }
    let area = |face| clipped_area(call, vertices, face);
    let [left, right] = [[a, b, c], [b, a, d]].map(area);
    [left, -right]
}

/// Twice the area of the part of a triangle that is inside all planes; 0 if no part is inside.
#[cold]
#[inline(never)]
fn clipped_area<K: ProjectionKind, const N: usize>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache<'_, N>,
    indices: [Index; 3],
) -> i64 {
    let corners = vertices.copies(&call.projector, indices);
    let [a, b, c] = &corners;
    let any = a.outcode | b.outcode | c.outcode;
    if any == 0 {
        return raster::area(&ScreenVertex::screens([a, b, c]));
    }
    if a.outcode & b.outcode & c.outcode != 0 {
        return 0;
    }
    let mut polygon = ClippedPolygon::new();
    clip(&call.projector, &indices, any, &mut polygon);
    Polygon::area(&polygon)
}

/// How steep a triangle beside an edge is: the greatest change of depth from a pixel to the next, across or down, in
/// the format [`WideFloatDepth`]; 0 if the triangle is outside the view. The change is limited to the triangle's range
/// of depths. If the edge is no crease, the limit is twice this range, because on a round body the pixels of a
/// silhouette may lie over the next triangle.
#[inline(never)]
pub(super) fn steepness<K: ProjectionKind, const N: usize>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache<'_, N>,
    indices: [Index; 3],
    is_crease: bool,
) -> u16 {
    let corners = indices.map(|index| *vertices.vertex(&call.projector, index));
    let [a, b, c] = &corners;
    let any = a.outcode | b.outcode | c.outcode;
    let mut polygon = ClippedPolygon::new();
    let widest = if any == 0 {
        let corners = [a, b, c];
        Some((corners, raster::area(&ScreenVertex::screens(corners))))
    } else {
        if a.outcode & b.outcode & c.outcode == 0 {
            clip(&call.projector, &indices, any, &mut polygon);
        }
        Polygon::widest(&polygon)
    };
    let Some((corners, area)) = widest else {
        return 0;
    };
    let ([a, b, c], exponent) = ScreenVertex::weights(corners);
    let range = a.max(b).max(c) - a.min(b).min(c);
    let [b, c] = [b, c].map(|q| q.cast_signed() - a.cast_signed());
    let [from, to_b, to_c] = ScreenVertex::screens(corners);
    let side = |to: [i32; 2]| [to[0] - from[0], to[1] - from[1]];
    let ([bx, by], [cx, cy]) = (side(to_b), side(to_c));
    // `across` and `down` are the changes per 1/256 pixel, times the area. The differences of interpolants have 31 bits
    // and the sides have 20 bits, so the change times the area has 52 bits.
    let across = product(b, cy) - product(c, by);
    let down = product(c, bx) - product(b, cx);
    let gain = across.unsigned_abs().max(down.unsigned_abs());
    // Let the gain be g · 2^(32 - z), and the area a · 2^(32 - y), where g and a have 32 bits with the top bit set.
    // Then the change per pixel, 256 · gain / area, is (g · (2^62 / a) / 2^32) · 2^(y - z - 22). If the gain is 0, g is
    // 0, too. If the area is 0, the result does not matter, because a triangle without area has no pixels.
    let [z, y] = [gain, area.unsigned_abs()].map(u64::leading_zeros);
    let [g, a] =
        [gain << (z & 63), area.unsigned_abs() << (y & 63)].map(|number| (number >> 32) as u32);
    let change = (unsigned_product(g, reciprocal(a >> 1)) >> 32) as u32;
    let shift = call.projector.depth_shift().right_shift(exponent);
    // A change that is shifted by 15 bits or less is greater than any depth.
    let steepness = WideFloatDepth::encode(change, (shift + 22 + z).saturating_sub(y).max(15));
    let most = WideFloatDepth::encode(range, shift - u32::from(!is_crease));
    steepness.min(most) as u16
}
