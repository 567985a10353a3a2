//! Whole pictures: the measured scenes, and a surface with bumps.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_8};

use crate::bounds;
use crate::bumpy::bumpy;
use crate::comparison::{Comparison, ROUNDING, Scene};
use crate::moves::{to, x, y};
use crate::reference::scenes::{POSES, cube, floor, sphere};

/// Holds a picture to what the formats allow, and to what the crate promises.
fn check(name: &str, picture: &Comparison) {
    picture.print(name);
    assert!(picture.allowed.max() <= 1., "attributes");
    // The promise is 0.03 texel of 256 at most, and 0.001 for 999 pixels of 1,000.
    assert!(
        picture.snapped.max() <= 0.001,
        "texels, given snapped vertices"
    );
    // What a picture shows is what its u and v were meant to be: a corner's is off by its rounding,
    // and so is what lies between corners. The rest is as above.
    assert!(
        picture.unrounded.max() <= 0.001 + ROUNDING,
        "texels, given snapped vertices and unrounded u and v"
    );
    assert!(
        picture.unrounded.within(0.001) >= 0.999,
        "pixels within 0.001 texel of unrounded u and v"
    );
    // Vertices move by up to 1/512 pixel along each axis, less than 1/256 altogether; the rest is as above.
    assert!(
        picture.excess.max() <= 0.002,
        "texels, given unsnapped vertices"
    );
    assert!(picture.depth.max() <= bounds::DEPTH, "depth");
    // Two depths that are the same step, each with its error.
    assert!(
        picture.order.max() <= 1. + 2. * bounds::DEPTH,
        "depth order"
    );
    assert_eq!(picture.not_alike, 0, "coverage, given snapped vertices");
    let [missed, ..] = picture.inside;
    assert_eq!(
        missed, 0,
        "centres inside the silhouette that were not drawn"
    );
    assert_eq!(
        picture.outside, 0,
        "centres outside the silhouette that were drawn"
    );
}

/// The same for a surface of which no part hides another.
fn check_convex(name: &str, picture: &Comparison) {
    check(name, picture);
    let [_, _, again] = picture.inside;
    assert_eq!(
        again, 0,
        "centres inside the silhouette that were drawn twice"
    );
}

#[test]
fn the_floor() {
    let (shape, _) = floor();
    let scene = Scene::new(&shape, &[x(0.2_f64.atan()), to([0., -1., 0.])]);
    check_convex("floor", &scene.compare());
}

#[test]
fn the_cube() {
    for pose in 0..POSES {
        let k = f64::from(pose);
        let moves = [
            to([0., 0., -3.133_832_458]),
            x(0.3 + k * FRAC_PI_8),
            y(0.4 + k * FRAC_PI_4),
        ];
        let scene = Scene::new(&cube(pose).0, &moves);
        check_convex(&format!("cube {pose}"), &scene.compare());
    }
}

#[test]
fn the_sphere() {
    for pose in 0..POSES {
        let k = f64::from(pose);
        let moves = [
            to([0., 0., -2.256_239_223_7]),
            x(0.35 + 0.3 * k),
            y(0.2 + k * FRAC_PI_4),
        ];
        let scene = Scene::new(&sphere(pose).0, &moves);
        check_convex(&format!("sphere {pose}"), &scene.compare());
    }
}

#[test]
fn a_bumpy_surface() {
    let scene = Scene::new(&bumpy(), &[to([0., 0., -2.5]), x(0.4), y(0.7)]);
    check("bumpy", &scene.compare());
}
