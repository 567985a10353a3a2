//! The coefficients of projections, compared with their formulas in f64, and refused arguments.

use super::*;
use crate::Error;
use crate::random::{Random, cases, within};
use crate::view::Aspect;
use crate::{Angle, Vec3};
use core::f64::consts::TAU;
use core::ops::Bound::{Excluded, Unbounded};
use rand::Rng;

fn real(row: &ProjectionRow) -> [f64; 4] {
    let value = |(m, exp): (i32, i32)| f64::from(m) * f64::from(-exp).exp2();
    let [x, y, z, offset] = row.m;
    [
        (x, row.exp),
        (y, row.exp),
        (z, row.exp),
        (offset, row.offset_exp),
    ]
    .map(value)
}

fn float(value: Scalar) -> f64 {
    f64::from(value.to_bits()) / 65_536.0
}

/// Whether each coefficient of a row has an error of at most 2^-28 of the largest coefficient, and is exactly zero
/// where zero is expected.
fn close(row: &ProjectionRow, expected: [f64; 4]) -> bool {
    let size = expected.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
    let mut both = real(row).into_iter().zip(expected);
    both.all(|(found, expected)| {
        let allowed = if expected == 0. {
            0.
        } else {
            size * f64::from(-28).exp2()
        };
        (found - expected).abs() <= allowed
    })
}

fn one(value: f64) -> Scalar {
    Scalar::try_from(value).unwrap()
}

/// Distances of a near and a far plane ahead of the eye, of all sizes.
fn planes(random: &mut Random) -> (Scalar, Scalar) {
    let [a, b] =
        [(); 2].map(|()| (random.random_range(1..i32::MAX) >> random.random_range(0..31)).max(1));
    let (near, far) = (a.min(b), a.max(b).max(a.min(b) + 1));
    (Scalar::from_bits(near), Scalar::from_bits(far))
}

/// Two numbers in ascending order, of all sizes.
fn ordered(random: &mut Random) -> (Scalar, Scalar) {
    loop {
        let cut = random.random_range(0..31);
        let [a, b] = random
            .random::<[i32; 2]>()
            .map(|v| Scalar::from_bits(v >> cut));
        if a != b {
            return (a.min(b), a.max(b));
        }
    }
}

#[test]
fn perspective_has_28_bits() {
    cases(256, |random| {
        let bits = random.random_range(1 << 16..1_u32 << 31);
        let size = within(random, [1_u32..8192, 1..8192]);
        let fov = Angle::from_bits(bits);
        let projection =
            Projection::perspective(fov, (size[0], size[1]), one(0.1), one(100.0)).unwrap();
        let half = f64::from(bits) / f64::from(33).exp2() * TAU;
        let scale = half.cos() / half.sin();
        // Half a unit of the angle is dropped, which matters at both ends of the angle's range.
        let slack = f64::from(-28).exp2() + 8e-10 / (half.sin() * half.cos());
        let [x, y] = projection.rows.map(|row| row.m);
        assert_eq!((&x[1..], [y[0], y[2], y[3]]), (&[0; 3][..], [0; 3]));
        let found = real(&projection.rows[1])[1];
        assert!((found / scale - 1.0).abs() <= slack, "{found} {scale}");
        let x = scale * f64::from(size[1]) / f64::from(size[0]);
        let found = real(&projection.rows[0])[0];
        assert!((found / x - 1.0).abs() <= slack, "{found} {x}");
        let error = (projection.fov() - fov).to_bits().cast_signed();
        assert!(error.abs() <= 8, "{error}");
    });
}

#[test]
fn frustum_has_28_bits() {
    cases(256, |random| {
        let (l, r) = ordered(random);
        let (b, t) = ordered(random);
        let (n, f) = planes(random);
        let projection = Projection::frustum(
            Window {
                left: l,
                right: r,
                bottom: b,
                top: t,
            },
            n,
            f,
        )
        .unwrap();
        let [lf, rf, bf, tf, nf] = [l, r, b, t, n].map(float);
        assert!(close(
            &projection.rows[0],
            [2.0 * nf / (rf - lf), 0.0, (rf + lf) / (rf - lf), 0.0]
        ));
        assert!(close(
            &projection.rows[1],
            [0.0, 2.0 * nf / (tf - bf), (tf + bf) / (tf - bf), 0.0]
        ));
    });
}

