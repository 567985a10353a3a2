//! Vectors and matrices.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::*;
use linear::*;

#[test]
fn quarter_turns_take_axis_to_axis() {
    let [x, y, z] = [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    close(point(&rotate_x(FRAC_PI_2), y), z);
    close(point(&rotate_y(FRAC_PI_2), z), x);
    close(point(&rotate_z(FRAC_PI_2), x), y);
}

#[test]
fn rotations_about_any_axis_agree_with_those_about_x_y_and_z() {
    for (axis, matrix) in [
        ([2., 0., 0.], rotate_x(0.7)),
        ([0., 3., 0.], rotate_y(0.7)),
        ([0., 0., 0.5], rotate_z(0.7)),
    ] {
        close_matrix(&rotate(axis, 0.7), &matrix);
    }
    // A third of a turn about the diagonal turns the x axis to y, and y to z.
    let third = rotate([1., 1., 1.], TAU / 3.);
    close(point(&third, [1., 2., 3.]), [3., 1., 2.]);
}

#[test]
fn the_last_factor_acts_first() {
    let moved = translate([1., 0., 0.]);
    let scaled = scale([2., 3., 4.]);
    close(
        point(&multiply(&scaled, &moved), [1., 1., 1.]),
        [4., 3., 4.],
    );
    close(
        point(&multiply(&moved, &scaled), [1., 1., 1.]),
        [3., 3., 4.],
    );
    close(direction(&moved, [1., 1., 1.]), [1., 1., 1.]);
    close_matrix(&product(&[]), &IDENTITY);
    close_matrix(
        &product(&[scaled, moved, scaled]),
        &multiply(&scaled, &multiply(&moved, &scaled)),
    );
}

#[test]
fn look_at_faces_the_target() {
    // The eye is at (3, 0, 0) and looks toward the origin: right is −z, ahead is −x.
    let m = look_at([3., 0., 0.], [0.; 3], [0., 1., 0.]).unwrap();
    close_matrix(
        &m,
        &[
            [0., 0., -1., 0.],
            [0., 1., 0., 0.],
            [1., 0., 0., -3.],
            [0., 0., 0., 1.],
        ],
    );
    let (eye, target, up) = ([1., 2., 3.], [-4., 0.5, 2.], [0.1, 1., 0.3]);
    let m = look_at(eye, target, up).unwrap();
    close(point(&m, eye), [0.; 3]);
    close(point(&m, target), [0., 0., -length(subtract(eye, target))]);
    // `up` need not be at right angles to the line of sight. In the picture, `up` points straight up.
    let up = direction(&m, up);
    assert!(up[0].abs() < EPSILON && up[1] > 0.);
    assert_eq!(look_at(eye, eye, [0., 1., 0.]), None);
    assert_eq!(look_at([0., 5., 0.], [0.; 3], [0., 1., 0.]), None);
}

#[test]
fn the_inverse_undoes_a_matrix() {
    let m = product(&[
        translate([1., -2., 3.]),
        rotate([1., 2., -1.], 1.1),
        scale([2., 0.5, -3.]),
    ]);
    close_matrix(&multiply(&m, &inverse(&m).unwrap()), &IDENTITY);
    // A projective matrix with a zero on its diagonal, which needs pivoting.
    let m = projection::frustum(-1., 2., -1., 1., 1., 5.).matrix;
    close_matrix(&multiply(&inverse(&m).unwrap(), &m), &IDENTITY);
    assert_eq!(inverse(&scale([1., 0., 1.])), None);
    // The inverse of a rigid matrix is the transposed rotation times the opposite translation.
    let turn = rotate([1., 1., 0.], 0.4);
    close_matrix(
        &inverse(&multiply(&translate([1., 2., 3.]), &turn)).unwrap(),
        &multiply(&transpose(&turn), &translate([-1., -2., -3.])),
    );
}

#[test]
fn a_normal_stays_normal() {
    // The scale turns the plane x + y = 0 into x + 2y = 0.
    let squeeze = scale([1., 0.5, 1.]);
    let n = normal(&squeeze, [1., 1., 0.]).unwrap();
    close(n, normalized([1., 2., 0.]));
    close([dot(n, direction(&squeeze, [1., -1., 0.]))], [0.]);
}
