//! Angles at a time, for constant rates of rotation.

use core::f64::consts::TAU;

use fixel::prelude::*;

use super::helpers::close;

/// A sine has an error of up to 1.6e-9, and 2^-32 of a turn is 1.5e-9 radians.
const SINE: f64 = 3e-9;

#[test]
fn a_sine_once_a_second() {
    for ms in 0..2_000_u32 {
        let expected = (TAU * f64::from(ms) / 1_000.0).sin();
        let found = Rate::hertz(1).angle_at(ms.into()).sin();
        close(f64::from(found), expected, SINE);
    }
}

#[test]
fn rotations_per_minute_to_radians_per_millisecond() {
    let per_ms = 10.0 * TAU / (60.0 * 1_000.0);
    for ms in [1_u32, 16, 1_000, 1_499, 5_999] {
        let found = f64::from(Rate::rpm(10).angle_at(ms.into()).to_bits()) / 4_294_967_296.0 * TAU;
        close(found, per_ms * f64::from(ms), 1.5e-9);
    }
}

#[test]
fn absolute_time_is_exact_after_days() {
    // Ten turns a minute are one turn in 6000 ms.
    let rate = Rate::rpm(10);
    for hours in [1, 24, 30 * 24, 365 * 24 * 1_000] {
        let turns = hours * 600;
        for ms in [0, 1, 17, 3_000, 5_999] {
            assert_eq!(rate.angle_at(turns * 6_000 + ms), rate.angle_at(ms));
        }
    }
}
