//! Transforms that are computed twice from the same numbers: by the crate, and as f64 matrices.

use std::f64::consts::TAU;

use fixel::{Angle, Scalar, Transform, Vec3};

use crate::reference::linear::{self, IDENTITY, Matrix, multiply};

/// A factor in a product of transforms.
#[derive(Clone, Copy, Debug)]
pub enum Move {
    To(Vec3),
    X(Angle),
    Y(Angle),
    Z(Angle),
    Scale(Vec3),
}

/// A translation, rounded to the crate's nearest numbers.
pub fn to(offset: [f64; 3]) -> Move {
    Move::To(rounded(offset))
}

/// A rotation about x by an angle in radians.
pub fn x(radians: f64) -> Move {
    Move::X(Angle::try_from_radians(radians).unwrap())
}

/// A rotation about y by an angle in radians.
pub fn y(radians: f64) -> Move {
    Move::Y(Angle::try_from_radians(radians).unwrap())
}

/// The crate's nearest number.
pub fn number(x: f64) -> Scalar {
    Scalar::try_from(x).unwrap()
}

/// A point rounded to the crate's nearest numbers.
pub fn rounded(point: [f64; 3]) -> Vec3 {
    let [x, y, z] = point.map(number);
    Vec3::new(x, y, z)
}

/// The exact coordinates of one of the crate's points.
pub fn exact(point: Vec3) -> [f64; 3] {
    [point.x, point.y, point.z].map(f64::from)
}

/// An angle in radians, with an error of only f64's last bit.
pub fn radians(angle: Angle) -> f64 {
    f64::from(angle.to_bits()) / 2_f64.powi(32) * TAU
}

impl Move {
    pub fn transform(self) -> Transform {
        match self {
            Move::To(offset) => Transform::translate(offset),
            Move::X(angle) => Transform::rotate_x(angle),
            Move::Y(angle) => Transform::rotate_y(angle),
            Move::Z(angle) => Transform::rotate_z(angle),
            Move::Scale(factors) => Transform::scale_axes(factors),
        }
    }

    pub fn matrix(self) -> Matrix {
        match self {
            Move::To(offset) => linear::translate(exact(offset)),
            Move::X(angle) => linear::rotate_x(radians(angle)),
            Move::Y(angle) => linear::rotate_y(radians(angle)),
            Move::Z(angle) => linear::rotate_z(radians(angle)),
            Move::Scale(factors) => linear::scale(exact(factors)),
        }
    }
}

/// The product of moves, computed by the crate and in f64. The last move acts first.
pub fn product(moves: &[Move]) -> (Transform, Matrix) {
    moves.iter().fold(
        (Transform::IDENTITY, IDENTITY),
        |(transform, matrix), part| {
            (
                transform * part.transform(),
                multiply(&matrix, &part.matrix()),
            )
        },
    )
}

/// The largest distance from the origin that a point reaches while the moves act on it. Errors are relative to this
/// distance.
pub fn size(moves: &[Move], p: Vec3) -> f64 {
    let length = |v: Vec3| linear::length(exact(v));
    let largest = |v: Vec3| {
        exact(v)
            .into_iter()
            .fold(0., |most: f64, x| most.max(x.abs()))
    };
    moves.iter().rev().fold(length(p), |size, step| match step {
        Move::To(offset) => size + length(*offset),
        Move::Scale(factors) => size * largest(*factors),
        _ => size,
    })
}

/// The bound of the error of clip coordinates, relative to [`size`] and the largest coefficient. Each move adds 2⁻³⁰
/// three times: for its mantissas, for a sine, and for the mantissas of the product. The projection, its product, and
/// its scale add 2⁻³⁰ each. The common exponent adds 2⁻³⁰ twice, because it costs one bit. The sum of a point's three
/// coordinates is at most √3 times its length.
pub fn relative(moves: &[Move]) -> f64 {
    2_f64.powi(-30) * 3_f64.sqrt() * (3 * moves.len() + 5) as f64
}
