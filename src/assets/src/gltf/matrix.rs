//! The matrices of nodes and of joints.

use serde_json::Value;

use super::numbers;

/// A matrix as glTF stores it: a list of columns.
pub(super) type Matrix = [[f64; 4]; 4];

pub(super) const IDENTITY: Matrix = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

/// Converts a list of 16 numbers into a matrix.
pub(super) fn matrix(numbers: [f64; 16]) -> Matrix {
    [0, 1, 2, 3].map(|column| [0, 1, 2, 3].map(|row| numbers[4 * column + row]))
}

/// The matrix that transforms normals, and the determinant of the upper left 3 x 3 of `m`. The matrix has the cofactors
/// of this 3 x 3 as entries, so it is the transposed inverse times the determinant.
pub(super) fn normal_matrix(m: &Matrix) -> ([[f64; 3]; 3], f64) {
    let cofactors = [0, 1, 2].map(|column| {
        let (a, b) = (&m[(column + 1) % 3], &m[(column + 2) % 3]);
        [0, 1, 2].map(|row| {
            let (i, j) = ((row + 1) % 3, (row + 2) % 3);
            a[i] * b[j] - a[j] * b[i]
        })
    });
    let determinant = (0..3).map(|row| m[0][row] * cofactors[0][row]).sum();
    (cofactors, determinant)
}

/// The matrix of a node, relative to its parent.
pub(super) fn local(node: &Value) -> Matrix {
    if let Some(numbers) = numbers(&node["matrix"]) {
        return matrix(numbers);
    }
    let [x, y, z, w] = numbers(&node["rotation"]).unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let scale = numbers(&node["scale"]).unwrap_or([1.0; 3]);
    let [tx, ty, tz] = numbers(&node["translation"]).unwrap_or([0.0; 3]);
    let axes = [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ],
        [
            2.0 * (x * y - w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z + w * x),
        ],
        [
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ];
    let axis = |at: usize| {
        let [x, y, z] = axes[at].map(|x| x * scale[at]);
        [x, y, z, 0.0]
    };
    [axis(0), axis(1), axis(2), [tx, ty, tz, 1.0]]
}

/// The weighted mean of the matrices of a vertex's joints; `None` if the sum of the weights is not positive.
pub(super) fn blend<'a>(
    joints: &[Matrix],
    bones: impl Iterator<Item = &'a ([f64; 4], [f64; 4])> + Clone,
) -> Option<Matrix> {
    let all: f64 = bones.clone().flat_map(|(_, weights)| weights).sum();
    let mut mean = [[0.0; 4]; 4];
    for (&joint, weight) in bones.flat_map(|(which, weights)| which.iter().zip(weights)) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a whole number
        let joint = joints.get(joint as usize).unwrap_or(&IDENTITY);
        for (sum, x) in mean.as_flattened_mut().iter_mut().zip(joint.as_flattened()) {
            *sum += x * weight / all;
        }
    }
    (all > 0.0).then_some(mean)
}
