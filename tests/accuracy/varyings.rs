//! Interpolated values of random triangles. The crate and the model use the same snapped corners, so only interpolation
//! is tested.

use std::array::{self, from_fn};

use embedded_graphics::pixelcolor::Gray8;
use fixel::Window;
use fixel::prelude::*;
use fixel::view::{Perspective, ProjectionKind};
use rand::Rng;
use rand::seq::IndexedRandom;

use crate::triangle::Triangle;
use support::bounds::{self, Bound};
use support::counter::{BOTH_SIDES, at_subpixel, pixel_projection};
use support::drawing::Seen;
use support::mode::Mode;
use support::random::{Random, cases, sampled, within};
use support::recorder::{Probe, record};
use support::reference::coverage::Snapped;

/// The width is more than two spans of 64 pixels.
const SIZE: (u32, u32) = (160, 48);
const FOCAL: i16 = 200;
/// The near plane's distance. Distances are from 2^-13 to 2^11.
const NEAR: Scalar = fx!(0.000_061_035_156_25);
/// The number of values at a corner.
const VALUES: usize = 3;

/// A triangle on the screen, in pixels.
type Shape = [[f64; 2]; 3];

/// A position in or near the picture.
fn about(random: &mut Random) -> [f64; 2] {
    within(random, [-40.0..200., -20.0..68.])
}

/// A triangle with corners in and around the picture, far outside it, all within a pixel or two, or nearly on a line.
fn shape(random: &mut Random) -> Shape {
    match random.random_range(0..4) {
        0 => [about(random), about(random), about(random)],
        1 => [[(); 2]; 3].map(|corner| corner.map(|()| random.random_range(-1900.0..1900.))),
        2 => {
            let at = within(random, [0.0..160., 0.0..48.]);
            [at; 3].map(|corner| corner.map(|x| x + random.random_range(-1.5..1.5)))
        }
        _ => {
            let (a, b, way) = (about(random), about(random), random.random_range(-0.5..1.5));
            let beside = |i: usize| a[i] + way * (b[i] - a[i]) + random.random_range(-0.05..0.05);
            [a, b, array::from_fn(beside)]
        }
    }
}

/// Three random distances: equal, nearly equal, as in a picture, or as different as possible.
fn distances(random: &mut Random) -> [f64; 3] {
    let (base, spread) = match random.random_range(0..5) {
        0 => (-4.0..10., 0.),
        1 => (-4.0..10., 0.01),
        2 => (-4.0..8., 3.),
        3 => (-13.0..-12., 12.),
        _ => (-13.0..-12.9, 23.5),
    };
    let base: f64 = random.random_range(base);
    [(); 3].map(|()| (base + spread * random.random::<f64>()).exp2())
}

/// A value at three corners: like a color, like a texture coordinate, any value, the ends of the format, the same value
/// at all corners, or just below powers of two, where scaling leaves the least room.
fn corners(random: &mut Random) -> [i32; 3] {
    match random.random_range(0..6) {
        0 => [(); 3].map(|()| random.random_range(0..256)),
        1 => [(); 3].map(|()| random.random_range(-(4 << 24)..4 << 24)),
        2 => random.random(),
        3 => [(); 3].map(|()| *[i32::MIN, -1, 0, 1, i32::MAX].choose(random).unwrap()),
        4 => [random.random(); 3],
        _ => {
            let value = i32::MAX >> random.random_range(0..32);
            [(); 3].map(|()| if random.random() { value } else { -value })
        }
    }
}

/// Attributes that are independent, or that are all in the same range, like u and v.
fn values(random: &mut Random) -> [[i32; 3]; VALUES] {
    if random.random() {
        return [corners(random), corners(random), corners(random)];
    }
    let end = 1 << random.random_range(8..31);
    [[(); 3]; VALUES].map(|corners| corners.map(|()| random.random_range(-end..end)))
}

/// Draws a triangle in some modes, and compares every pixel with the model. `bound` returns the bound of a value's
/// error, given the value at the corners. `depth_error` is the bound of a depth's error, before the depth is rounded
/// down.
fn compare<K: ProjectionKind>(
    triangle: &Triangle<K, VALUES>,
    screen: Snapped,
    modes: &[Mode],
    depth_error: f64,
    bound: impl Fn(Mode, [i32; 3]) -> Bound,
) {
    let model = triangle.model(screen);
    let depths =
        |seen: &[Seen<VALUES>]| -> Vec<u16> { seen.iter().map(|seen| seen.depth).collect() };
    let exact = depths(&triangle.draw(Mode::Exact));
    for &mode in modes {
        let seen = triangle.draw(mode);
        // Depths must not depend on the mode, except in `Compact`, so that meshes in different modes meet where they
        // should.
        assert!(
            mode == Mode::Compact || depths(&seen) == exact,
            "{mode:?}: depths differ"
        );
        let pixels = seen.iter().map(|seen| seen.pixel);
        assert!(
            pixels.eq(model.iter().map(|model| model.pixel)),
            "{mode:?}: pixels of {screen:?}"
        );
        let bounds = triangle.values.map(|value| bound(mode, value));
        for (seen, model) in seen.iter().zip(&model) {
            for (k, &value) in triangle.values.iter().enumerate() {
                let error = (f64::from(seen.values[k]) - model.values[k]).abs();
                let bound = bounds[k].at(model.w, model.farthest);
                assert!(
                    error <= bound,
                    "{mode:?}: {value:?} at {:?} on {screen:?} gives {} at {:?}, not {}: an error of {error}, over {bound}",
                    triangle.w,
                    seen.values[k],
                    seen.pixel,
                    model.values[k],
                );
            }
            let (stored, depth) = (f64::from(seen.depth), model.depth);
            assert!(
                stored <= depth + depth_error && depth < stored + 1. + depth_error,
                "{mode:?}: depth {stored} at {:?} is not {depth}",
                seen.pixel,
            );
        }
    }
}

