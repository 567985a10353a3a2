//! Transforms, compared with their formulas in f64.
#![allow(clippy::needless_range_loop)] // formulas with indices

use super::*;
use crate::random::{Random, cases, list};
use crate::{Angle, Error, Scalar, fx, vec3};
use core::f64::consts::TAU;
use rand::Rng;
use std::vec::Vec;

/// Rows of a 3×4 matrix.
pub(super) type Real = [[f64; 4]; 3];

pub(super) fn power(exp: i32) -> f64 {
    f64::from(exp).exp2()
}

pub(super) fn real(t: &Transform) -> Real {
    core::array::from_fn(|i| {
        let [x, y, z] = t.linear[i].map(|m| f64::from(m) * power(-t.linear_exp));
        [
            x,
            y,
            z,
            f64::from(t.translation[i]) * power(-t.translation_exp),
        ]
    })
}

pub(super) fn multiply(a: &Real, b: &Real) -> Real {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let moved = if j == 3 { a[i][3] } else { 0.0 };
            (0..3).map(|k| a[i][k] * b[k][j]).sum::<f64>() + moved
        })
    })
}

/// The largest entries of the matrix and of the translation.
fn sizes(m: &Real) -> [f64; 2] {
    let max = |range: core::ops::Range<usize>| {
        m.iter()
            .flat_map(|row| row[range.clone()].iter())
            .fold(0.0, |max: f64, v| max.max(v.abs()))
    };
    [max(0..3), max(3..4)]
}

/// The largest errors of the matrix and of the translation.
pub(super) fn errors(found: &Real, expected: &Real) -> [f64; 2] {
    sizes(&core::array::from_fn(|i| {
        core::array::from_fn(|j| found[i][j] - expected[i][j])
    }))
}

#[derive(Clone, Copy, Debug)]
enum Step {
    X(u32),
    Y(u32),
    Z(u32),
    About([i32; 3], u32),
    Move([i32; 3]),
}

impl Step {
    fn transform(self) -> Transform {
        match self {
            Self::X(a) => Transform::rotate_x(Angle::from_bits(a)),
            Self::Y(a) => Transform::rotate_y(Angle::from_bits(a)),
            Self::Z(a) => Transform::rotate_z(Angle::from_bits(a)),
            Self::About(axis, a) => {
                Transform::rotate(Vec3::from_bits(axis), Angle::from_bits(a)).unwrap_or_default()
            }
            Self::Move(by) => Transform::translate(Vec3::from_bits(by)),
        }
    }

    fn real(self) -> Real {
        // Rodrigues' formula serves all rotations.
        let about = |axis: [f64; 3], angle: u32| {
            let (sin, cos) = (f64::from(angle) / power(32) * TAU).sin_cos();
            let length = axis.iter().map(|v| v * v).sum::<f64>().sqrt();
            let [x, y, z] = axis.map(|v| if length > 0.0 { v / length } else { 0.0 });
            let skew = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
            let axis = [x, y, z];
            core::array::from_fn(|i| {
                core::array::from_fn(|j| match j {
                    3 => 0.0,
                    _ if length == 0.0 => f64::from(u8::from(i == j)),
                    _ => {
                        let diagonal = if i == j { cos } else { 0.0 };
                        diagonal + sin * skew[i][j] + (1.0 - cos) * axis[i] * axis[j]
                    }
                })
            })
        };
        match self {
            Self::X(a) => about([1.0, 0.0, 0.0], a),
            Self::Y(a) => about([0.0, 1.0, 0.0], a),
            Self::Z(a) => about([0.0, 0.0, 1.0], a),
            Self::About(axis, a) => about(axis.map(f64::from), a),
            Self::Move(by) => {
                let mut m = about([1.0, 0.0, 0.0], 0);
                for (row, by) in m.iter_mut().zip(by) {
                    row[3] = f64::from(by) / 65_536.0;
                }
                m
            }
        }
    }
}

