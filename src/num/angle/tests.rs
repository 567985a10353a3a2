//! Angles and their sines, compared with f64.

use super::*;
use crate::random::{cases, number};
use rand::Rng;
use std::string::ToString;

#[allow(clippy::cast_precision_loss)]
fn radians(angle: Angle) -> f64 {
    f64::from(angle.to_bits()) / TURN * core::f64::consts::TAU
}

fn real(unit: Fraction) -> f64 {
    f64::from(unit.to_bits()) / 1_073_741_824.0
}

#[test]
fn sine_and_cosine_are_within_1_6e_minus_9() {
    let mut worst = 0_f64;
    for bits in (0..=u32::MAX).step_by(1_009) {
        let angle = Angle::from_bits(bits);
        worst = worst.max((real(angle.sin()) - radians(angle).sin()).abs());
        worst = worst.max((real(angle.cos()) - radians(angle).cos()).abs());
    }
    // The error comes from the polynomial, from three roundings to 2^-30, and from the rounding of the square.
    // Measured: 1.52e-9.
    assert!(worst < 1.6e-9, "{worst:e}");
}

/// The largest error found is 1.542e-9.
#[test]
#[ignore = "all 2^32 angles take three minutes"]
fn sine_of_every_angle() {
    let worst = |range: core::ops::RangeInclusive<u32>| {
        let error = |bits: u32| {
            let angle = Angle::from_bits(bits);
            (real(angle.sin()) - radians(angle).sin()).abs()
        };
        range.map(error).fold(0., f64::max)
    };
    let half = 1 << 31;
    let found = std::thread::scope(|scope| {
        let first = scope.spawn(move || worst(0..=half - 1));
        worst(half..=u32::MAX).max(first.join().unwrap())
    });
    assert!(found < 1.6e-9, "{found:e}");
}

#[test]
fn sine_is_symmetric_and_bounded() {
    for bits in (0..1_u32 << 30).step_by(10_007) {
        let angle = Angle::from_bits(bits);
        let sin = angle.sin();
        assert!(sin >= Fraction::ZERO && sin <= Fraction::ONE);
        assert_eq!((-angle).sin(), -sin);
        assert_eq!((Angle::HALF - angle).sin(), sin);
        assert_eq!((Angle::QUARTER - angle).cos(), sin);
    }
}

#[test]
fn quarters_are_exact() {
    let (zero, one) = (Fraction::ZERO, Fraction::ONE);
    for (degrees, sin_cos) in [
        (0, (zero, one)),
        (90, (one, zero)),
        (180, (zero, -one)),
        (270, (-one, zero)),
        (-90, (-one, zero)),
        (720, (zero, one)),
    ] {
        assert_eq!(Angle::from_degrees(degrees).sin_cos(), sin_cos, "{degrees}");
    }
}

#[test]
fn degrees_are_rounded_to_nearest() {
    for degrees in -1_000..1_000 {
        // This check is exact in 128 bits: |bits · 360 − degrees · 2^32| ≤ 180, mod 360 · 2^32.
        let bits = i128::from(Angle::from_degrees(degrees).to_bits());
        let error = (bits * 360 - i128::from(degrees) * (1 << 32)).rem_euclid(360 << 32);
        assert!(error <= 180 || error >= (360 << 32) - 180, "{degrees}");
        assert_eq!(
            Angle::try_from_degrees(degrees),
            Ok(Angle::from_degrees(degrees))
        );
    }
    assert_eq!(Angle::from_degrees(i32::MIN), Angle::from_degrees(-128));
}

#[test]
fn floats_wrap_and_nonsense_is_refused() {
    assert_eq!(Angle::nearest(-2.75, 1.0), Ok(Angle::QUARTER));
    assert_eq!(Angle::try_from_degrees(-1e-300), Ok(Angle::ZERO));
    assert_eq!(Angle::try_from_degrees(360.0 - 1e-9), Ok(Angle::ZERO));
    assert_eq!(
        Angle::try_from_radians(core::f64::consts::PI),
        Ok(Angle::HALF)
    );
    assert!(Angle::try_from_radians(f64::MAX).is_ok());
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(Angle::try_from_degrees(value).is_err());
        assert!(Angle::try_from_radians(value).is_err());
    }
}

