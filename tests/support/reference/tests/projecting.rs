//! Projections compared with their formulas.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_6, PI};

use super::*;
use projection::*;

/// A point of eye space after the division by w.
fn ndc(projection: &Projection, p: Vec3) -> Vec3 {
    let [x, y, z, w] = linear::apply_point(&projection.matrix, p);
    [x / w, y / w, z / w]
}

#[test]
fn perspective_is_a_symmetric_frustum() {
    let [l, r, b, t] = window(PI / 3., 1.5, 2.);
    let expected = [-1.732_050_8, 1.732_050_8, -1.154_700_5, 1.154_700_5];
    for (a, b) in [l, r, b, t].into_iter().zip(expected) {
        assert!((a - b).abs() < 1e-7); // the expected numbers have seven digits
    }
    let projection = perspective(PI / 3., 1.5, 2., 10.);
    close(ndc(&projection, [0., 0., -2.]), [0., 0., -1.]);
    close(ndc(&projection, [0., 0., -10.]), [0., 0., 1.]);
    close(ndc(&projection, [r, t, -2.]), [1., 1., -1.]);
    close(ndc(&projection, [5. * l, 5. * b, -10.]), [-1., -1., 1.]);
}

#[test]
fn a_frustum_may_be_off_center() {
    let projection = frustum(-1., 3., -2., 1., 1., 4.);
    close(ndc(&projection, [-1., -2., -1.]), [-1., -1., -1.]);
    close(ndc(&projection, [12., 4., -4.]), [1., 1., 1.]);
}

#[test]
fn a_frustum_is_a_product() {
    // The perspective transform comes first, then an orthographic projection, which is a translation followed by a
    // scale.
    let (l, r, b, t, n, f) = (-1., 3., -2., 1., 1.5, 4.);
    let straight = orthographic(l, r, b, t, n, f).matrix;
    close_matrix(
        &straight,
        &linear::product(&[
            linear::scale([2. / (r - l), 2. / (t - b), -2. / (f - n)]),
            linear::translate([-(l + r) / 2., -(b + t) / 2., f64::midpoint(n, f)]),
        ]),
    );
    close_matrix(
        &linear::multiply(&straight, &perspective_transform(n, f)),
        &frustum(l, r, b, t, n, f).matrix,
    );
    // The distance z becomes (n + f) − nf/z: n → n, f → f, 2 → 5.5 − 3 = 2.5.
    for (z, expected) in [(1.5, 1.5), (4., 4.), (2., 2.5)] {
        let [_, _, z, w] = linear::apply_point(&perspective_transform(n, f), [0., 0., -z]);
        close([-z / w], [expected]);
    }
}

#[test]
fn images_of_a_cubes_corners() {
    close(
        project_on_plane([1., -1., -3.], 2.).unwrap(),
        [2. / 3., -2. / 3.],
    );
    close(project_on_plane([-1., 1., -5.], 2.).unwrap(), [-0.4, 0.4]);
    assert_eq!(project_on_plane([1., 1., 0.], 2.), None);
}

#[test]
fn vanishing_points_and_speed() {
    close(vanishing_point([1., 2., -4.], 2.).unwrap(), [0.5, 1.]);
    assert_eq!(vanishing_point([1., 2., 0.], 2.), None);
    // With P = (1, 0, −2), v = (0, 0, −1) and n = 1, x' is 1/(2 + t), so at t = 2, ∂x'/∂t is −1/16.
    close([speed([1., 0., -2.], [0., 0., -1.], 2., 1.)], [-1. / 16.]);
}

#[test]
fn orthographic_takes_the_box_to_the_cube() {
    let projection = orthographic(-1., 3., -2., 1., 1., 4.);
    close(ndc(&projection, [-1., -2., -1.]), [-1., -1., -1.]);
    close(ndc(&projection, [3., 1., -4.]), [1., 1., 1.]);
    // The isometric view turns by 45° about y, then down by atan(1/√2). Each axis has a length of √(2/3) in the
    // picture.
    let turn = linear::multiply(
        &linear::rotate_x((0.5_f64).sqrt().atan()),
        &linear::rotate_y(-FRAC_PI_4),
    );
    for axis in [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]] {
        let [x, y, _] = linear::direction(&turn, axis);
        close([x.hypot(y)], [(2_f64 / 3.).sqrt()]);
    }
}

#[test]
fn oblique_projections_show_receding_edges_at_their_length() {
    let window = (-1., 1., -1., 1.);
    for (projection, length) in [
        (cavalier(FRAC_PI_6, window, 1., 4.), 1.),
        (cabinet(FRAC_PI_6, window, 1., 4.), 0.5),
    ] {
        let front = ndc(&projection, [0.2, 0.1, -2.]);
        let back = ndc(&projection, [0.2, 0.1, -3.]);
        let expected = [length * FRAC_PI_6.cos(), length * FRAC_PI_6.sin()];
        close([back[0] - front[0], back[1] - front[1]], expected);
        close(
            [
                ndc(&projection, [0., 0., -1.])[2],
                ndc(&projection, [0., 0., -4.])[2],
            ],
            [-1., 1.],
        );
    }
}

#[test]
fn depth_falls_from_65535() {
    let projection = perspective(1., 1., 0.5, 100.);
    close(
        [projection.depth(0.5), projection.depth(5.)],
        [65535., 6553.5],
    );
    let projection = orthographic(-1., 1., -1., 1., 2., 10.);
    close(
        [
            projection.depth(2.),
            projection.depth(4.),
            projection.depth(10.),
        ],
        [65535., 49151.25, 0.],
    );
    for projection in [projection, frustum(-1., 2., -1., 1., 2., 10.)] {
        let clip = linear::apply_point(&projection.matrix, [0.3, 0.2, -7.]);
        close([projection.distance(clip)], [7.]);
        close([projection.distance_at_depth(projection.depth(7.))], [7.]);
    }
}