fn step(random: &mut Random) -> Step {
    match random.random_range(0..5) {
        0 => Step::X(random.random()),
        1 => Step::Y(random.random()),
        2 => Step::Z(random.random()),
        3 => Step::About(random.random(), random.random()),
        // Offsets within ±100.
        _ => Step::Move([(); 3].map(|()| random.random_range(-6_553_600..6_553_600))),
    }
}

/// A random transform with all fields in range.
fn transform(random: &mut Random) -> Transform {
    let [linear_exp, exp] = [(); 2].map(|()| random.random_range(block::MIN_EXP..=block::MAX_EXP));
    // Nine entries, then the translation.
    Transform::from_block_floats(&core::array::from_fn(|at| {
        let mantissa = random.random_range(1 - (1 << 30)..1 << 30);
        BlockFloat::new(mantissa, if at < 9 { linear_exp } else { exp })
    }))
}

fn admissible(t: &Transform) -> bool {
    let small = |m: &i32| m.unsigned_abs() < 1 << 30;
    let exps = block::MIN_EXP..=block::MAX_EXP;
    t.linear.as_flattened().iter().all(small)
        && t.translation.iter().all(small)
        && exps.contains(&t.linear_exp)
        && exps.contains(&t.translation_exp)
}

#[test]
fn identity_is_normalized() {
    let scaled = Transform::scale(Scalar::ONE);
    assert_eq!(scaled, Transform::IDENTITY);
    assert_eq!(Transform::IDENTITY * scaled, Transform::IDENTITY);
    assert_eq!(Transform::translate(Vec3::ZERO), Transform::IDENTITY);
}

/// Factors that only move are multiplied without their matrix. The product has the bits of the whole product, even if
/// translations cancel or have exponents far apart.
#[test]
fn factors_that_only_move_are_multiplied_as_others_are() {
    cases(4096, |random| {
        let any = transform(random);
        let turn = Transform::rotate_y(Angle::from_bits(random.random()));
        let mut moved = Transform::translate(Vec3::from_bits(random.random()));
        if random.random() {
            (moved.translation, moved.translation_exp) =
                (any.translation.map(|m| -m), any.translation_exp);
        }
        for other in [any, turn, moved * turn, Transform::IDENTITY] {
            for [first, then] in [[other, moved], [moved, other], [moved, moved]] {
                let ([i, j, k], [x, y, z]) = (then.linear, then.translation);
                let rows = [(i, x), (j, y), (k, z)].map(|(row, moved)| AffineRow {
                    row,
                    exp: then.linear_exp,
                    offset: [moved, 1],
                    offset_exp: then.translation_exp,
                });
                assert_eq!(then * first, compose(&rows, &first), "{then:?} {first:?}");
            }
        }
    });
}

#[test]
fn rotations_are_counter_clockwise() {
    let quarter = Angle::QUARTER;
    assert_eq!(Transform::rotate_x(quarter).point(Vec3::Y), Vec3::Z);
    assert_eq!(Transform::rotate_y(quarter).point(Vec3::Z), Vec3::X);
    assert_eq!(Transform::rotate_z(quarter).point(Vec3::X), Vec3::Y);
    let about_z = Transform::rotate(Vec3::Z, quarter).unwrap();
    assert_eq!(about_z, Transform::rotate_z(quarter));
    assert_eq!(
        Transform::rotate(Vec3::ZERO, quarter),
        Err(Error::ZERO_DIRECTION)
    );
}

#[test]
fn normals_follow_mirrors_and_uneven_scales() {
    // The plane x + y = 0 has the normal (1, 1, 0). The squeezed plane is 2x' + y' = 0. The squeezed and mirrored plane
    // is −2x' + y' = 0.
    for x in [0.5, -0.5] {
        let factors = Vec3::new(Scalar::try_from(x).unwrap(), Scalar::ONE, Scalar::ONE);
        let rows = Transform::scale_axes(factors).normal_matrix().0;
        let normal = rows.map(|row| f64::from(row[0]) + f64::from(row[1]));
        let slope = 1.0 / x;
        assert!(normal[1] > 0.0);
        assert!((normal[0] / normal[1] - slope).abs() < 1e-8);
        assert!(normal[2].abs() < f64::EPSILON);
    }
}

