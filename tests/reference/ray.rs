//! Where a ray from the origin meets a triangle.

use super::linear::{Vec3, cross, dot, subtract};

/// The barycentric coordinates of the point in which the ray meets the triangle, from either side; `None` if it misses.
///
/// The ray d meets the plane of a, b, c at the point whose coordinates are the volumes of the tetrahedra that d makes
/// with two corners each, divided by their sum.
pub fn hit(direction: Vec3, [a, b, c]: [Vec3; 3]) -> Option<[f64; 3]> {
    let volumes = [(b, c), (c, a), (a, b)].map(|(p, q)| dot(direction, cross(p, q)));
    let sum: f64 = volumes.iter().sum();
    let parts = volumes.map(|volume| volume / sum);
    // The ray has only one direction: the plane must lie ahead, not behind the origin.
    let normal = cross(subtract(b, a), subtract(c, a));
    let ahead = dot(normal, a) * dot(normal, direction) > 0.;
    (ahead && parts.iter().all(|&part| part >= 0.)).then_some(parts)
}
