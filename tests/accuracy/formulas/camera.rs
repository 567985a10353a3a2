//! Cameras, and products of projection, view and model.

use std::array::from_fn;

use fixel::prelude::*;
use rand::Rng;

use support::moves::exact;
use support::random::{Random, cases, within};
use support::reference::linear::{cross, dot, normalized, subtract};

use super::helpers::{STEP, all_close, close, float, vec};

/// For each axis, the length on the screen of an edge of length one along the axis, in an orthographic view.
fn foreshortening(camera: &Camera) -> [f64; 3] {
    [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| {
        let [x, y, _] = exact(camera.view().direction(axis));
        x.hypot(y)
    })
}

#[test]
fn axonometric_views_foreshorten_the_axes() {
    let (target, distance) = (vec3!(1, 2, 3), fx!(10));
    let alike = (2.0_f64 / 3.0).sqrt();
    // Each of the two coordinates is rounded by up to half a step.
    all_close(
        foreshortening(&Camera::isometric(target, distance)),
        [alike; 3],
        STEP,
    );
    let [x, y, z] = foreshortening(&Camera::dimetric(target, distance, Angle::from_degrees(20)));
    close(x, z, 2.0 * STEP);
    close(y, 20_f64.to_radians().cos(), STEP);
    assert!((x - y).abs() > 0.1);
    let (turn, tilt) = (Angle::from_degrees(30), Angle::from_degrees(20));
    let [x, y, z] = foreshortening(&Camera::trimetric(target, distance, turn, tilt));
    assert!((x - y).abs() > 0.05 && (y - z).abs() > 0.05 && (z - x).abs() > 0.05);
    for camera in [
        Camera::isometric(target, distance),
        Camera::front(target, distance),
        Camera::side(target, distance),
        Camera::top(target, distance),
    ] {
        // The target is in the middle of the picture, at the camera's distance.
        assert_eq!(camera.view().point(target), vec3!(0, 0, -10));
    }
    // Each view, with the axes that point right and up in the picture.
    for (camera, right, up) in [
        (Camera::front(target, distance), Vec3::X, Vec3::Y),
        (Camera::side(target, distance), -Vec3::Z, Vec3::Y),
        (Camera::top(target, distance), Vec3::X, -Vec3::Z),
    ] {
        assert_eq!(camera.view().direction(right), Vec3::X);
        assert_eq!(camera.view().direction(up), Vec3::Y);
    }
}

fn point(random: &mut Random) -> Vec3 {
    let [x, y, z] = within(random, [-50.0..50.0, -50.0..50.0, -50.0..50.0]);
    vec(x, y, z)
}

#[test]
fn look_at_follows_its_formula() {
    cases(256, |random| {
        let (eye, target, up, k, side) = loop {
            let [eye, target, up] = from_fn(|_| point(random));
            let k = normalized(subtract(exact(eye), exact(target)));
            let side = cross(exact(up), k);
            // If `up` is nearly parallel to the line of sight, the rounding error of `up` counts too much.
            if dot(side, side) > 1e-4 * dot(exact(up), exact(up)) {
                break (eye, target, up, k, side);
            }
        };
        let p = point(random);
        let camera = Camera::look_at(eye, target, up).unwrap();
        let i = normalized(side);
        let j = cross(k, i);
        let offset = subtract(exact(p), exact(eye));
        // Axes have an error of up to 2^-28/0.01, over a distance of at most 174. The result is rounded once.
        let expected = [i, j, k].map(|axis| dot(axis, offset));
        all_close(
            exact(camera.view().point(p)),
            expected,
            0.51 * STEP + 174.0 * 100.0 * 4e-9,
        );
        // The eye is at the origin of eye space, and the target is on the axis ahead.
        all_close(exact(camera.view().point(eye)), [0.0; 3], STEP);
        let distance = dot(subtract(exact(eye), exact(target)), k);
        all_close(
            exact(camera.view().point(target)),
            [0.0, 0.0, -distance],
            STEP,
        );
    });
}

#[test]
fn the_inverse_undoes_a_rigid_transform() {
    cases(256, |random| {
        let [a, b, c] = random.random::<[u32; 3]>().map(Angle::from_bits);
        let turns = Transform::rotate_y(b) * Transform::rotate_z(c);
        let pose = Transform::rotate_x(a) * Transform::translate(point(random)) * turns;
        let p = point(random);
        let camera = Camera::at_pose(pose).view();
        let inverse = pose.inverse().unwrap();
        for both in [pose * camera, camera * pose, pose * inverse, inverse * pose] {
            let identity = both.to_matrix();
            for (i, row) in identity.rows().iter().enumerate() {
                for (j, &entry) in row.iter().enumerate() {
                    // Numbers up to 100 with 30 bits have units of less than 2^-22.
                    close(float(entry), f64::from(u8::from(i == j)), STEP);
                }
            }
            all_close(exact(both.point(p)), exact(p), STEP);
        }
    });
}

