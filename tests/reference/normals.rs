//! Smooth normals: at each position, the mean of its triangles' normals, weighted by their angles there.

type V = [f64; 3];

fn minus(a: V, b: V) -> V {
    std::array::from_fn(|i| a[i] - b[i])
}

fn dot(a: V, b: V) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: V, b: V) -> V {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The vector scaled to length one; NaN for the zero vector.
pub fn unit(v: V) -> V {
    v.map(|x| x / dot(v, v).sqrt())
}

/// The angle between two vectors, in radians.
pub fn angle(a: V, b: V) -> f64 {
    let c = cross(a, b);
    dot(c, c).sqrt().atan2(dot(a, b))
}

/// The unit normal of a triangle.
pub fn of_triangle([a, b, c]: [V; 3]) -> V {
    unit(cross(minus(b, a), minus(c, a)))
}

/// The sum of the weighted normals around a position, and of their weights, over the triangles with accepted normals.
pub fn around(
    position: usize,
    positions: &[V],
    faces: &[[usize; 3]],
    accepted: impl Fn(V) -> bool,
) -> (V, f64) {
    let (mut sum, mut weights) = ([0.; 3], 0.);
    for face in faces {
        let normal = of_triangle(face.map(|i| positions[i]));
        if normal[0].is_nan() || !accepted(normal) {
            continue;
        }
        for corner in (0..3).filter(|&corner| face[corner] == position) {
            let [a, b, c] = [0, 1, 2].map(|i| positions[face[(corner + i) % 3]]);
            let weight = angle(minus(b, a), minus(c, a));
            sum = std::array::from_fn(|i| sum[i] + weight * normal[i]);
            weights += weight;
        }
    }
    (sum, weights)
}
