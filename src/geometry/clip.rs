//! Clipping in homogeneous coordinates.

use heapless::Vec;

use super::project::{ClipPosition, Projector};
use crate::interpolate::reciprocal;
use crate::view::Kind;

/// A corner in clip space, with its varyings.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipVertex<const N: usize> {
    pub(crate) position: ClipPosition,
    pub(crate) varyings: [i32; N],
}

/// A clipped triangle: each of six planes adds a corner at most.
pub(crate) type Polygon<const N: usize> = Vec<ClipVertex<N>, 9>;

/// The part of a triangle inside the `planes` (a bit each) that any of its corners is outside of.
///
/// An edge is cut by the planes that its own ends are outside of, in the order of the planes, from
/// its inside end: so two triangles that share an edge get the same new corners.
pub(crate) fn triangle<K: Kind, const N: usize>(
    projector: &Projector<K>,
    corners: &[ClipVertex<N>; 3],
    planes: u8,
) -> Polygon<N> {
    let mut polygon: Polygon<N> = corners.iter().copied().collect();
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
pub(crate) fn line<K: Kind, const N: usize>(
    projector: &Projector<K>,
    [mut a, mut b]: [ClipVertex<N>; 2],
    planes: u8,
) -> Option<[ClipVertex<N>; 2]> {
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
fn cut<K: Kind, const N: usize>(
    projector: &Projector<K>,
    plane: u32,
    (inside, inner): (&ClipVertex<N>, i64),
    (outside, outer): (&ClipVertex<N>, i64),
) -> ClipVertex<N> {
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
    let mut varyings = inside.varyings;
    for (from, to) in varyings.iter_mut().zip(outside.varyings) {
        let way = i64::from(to) - i64::from(*from);
        // The way may take 33 bits; the sum is between the two, so it is right modulo 2^32.
        *from = from.wrapping_add(((way * fraction) >> 31) as i32);
    }
    ClipVertex {
        position: projector.onto(position, plane),
        varyings,
    }
}