#[test]
fn large_floats_in_radians_are_accurate_to_a_unit() {
    // 2^96 / 2π: this factor turns whole radians into units of 2^-96 of a turn.
    const TURN: u128 = 12_609_553_696_233_175_933_233_255_924;
    for radians in (0..10_000_000_u32).step_by(1009).chain([10_000_000]) {
        let exact = ((TURN * u128::from(radians)) >> 64) as u32;
        for (float, exact) in [
            (f64::from(radians), exact),
            (-f64::from(radians), exact.wrapping_neg()),
        ] {
            let found = Angle::try_from_radians(float).unwrap().to_bits();
            let error = found.wrapping_sub(exact).cast_signed();
            // The exact angle is rounded down, which adds an error of one unit.
            assert!(error.abs() <= 2, "{float}: {error}");
        }
    }
}

#[test]
fn radians_are_rounded_to_a_unit() {
    for bits in (i32::MIN..=i32::MAX).step_by(1_000_003).chain([i32::MAX]) {
        let radians = Scalar::from_bits(bits);
        let expected = Angle::try_from_radians(f64::from(bits) / 65_536.0).unwrap();
        let error = (Angle::from_radians(radians) - expected).to_bits();
        assert!(error <= 1 || error == u32::MAX, "{radians}");
    }
}

#[test]
fn degrees_are_displayed() {
    for (angle, shown) in [
        (Angle::from_degrees(180), "180 degrees"),
        (Angle::from_degrees(-10), "350 degrees"),
        (Angle::from_degrees(1), "1 degrees"),
        (Angle::try_from_degrees(0.05).unwrap(), "0.05 degrees"),
        (Angle::try_from_degrees(0.0001).unwrap(), "0.0001 degrees"),
        (Angle::try_from_degrees(59.999_99).unwrap(), "60 degrees"),
    ] {
        assert_eq!(angle.to_string(), shown);
    }
    assert_eq!(
        std::format!("{:?}", Angle::QUARTER),
        "90 degrees (0x40000000)"
    );
}

#[test]
fn arc_tangent_inverts() {
    for bits in (0..=u32::MAX).step_by(777_777) {
        let angle = Angle::from_bits(bits);
        let (sin, cos) = angle.sin_cos();
        let found = Angle::atan2_bits(sin.to_bits().into(), cos.to_bits().into());
        let error = (found - angle).to_bits();
        // An error of 2e-9 radians is 1.4 units. The point itself is rounded to 1.4e-9.
        assert!(error <= 3 || error >= u32::MAX - 2, "{bits}: {error}");
    }
    assert_eq!(Angle::atan2_bits(0, 0), Angle::ZERO);
    assert_eq!(Angle::atan2_bits(0, i64::MIN), Angle::HALF);
    assert_eq!(Angle::atan2_bits(i64::MAX, 0), Angle::QUARTER);
}

#[test]
fn assignments_are_the_operators() {
    let (mut sum, mut difference) = (Angle::QUARTER, Angle::QUARTER);
    sum += Angle::HALF;
    difference -= Angle::HALF;
    assert_eq!(sum, Angle::from_degrees(270));
    assert_eq!(difference, Angle::from_degrees(-90));
    difference -= Angle::from_bits(3);
    assert_eq!(difference.to_bits(), (3 << 30) - 3);
}

/// Checks an angle against a number of turns.
///
/// The angle is rounded by at most half a unit, 2^-33 turns. Below 2^15 turns, each of at most three roundings of f64
/// is at most 2^-39; they add 5 %.
fn assert_turns(angle: Angle, turns: f64) {
    let error = f64::from(angle.to_bits()) / TURN - turns;
    let error = (error - error.round()).abs();
    assert!(
        error <= 1.05 / (2.0 * TURN),
        "{angle:?}, {turns}: {error:e}"
    );
}

#[test]
fn products_are_of_angles_from_0_to_below_a_turn() {
    cases(1024, |random| {
        let (angle, bits) = (Angle::from_bits(random.random()), number(random));
        let turns = f64::from(angle.to_bits()) / TURN;
        let (scalar, fraction) = (Scalar::from_bits(bits), Fraction::from_bits(bits));
        assert_turns(angle * scalar, turns * f64::from(scalar));
        assert_turns(angle * fraction, turns * f64::from(fraction));
        let whole: i16 = random.random();
        assert_eq!(angle * Scalar::from(whole), angle * i32::from(whole));
        assert_eq!(scalar * angle, angle * scalar);
        assert_eq!(fraction * angle, angle * fraction);
        assert_eq!(bits * angle, angle * bits);
        let mut products = [angle; 3];
        products[0] *= scalar;
        products[1] *= fraction;
        products[2] *= bits;
        assert_eq!(products, [angle * scalar, angle * fraction, angle * bits]);
    });
}

