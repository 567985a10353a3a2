//! Vectors and 4x4 matrices, in their textbook forms.

/// A point or direction in three dimensions.
pub type Vec3 = [f64; 3];

/// A homogeneous point.
pub type Vec4 = [f64; 4];

/// A matrix, as four rows. A column vector stands on its right: `M · v`.
pub type Matrix = [[f64; 4]; 4];

/// The identity matrix.
pub const IDENTITY: Matrix = [
    [1., 0., 0., 0.],
    [0., 1., 0., 0.],
    [0., 0., 1., 0.],
    [0., 0., 0., 1.],
];

/// Σ aᵢ bᵢ.
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b, right-handed.
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a − b.
pub fn subtract(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// ‖v‖.
pub fn length(v: Vec3) -> f64 {
    dot(v, v).sqrt()
}

/// v/‖v‖; NaN for the zero vector.
pub fn normalized(v: Vec3) -> Vec3 {
    let length = length(v);
    [v[0] / length, v[1] / length, v[2] / length]
}

/// The product a · b, which applies `b` first, then `a`.
pub fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..4).map(|k| a[row][k] * b[k][column]).sum())
    })
}

/// The product of matrices in the order written: the last one acts first. The product of no matrices is `IDENTITY`.
pub fn product(matrices: &[Matrix]) -> Matrix {
    matrices
        .iter()
        .fold(IDENTITY, |all, matrix| multiply(&all, matrix))
}

/// M · v.
pub fn apply(m: &Matrix, v: Vec4) -> Vec4 {
    let with = |row: [f64; 4]| row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + row[3] * v[3];
    [with(m[0]), with(m[1]), with(m[2]), with(m[3])]
}

/// M · (p, 1), before the division by w.
pub fn apply_point(m: &Matrix, p: Vec3) -> Vec4 {
    apply(m, [p[0], p[1], p[2], 1.])
}

/// M · (p, 1) for an affine `m`. The last row of `m` is (0, 0, 0, 1).
pub fn point(m: &Matrix, p: Vec3) -> Vec3 {
    let [x, y, z, _] = apply_point(m, p);
    [x, y, z]
}

/// M · (v, 0) for an affine `m`. The translation has no effect.
pub fn direction(m: &Matrix, v: Vec3) -> Vec3 {
    let [x, y, z, _] = apply(m, [v[0], v[1], v[2], 0.]);
    [x, y, z]
}

/// A surface normal, transformed by the inverse transpose of the linear part of `m`, with length 1; `None` if `m` has
/// no inverse.
pub fn normal(m: &Matrix, n: Vec3) -> Option<Vec3> {
    let inverse = inverse(m)?;
    Some(normalized(std::array::from_fn(|i| {
        (0..3).map(|k| inverse[k][i] * n[k]).sum()
    })))
}

/// Translates by `by`.
pub fn translate(by: Vec3) -> Matrix {
    let mut m = IDENTITY;
    for (row, by) in m.iter_mut().zip(by) {
        row[3] = by;
    }
    m
}

/// Scales each axis by its own factor.
pub fn scale(by: Vec3) -> Matrix {
    let mut m = IDENTITY;
    for (i, by) in by.into_iter().enumerate() {
        m[i][i] = by;
    }
    m
}

/// Rotates about the x axis, y toward z.
pub fn rotate_x(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [
        [1., 0., 0., 0.],
        [0., c, -s, 0.],
        [0., s, c, 0.],
        [0., 0., 0., 1.],
    ]
}

/// Rotates about the y axis, z toward x.
pub fn rotate_y(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [
        [c, 0., s, 0.],
        [0., 1., 0., 0.],
        [-s, 0., c, 0.],
        [0., 0., 0., 1.],
    ]
}

/// Rotates about the z axis, x toward y.
pub fn rotate_z(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [
        [c, -s, 0., 0.],
        [s, c, 0., 0.],
        [0., 0., 1., 0.],
        [0., 0., 0., 1.],
    ]
}

/// Rotates about any axis, counter-clockwise as seen from the tip of the axis (Rodrigues' formula).
pub fn rotate(axis: Vec3, angle: f64) -> Matrix {
    let k = normalized(axis);
    let (s, c) = angle.sin_cos();
    let mut m = IDENTITY;
    for i in 0..3 {
        let mut unit = [0.; 3];
        unit[i] = 1.;
        let turned = cross(k, unit);
        for row in 0..3 {
            m[row][i] = c * unit[row] + s * turned[row] + (1. - c) * k[i] * k[row];
        }
    }
    m
}

/// The matrix from world space to eye space, with the axes k = (eye − target)/‖·‖, i = up × k/‖·‖, j = k × i.
///
/// `None` if eye and target coincide or `up` is parallel to the line of sight, to within 1e-12.
pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Option<Matrix> {
    let back = subtract(eye, target);
    let side = cross(up, back);
    if length(back) < 1e-12 || length(side) <= 1e-12 * length(up) * length(back) {
        return None;
    }
    let k = normalized(back);
    let i = normalized(side);
    let j = cross(k, i);
    let row = |v: Vec3| [v[0], v[1], v[2], -dot(v, eye)];
    Some([row(i), row(j), row(k), [0., 0., 0., 1.]])
}

/// The transpose.
pub fn transpose(m: &Matrix) -> Matrix {
    std::array::from_fn(|row| std::array::from_fn(|column| m[column][row]))
}

/// The inverse by Gauss–Jordan elimination with partial pivoting; `None` for a singular matrix.
pub fn inverse(m: &Matrix) -> Option<Matrix> {
    let mut left = *m;
    let mut right = IDENTITY;
    for column in 0..4 {
        let pivot =
            (column..4).max_by(|&a, &b| left[a][column].abs().total_cmp(&left[b][column].abs()))?;
        left.swap(column, pivot);
        right.swap(column, pivot);
        let by = left[column][column];
        if by == 0. || !by.is_finite() {
            return None;
        }
        left[column] = left[column].map(|x| x / by);
        right[column] = right[column].map(|x| x / by);
        for row in (0..4).filter(|&row| row != column) {
            let times = left[row][column];
            for k in 0..4 {
                left[row][k] -= times * left[column][k];
                right[row][k] -= times * right[column][k];
            }
        }
    }
    Some(right)
}
