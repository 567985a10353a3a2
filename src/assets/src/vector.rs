//! Vectors in f64, for computations before anything is drawn.

/// A position or a direction.
pub type Vector = [f64; 3];

/// a − b.
#[must_use]
pub fn sub(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

/// a + b.
#[must_use]
pub fn add(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// a + direction · by.
#[must_use]
pub fn along(a: Vector, direction: Vector, by: f64) -> Vector {
    [0, 1, 2].map(|i| a[i] + direction[i] * by)
}

/// The dot product.
#[must_use]
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product.
#[must_use]
pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The length.
#[must_use]
pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The largest absolute value of a coordinate.
#[must_use]
pub fn largest(a: Vector) -> f64 {
    a.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// The vector of length 1 in the direction of `a`; `None` if `a` has no direction.
#[must_use]
pub fn unit(a: Vector) -> Option<Vector> {
    let size = largest(a);
    let a = a.map(|x| x / size);
    let length = length(a);
    (size > 0.0 && length.is_finite()).then(|| a.map(|x| x / length))
}
