//! Clipping in homogeneous coordinates.

use heapless::Vec;

use super::project::{ClipPosition, Projector};
use super::projected::Projected;
use crate::mesh::Index;
use crate::num::reciprocal;
use crate::view::ProjectionKind as Kind;

/// Where a point lies in its triangle: how much of the second and of the third corner it has, in
/// units of 2⁻³⁰; the first has the rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights([i32; 2]);

impl Weights {
    /// Those of the corners themselves.
    pub(crate) const CORNERS: [Self; 3] = [Self([0, 0]), Self([1 << 30, 0]), Self([0, 1 << 30])];

    /// A varying of the point, of those of the corners: to the nearest unit but for the rounding of the weights.
    pub(crate) fn mix(self, [value, second, third]: &[i32; 3]) -> i32 {
        let way = |to: &i32| i64::from(*to) - i64::from(*value);
        let [b, c] = self.0.map(i64::from);
        // Ways take 33 bits, and the weights are together at most 2^30 and a few units.
        let sum = way(second) * b + way(third) * c;
        let mixed = i64::from(*value) + ((sum + (1 << 29)) >> 30);
        mixed.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }
}

/// Most corners of a clipped triangle: each of six planes adds one at most.
const MOST_CORNERS: usize = 9;

/// A corner of a clipped triangle or an end of a line, and where in the mesh's triangle it lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClippedCorner {
    pub(crate) vertex: Projected,
    pub(crate) weights: Weights,
}

/// A clipped triangle or line on the screen.
pub(crate) type Outline = Vec<ClippedCorner, MOST_CORNERS>;

/// A corner on its way to be clipped.
#[derive(Clone, Copy)]
struct ClipVertex {
    position: ClipPosition,
    /// [`Weights`], as wide as the position, as they are cut in the same way.
    weights: [i64; 2],
}

type Polygon = Vec<ClipVertex, MOST_CORNERS>;

/// The part of a line between two of the positions or of a triangle of three that is inside the `planes` (a bit
/// each) that any of the corners is outside of; no corners if there is none.
///
/// An edge is cut by the planes that its own ends are outside of, in the order of the planes, from
/// its inside end: so two triangles that share an edge get the same new corners.
#[inline(never)]
pub(crate) fn clip<K: Kind>(
    projector: &Projector<'_, K>,
    corners: &[Index],
    planes: u8,
) -> Outline {
    let (mut polygon, mut inside) = (&mut Polygon::new(), &mut Polygon::new());
    for (&index, weights) in corners.iter().zip(Weights::CORNERS) {
        let _ = polygon.push(ClipVertex {
            position: projector.clip_position(index),
            weights: weights.0.map(i64::from),
        });
    }
    let closed = corners.len() > 2;
    for plane in (0..6).filter(|plane| planes >> plane & 1 != 0) {
        inside.clear();
        cut_off(projector, plane, (polygon, closed), inside);
        (polygon, inside) = (inside, polygon);
    }
    let mut outline = Outline::new();
    for corner in polygon {
        let mut vertex = Projected::NONE;
        projector.project_inside(&corner.position, &mut vertex);
        let _ = outline.push(ClippedCorner {
            vertex,
            // At most 2^30.
            weights: Weights(corner.weights.map(|weight| weight as i32)),
        });
    }
    outline
}

/// Gives `inside` the part of a polygon or, if it is not `closed`, of a line that is inside a plane.
#[inline(never)]
fn cut_off<K: Kind>(
    projector: &Projector<'_, K>,
    plane: u32,
    (polygon, closed): (&[ClipVertex], bool),
    inside: &mut Polygon,
) {
    // There is room: a plane cuts a convex polygon's outline twice.
    let mut add = |vertex: ClipVertex| inside.push(vertex).unwrap_or(());
    // A triangle's last corner is joined to the first, a line's is not.
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

/// Where `plane` cuts an edge of which one end is inside, the other outside; they come with their
/// distances from it.
fn cut<K: Kind>(
    projector: &Projector<'_, K>,
    plane: u32,
    [mut inside, mut outside]: [(&ClipVertex, i64); 2],
) -> ClipVertex {
    if inside.1 < outside.1 {
        (inside, outside) = (outside, inside);
    }
    // The fraction of the way, inner / (inner - outer), in units of 2^-31 and rounded down.
    let (inner, outer) = (inside.1.max(0).unsigned_abs(), outside.1.unsigned_abs());
    let sum = ((inner >> 1) + (outer >> 1)) | 1;
    let up = sum.leading_zeros();
    let (part, whole) = ((inner >> 1 << up >> 33) as u32, (sum << up >> 33) as u32);
    let fraction = ((u64::from(part) * u64::from(reciprocal(whole))) >> 30)
        .min((1 << 31) - 1)
        .cast_signed();

    let (mut vertex, outside) = (*inside.0, outside.0);
    let values = vertex.position.iter_mut().chain(&mut vertex.weights);
    let others = outside.position.iter().chain(&outside.weights);
    for (from, to) in values.zip(others) {
        let way = to.saturating_sub(*from);
        // The fraction of 64 bits, from the halves; below 2^63 as the fraction is below 2^31.
        *from += (((way >> 32) * fraction) << 1) + (((way & 0xffff_ffff) * fraction) >> 31);
    }
    projector.put_onto(&mut vertex.position, plane);
    vertex
}
