//! Where a ray from the origin meets a triangle.

use super::linear::{Vec3, cross, dot, subtract};

/// The barycentric coordinates of the point where the ray meets the triangle, from either side; `None` if it misses.
///
/// The direction d of the ray forms a tetrahedron with each two of the corners a, b and c. The coordinates are the
/// volumes of these tetrahedra, divided by their sum.
pub fn hit(direction: Vec3, [a, b, c]: [Vec3; 3]) -> Option<[f64; 3]> {
    let volumes = [(b, c), (c, a), (a, b)].map(|(p, q)| dot(direction, cross(p, q)));
    let sum: f64 = volumes.iter().sum();
    let parts = volumes.map(|volume| volume / sum);
    // A ray goes in one direction only: the plane must be ahead of the origin, not behind it.
    let normal = cross(subtract(b, a), subtract(c, a));
    let ahead = dot(normal, a) * dot(normal, direction) > 0.;
    (ahead && parts.iter().all(|&part| part >= 0.)).then_some(parts)
}
