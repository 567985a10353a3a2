//! Projections: matrices, fields of view, and vanishing points.

use core::f64::consts::TAU;

use fixel::prelude::*;
use fixel::textbook::perspective_transform;
use fixel::view::{Parallel, Perspective};
use fixel::{Matrix4, Window};
use rand::Rng;

use support::moves::{exact, number, rounded};
use support::random::{cases, within};

use super::helpers::{STEP, all_close, close, float, same_matrix, vec};

fn degrees(angle: Angle) -> f64 {
    f64::from(angle.to_bits()) / 4_294_967_296.0 * 360.0
}

/// A projection with a vertical field of view of 60°, an aspect ratio of 3 : 2, and planes at 2 and 10.
fn projection() -> Projection<Perspective> {
    Projection::perspective(Angle::from_degrees(60), fx!(1.5), fx!(2), fx!(10)).unwrap()
}

#[test]
fn points_beside_and_behind_the_eye_have_no_image() {
    let projection = projection();
    let screen = Viewport::new(0, 0, 8, 8).unwrap();
    for z in [0.0, 1.0 / 65_536.0, 5.0] {
        let point = vec(0.1, 0.1, z);
        assert_eq!(projection.image(point), None);
        assert_eq!(projection.to_matrix().project(point), None);
        let place = screen.project(point, &(projection * Transform::IDENTITY));
        assert_eq!(place, None);
    }
    let image = projection.image(vec(1.0, -0.5, -4.0)).unwrap();
    assert_eq!(image, [fx!(0.5), fx!(-0.25)]);
}

#[test]
fn images_of_a_cubes_corners() {
    let projection =
        Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10)).unwrap();
    for (z, size) in [(-3.0, 2.0 / 3.0), (-5.0, 2.0 / 5.0)] {
        for (x, y) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let image = projection.image(vec(x, y, z)).unwrap().map(float);
            all_close(image, [x * size, y * size], STEP / 2.0);
            // The window is ±1, like normalized device coordinates.
            let ndc = projection.to_matrix().project(vec(x, y, z)).unwrap();
            all_close([ndc.x, ndc.y].map(float), [x * size, y * size], STEP / 2.0);
        }
    }
}

#[test]
fn perspective_by_field_of_view() {
    let projection = projection();
    let Window {
        left,
        right,
        bottom,
        top,
    } = projection.window();
    let edges = [top, right, bottom, left].map(float);
    let top = 2.0 * (TAU / 12.0).tan();
    // The edges are values of 30 bits that are rounded once.
    let expected = [top, top * 1.5, -top, -top * 1.5];
    all_close(edges, expected, 0.51 * STEP);
    // Printed tables have these values with four decimals.
    all_close(edges, [1.1547, 1.7321, -1.1547, -1.7321], 0.5e-4);
    assert_eq!((projection.near(), projection.far()), (fx!(2), fx!(10)));
}

#[test]
fn a_frustum_gives_back_its_field_of_view_and_edges() {
    let seven = projection();
    let eight = Projection::frustum(seven.window(), seven.near(), seven.far()).unwrap();
    // Edges of about 1.15 are rounded by up to half a step.
    let relative = STEP / 2.0 / 1.15;
    close(
        float(eight.aspect()),
        1.5,
        1.5 * 2.0 * relative + STEP / 2.0,
    );
    // d(2·atan(h))/dh = 2/(1 + h²), with h = 0.577.
    let slack = (2.0 / (1.0 + 1.0 / 3.0) * 0.577 * relative).to_degrees();
    close(degrees(eight.fov()), 60.0, slack + 1e-6);
    let again = Projection::perspective(eight.fov(), eight.aspect(), fx!(2), fx!(10)).unwrap();
    let expected = seven.to_matrix().rows().map(|row| row.map(float));
    same_matrix(&again.to_matrix(), expected, 2.0 * 4.0 * relative + STEP);

    // An off-center frustum gives back its edges.
    let window = Window {
        left: fx!(-1),
        right: fx!(3),
        bottom: fx!(0.5),
        top: fx!(2.5),
    };
    let off = Projection::frustum(window, fx!(2), fx!(10)).unwrap();
    assert_eq!(off.window(), window);
    assert_eq!(off.aspect(), fx!(2));
    close(
        degrees(off.fov()),
        (2.0 * 0.5_f64.atan()).to_degrees(),
        1e-6,
    );
}