/// Only rotations drift. A translation, large or small, keeps every bit.
#[test]
fn renormalizing_keeps_the_translation() {
    let turn = Transform::rotate(Vec3::from_ints(1, 2, 3), Angle::from_degrees(40)).unwrap();
    for place in [vec3!(1, 2, 3), vec3!(-0.001, 0, 0.5), vec3!(30000, -7, 1)] {
        let pose = Transform::translate(place) * turn;
        assert_eq!(pose.renormalized().point(Vec3::ZERO), place);
    }
}

#[test]
fn drift_is_removed() {
    let step = Transform::rotate(Vec3::from_ints(1, 2, 3), Angle::from_degrees(1)).unwrap();
    let mut t = Transform::IDENTITY;
    for _ in 0..360_000 {
        t = t * step;
    }
    let rigid = |t: &Transform| {
        let product = multiply(&real(&t.inverse_rigid()), &real(t));
        errors(&product, &real(&Transform::IDENTITY))[0]
    };
    // After a thousand turns the matrix must have drifted, or the test would show nothing.
    assert!(rigid(&t) > 1e-6, "{:e}", rigid(&t));
    assert!(
        rigid(&t.renormalized()) < 4e-9,
        "{:e}",
        rigid(&t.renormalized())
    );
    let mirror = Transform::scale_axes(Vec3::from_ints(-1, 1, 1));
    assert_eq!(mirror.renormalized(), mirror);
    let flat = Transform::scale(Scalar::ZERO);
    assert_eq!(flat.renormalized(), flat);
}

#[test]
fn steps_are_good_to_28_bits() {
    cases(256, |random| {
        let step = step(random);
        let [linear, translation] = errors(&real(&step.transform()), &step.real());
        // Sine and cosine have errors of up to 1.6e-9. The axis has an error of up to 2^-28 and is used twice.
        assert!(linear <= 3.0 * power(-28), "{linear:e}");
        assert!(translation <= f64::EPSILON);
        if !matches!(step, Step::About(..)) {
            // Rounding adds half of 2^-29, because an entry of one takes the 30th bit.
            assert!(linear <= 1.6e-9 + power(-30), "{linear:e}");
        }
    });
}

#[test]
fn products_round_once() {
    cases(256, |random| {
        let a = transform(random);
        let b = transform(random);
        let product = a * b;
        assert!(admissible(&product));
        let expected = multiply(&real(&a), &real(&b));
        let found = real(&product);
        let [linear, translation] = errors(&found, &expected);
        if product.linear_exp > block::MIN_EXP {
            assert!(linear <= 0.501 * power(-product.linear_exp));
        }
        if product.translation_exp > block::MIN_EXP {
            // The two summands were rounded to 60 bits before the sum.
            let summands = sizes(&expected)[1].max(sizes(&real(&a))[1]);
            let slack = 0.501 * power(-product.translation_exp) + summands * power(-50);
            assert!(translation <= slack);
        }
    });
}

#[test]
fn composing_never_panics() {
    cases(256, |random| {
        let t = list(random, 1..40, transform);
        let p = random.random::<[i32; 3]>();
        let all: Vec<Transform> = t
            .iter()
            .scan(Transform::IDENTITY, |all, &t| {
                *all = *all * t;
                Some(*all)
            })
            .collect();
        let p = Vec3::from_bits(p);
        for t in all.iter().chain(&t) {
            assert!(admissible(t));
            let _ = (t.point(p), t.direction(p), t.to_matrix(), t.normal_matrix());
            assert!(admissible(&t.inverse_rigid()) && admissible(&t.renormalized()));
            assert!(t.inverse().is_none_or(|inverse| admissible(&inverse)));
        }
    });
}