#[test]
fn oblique_has_28_bits() {
    cases(256, |random| {
        let (l, r) = ordered(random);
        let (b, t) = ordered(random);
        let (n, f) = ordered(random);
        let angle = random.random::<u32>();
        let ratio = random.random::<i32>();
        let (angle, ratio) = (Angle::from_bits(angle), Scalar::from_bits(ratio));
        let plane = Scalar::from_bits(crate::random::number(random));
        let projection = Projection::oblique(
            angle,
            ratio,
            plane,
            Window {
                left: l,
                right: r,
                bottom: b,
                top: t,
            },
            n,
            f,
        )
        .unwrap();
        let [lf, rf, bf, tf, pf, k] = [l, r, b, t, plane, ratio].map(float);
        let (sin, cos) = (f64::from(angle.to_bits()) / f64::from(32).exp2() * TAU).sin_cos();
        let (x, y) = (2.0 / (rf - lf), 2.0 / (tf - bf));
        let (cx, cy) = (-x * k * cos, -y * k * sin);
        // The error of a sine is up to 1.6e-9, not 2^-28 of the sine; ratio and distance multiply this error.
        let slack = |scale: f64, middle: f64| {
            f64::from(-28).exp2() * (scale + middle.abs() + scale * k.abs() * (1.0 + pf.abs()))
        };
        let check = |row: &ProjectionRow, expected: [f64; 4], slack: f64| {
            real(row)
                .into_iter()
                .zip(expected)
                .all(|(found, v)| (found - v).abs() <= slack)
        };
        let middle = (rf + lf) / (rf - lf);
        assert!(check(
            &projection.rows[0],
            [x, 0.0, cx, -middle + cx * pf],
            slack(x, middle)
        ));
        let middle = (tf + bf) / (tf - bf);
        assert!(check(
            &projection.rows[1],
            [0.0, y, cy, -middle + cy * pf],
            slack(y, middle)
        ));
    });
}

#[test]
fn no_accessor_panics() {
    cases(256, |random| {
        let v = random.random::<[i32; 7]>();
        let angle = random.random::<u32>();
        let size = random.random::<(u32, u32)>();
        let [l, r, b, t, n, f, k] = v.map(Scalar::from_bits);
        let angle = Angle::from_bits(angle);
        let window = Window {
            left: l,
            right: r,
            bottom: b,
            top: t,
        };
        let projections = [
            Projection::perspective(angle, size, n, f),
            Projection::from_focal_length(k, size, n, f),
            Projection::frustum(window, n, f),
        ];
        for projection in projections.into_iter().flatten() {
            let _ = (
                projection.window(),
                projection.aspect(),
                projection.fov(),
                projection.to_matrix(),
            );
            let _ = (
                projection.vanishing_point(Vec3::new(l, r, b)),
                projection.image(Vec3::new(l, r, b)),
            );
        }
        let projections = [
            Projection::orthographic(window, n, f),
            Projection::oblique(angle, k, n, window, n, f),
        ];
        for projection in projections.into_iter().flatten() {
            let _ = (
                projection.window(),
                projection.aspect(),
                projection.to_matrix(),
            );
        }
    });
}

/// The window keeps its place, however far it is from the line of sight compared with its size.
#[test]
fn a_window_keeps_its_place() {
    let check = |window: Window, found: Window, near: f64, ratio: f64| {
        let edges = |w: Window| [w.left, w.right, w.bottom, w.top].map(float);
        let largest = edges(window)
            .into_iter()
            .fold(0.0, |max: f64, v| max.max(v.abs()));
        for (found, exact) in edges(found).into_iter().zip(edges(window)) {
            // 2^-17 is half a unit of the result.
            let most = largest.max(near.abs()) * (1.0 + ratio.abs());
            let allowed = f64::from(-17).exp2() + f64::from(-29).exp2() * most;
            assert!((found - exact).abs() <= allowed, "{window:?} {found}");
        }
    };
    cases(256, |random| {
        let ((left, right), (bottom, top)) = (ordered(random), ordered(random));
        let window = Window {
            left,
            right,
            bottom,
            top,
        };
        let (near, far) = ordered(random);
        let projection = Projection::orthographic(window, near, far).unwrap();
        check(window, projection.window(), 0.0, 0.0);
        let angle = Angle::from_bits(random.random());
        let ratio = Scalar::from_bits(random.random());
        let projection = Projection::oblique(angle, ratio, near, window, near, far).unwrap();
        check(window, projection.window(), float(near), float(ratio));
    });
}