fn point([x, y, z]: [f64; 3]) -> Option<Vec3> {
    Some(Vec3::new(
        Scalar::try_from(x).ok()?,
        Scalar::try_from(y).ok()?,
        Scalar::try_from(z).ok()?,
    ))
}

#[test]
fn values_in_perspective_are_within_the_bounds() {
    cases(sampled(4000), |random| {
        loop {
            let (shape, w, values) = (shape(random), distances(random), values(random));
            let corner = |i: usize| {
                let [x, y] = shape[i];
                let scale = w[i] / f64::from(FOCAL);
                point([(x - 80.) * scale, (24. - y) * scale, -w[i]])
            };
            let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) else {
                continue;
            };
            let positions = [a, b, c];
            let w = positions.map(|p| -f64::from(p.z));
            let projection = Projection::<Perspective>::from_focal_length(
                Scalar::from(FOCAL),
                SIZE,
                NEAR,
                fx!(32767),
            )
            .unwrap();
            let near = f64::from(NEAR);
            let depth = w.map(|w| 65535. * near / w);
            let mvp = projection.into();
            let triangle = Triangle {
                size: SIZE,
                mvp,
                positions,
                values,
                w,
                depth,
            };
            // Rounding can move a corner out of the guard band or onto another corner.
            let Some(screen) = triangle.screen() else {
                continue;
            };
            compare(
                &triangle,
                screen,
                &Mode::PERSPECTIVE,
                bounds::depth(w),
                |mode, corners| Bound::perspective(mode, corners, w),
            );
            // A value that is not divided by w is linear on the screen, under any projection.
            let triangle = Triangle {
                w: [1.; 3],
                ..triangle
            };
            compare(
                &triangle,
                screen,
                &[Mode::Affine],
                bounds::depth(w),
                Bound::parallel,
            );
            break;
        }
    });
}

#[test]
fn values_in_parallel_are_within_the_bounds() {
    // The page of modes states these bounds.
    let stated = |mode, most| Bound::parallel(mode, [0, most, 0]).at(1., 1.);
    assert!(stated(Mode::Exact, 256 << 16) <= 3.3);
    assert!(stated(Mode::Affine, 1 << 28) <= 36.5);
    for mode in Mode::PARALLEL {
        assert!(stated(mode, i32::MAX) <= 659.);
    }
    cases(sampled(4000), |random| {
        loop {
            let (shape, values) = (shape(random), values(random));
            let positions =
                shape.map(|[x, y]| point([x, 48. - y, -random.random_range(0.0..100.)]).unwrap());
            let projection = Projection::orthographic(
                Window {
                    left: fx!(0),
                    right: fx!(160),
                    bottom: fx!(0),
                    top: fx!(48),
                },
                fx!(0),
                fx!(100),
            )
            .unwrap();
            let depth = positions.map(|p| 65535. * (1. + f64::from(p.z) / 100.));
            let triangle = Triangle {
                size: SIZE,
                mvp: projection.into(),
                positions,
                values,
                w: [1.; 3],
                depth,
            };
            let Some(screen) = triangle.screen() else {
                continue;
            };
            compare(
                &triangle,
                screen,
                &Mode::PARALLEL,
                bounds::DEPTH,
                Bound::parallel,
            );
            break;
        }
    });
}

/// An attribute that is drawn affinely has an error of up to 37 units. The error is larger if the attribute needs more
/// than 30 bits.
#[test]
fn large_affine_attributes_are_less_exact() {
    let size = (320, 240);
    let options = BOTH_SIDES.with_mode(fixel::mode::Affine);
    let errors = [28, 31].map(|bits| {
        let mut worst = 0_f64;
        cases(40, |random| {
            let (width, height) = (
                random.random_range(25_000..80_000),
                random.random_range(25_000..60_000),
            );
            let positions = [[0, 0], [width, 0], [0, height]].map(at_subpixel);
            let values: [i32; 3] = from_fn(|_| random.random::<i32>() >> (31 - bits));
            let at = |corner: &Corner<'_>| {
                let index = positions.iter().position(|&at| at == corner.position());
                [values[index.unwrap()]]
            };
            let probe = Probe {
                values: &at,
                color: Some(Gray8::new(1)),
            };
            let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
            let mut pixels = vec![Gray8::new(0); 320 * 240];
            let mut canvas = Canvas::new(&mut pixels, size.0, size.1).unwrap();
            let record = record::<_, 1>(probe, |pen| {
                canvas.draw_with(&options, &mesh, &pixel_projection(size), pen);
            });
            let [a, b, c] = values.map(f64::from);
            for seen in &record.seen {
                let [x, y] = seen.pixel.map(|at| f64::from(at) * 256. + 128.);
                let exact = a + (b - a) * x / f64::from(width) + (c - a) * y / f64::from(height);
                worst = worst.max((f64::from(seen.values[0]) - exact).abs());
            }
        });
        worst
    });
    assert!(
        errors[0] <= 37. && errors[1] > 37. && errors[1] <= 4. * 37.,
        "{errors:?}"
    );
}