#[test]
fn points_are_rounded_and_saturated() {
    cases(256, |random| {
        let t = transform(random);
        let p = random.random::<[i32; 3]>();
        let m = real(&t);
        let p_real = p.map(|v| f64::from(v) / 65_536.0);
        let (point, direction) = (t.point(Vec3::from_bits(p)), t.direction(Vec3::from_bits(p)));
        let saturate = |v: f64| (v * 65_536.0).clamp(i32::MIN.into(), i32::MAX.into());
        for i in 0..3 {
            let linear = (0..3).map(|k| m[i][k] * p_real[k]).sum::<f64>();
            // The sum in f64 has a rounding error of its own if large terms cancel.
            let size = (0..3).map(|k| (m[i][k] * p_real[k]).abs()).sum::<f64>() + m[i][3].abs();
            let slack = 0.501 + size * 65_536.0 * power(-50);
            let error = f64::from(direction.to_bits()[i]) - saturate(linear);
            assert!(error.abs() <= slack);
            let error = f64::from(point.to_bits()[i]) - saturate(linear + m[i][3]);
            assert!(error.abs() <= slack);
        }
    });
}

#[test]
fn rigid_inverses_undo() {
    cases(256, |random| {
        let steps = list(random, 1..6, step);
        let t = steps
            .iter()
            .fold(Transform::IDENTITY, |t, step| t * step.transform());
        let both = real(&(t.inverse_rigid() * t));
        let [linear, translation] = errors(&both, &real(&Transform::IDENTITY));
        // The product has up to five factors, each within 3·2^-28 of a rotation.
        assert!(linear <= 20.0 * power(-28), "{linear:e}");
        let slack = 20.0 * power(-28) * (1.0 + sizes(&real(&t))[1]);
        assert!(translation <= slack, "{translation:e}");
    });
}

/// The determinant of a matrix of mantissas, and the inverse times this determinant.
fn adjugate(m: &[[i32; 3]; 3]) -> (i128, [[i128; 3]; 3]) {
    let m = m.map(|row| row.map(i128::from));
    let adjugate = [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            let (a, b, c, d) = ((j + 1) % 3, (j + 2) % 3, (i + 1) % 3, (i + 2) % 3);
            m[a][c] * m[b][d] - m[a][d] * m[b][c]
        })
    });
    let determinant = (0..3).map(|k| m[0][k] * adjugate[k][0]).sum();
    (determinant, adjugate)
}

/// Transforms with random entries, and transforms with rows that are nearly parallel, by as little as a unit.
#[test]
fn inverses_are_good_to_28_bits() {
    /// Each of nine cofactors loses less than 4 units in its quarter, and the determinant less than 4 in its quarter.
    const CUT: i128 = 10 * 4;
    let mut refused = 0;
    cases(1024, |random| {
        let mut t = transform(random);
        if random.random() {
            let down = random.random_range(0..31);
            for i in 0..3 {
                let noise = (mantissas(random)[0] >> down) / 2;
                t.linear[2][i] = i32::midpoint(t.linear[0][i], t.linear[1][i]) / 2 + noise;
            }
        }
        let (determinant, adjugate) = adjugate(&t.linear);
        let doubt: i128 = adjugate.as_flattened().iter().map(|v| v.abs()).sum();
        let Some(inverse) = t.inverse() else {
            assert!(2 * determinant.abs() <= doubt + CUT, "{t:?}");
            refused += 1;
            return;
        };
        assert!(2 * determinant.abs() >= doubt - CUT, "{t:?}");
        assert!(admissible(&inverse));
        assert_eq!(inverse.is_mirror, t.is_mirror);
        #[allow(clippy::cast_precision_loss)]
        let expected: Real = core::array::from_fn(|i| {
            let entry = |j: usize| adjugate[i][j] as f64 / determinant as f64 * power(t.linear_exp);
            [entry(0), entry(1), entry(2), 0.0]
        });
        let found = real(&inverse);
        let largest = sizes(&expected)[0];
        // The greatest mantissa is that of the largest number, up to 2^62, and the least unit is 2^-62.
        if largest < power(62) {
            // A quotient of two numbers of 31 bits, and the rounding to 30 bits.
            let slack = (1.3 + 1.0) * power(-30) * largest + 0.5 * power(-62);
            let error = errors(&found, &expected)[0];
            assert!(error <= slack, "{error:e} of {largest:e}");
        }
        // The translation is computed from the inverse's own matrix, and rounded once.
        for (row, moved) in found.iter().zip(inverse.translation) {
            let exact: f64 = (0..3).map(|k| -row[k] * real(&t)[k][3]).sum();
            let size: f64 = (0..3).map(|k| (row[k] * real(&t)[k][3]).abs()).sum();
            if exact.abs() < power(62) {
                let slack = 0.501 * power(-inverse.translation_exp) + size * power(-50);
                let found = f64::from(moved) * power(-inverse.translation_exp);
                assert!((found - exact).abs() <= slack, "{found:e} {exact:e}");
            }
        }
    });
    assert!(refused > 10, "{refused}");
}