#[test]
fn a_camera_of_composed_moves_equals_look_at() {
    cases(256, |random| {
        let (eye, p) = (point(random), point(random));
        let turn = Angle::from_bits(random.random());
        let tilt = Angle::from_degrees(random.random_range(-80..80));
        let turns = Transform::rotate_y(turn) * Transform::rotate_x(tilt);
        let pose = Transform::translate(eye) * turns;
        let composed = Camera::at_pose(pose);
        // The inverse of a product is the product of the inverses in reverse order.
        let turns = Transform::rotate_x(-tilt) * Transform::rotate_y(-turn);
        let reverse = turns * Transform::translate(-eye);
        all_close(
            exact(composed.view().point(p)),
            exact(reverse.point(p)),
            STEP,
        );
        // `Camera::look_at` gives the same pose. The target is 100 units ahead, and rounded by up to half a step along
        // each axis.
        let camera = Camera::look_at(eye, pose.point(vec3!(0, 0, -100)), Vec3::Y).unwrap();
        let slack = STEP + 174.0 * (STEP / 100.0) * 2.0 / 80_f64.to_radians().cos();
        all_close(
            exact(composed.view().point(p)),
            exact(camera.view().point(p)),
            slack,
        );
    });
}

#[test]
fn useless_cameras_are_refused() {
    let eye = vec3!(1, 2, 3);
    let refused = Camera::look_at(eye, eye, Vec3::Y);
    assert!(matches!(refused, Err(Error::NoDirection { of: "eye", given, .. }) if given == eye));
    for up in [vec3!(0, 0, 0), vec3!(1, 2, 3), vec3!(-2, -4, -6)] {
        let refused = Camera::look_at(eye, Vec3::ZERO, up);
        assert!(matches!(refused, Err(Error::NoDirection { of: "up", given, .. }) if given == up));
    }
}

/// The middle of the picture.
const MIDDLE: [f64; 2] = [160.0, 120.0];

#[test]
fn the_mvp_applies_from_right_to_left() {
    let projection =
        Projection::perspective(Angle::from_degrees(90), (4, 3), fx!(0.5), fx!(100)).unwrap();
    let camera = Camera::look_at(vec3!(0, 0, 5), Vec3::ZERO, Vec3::Y).unwrap();
    let screen = Viewport::new(32, 16, 160, 120).unwrap();
    let place = |mvp: &_, p| {
        let place = screen.project(p, mvp).unwrap();
        [f64::from(place.x), f64::from(place.y)]
    };
    let (turn, shift) = (
        Transform::rotate_z(Angle::from_degrees(90)),
        Transform::translate(vec3!(2, 0, 0)),
    );
    // The model's point (1, 0, 0) is turned to (0, 1, 0) and moved to (2, 1, 0). In eye space, it is at (2, 1, −5). In
    // the picture, it is at (2/5 / (4/3), 1/5) = (0.3, 0.2). The middle of the picture is (112, 76), and its halves are
    // 80 by 60 pixels.
    let mvp = projection * camera * (shift * turn);
    all_close(
        place(&mvp, Vec3::X),
        [112.0 + 24.0, 76.0 - 12.0],
        1.0 / 256.0,
    );
    let apart = projection * camera * shift * turn;
    all_close(place(&apart, Vec3::X), place(&mvp, Vec3::X), 0.0);
    // With swapped factors, the point is moved to (3, 0, 0) and turned to (0, 3, 0).
    let swapped = projection * camera * (turn * shift);
    all_close(place(&swapped, Vec3::X), [112.0, 76.0 - 36.0], 1.0 / 256.0);
}

#[test]
fn a_line_projects_to_a_line() {
    cases(256, |random| {
        let screen = Viewport::new(0, 0, 320, 240).unwrap();
        let size = (320, 240);
        let projection = Projection::from_focal_length(fx!(100), size, fx!(0.5), fx!(100)).unwrap();
        // Coordinates are multiples of four steps, so that the format represents every quarter of the way exactly.
        let mut multiple = |range| {
            let v: f64 = random.random_range(range);
            (v * 16_384.0).round() / 16_384.0
        };
        let p = [-3.0..3.0, -3.0..3.0, -9.0..-4.0].map(&mut multiple);
        let v = [-1.0..1.0, -1.0..1.0, -1.0..1.0].map(multiple);
        for t in 0..=8 {
            let t = f64::from(t) / 4.0;
            let point = [0, 1, 2].map(|i| p[i] + t * v[i]);
            let [x, y] = [100.0 * point[0] / -point[2], 100.0 * point[1] / -point[2]];
            let mvp = projection * Transform::IDENTITY;
            let place = screen.project(Vec3::try_from(point).unwrap(), &mvp);
            let place = place.expect("the point is ahead");
            // The position is rounded by up to half a subpixel.
            let expected = [MIDDLE[0] + x, MIDDLE[1] - y];
            all_close(
                [f64::from(place.x), f64::from(place.y)],
                expected,
                0.51 / 256.0,
            );
        }
    });
}

#[test]
fn lines_across_the_view_keep_their_slope() {
    cases(256, |random| {
        let p = within(random, [-3.0..3.0, -3.0..3.0, -9.0..-2.0]);
        let v = within(random, [0.5..2.0, -2.0..2.0]);
        let fov = Angle::from_degrees(90);
        let projection = Projection::perspective(fov, (1, 1), fx!(1), fx!(100)).unwrap();
        let point = |t: f64| vec(p[0] + t * v[0], p[1] + t * v[1], p[2]);
        let at = |t| projection.image(point(t)).unwrap().map(float);
        let (a, b) = (at(0.0), at(4.0));
        // The distance is at least 4·0.5/9. Both ends of this distance are rounded by up to half a step in space, and
        // again on the screen.
        let run = 4.0 * v[0] / -p[2];
        let slack = 4.0 * STEP * (1.0 + 4.0) / run;
        close((b[1] - a[1]) / (b[0] - a[0]), v[1] / v[0], slack);
    });
}
