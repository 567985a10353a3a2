//! Mirror images and shadows: p′ = p − k (n · (p − q)) / (n · d) d, for a plane through q with the normal n.

use std::array::from_fn;

use fixel::prelude::*;

use support::moves::exact;
use support::random::{Random, cases, within};
use support::reference::linear::{dot, length, subtract};

use super::helpers::{STEP, all_close, vec};

/// A point at most 20 units from the origin along each axis.
fn point(random: &mut Random) -> Vec3 {
    let [x, y, z] = within(random, [-20.0..20.0, -20.0..20.0, -20.0..20.0]);
    vec(x, y, z)
}

/// The formula, with k = `times`.
fn along(p: Vec3, (q, n): (Vec3, Vec3), d: Vec3, times: f64) -> [f64; 3] {
    let (p, q, n, d) = (exact(p), exact(q), exact(n), exact(d));
    let steps = times * dot(n, subtract(p, q)) / dot(n, d);
    from_fn(|i| p[i] - steps * d[i])
}

/// The bound of the error of a coordinate. The entries of the matrix have errors of up to 3.3 · 2^-30 of the largest entry,
/// which is at least 1: a quotient's 1.3, its rounding, and the rounding to a mantissa. They multiply the three coordinates
/// of p − q, each up to 40. The translation is a product of q with these entries, and is rounded with each of two products:
/// by 2^-30 of at most 60 times the largest entry. The result is rounded once.
fn slack(largest: f64) -> f64 {
    (3. * 40. * 3.3 + 2. * 60.) * 2_f64.powi(-30) * largest + STEP / 2.
}

#[test]
fn a_mirror_image_is_as_far_behind_the_plane() {
    cases(256, |random| {
        let (q, n, p) = (point(random), point(random), point(random));
        let camera = Camera::default().mirrored(q, n).unwrap();
        let image = camera.view().point(p);
        // No entry of a reflection is above 1.
        all_close(exact(image), along(p, (q, n), n, 2.), slack(1.));
        // The pose of a mirrored camera undoes its view. Its matrix is a transpose, which differs from the inverse by the
        // errors of two matrices.
        all_close(exact(camera.pose().point(image)), exact(p), 3. * slack(1.));
        let twice = camera.mirrored(q, n).unwrap();
        all_close(exact(twice.view().point(p)), exact(p), 3. * slack(1.));
    });
}

#[test]
fn a_shadow_falls_along_the_light() {
    cases(256, |random| {
        let (q, p) = (point(random), point(random));
        let (n, light) = loop {
            let [n, light] = from_fn(|_| point(random));
            let sine = dot(exact(n), exact(light)) / length(exact(n)) / length(exact(light));
            if sine.abs() > 0.05 {
                break (n, light);
            }
        };
        let shadow = Transform::shadow(q, n, light).unwrap();
        let fallen = exact(shadow.point(p));
        let sine = dot(exact(n), exact(light)) / length(exact(n)) / length(exact(light));
        // An entry of the matrix is at most 1, plus the product of two components of unit vectors divided by the sine.
        let slack = slack(1. + 1. / sine.abs());
        all_close(fallen, along(p, (q, n), light, 1.), slack);
        // The shadow is on the plane. The distance is at most √3 times the error of a coordinate.
        let distance = dot(exact(n), subtract(fallen, exact(q))) / length(exact(n));
        assert!(distance.abs() <= 3_f64.sqrt() * slack, "{distance:e}");
        assert_eq!(shadow, Transform::shadow(q, -n, light).unwrap());
        assert_eq!(shadow, Transform::shadow(q, n, -light).unwrap());
    });
}

/// Planes along the axes are exact, however the vectors are scaled.
#[test]
fn planes_along_the_axes_are_exact() {
    for size in [fx!(0.001), fx!(1), fx!(3), fx!(30_000)] {
        let mirror = |axis: Vec3| Camera::default().mirrored(Vec3::ZERO, axis * size).unwrap();
        let scale = |factors| Camera::from_view(Transform::scale_axes(factors));
        assert_eq!(mirror(Vec3::X), scale(vec3!(-1, 1, 1)));
        assert_eq!(mirror(Vec3::Y), scale(vec3!(1, -1, 1)));
        assert_eq!(mirror(Vec3::Z), scale(vec3!(1, 1, -1)));
        let below = Transform::shadow(Vec3::ZERO, Vec3::Y * size, Vec3::Y * size).unwrap();
        assert_eq!(below, Transform::scale_axes(vec3!(1, 0, 1)));
    }
}

#[test]
fn planes_without_a_normal_and_grazing_lights_are_refused() {
    let refused = |result: Result<Transform, Error>| match result {
        Err(Error::NoDirection { of, given, .. }) => (of, given),
        other => panic!("{other:?}"),
    };
    let mirror = Camera::default().mirrored(Vec3::X, Vec3::ZERO);
    assert_eq!(
        refused(mirror.map(|camera| camera.view())),
        ("direction", Vec3::ZERO)
    );
    let shadow = |normal, light| refused(Transform::shadow(Vec3::X, normal, light));
    assert_eq!(shadow(Vec3::ZERO, Vec3::Y), ("direction", Vec3::ZERO));
    for light in [Vec3::ZERO, vec3!(3, 0, -2)] {
        assert_eq!(shadow(Vec3::Y, light), ("light", light));
    }
}