/// The products of these factors are the largest. Halves are rounded up.
#[test]
fn products_at_the_ends_of_the_formats() {
    let most = Angle::from_bits(u32::MAX);
    // (2^32 − 1)(2^31 − 1) / 2^16 = 2^47 − 2^16 − 2^15 + 2^-16.
    assert_eq!(
        (most * Scalar::MAX).to_bits(),
        0_u32.wrapping_sub((1 << 16) + (1 << 15))
    );
    // (2^32 − 1) · −2^31 / 2^16 = −2^47 + 2^15.
    assert_eq!((most * Scalar::MIN).to_bits(), 1 << 15);
    // (2^32 − 1)(2^31 − 1) / 2^30 = 2^33 − 4 − 2 + 2^-30.
    assert_eq!((most * Fraction::MAX).to_bits(), 0_u32.wrapping_sub(6));
    assert_eq!((most * Fraction::MIN).to_bits(), 2);
    let unit = Angle::from_bits(1);
    assert_eq!(
        [unit * (Scalar::ONE / 2), unit * (-Scalar::ONE / 2)],
        [unit, Angle::ZERO]
    );
    assert_eq!(
        [unit * (Fraction::ONE / 2), unit * (-Fraction::ONE / 2)],
        [unit, Angle::ZERO]
    );
}

#[test]
fn interpolation_takes_the_shorter_way() {
    // Opposite angles: clockwise.
    const BETWEEN: Angle = Angle::ZERO.lerp(Angle::HALF, Scalar::from_bits(1 << 15));
    assert_eq!(BETWEEN, -Angle::QUARTER);
    cases(1024, |random| {
        let [a, b] = [(); 2].map(|()| Angle::from_bits(random.random()));
        let t = Scalar::from_bits(number(random));
        let [from, to] = [a, b].map(|angle| f64::from(angle.to_bits()) / TURN);
        // `random` makes no opposite angles. For others, the nearest whole number of turns tells the shorter way.
        let way = to - from;
        let way = way - way.round();
        assert_turns(a.lerp(b, t), from + way * f64::from(t));
        assert_eq!(a.lerp(b, Scalar::ZERO), a);
        assert_eq!(a.lerp(b, Scalar::ONE), b);
        assert_eq!(a.lerp(a, t), a);
    });
}

/// Compares the angle of points of all magnitudes with f64. The largest error of 40 million points was 2.006e-9.
#[test]
fn arc_tangent_is_within_2_3e_minus_9() {
    let mut worst = 0_f64;
    for step in 0_u32..40_000 {
        let bits = step.wrapping_mul(0x9e37_79b9);
        let [x, y] = [bits, bits.wrapping_mul(0x85eb_ca6b) ^ step]
            .map(|bits| i64::from(bits.cast_signed()) >> (step & 15));
        if [x, y] == [0, 0] {
            continue;
        }
        #[allow(clippy::cast_precision_loss)] // of 32 bits
        let expected = (y as f64).atan2(x as f64);
        let found = radians(Angle::atan2_bits(y, x));
        let error = (found - expected).rem_euclid(core::f64::consts::TAU);
        worst = worst.max(error.min(core::f64::consts::TAU - error));
    }
    assert!(worst < 2.3e-9, "{worst:e}");
}

/// On the axes and the diagonals, at all distances, the polynomial and all roundings leave no error.
#[test]
fn arc_tangent_of_multiples_of_45_degrees_is_exact() {
    for far in (0..1_000).map(|i| 1 + i * 2_147_483).chain([i32::MAX]) {
        let far = i64::from(far);
        let points = [
            (0, 1),
            (1, 1),
            (1, 0),
            (1, -1),
            (0, -1),
            (-1, -1),
            (-1, 0),
            (-1, 1),
        ];
        for (eighths, (y, x)) in (0..).zip(points) {
            let found = Angle::atan2_bits(y * far, x * far);
            assert_eq!(found, Angle::from_degrees(45) * eighths, "{far}");
        }
    }
}