#[test]
fn focal_length_is_exact() {
    let projection =
        Projection::from_focal_length(one(200.0), (320, 240), one(0.25), one(100.0)).unwrap();
    assert!((real(&projection.rows[0])[0] - 1.25).abs() < f64::EPSILON);
    // 5/3 is rounded to 30 bits.
    assert!((real(&projection.rows[1])[1] - 5.0 / 3.0).abs() < f64::from(-29).exp2());
}

#[test]
fn invalid_arguments_are_refused() {
    let not_above = |of, given, low| Error::OutOfRange {
        of,
        given,
        range: (Excluded(low), Unbounded),
    };
    let (zero, low, high) = (Scalar::ZERO, one(1.0), one(2.0));
    let fov = Angle::from_degrees(60);
    let square = Window::centered(high, high);
    for degrees in [0, 180, 181, 270, -1] {
        let angle = Angle::from_degrees(degrees);
        let refused = Projection::perspective(angle, (4, 3), low, high);
        let error = Error::Angle {
            of: "field of view",
            given: angle,
            range: (Excluded(Angle::ZERO), Excluded(Angle::HALF)),
        };
        assert_eq!(refused, Err(error));
    }
    for near in [zero, -low] {
        let refused = [
            Projection::perspective(fov, (4, 3), near, high),
            Projection::from_focal_length(low, (4, 3), near, high),
            Projection::frustum(square, near, high),
        ];
        let error = not_above("distance of the near plane", near, zero);
        assert_eq!(refused, [Err(error); 3]);
    }
    for far in [low, high] {
        let refused = [
            Projection::perspective(fov, (4, 3), high, far),
            Projection::from_focal_length(low, (4, 3), high, far),
            Projection::frustum(square, high, far),
        ];
        let error = not_above("distance of the far plane", far, high);
        assert_eq!(refused, [Err(error); 3]);
        let refused = Projection::orthographic(square, high, far);
        assert_eq!(refused, Err(error));
    }
    for given in [low, zero] {
        let good = Window {
            left: low,
            right: high,
            bottom: low,
            top: high,
        };
        let narrow = Window {
            right: given,
            ..good
        };
        let flat = Window { top: given, ..good };
        for (window, of) in [
            (narrow, "right edge of the window"),
            (flat, "top edge of the window"),
        ] {
            let error = not_above(of, given, low);
            assert_eq!(Projection::frustum(window, low, high), Err(error));
            assert_eq!(Projection::orthographic(window, low, high), Err(error));
            let oblique = Projection::oblique(fov, Scalar::ONE, low, window, low, high);
            assert_eq!(oblique, Err(error));
        }
    }
    let (width, height) = ("width of the aspect ratio", "height of the aspect ratio");
    let perspective = |aspect: Aspect| Projection::perspective(fov, aspect, low, high);
    // The error contains the refused ratio with its fraction.
    for (aspect, of, given) in [
        ((4, 0).into(), height, zero),
        ((0, u32::MAX).into(), width, zero),
        ((u32::MAX, 0).into(), height, zero),
        (Aspect::from(-low), width, -low),
        (one(-0.25).into(), width, one(-0.25)),
    ] {
        assert_eq!(perspective(aspect), Err(not_above(of, given, zero)));
    }
    let refused = Projection::from_focal_length(zero, (4, 3), low, high);
    assert_eq!(refused, Err(not_above("focal length", zero, zero)));
}

#[test]
fn the_widest_and_narrowest_views_do_not_panic() {
    for bits in [1, 2, 3, (1 << 31) - 1, (1 << 31) - 2] {
        let projection =
            Projection::perspective(Angle::from_bits(bits), (1, 1), one(1.0), one(2.0)).unwrap();
        let _ = (
            projection.window(),
            projection.fov(),
            projection.aspect(),
            projection.to_matrix(),
        );
    }
}
