//! Clipping in homogeneous coordinates.

use heapless::Vec;

use super::vertex::{ClipPosition, Projector};
use crate::mesh::Index;
use crate::num::reciprocal;
use crate::raster::{Barycentric, ClippedVertex, ScreenVertex};
use crate::view::ProjectionKind;

/// Most corners of a clipped triangle: three, and at most one more for each of six planes.
const MOST_CORNERS: usize = 9;

/// A clipped triangle or line on the screen.
pub(crate) type ClippedPolygon = Vec<ClippedVertex, MOST_CORNERS>;

/// A corner of a triangle or line while it is clipped.
#[derive(Clone, Copy)]
struct ClipVertex {
    position: ClipPosition,
    /// [`Barycentric`] weights, as wide as the position, because they are cut in the same way.
    barycentric: [i64; 2],
}

type Polygon = Vec<ClipVertex, MOST_CORNERS>;

/// Clips a line between two positions, or a triangle of three, to the inside of `planes`. This mask has a bit for
/// each plane that any of the corners is outside of. Adds the corners of the result to `clipped`: none if nothing is
/// inside. (An out-parameter saves a copy of 220 bytes, and the routine that copies.)
///
/// An edge is cut only by the planes that its own ends are outside of, in the order of the planes, and from its
/// inside end. So two triangles that share an edge get the same new corners.
#[inline(never)]
pub(crate) fn clip<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    corners: &[Index],
    planes: u8,
    clipped: &mut ClippedPolygon,
) {
    let (mut polygon, mut inside) = (&mut Polygon::new(), &mut Polygon::new());
    for (&index, weights) in corners.iter().zip(Barycentric::CORNERS) {
        let _ = polygon.push(ClipVertex {
            position: projector.clip_position(index),
            barycentric: weights.0.map(i64::from),
        });
    }
    let closed = corners.len() > 2;
    for plane in (0..6).filter(|plane| planes >> plane & 1 != 0) {
        inside.clear();
        clip_to_plane(projector, plane, (polygon, closed), inside);
        (polygon, inside) = (inside, polygon);
    }
    for corner in polygon {
        let mut vertex = ScreenVertex::UNSET;
        projector.project_inside(&corner.position, &mut vertex);
        let _ = clipped.push(ClippedVertex {
            vertex,
            // Weights are at most 2^30.
            barycentric: Barycentric(corner.barycentric.map(|weight| weight as i32)),
        });
    }
}

/// Writes to `inside` the part of a polygon that is inside a plane, or of a line if it is not `closed`.
#[inline(never)]
fn clip_to_plane<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    plane: u32,
    (polygon, closed): (&[ClipVertex], bool),
    inside: &mut Polygon,
) {
    // There is room, because a plane cuts the outline of a convex polygon twice.
    let mut add = |vertex: ClipVertex| inside.push(vertex).unwrap_or(());
    // A polygon's last corner is joined to its first, a line's is not.
    let mut from = polygon.last().filter(|_| closed);
    for to in polygon {
        let to_distance = projector.distance(&to.position, plane);
        let is_out = |distance| Projector::<K>::is_outside(distance, plane);
        if let Some(from) = from {
            let from_distance = projector.distance(&from.position, plane);
            if is_out(from_distance) != is_out(to_distance) {
                let ends = [(from, from_distance), (to, to_distance)];
                add(cut(projector, plane, ends));
            }
        }
        if !is_out(to_distance) {
            add(*to);
        }
        from = Some(to);
    }
}

/// The point where `plane` cuts an edge that has one end inside and one outside. Each end comes with its distance
/// from the plane.
///
/// ```text
///  inside          plane          outside
///    ●───── inner ───┼─── outer ─────○
/// ```
fn cut<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    plane: u32,
    [mut inside, mut outside]: [(&ClipVertex, i64); 2],
) -> ClipVertex {
    if inside.1 < outside.1 {
        (inside, outside) = (outside, inside);
    }
    // The fraction of the way from inside to outside, inner / (inner + outer), in units of 2^-31, rounded down.
    let (inner, outer) = (inside.1.max(0).unsigned_abs(), outside.1.unsigned_abs());
    let sum = ((inner >> 1) + (outer >> 1)) | 1;
    let up = sum.leading_zeros();
    let (part, whole) = ((inner >> 1 << up >> 33) as u32, (sum << up >> 33) as u32);
    let fraction = ((u64::from(part) * u64::from(reciprocal(whole))) >> 30)
        .min((1 << 31) - 1)
        .cast_signed();

    let (mut vertex, outside) = (*inside.0, outside.0);
    let values = vertex.position.iter_mut().chain(&mut vertex.barycentric);
    let others = outside.position.iter().chain(&outside.barycentric);
    for (from, to) in values.zip(others) {
        let difference = to.saturating_sub(*from);
        // The product of 64 bits and the fraction, from the halves of `difference`: below 2^63, because the fraction
        // is below 2^31.
        *from += (((difference >> 32) * fraction) << 1)
            + (((difference & 0xffff_ffff) * fraction) >> 31);
    }
    projector.put_onto(&mut vertex.position, plane);
    vertex
}
