//! Turns: Rodrigues' formula and quaternions.

use std::array::from_fn;
use std::f64::consts::TAU;

use fixel::prelude::*;
use rand::Rng;

use support::moves::exact;
use support::random::{Random, cases, within};
use support::reference::linear::{cross, dot, normalized};

use super::helpers::{STEP, all_close, assert_row, digits, float, vec};

/// v′ = cos θ v + sin θ (u × v) + (1 − cos θ) (u · v) u, for an axis u of length one.
pub fn rodrigues(u: [f64; 3], v: [f64; 3], angle: f64) -> [f64; 3] {
    let (sine, cosine) = angle.sin_cos();
    let (across, along) = (cross(u, v), dot(u, v));
    from_fn(|i| cosine * v[i] + sine * across[i] + (1.0 - cosine) * along * u[i])
}

/// A quaternion: the number, and the vector.
type Quaternion = (f64, [f64; 3]);

/// The product, from i² = j² = k² = −1, ij = k, jk = i and ki = j.
fn product((a, [b, c, d]): Quaternion, (e, [f, g, h]): Quaternion) -> Quaternion {
    let number = a * e - b * f - c * g - d * h;
    let i = a * f + b * e + c * h - d * g;
    let j = a * g - b * h + c * e + d * f;
    let k = a * h + b * g - c * f + d * e;
    (number, [i, j, k])
}

/// q v q*, divided by the square of the length of q.
fn turned(q: Quaternion, v: [f64; 3]) -> [f64; 3] {
    let conjugate = (q.0, q.1.map(|x| -x));
    let (number, vector) = product(product(q, (0.0, v)), conjugate);
    let squared = q.0 * q.0 + dot(q.1, q.1);
    assert!(number.abs() < 1e-12 * squared * (1.0 + dot(v, v)));
    vector.map(|x| x / squared)
}

/// A point at most 20 units from the origin along each axis. An entry of a rotation matrix with an error of 2^-26
/// changes a coordinate by less than 60 · 2^-26, a sixteenth of a step.
fn point(random: &mut Random) -> Vec3 {
    let [x, y, z] = within(random, [-20.0..20.0, -20.0..20.0, -20.0..20.0]);
    vec(x, y, z)
}

/// A result is rounded by up to half a step.
const SLACK: f64 = STEP * (0.5 + 1.0 / 16.0);

#[test]
fn a_turn_follows_rodrigues() {
    cases(256, |random| {
        let (axis, v) = (point(random), point(random));
        let angle = Angle::from_bits(random.random());
        let radians = f64::from(angle.to_bits()) / 4_294_967_296.0 * TAU;
        let turn = Transform::rotate(axis, angle).unwrap();
        let expected = rodrigues(normalized(exact(axis)), exact(v), radians);
        all_close(exact(turn.point(v)), expected, SLACK);
    });
}

/// Parts in the crate's order, with the number last.
fn parts(random: &mut Random) -> [Scalar; 4] {
    let [x, y, z, w] = within(random, [-1.0..1.0, -1.0..1.0, -1.0..1.0, 0.1..1.0]);
    [x, y, z, w].map(|part| Scalar::try_from(part).unwrap())
}

fn quaternion(parts: [Scalar; 4]) -> Quaternion {
    let [x, y, z, w] = parts.map(float);
    (w, [x, y, z])
}

#[test]
fn a_quaternion_turns_by_twice_its_angle() {
    cases(256, |random| {
        let (parts, v) = (parts(random), point(random));
        let q = quaternion(parts);
        let half = dot(q.1, q.1).sqrt().atan2(q.0);
        let expected = rodrigues(normalized(q.1), exact(v), 2.0 * half);
        all_close(turned(q, exact(v)), expected, 1e-12);
        let turn = Transform::from_quaternion(parts).unwrap();
        all_close(exact(turn.point(v)), expected, SLACK);
        let opposite = Transform::from_quaternion(parts.map(|part| -part)).unwrap();
        all_close(exact(opposite.point(v)), expected, SLACK);
    });
}

#[test]
fn a_product_of_quaternions_is_one_turn_after_another() {
    cases(256, |random| {
        let ([first, second], v) = (from_fn(|_| parts(random)), point(random));
        let expected = turned(product(quaternion(second), quaternion(first)), exact(v));
        let [first, second] = [first, second].map(|q| Transform::from_quaternion(q).unwrap());
        // The product rounds its entries once more.
        all_close(exact((second * first).point(v)), expected, SLACK);
    });
}

#[test]
fn two_quarter_turns_are_a_third_of_a_turn() {
    let quarter = |axis: [f64; 3]| (1.0, axis);
    let both = product(quarter([0.0, 1.0, 0.0]), quarter([1.0, 0.0, 0.0]));
    assert_eq!(both, (1.0, [1.0, 1.0, -1.0]));
    let third = rodrigues(normalized([1.0, 1.0, -1.0]), [1.0, 2.0, 3.0], TAU / 3.0);
    all_close(third, [2.0, -3.0, -1.0], 1e-12);
}

#[test]
fn the_guides_table_of_turns() {
    let page = include_str!("../../../src/guide/mathematics/rotation.rs");
    for (degrees, sum) in [
        (0_i16, "*p* + *r*"),
        (90, "*p* + *b*"),
        (180, "*p* − *r*"),
        (270, "*p* − *b*"),
    ] {
        let turn = Transform::rotate(vec3!(3, 0, 4), Angle::from_degrees(degrees.into())).unwrap();
        let place = exact(turn.point(vec3!(5, 5, 0)));
        let expected = rodrigues(
            [0.6, 0.0, 0.8],
            [5.0, 5.0, 0.0],
            f64::from(degrees).to_radians(),
        );
        all_close(place, expected, SLACK);
        let [x, y, z] = place.map(|at| digits(at, 1));
        assert_row(page, &[format!("{degrees}°"), sum.into(), x, y, z]);
    }
}