/// The matrix of a frustum.
fn frustum([l, r, b, t, n, f]: [f64; 6]) -> [[f64; 4]; 4] {
    [
        [2.0 * n / (r - l), 0.0, (r + l) / (r - l), 0.0],
        [0.0, 2.0 * n / (t - b), (t + b) / (t - b), 0.0],
        [0.0, 0.0, -(f + n) / (f - n), -2.0 * f * n / (f - n)],
        [0.0, 0.0, -1.0, 0.0],
    ]
}

#[test]
fn a_frustums_matrix_is_a_product() {
    cases(256, |random| {
        let [l, b] = within(random, [-4.0..0.0, -4.0..0.0]);
        let [w, h, n] = within(random, [0.5..4.0, 0.5..4.0, 0.5..4.0]);
        let d = random.random_range(1.0..50.0);
        let edges = [l, l + w, b, b + h, n, n + d].map(|v| float(number(v)));
        let [left, right, bottom, top, near, far] = edges.map(number);
        let window = Window {
            left,
            right,
            bottom,
            top,
        };
        let projection = Projection::frustum(window, near, far).unwrap();
        let expected = frustum(edges);
        // Entries are numbers up to 64 with 28 bits, and are rounded once.
        same_matrix(&projection.to_matrix(), expected, 0.52 * STEP);

        // z = −n becomes −1, and z = −f becomes +1. Two entries are rounded by up to half a step. One of these entries
        // is multiplied by z, and the sum is divided by w = −z.
        let depth = |z: f64| float(projection.to_matrix().project(vec(0.0, 0.0, z)).unwrap().z);
        let [.., n, f] = edges;
        close(depth(-n), -1.0, STEP * (2.0 / n + 1.0));
        close(depth(-f), 1.0, STEP * (2.0 / f + 1.0));

        // The box behind the window, with z from −n to −f, is scaled and then moved to ±1.
        let [l, r, b, t, n, f] = edges;
        let perspective = perspective_transform(near, far);
        let scale = Matrix4::scale(vec(2.0 / (r - l), 2.0 / (t - b), -2.0 / (f - n)));
        let middle = vec(-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n));
        let middle = Matrix4::translate(middle);
        // Factors are rounded by up to half a step, and multiplied by up to n·f, which is below 217.
        let slack = 0.51 * STEP * (2.0 + (n + f).max(n * f));
        same_matrix(&(middle * scale * perspective), expected, slack);
    });
}

#[test]
fn depths_of_the_perspective_transform_follow_their_formula() {
    let (n, f) = (2.0, 10.0);
    // In the formula, z is positive ahead of the eye. In the transform, z and the depth are negative there.
    let depth = |z: f64| {
        let matrix = perspective_transform(number(n), number(f));
        -float(matrix.project(vec(0.0, 0.0, -z)).unwrap().z)
    };
    close(depth(n), n, 0.0);
    close(depth(f), f, 0.0);
    let mut last = f64::NEG_INFINITY;
    for i in 0..=1_000 {
        let z = float(number(n + (f - n) * f64::from(i) / 1_000.0));
        close(depth(z), (n + f) - n * f / z, STEP / 2.0);
        assert!(depth(z) > last);
        last = depth(z);
    }
}

#[test]
fn orthographic_projections_map_a_box_to_the_cube() {
    let edges = [-3.0, 5.0, -1.0, 1.0, 2.0, 10.0];
    let [l, r, b, t, n, f] = edges.map(number);
    let window = Window {
        left: l,
        right: r,
        bottom: b,
        top: t,
    };
    let projection = Projection::orthographic(window, n, f).unwrap();
    assert_eq!(projection.window(), window);
    let [l, r, b, t, n, f] = edges;
    let corner = |i: usize, low: f64, high: f64| if i == 0 { (low, -1.0) } else { (high, 1.0) };
    for i in 0..8 {
        let (x, nx) = corner(i & 1, l, r);
        let (y, ny) = corner(i & 2, b, t);
        let (z, nz) = corner(i & 4, -n, -f);
        let ndc = projection.to_matrix().project(vec(x, y, z)).unwrap();
        assert_eq!(ndc, vec(nx, ny, nz));
    }
    // Parallel lines stay parallel: the image of a direction is the same from every point.
    let at = |x, y, z| projection.to_matrix().project(vec(x, y, z)).unwrap();
    let first = at(1.0, 0.5, -7.0) - at(0.0, 0.25, -3.0);
    let second = at(-1.0, 0.0, -9.0) - at(-2.0, -0.25, -5.0);
    assert_eq!(first, second);
}