/// Factors that are far apart, down to 2^-28 of each other, are no reason to refuse.
#[test]
fn only_flat_transforms_have_no_inverse() {
    let one = Scalar::ONE;
    for small in [one, Scalar::DELTA, Scalar::DELTA * 3] {
        for (at, [x, y, z]) in [[small, one, one], [one, -small, one], [small, one, small]]
            .into_iter()
            .enumerate()
        {
            let t = Transform::scale_axes(Vec3::new(x, y, z) * fx!(8));
            let turn = Transform::rotate(vec3!(1, 2, 3), Angle::from_degrees(40)).unwrap();
            for t in [t, turn * t] {
                let inverse = t.inverse().unwrap();
                assert_eq!(inverse.is_mirror, at == 1);
                let [there, _] = errors(&real(&(inverse * t)), &real(&Transform::IDENTITY));
                // The rounding of the matrix is magnified by the ratio of the factors.
                assert!(there <= power(-26) / f64::from(small), "{there:e}");
            }
        }
    }
    for flat in [
        Transform::scale(Scalar::ZERO),
        Transform::scale_axes(vec3!(1, 0, 1)),
        Transform::shadow(vec3!(0, 1, 0), Vec3::Y, vec3!(1, 2, 3)).unwrap(),
        Transform::shadow(vec3!(1, 2, 3), vec3!(3, 1, -2), vec3!(2, 1, 1)).unwrap(),
    ] {
        assert_eq!(flat.inverse(), None);
    }
}

/// The stored sign is the sign of the determinant: for products, rigid inverses, renormalized transforms and matrices.
#[test]
fn every_transform_knows_whether_it_mirrors() {
    let determinant = |t: &Transform| {
        let [[a, b, c, _], [d, e, f, _], [g, h, i, _]] = real(t);
        a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    };
    cases(256, |random| {
        let mirrors = list(random, 1..6, |random| (step(random), random.random::<u8>()));
        let t = mirrors
            .iter()
            .fold(Transform::IDENTITY, |t, (step, signs)| {
                let factors = [1, 2, 4].map(|bit| if signs & bit == 0 { 1 } else { -1 });
                t * step.transform()
                    * Transform::scale_axes(Vec3::from_bits(factors.map(|one: i32| one << 16)))
            });
        let from_matrix = Transform::try_from(t.to_matrix()).unwrap();
        let inverse = t.inverse_rigid();
        let general = t.inverse().unwrap();
        for t in [
            t,
            inverse,
            general,
            t.renormalized(),
            inverse * t * t,
            from_matrix,
        ] {
            // Rotations and mirrors have a determinant of 1 or −1. The entries of a `Matrix4` are rounded to 2^-17 or less.
            // Each of the nine entries changes the determinant by its rounding times a cofactor of at most 1.
            let found = determinant(&t);
            assert!((found.abs() - 1.).abs() < 9. * power(-17) + 1e-6, "{found}");
            assert_eq!(t.is_mirror, found < 0., "{found}");
        }
    });
}

