//! Smooth normals: at each position, the mean of the normals of its triangles, weighted by the triangles' angles there.

use super::linear::{Vec3, cross, dot, length, normalized, subtract};

/// The angle between two vectors, in radians.
pub fn angle(a: Vec3, b: Vec3) -> f64 {
    length(cross(a, b)).atan2(dot(a, b))
}

/// The unit normal of a triangle.
fn of_triangle([a, b, c]: [Vec3; 3]) -> Vec3 {
    normalized(cross(subtract(b, a), subtract(c, a)))
}

/// The sum of the weighted normals of the triangles around a position, and the sum of the weights.
pub fn around(position: usize, positions: &[Vec3], faces: &[[usize; 3]]) -> (Vec3, f64) {
    let (mut sum, mut weights) = ([0.; 3], 0.);
    for face in faces {
        let normal = of_triangle(face.map(|i| positions[i]));
        if normal[0].is_nan() {
            continue;
        }
        for corner in (0..3).filter(|&corner| face[corner] == position) {
            let [a, b, c] = [0, 1, 2].map(|i| positions[face[(corner + i) % 3]]);
            let weight = angle(subtract(b, a), subtract(c, a));
            sum = std::array::from_fn(|i| sum[i] + weight * normal[i]);
            weights += weight;
        }
    }
    (sum, weights)
}
