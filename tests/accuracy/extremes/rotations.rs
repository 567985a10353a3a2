//! Products of a million small rotations, with and without renormalization of the matrix.
//!
//! A product rounds each of its nine entries by up to half of 2⁻²⁹. As a matrix, these roundings move a vector of length
//! one by at most 3 · 2⁻³⁰. So each product adds at most 6 · 2⁻³⁰ to R·Rᵀ − I, and the rotation by which the product is
//! multiplied adds its own error. (Rotations carry earlier errors along, and change no length.) A rotation's own error is
//!
//! - about x, y or z: |s² + c² − 1| for a sine and a cosine with errors of 2.6·10⁻⁹, at most 2 · √2 · 2.6·10⁻⁹;
//! - about an axis and from a quaternion: 9 · 2⁻³⁰ from the rounding of the nine entries, by 1.5 · 2⁻³⁰ each, and
//!   2 · √3 · 2⁻³³ from the error of an entry before it is rounded;
//! - from Euler angles: three rotations and two products.
//!
//! So a million rotations add at most 10⁶ · (8.8·10⁻⁹ + 5.6·10⁻⁹) = 1.5 %, where Euler angles count as three. After
//! renormalization, each entry has an error of at most a unit of 2⁻²⁹, and each sum of products of two rows has an
//! error of at most 4·10⁻⁹, however large the error was before.

use fixel::prelude::*;

use super::table::{Cases, figure};
use super::verdict::Worst;
use rand::Rng as _;
use support::moves::radians;
use support::random::cases;
use support::reference::linear::{self, Matrix};

/// The number 1 in the units of a matrix's entries, 2⁻³⁰.
const ONE: f64 = 1_073_741_824.;
const STEPS: u32 = 1_000_000;
/// How far the roundings of a product move a vector of length one.
const ROUNDED: f64 = 3. / ONE;
/// The own error of a rotation about x, y or z, as an error of R·Rᵀ − I.
const ABOUT_X: f64 = 2. * std::f64::consts::SQRT_2 * 2.6e-9;
/// The own error of a rotation about an axis or from a quaternion.
const ABOUT_AXIS: f64 = 3. * ROUNDED + 2. * 1.732_051 / 8. / ONE;
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
    // A matrix moves a vector of length one by at most three times its largest entry.
    let (stretch, error) = (3. * from_rigid(&step), 3. * from_model(&step, &turn));
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
                None => f64::from(i) * (stretch + 2. * ROUNDED),
                Some(_) => RIGID,
            };
            rigid.add(from_rigid(&transform), bound, || format!("after {i}"));
            let bound = f64::from(i) * (error + ROUNDED);
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

/// Searches for the rotation that is farthest from rigid. Starts at random numbers and climbs by small changes.
fn least_rigid(seeds: u32, rotation: impl Fn([i32; 4]) -> Option<Transform>) -> (f64, [i32; 4]) {
    let mut worst = (0., [0; 4]);
    cases(seeds, |random| {
        let error = |at| rotation(at).map_or(0., |transform| from_rigid(&transform));
        let mut best = [(); 4].map(|()| random.random::<i32>() >> random.random_range(0..32));
        let mut most = error(best);
        for _ in 0..500 {
            let mut other = best;
            let changed = &mut other[random.random_range(0..4)];
            *changed = changed.wrapping_add(random.random::<i32>() >> random.random_range(0..32));
            let found = error(other);
            if found >= most {
                (most, best) = (found, other);
            }
        }
        if most > worst.0 {
            worst = (most, best);
        }
    });
    worst
}

/// Makes a rotation from four numbers, if they can make one.
type Make<'a> = &'a dyn Fn([i32; 4]) -> Option<Transform>;

/// Each way to make a rotation has its own bound. The worst rotation found is then multiplied a million times.
#[test]
fn every_rotation_is_rigid_and_stays_rigid() {
    let angle = |bits: i32| Angle::from_bits(bits.cast_unsigned());
    let about_axis =
        |[x, y, z, turn]: [i32; 4]| Transform::rotate(Vec3::from_bits([x, y, z]), angle(turn)).ok();
    let of_quaternion =
        |parts: [i32; 4]| Transform::from_quaternion(parts.map(Scalar::from_bits)).ok();
    let about_axes = |[x, y, z, which]: [i32; 4]| {
        Some(match which.rem_euclid(3) {
            0 => Transform::rotate_x(angle(x)),
            1 => Transform::rotate_y(angle(y)),
            _ => Transform::rotate_z(angle(z)),
        })
    };
    let of_euler = |[yaw, pitch, roll, _]: [i32; 4]| {
        Some(Transform::from_euler(angle(yaw), angle(pitch), angle(roll)))
    };
    let three = 3. * ABOUT_X + 4. * ROUNDED;
    let kinds: [(&str, Make<'_>, f64); 4] = [
        ("x, y, z", &about_axes, ABOUT_X),
        ("axis", &about_axis, ABOUT_AXIS),
        ("quaternion", &of_quaternion, ABOUT_AXIS),
        ("Euler angles", &of_euler, three),
    ];
    for (name, make, bound) in kinds {
        let (found, worst) = least_rigid(64, make);
        assert!(found <= bound, "{name} {worst:?}: {found:e} > {bound:e}");
        // The search comes near the bound, so that a rotation with twice the error fails.
        assert!(
            found >= bound / 3.,
            "{name} {worst:?}: {found:e} is far below {bound:e}"
        );
        let (step, mut product) = (make(worst).unwrap(), Transform::IDENTITY);
        for _ in 0..STEPS {
            product = step * product;
        }
        let (drift, bound) = (
            from_rigid(&product),
            f64::from(STEPS) * (bound + 2. * ROUNDED),
        );
        assert!(drift <= bound, "{name} {worst:?}: {drift} > {bound}");
    }
    // An axis that is nearly −y, turned by half a turn: here an axis of length 1 + 10⁻⁹ would stretch the model most.
    let worst = [
        -7_983_218,
        -2_147_483_647,
        24_820_525,
        2_171_108_184_u32.cast_signed(),
    ];
    let found = from_rigid(&about_axis(worst).unwrap());
    assert!(found <= ABOUT_AXIS, "{found:e}");
}
