//! Clipping in homogeneous coordinates.

use heapless::Vec;

use super::project::{ClipPosition, Projector};
use crate::interpolate::reciprocal;
use crate::view::Kind;

/// Where a point lies in its triangle: how much of the second and of the third corner it has, in
/// units of 2⁻³⁰; the first has the rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights([i32; 2]);

impl Weights {
    /// Those of the corners themselves.
    pub(crate) const CORNERS: [Self; 3] = [Self([0, 0]), Self([1 << 30, 0]), Self([0, 1 << 30])];

    /// The varyings of the point, of those of the corners: to the nearest unit but for the rounding of the weights.
    pub(crate) fn mix<const N: usize>(self, corners: &[[i32; N]; 3]) -> [i32; N] {
        let [from, second, third] = corners;
        let [b, c] = self.0.map(i64::from);
        let mut varyings = *from;
        for ((value, second), third) in varyings.iter_mut().zip(second).zip(third) {
            let way = |to: i32| i64::from(to) - i64::from(*value);
            // Ways take 33 bits, and the weights are together at most 2^30 and a few units.
            let sum = way(*second) * b + way(*third) * c;
            let mixed = i64::from(*value) + ((sum + (1 << 29)) >> 30);
            *value = mixed.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        }
        varyings
    }
}

/// A corner in clip space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipVertex {
    pub(crate) position: ClipPosition,
    pub(crate) weights: Weights,
}

/// Most corners of a clipped triangle: each of six planes adds one at most.
pub(crate) const MOST_CORNERS: usize = 9;

/// A clipped triangle.
pub(crate) type Polygon = Vec<ClipVertex, MOST_CORNERS>;

/// The part of a triangle inside the `planes` (a bit each) that any of its corners is outside of.
///
/// An edge is cut by the planes that its own ends are outside of, in the order of the planes, from
/// its inside end: so two triangles that share an edge get the same new corners.
pub(crate) fn triangle<K: Kind>(
    projector: &Projector<K>,
    corners: &[ClipPosition; 3],
    planes: u8,
) -> Polygon {
    let mut polygon = Polygon::new();
    for (&position, weights) in corners.iter().zip(Weights::CORNERS) {
        let _ = polygon.push(ClipVertex { position, weights });
    }
    for plane in (0..6).filter(|plane| planes >> plane & 1 != 0) {
        let mut inside = Polygon::new();
        // There is room: a plane cuts a convex polygon's outline twice.
        let mut add = |vertex| inside.push(vertex).unwrap_or(());
        let Some(mut from) = polygon.last() else {
            break;
        };
        let mut from_distance = projector.distance(from.position, plane);
        for to in &polygon {
            let to_distance = projector.distance(to.position, plane);
            let from_out = Projector::<K>::is_outside(from_distance, plane);
            let to_out = Projector::<K>::is_outside(to_distance, plane);
            if from_out && !to_out {
                add(cut(
                    projector,
                    plane,
                    (to, to_distance),
                    (from, from_distance),
                ));
            } else if to_out && !from_out {
                add(cut(
                    projector,
                    plane,
                    (from, from_distance),
                    (to, to_distance),
                ));
            }
            if !to_out {
                add(*to);
            }
            (from, from_distance) = (to, to_distance);
        }
        polygon = inside;
    }
    polygon
}

/// The part of a line inside the `planes` that any of its ends is outside of.
pub(crate) fn line<K: Kind>(
    projector: &Projector<K>,
    [a, b]: [ClipPosition; 2],
    planes: u8,
) -> Option<[ClipVertex; 2]> {
    let [at_a, at_b, _] = Weights::CORNERS;
    let end = |position, weights| ClipVertex { position, weights };
    let (mut a, mut b) = (end(a, at_a), end(b, at_b));
    for plane in (0..6).filter(|plane| planes >> plane & 1 != 0) {
        let (at_a, at_b) = (
            projector.distance(a.position, plane),
            projector.distance(b.position, plane),
        );
        match (
            Projector::<K>::is_outside(at_a, plane),
            Projector::<K>::is_outside(at_b, plane),
        ) {
            (true, true) => return None,
            (true, false) => a = cut(projector, plane, (&b, at_b), (&a, at_a)),
            (false, true) => b = cut(projector, plane, (&a, at_a), (&b, at_b)),
            (false, false) => {}
        }
    }
    Some([a, b])
}

/// Where `plane` cuts the edge from `inside` to `outside`, which come with their distances from it.
fn cut<K: Kind>(
    projector: &Projector<K>,
    plane: u32,
    (inside, inner): (&ClipVertex, i64),
    (outside, outer): (&ClipVertex, i64),
) -> ClipVertex {
    // The fraction of the way, inner / (inner - outer), in units of 2^-31 and rounded down.
    let (inner, outer) = (inner.max(0).unsigned_abs(), outer.unsigned_abs());
    let sum = ((inner >> 1) + (outer >> 1)) | 1;
    let up = sum.leading_zeros();
    let (part, whole) = ((inner >> 1 << up >> 33) as u32, (sum << up >> 33) as u32);
    let fraction = ((u64::from(part) * u64::from(reciprocal(whole))) >> 30)
        .min((1 << 31) - 1)
        .cast_signed();

    let mut position = inside.position;
    for (from, to) in position.iter_mut().zip(outside.position) {
        let way = to.saturating_sub(*from);
        // The fraction of 64 bits, from the halves; below 2^63 as the fraction is below 2^31.
        *from += (((way >> 32) * fraction) << 1) + (((way & 0xffff_ffff) * fraction) >> 31);
    }
    let mut weights = inside.weights;
    for (from, to) in weights.0.iter_mut().zip(outside.weights.0) {
        // At most 2^30 by less than 2^31.
        *from += ((i64::from(to - *from) * fraction) >> 31) as i32;
    }
    ClipVertex {
        position: projector.onto(position, plane),
        weights,
    }
}
