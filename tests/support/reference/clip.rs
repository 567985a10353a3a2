//! Polygons and segments clipped to planes, in homogeneous coordinates (Sutherland–Hodgman).

use super::linear::Vec4;

/// A half-space: a position in clip space is inside if its dot product with the plane is not negative.
pub type Plane = Vec4;

/// The near plane: −w ≤ z.
pub const NEAR: Plane = [0., 0., 1., 1.];
/// The far plane: z ≤ w.
pub const FAR: Plane = [0., 0., -1., 1.];
/// The left plane: −w ≤ x.
pub const LEFT: Plane = [1., 0., 0., 1.];
/// The right plane: x ≤ w.
pub const RIGHT: Plane = [-1., 0., 0., 1.];
/// The bottom plane: −w ≤ y.
pub const BOTTOM: Plane = [0., 1., 0., 1.];
/// The top plane: y ≤ w.
pub const TOP: Plane = [0., -1., 0., 1.];

/// The planes that make a division by w safe.
pub const DEPTH_PLANES: [Plane; 2] = [NEAR, FAR];
/// All six planes of the view volume.
pub const ALL_PLANES: [Plane; 6] = [NEAR, FAR, LEFT, RIGHT, BOTTOM, TOP];

/// A vertex in clip space with its attributes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipVertex<const N: usize> {
    /// Position in clip space.
    pub position: Vec4,
    /// Attributes, which are linear in space.
    pub attributes: [f64; N],
    /// The index of the mesh's position; `None` for a vertex that clipping made.
    pub source: Option<usize>,
}

/// The distance of a position from a plane, in units of w: positive inside, negative outside.
pub fn side(plane: &Plane, position: &Vec4) -> f64 {
    plane.iter().zip(position).map(|(a, b)| a * b).sum()
}

/// The point where an edge meets a plane. The point is always computed from the inside end to the outside end, so that
/// two polygons with the same edge get the same bits.
fn cut<const N: usize>(
    inside: &ClipVertex<N>,
    outside: &ClipVertex<N>,
    plane: &Plane,
) -> ClipVertex<N> {
    let (a, b) = (
        side(plane, &inside.position),
        side(plane, &outside.position),
    );
    let t = a / (a - b);
    let lerp = |from: f64, to: f64| from + t * (to - from);
    ClipVertex {
        position: std::array::from_fn(|i| lerp(inside.position[i], outside.position[i])),
        attributes: std::array::from_fn(|i| lerp(inside.attributes[i], outside.attributes[i])),
        source: None,
    }
}

/// The part of a convex polygon inside all `planes`, with the same winding; empty if no part is inside.
pub fn polygon<const N: usize>(vertices: &[ClipVertex<N>], planes: &[Plane]) -> Vec<ClipVertex<N>> {
    let mut inside = vertices.to_vec();
    for plane in planes {
        let mut kept = Vec::with_capacity(inside.len() + 1);
        for (i, end) in inside.iter().enumerate() {
            let start = &inside[(i + inside.len() - 1) % inside.len()];
            match (
                side(plane, &start.position) >= 0.,
                side(plane, &end.position) >= 0.,
            ) {
                (true, true) => kept.push(*end),
                (true, false) => kept.push(cut(start, end, plane)),
                (false, true) => kept.extend([cut(end, start, plane), *end]),
                (false, false) => {}
            }
        }
        inside = kept;
    }
    inside
}

/// The part of a segment inside all `planes`; `None` if no part is inside.
pub fn segment<const N: usize>(
    ends: [ClipVertex<N>; 2],
    planes: &[Plane],
) -> Option<[ClipVertex<N>; 2]> {
    let [mut start, mut end] = ends;
    for plane in planes {
        match (
            side(plane, &start.position) >= 0.,
            side(plane, &end.position) >= 0.,
        ) {
            (true, true) => {}
            (true, false) => end = cut(&start, &end, plane),
            (false, true) => start = cut(&end, &start, plane),
            (false, false) => return None,
        }
    }
    Some([start, end])
}

/// A convex polygon as triangles that all start at its first vertex, with the same winding.
pub fn fan<const N: usize>(polygon: &[ClipVertex<N>]) -> Vec<[ClipVertex<N>; 3]> {
    (1..polygon.len().max(2) - 1)
        .map(|i| [polygon[0], polygon[i], polygon[i + 1]])
        .collect()
}
