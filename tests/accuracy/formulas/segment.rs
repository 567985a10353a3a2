//! Depth, fractions, values and speed along a projected segment.

use fixel::prelude::*;
use fixel::textbook::{Segment, speed};
use rand::Rng;

use support::moves::{exact, number, rounded};
use support::random::{cases, within};

use super::helpers::{STEP, UNIT_STEP, close, float, unit, vec};

fn segment(z0: f64, z1: f64) -> Segment {
    Segment::new(number(z0), number(z1)).unwrap()
}

#[test]
fn depth_halfway_along_a_projected_segment() {
    // q = 1/2 is exact. 1.6 is rounded by up to half a step.
    let z = segment(1.0, 4.0).distance(unit(0.5)).unwrap();
    close(float(z), 1.6, STEP / 2.0);
}

#[test]
fn a_fraction_on_screen_converts_to_space_and_back() {
    let segment = segment(1.0, 4.0);
    let t = segment.in_space(unit(0.5)).unwrap();
    close(f64::from(t), 0.2, UNIT_STEP / 2.0);
    let q = segment.on_screen(t).unwrap();
    // The error is half a step of t, times dq/dt = z0·z1/(z0 + t(z1 − z0))² = 4/1.6², plus half a step of q.
    close(f64::from(q), 0.5, UNIT_STEP * (0.5 + 0.5 * 4.0 / 2.56));
}

#[test]
fn depth_and_fraction_of_any_segment() {
    cases(256, |random| {
        let z = within(random, [0.1..1000.0, 0.1..1000.0]);
        let q = random.random_range(0.0..1.0);
        let s = segment(z[0], z[1]);
        // The arguments after rounding to the crate's formats.
        let [z0, z1] = z.map(|z| float(number(z)));
        let q = f64::from(unit(q));
        let depth = 1.0 / (1.0 / z0 + q * (1.0 / z1 - 1.0 / z0));
        // The result is rounded once. f64 itself has a relative error of only 1e-13.
        close(float(s.distance(unit(q)).unwrap()), depth, 0.501 * STEP);
        let t = q * z0 / (z1 - q * (z1 - z0));
        close(
            f64::from(s.in_space(unit(q)).unwrap()),
            t,
            0.501 * UNIT_STEP,
        );
        let back = q * z1 / (z0 + q * (z1 - z0));
        close(
            f64::from(s.on_screen(unit(q)).unwrap()),
            back,
            0.501 * UNIT_STEP,
        );
    });
}

#[test]
fn both_forms_of_interpolation_give_the_same_point() {
    cases(256, |random| {
        let segment = segment(
            random.random_range(0.1..100.0),
            random.random_range(0.1..100.0),
        );
        let [a, b] = within(random, [-100.0..100.0, -100.0..100.0]).map(number);
        let f = unit(random.random_range(0.0..1.0));
        // R = lerp(a/w0, b/w1, f) / lerp(1/w0, 1/w1, f).
        let homogeneous = segment.attribute(a, b, f).unwrap();
        // g = f / lerp(w1/w0, 1, f). The value is then interpolated linearly in space.
        let g = f64::from(segment.in_space(f).unwrap());
        let in_space = float(a) + g * (float(b) - float(a));
        // The result is rounded once. g is also rounded once, and multiplied by at most 200.
        close(
            float(homogeneous),
            in_space,
            0.501 * STEP + 200.0 * UNIT_STEP,
        );
    });
}

fn check_speed(n: f64, p: [f64; 3], v: [f64; 3], t: f64) {
    let found = speed(
        number(n),
        vec(p[0], p[1], p[2]),
        vec(v[0], v[1], v[2]),
        number(t),
    )
    .unwrap();
    let [n, t] = [n, t].map(|x| float(number(x)));
    let [p, v] = [p, v].map(|x| exact(rounded(x)));
    for i in 0..2 {
        let expected = -n * (v[i] * p[2] - p[i] * v[2]) / (p[2] + v[2] * t).powi(2);
        // The result is rounded once.
        close(float(found[i]), expected, 0.501 * STEP);
    }
}

#[test]
fn speed_along_a_line_follows_its_formula() {
    cases(256, |random| {
        let n = random.random_range(0.1..10.0);
        let p = within(random, [-50.0..50.0, -50.0..50.0, -50.0..-1.0]);
        let v = within(random, [-10.0..10.0, -10.0..10.0, -10.0..0.0]);
        let t = random.random_range(0.0..10.0);
        check_speed(n, p, v, t);
    });
}

/// The products in the formula have up to 94 bits.
#[test]
fn speed_at_the_ends_of_the_format() {
    cases(256, |random| {
        let n = random.random_range(16000.0..32767.0);
        let p = [-32767.0..32767.0, 20000.0..32767.0, -32767.0..-20000.0];
        let v = [-32767.0..32767.0, -32767.0..-20000.0, -32767.0..-20000.0];
        let [p, v] = [p, v].map(|v| within(random, v));
        let t = random.random_range(1.0..2.0);
        check_speed(n, p, v, t);
    });
}

#[test]
fn equal_steps_in_depth_shrink_on_screen() {
    let projection =
        Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(1), fx!(1000)).unwrap();
    let at = |t: f64| float(projection.image(vec(0.0, -1.0, -1.0 - t)).unwrap()[1]);
    let speed =
        |t: f64| float(speed(fx!(1), vec3!(0, -1, -1), vec3!(0, 0, -1), number(t)).unwrap()[1]);
    let mut last = f64::INFINITY;
    // The loop ends when the change between steps, 2/t³, is twice the rounding error of three points.
    for t in 0..25 {
        let t = f64::from(t);
        let step = at(t + 1.0) - at(t);
        assert!(step < last && step > 0.0, "step {step} after {last} at {t}");
        // The step lies between the speeds at its ends. All four numbers are rounded by up to half a step.
        assert!(step <= speed(t) + 2.0 * STEP && step >= speed(t + 1.0) - 2.0 * STEP);
        last = step;
    }
    close(speed(999.0), 1e-6, STEP / 2.0);
}
