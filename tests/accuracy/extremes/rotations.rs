//! Products of a million small rotations, with and without renormalization of the matrix.
//!
//! A product rounds each of its entries by up to half of 2⁻²⁹. An entry of a rotation has this error, and the error of
//! the sine, which is at most 1.6·10⁻⁹. Rows and columns have three entries. If all roundings had the same sign, a
//! million products would therefore change lengths and right angles by 10⁶ · 3 · (2 · 2⁻³⁰ + 1.6·10⁻⁹) = 1 %. After
//! renormalization, each entry has an error of at most a unit of 2⁻²⁹, and each sum of products of two rows has an
//! error of at most 4·10⁻⁹, however large the error was before.

use fixel::prelude::*;

use super::table::{Cases, figure};
use super::verdict::Worst;
use support::moves::radians;
use support::reference::linear::{self, Matrix};

/// The number 1 in the units of a matrix's entries, 2⁻³⁰.
const ONE: f64 = 1_073_741_824.;
const STEPS: u32 = 1_000_000;
/// The largest error that one product adds to each entry of R·Rᵀ − I, as derived above.
const DRIFT: f64 = 3. * (2. / ONE + 1.6e-9);
/// The largest error of an entry of R·Rᵀ − I after renormalization.
const RIGID: f64 = 4e-9;

/// The entries of a rotation, in units of 2⁻¹⁶ · 2⁻¹⁴, read from the images of axes of length 16,384.
fn matrix(transform: &Transform) -> [[f64; 3]; 3] {
    let axis = |i: usize| {
        let mut bits = [0; 3];
        bits[i] = 1 << 30;
        transform
            .direction(Vec3::from_bits(bits))
            .to_bits()
            .map(|v| f64::from(v) / ONE)
    };
    let columns = [axis(0), axis(1), axis(2)];
    [0, 1, 2].map(|row: usize| [0, 1, 2].map(|column: usize| columns[column][row]))
}

/// The largest absolute value of an entry of R·Rᵀ − I.
fn from_rigid(transform: &Transform) -> f64 {
    let rows = matrix(transform);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut worst = 0_f64;
    for (i, &a) in rows.iter().enumerate() {
        for (j, &b) in rows.iter().enumerate() {
            worst = worst.max((dot(a, b) - if i == j { 1. } else { 0. }).abs());
        }
    }
    worst
}

/// The largest difference between an entry of the crate's matrix and of the model's matrix.
fn from_model(transform: &Transform, model: &Matrix) -> f64 {
    let rows = matrix(transform);
    let entries = rows.iter().zip(model).flat_map(|(a, b)| a.iter().zip(b));
    entries.fold(0., |worst, (a, b)| worst.max((a - b).abs()))
}

/// Multiplies by the same three small rotations a million times. Returns the largest errors, measured after every
/// 10,000 products: the distance from a rigid matrix, and the distance from the model's matrix.
fn turned(renormalized_every: Option<u32>) -> [Worst; 2] {
    let angles = [0.001, 0.000_7, 0.002_3].map(|a| Angle::try_from_radians(a).unwrap());
    let step = Transform::rotate_x(angles[0])
        * Transform::rotate_y(angles[1])
        * Transform::rotate_z(angles[2]);
    let [x, y, z] = angles.map(radians);
    let turn = linear::product(&[
        linear::rotate_x(x),
        linear::rotate_y(y),
        linear::rotate_z(z),
    ]);
    let (mut transform, mut model) = (Transform::IDENTITY, linear::IDENTITY);
    let (mut rigid, mut place) = (Worst::default(), Worst::default());
    for i in 1..=STEPS {
        transform = step * transform;
        model = linear::multiply(&turn, &model);
        if renormalized_every.is_some_and(|every| i % every == 0) {
            transform = transform.renormalized();
        }
        if i % 10_000 == 0 {
            let bound = match renormalized_every {
                None => f64::from(i) * DRIFT,
                Some(_) => RIGID,
            };
            rigid.add(from_rigid(&transform), bound, || format!("after {i}"));
            let bound = f64::from(i) * DRIFT;
            place.add(from_model(&transform, &model), bound, || {
                format!("after {i}")
            });
        }
    }
    [rigid, place]
}

pub static CASES: Cases = Cases::new(|| {
    let [drifted, place] = turned(None);
    let [rigid, renormalized] = turned(Some(1000));
    vec![
        figure(
            "product R of 10⁶ rotations: entries of R·Rᵀ − I",
            "",
            drifted,
        ),
        figure(
            "product R of 10⁶ rotations: error of the entries",
            "",
            place,
        ),
        figure(
            "R, `renormalized` every 1000 rotations: entries of R·Rᵀ − I",
            "",
            rigid,
        ),
        figure(
            "R, `renormalized` every 1000 rotations: error of the entries",
            "",
            renormalized,
        ),
    ]
});

#[test]
fn errors_of_a_million_rotations_are_within_their_bounds() {
    assert_eq!(CASES.len(), 4);
}
