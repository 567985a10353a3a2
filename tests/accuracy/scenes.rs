//! Whole pictures: the measured scenes and a bumpy surface.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_8};

use crate::bumpy::bumpy;
use support::bounds;
use support::comparison::{Comparison, ROUNDING, Scene};
use support::mode::Mode;
use support::moves::{to, x, y};
use support::random::sampled;
use support::reference::scenes::{POSES, cube, floor, sphere};

/// Checks a scene's picture in every mode against the bounds of the formats and the promise of the mode.
fn check(name: &str, scene: &Scene, is_convex: bool) {
    for (mode, picture) in scene.compare(&Mode::PERSPECTIVE) {
        check_mode(&format!("{name}, {mode:?}"), mode, &picture);
        let [_, _, again] = picture.coverage.inside;
        // No part of a convex surface hides another part.
        assert!(
            again == 0 || !is_convex,
            "centers inside the silhouette that were drawn twice"
        );
    }
}

/// Checks a picture against the bounds of the formats and the promise of its mode.
fn check_mode(name: &str, mode: Mode, picture: &Comparison) {
    picture.print(name);
    assert!(picture.allowed.max() <= 1., "{name}: attributes");
    let promised = mode.promised();
    assert!(
        picture.snapped.max() <= promised,
        "{name}: texels, given snapped vertices"
    );
    // Unrounded u and v differ from rounded u and v at the corners. This difference is also added between the corners.
    assert!(
        picture.unrounded.max() <= promised + ROUNDING,
        "{name}: texels, given snapped vertices and unrounded u and v"
    );
    assert!(
        picture.unrounded.within(promised) >= 0.999,
        "{name}: pixels within the promise of unrounded u and v"
    );
    // Rounding moves vertices by up to 1/512 pixel along each axis, which is less than 1/256 pixel in any direction.
    assert!(
        picture.excess.max() <= 0.001 + promised,
        "{name}: texels, given unsnapped vertices"
    );
    assert!(picture.depth.max() <= bounds::DEPTH, "depth");
    // Two depths can be in the same step, and each has its own error.
    assert!(
        picture.order.max() <= 1. + 2. * bounds::DEPTH,
        "depth order"
    );
    assert_eq!(
        picture.coverage.not_alike, 0,
        "coverage, given snapped vertices"
    );
    let [missed, ..] = picture.coverage.inside;
    assert_eq!(
        missed, 0,
        "centers inside the silhouette that were not drawn"
    );
    assert_eq!(
        picture.coverage.outside, 0,
        "centers outside the silhouette that were drawn"
    );
}

/// The poses of a turning model.
fn poses() -> impl Iterator<Item = u32> {
    (0..POSES).step_by((POSES / sampled(POSES)) as usize)
}

#[test]
fn the_floor_keeps_the_promises() {
    let (shape, _) = floor();
    let scene = Scene::new(&shape, &[x(0.2_f64.atan()), to([0., -1., 0.])]);
    check("floor", &scene, true);
}

#[test]
fn the_cube_keeps_the_promises() {
    for pose in poses() {
        let k = f64::from(pose);
        let moves = [
            to([0., 0., -3.133_832_458]),
            x(0.3 + k * FRAC_PI_8),
            y(0.4 + k * FRAC_PI_4),
        ];
        let scene = Scene::new(&cube(pose).0, &moves);
        check(&format!("cube {pose}"), &scene, true);
    }
}

#[test]
fn the_sphere_keeps_the_promises() {
    for pose in poses() {
        let k = f64::from(pose);
        let moves = [
            to([0., 0., -2.256_239_223_7]),
            x(0.35 + 0.3 * k),
            y(0.2 + k * FRAC_PI_4),
        ];
        let scene = Scene::new(&sphere(pose).0, &moves);
        check(&format!("sphere {pose}"), &scene, true);
    }
}

#[test]
fn a_bumpy_surface_keeps_the_promises() {
    let scene = Scene::new(&bumpy(), &[to([0., 0., -2.5]), x(0.4), y(0.7)]);
    check("bumpy", &scene, false);
}