/// The image of an edge of length one along the line of sight: its length, and its direction in degrees.
fn receding(projection: &Projection<Parallel>) -> (f64, f64) {
    let at = |z| projection.to_matrix().project(vec(0.25, 0.25, z)).unwrap();
    // The window is ±1, like normalized device coordinates.
    let [x, y] = [at(-3.0) - at(-2.0)].map(|d| [float(d.x), float(d.y)])[0];
    (x.hypot(y), y.atan2(x).to_degrees())
}

#[test]
fn oblique_projections_show_receding_edges_at_their_length_and_angle() {
    let (window, near, far) = (Window::centered(fx!(2), fx!(2)), fx!(1), fx!(10));
    for angle in [0, 30, 45, 63, 120, 225] {
        let turn = Angle::from_degrees(angle);
        for (ratio, length) in [(fx!(1), 1.0), (fx!(0.5), 0.5), (fx!(0.75), 0.75)] {
            let projection = Projection::oblique(turn, ratio, near, window, near, far).unwrap();
            let (found, direction) = receding(&projection);
            // Entries of the matrix are rounded by up to half a step, and multiplied by z = 3 and 2. The images are
            // rounded, too.
            let slack = STEP * 3.5;
            close(found, length, slack);
            let off = (direction - f64::from(angle)).rem_euclid(360.0);
            close(off.min(360.0 - off), 0.0, (slack / length).to_degrees());
            // The shear leaves points in the near plane in place.
            let ndc = projection
                .to_matrix()
                .project(vec(0.5, -0.25, -1.0))
                .unwrap();
            all_close([ndc.x, ndc.y].map(float), [0.5, -0.25], 2.0 * STEP);
            let Window { left, top, .. } = projection.window();
            all_close([left, top].map(float), [-1.0, 1.0], STEP);
        }
    }
}

#[test]
fn vanishing_points_follow_their_formula() {
    cases(256, |random| {
        let z = if random.random() {
            -100.0..-0.1
        } else {
            0.1..100.0
        };
        let v = within(random, [-100.0..100.0, -100.0..100.0, z]);
        let direction = vec(v[0], v[1], v[2]);
        let found = projection().vanishing_point(direction).unwrap().map(float);
        let [x, y, z] = exact(rounded(v));
        all_close(found, [-2.0 * x / z, -2.0 * y / z], 0.501 * STEP);
    });
}

#[test]
fn lines_approach_their_vanishing_points() {
    cases(256, |random| {
        let p = within(random, [-10.0..10.0, -10.0..10.0]);
        let v = within(random, [-1.0..1.0, -1.0..1.0]);
        let projection = projection();
        let end = projection
            .vanishing_point(vec(v[0], v[1], -1.0))
            .unwrap()
            .map(float);
        // Go from (p, −1) along v until p is only 1/20000 of the distance.
        let t = 20_000.0;
        let far = projection
            .image(vec(p[0] + t * v[0], p[1] + t * v[1], -1.0 - t))
            .unwrap()
            .map(float);
        // The image is at most n·(|p| + |v|)/t from the vanishing point, plus two roundings, plus the rounding of v
        // times n.
        all_close(far, end, 2.0 * 11.0 / t + 3.0 * STEP);
    });
}

#[test]
fn directions_across_the_view_have_no_vanishing_point() {
    for direction in [vec3!(1, 0, 0), vec3!(0, 1, 0), vec3!(3, -2, 0)] {
        assert_eq!(projection().vanishing_point(direction), None);
    }
}