#[test]
fn normals_stay_at_right_angles() {
    cases(256, |random| {
        let t = transform(random);
        // Column i of the normal matrix times column j of the matrix is 0 unless i = j; there it is
        // the determinant's magnitude, up to a positive factor.
        let n = t.normal_matrix().0.map(|row| row.map(f64::from));
        let m = t.linear.map(|row| row.map(f64::from));
        for i in 0..3 {
            for j in 0..3 {
                let dot = (0..3).map(|k| n[k][i] * m[k][j]).sum::<f64>();
                let size = (0..3).map(|k| (n[k][i] * m[k][j]).abs()).sum::<f64>();
                // Cofactors are rounded to 2^-31 of the largest cofactor.
                let slack = power(31) + size * power(-50);
                if i == j {
                    assert!(dot >= -slack);
                } else {
                    assert!(dot.abs() <= slack, "{dot:e}");
                }
            }
        }
    });
}

fn mantissas(random: &mut Random) -> [i32; 3] {
    const MOST: i32 = (1 << 30) - 1;
    [(); 3].map(|()| match random.random_range(0..3) {
        0 => MOST,
        1 => -MOST,
        _ => (random.random::<i32>() >> random.random_range(2..32)).max(-MOST),
    })
}

#[test]
fn points_are_rounded_once() {
    cases(256, |random| {
        let linear = [mantissas(random), mantissas(random), mantissas(random)];
        let translation = mantissas(random);
        let linear_exp = random.random_range(1_i32..=40);
        let translation_exp = random.random_range(-32_i32..=62);
        let point = random.random::<[i32; 3]>();
        let cut = random.random_range(0_u32..32);
        // With these exponents, all numbers fit into 64 bits.
        let translation_exp = translation_exp.max(linear_exp - 14);
        let t = Transform {
            linear,
            linear_exp,
            translation,
            translation_exp,
            is_mirror: false,
        };
        let point = Vec3::from_bits(point.map(|v| v >> cut));
        let exp = translation_exp.max(linear_exp + 16);
        let exact: [i32; 3] = core::array::from_fn(|i| {
            let products = linear[i].iter().zip(point.to_bits());
            let sum: i128 = products.map(|(&m, v)| i128::from(m) * i128::from(v)).sum();
            let moved = i128::from(translation[i]) << (exp - translation_exp);
            let twice = (sum << (exp - linear_exp - 16)) + moved + (1 << (exp - 17));
            (twice >> (exp - 16)).clamp(i32::MIN.into(), i32::MAX.into()) as i32
        });
        assert_eq!(t.point(point).to_bits(), exact);
        // Block floats drop up to two bits of the products of 63 bits and of the translation, and then round the sum
        // again.
        let bound = 1 + (4 >> linear_exp.min(3));
        for (far, exact) in t.far_point(point).to_bits().into_iter().zip(exact) {
            assert!(far.abs_diff(exact) <= bound);
        }
    });
}

#[test]
fn scales_and_offsets_below_16384_are_exact() {
    let most = (1 << 30) - 1;
    for bits in [most, -most, most - 1, 1 << 29 | 1] {
        let value = Scalar::from_bits(bits);
        let moved = Transform::translate(Vec3::new(value, Scalar::DELTA, -value));
        assert_eq!(moved.point(Vec3::ZERO).to_bits(), [bits, 1, -bits]);
        let scaled = Transform::scale(value).point(Vec3::from_ints(1, 0, -1));
        assert_eq!(scaled.to_bits(), [bits, 0, -bits]);
    }
    // A larger number is rounded to a multiple of two.
    let value = Scalar::from_bits(1 << 30 | 1);
    let moved = Transform::translate(Vec3::new(value, Scalar::ZERO, Scalar::ZERO));
    let scaled = Transform::scale(value).point(Vec3::X);
    for found in [moved.point(Vec3::ZERO), scaled] {
        assert_eq!(found.to_bits(), [1 << 30 | 2, 0, 0]);
    }
}
