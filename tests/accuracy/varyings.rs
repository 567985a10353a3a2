//! Values over random triangles: interpolation alone, given the snapped corners.

use fixel::num::scalar;
use fixel::prelude::*;
use fixel::view::{Perspective, ProjectionKind};
use proptest::prelude::*;

use crate::bounds::{self, Bound};
use crate::drawing::Seen;
use crate::mode::Mode;
use crate::triangle::Triangle;

/// Wider than two spans.
const SIZE: (u32, u32) = (160, 48);
const FOCAL: i16 = 200;
/// Distances from 2^-13 to 2^11.
const NEAR: Scalar = fx!(0.000_061_035_156_25);
/// Values at a corner.
const VALUES: usize = 3;

/// A triangle on the screen, in pixels.
type Shape = [[f64; 2]; 3];

/// Triangles with corners in and around the picture, far outside it, all within a pixel or two, or nearly in a line.
fn shapes() -> impl Strategy<Value = Shape> {
    let about = || [-40.0..200.0, -20.0..68.0];
    let beyond = || [-1900.0..1900.0, -1900.0..1900.0];
    let offset = || [-1.5..1.5, -1.5..1.5];
    let sum = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
    prop_oneof![
        [about(), about(), about()],
        [beyond(), beyond(), beyond()],
        ([0.0..160.0, 0.0..48.0], [offset(), offset(), offset()])
            .prop_map(move |(at, corners)| corners.map(|corner| sum(at, corner))),
        (about(), about(), -0.5..1.5, [-0.05..0.05, -0.05..0.05]).prop_map(
            move |(a, b, way, aside)| {
                let between = [0, 1].map(|i: usize| a[i] + way * (b[i] - a[i]));
                [a, b, sum(between, aside)]
            }
        ),
    ]
}

/// Three distances: equal, nearly equal, as in a picture, or as different as possible.
fn distances() -> impl Strategy<Value = [f64; 3]> {
    let apart = |low: f64, high: f64, spread: f64| {
        (low..high, [0.0..spread, 0.0..spread, 0.0..spread])
            .prop_map(|(base, more)| more.map(|more| (base + more).exp2()))
    };
    prop_oneof![
        (-4.0..10_f64).prop_map(|distance| [distance.exp2(); 3]),
        apart(-4., 10., 0.01),
        apart(-4., 8., 3.),
        apart(-13., -12., 12.),
        apart(-13., -12.9, 23.5),
    ]
}

/// A value at three corners: like a color, like a texture coordinate, any value, the ends of the format, or just
/// below powers of two, where scaling leaves the least room.
fn corners() -> impl Strategy<Value = [i32; 3]> {
    let triple = |range: std::ops::Range<i32>| [range.clone(), range.clone(), range];
    prop_oneof![
        triple(0..256),
        triple(-(4 << 24)..4 << 24),
        [any::<i32>(), any::<i32>(), any::<i32>()],
        prop::array::uniform3(prop::sample::select(vec![i32::MIN, -1, 0, 1, i32::MAX])),
        any::<i32>().prop_map(|value| [value; 3]),
        (0..32_u32, any::<[bool; 3]>()).prop_map(|(bits, signs)| {
            let value = i32::MAX >> (31 - bits.min(31));
            signs.map(|sign| if sign { value } else { -value })
        }),
    ]
}

/// Attributes that are independent, or all of similar size, as u and v are.
fn values() -> impl Strategy<Value = [[i32; 3]; VALUES]> {
    prop_oneof![
        prop::array::uniform3(corners()),
        (8..31_u32).prop_flat_map(|bits| {
            let range = -(1 << bits)..1 << bits;
            prop::array::uniform3([range.clone(), range.clone(), range])
        }),
    ]
}

/// Draws a triangle in some modes, and compares every pixel with the model. `bound` returns the bound of the error of a
/// value, given the value at the corners; `depth_error` is the bound of a depth's error, before it is rounded down.
fn compare<K: ProjectionKind>(
    triangle: &Triangle<K, VALUES>,
    modes: &[Mode],
    depth_error: f64,
    bound: impl Fn(Mode, [i32; 3]) -> Bound,
) -> Result<(), TestCaseError> {
    let Some(screen) = triangle.screen() else {
        // Skip the triangle if rounding moved a corner out of the guard band or onto another corner.
        return Err(TestCaseError::reject("clipped"));
    };
    let model = triangle.model(screen);
    let depths =
        |seen: &[Seen<VALUES>]| -> Vec<u16> { seen.iter().map(|seen| seen.depth).collect() };
    let exact = depths(&triangle.draw(Mode::Exact));
    for &mode in modes {
        let seen = triangle.draw(mode);
        // Except in `Compact`, depths must not depend on the mode, so that meshes in different modes meet where they
        // should.
        prop_assert!(
            mode == Mode::Compact || depths(&seen) == exact,
            "{mode:?}: depths differ"
        );
        let pixels = seen.iter().map(|seen| seen.pixel);
        prop_assert!(pixels.eq(model.iter().map(|model| model.pixel)));
        let bounds = triangle.values.map(|value| bound(mode, value));
        for (seen, model) in seen.iter().zip(&model) {
            for (k, &value) in triangle.values.iter().enumerate() {
                let error = (f64::from(seen.values[k]) - model.values[k]).abs();
                let bound = bounds[k].at(model.w, model.farthest);
                prop_assert!(
                    error <= bound,
                    "{mode:?}: {value:?} at {:?} on {screen:?} gives {} at {:?}, not {}: an error of {error}, over {bound}",
                    triangle.w,
                    seen.values[k],
                    seen.pixel,
                    model.values[k],
                );
            }
            let (stored, depth) = (f64::from(seen.depth), model.depth);
            prop_assert!(
                stored <= depth + depth_error && depth < stored + 1. + depth_error,
                "{mode:?}: depth {stored} at {:?} is not {depth}",
                seen.pixel,
            );
        }
    }
    Ok(())
}

fn point([x, y, z]: [f64; 3]) -> Option<Vec3> {
    Some(Vec3::new(scalar(x).ok()?, scalar(y).ok()?, scalar(z).ok()?))
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 1500,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn values_in_perspective_are_within_the_bounds(shape in shapes(), w in distances(), values in values()) {
        let corner = |i: usize| {
            let [x, y]: [f64; 2] = shape[i];
            let scale = w[i] / f64::from(FOCAL);
            point([(x - 80.) * scale, (24. - y) * scale, -w[i]])
        };
        let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) else {
            return Err(TestCaseError::reject("beyond the format"));
        };
        let positions = [a, b, c];
        let w = positions.map(|p| -p.z.to_num::<f64>());
        let projection = Projection::<Perspective>::from_focal_length(
            Scalar::from_num(FOCAL), SIZE, NEAR, fx!(32767),
        ).unwrap();
        let near: f64 = NEAR.to_num();
        let depth = w.map(|w| 65535. * near / w);
        let mvp = projection.into();
        let triangle = Triangle { size: SIZE, mvp, positions, values, w, depth };
        compare(&triangle, &Mode::PERSPECTIVE, bounds::depth(w), |mode, corners| {
            Bound::perspective(mode, corners, w)
        })?;
        // Under any projection, a value that is not divided by w is linear on the screen.
        let triangle = Triangle { w: [1.; 3], ..triangle };
        compare(&triangle, &[Mode::Affine], bounds::depth(w), Bound::parallel)?;
    }

    #[test]
    fn values_in_parallel_are_within_the_bounds(
        shape in shapes(),
        z in [0.0..100.0, 0.0..100.0, 0.0..100.0],
        values in values(),
    ) {
        let corner = |i: usize| {
            let [x, y]: [f64; 2] = shape[i];
            let z: f64 = z[i];
            point([x, 48. - y, -z]).unwrap()
        };
        let projection = Projection::orthographic(Window { left: fx!(0), right: fx!(160), bottom: fx!(0), top: fx!(48) }, fx!(0), fx!(100)).unwrap();
        let positions = [corner(0), corner(1), corner(2)];
        let depth = positions.map(|p| 65535. * (1. + p.z.to_num::<f64>() / 100.));
        let triangle = Triangle { size: SIZE, mvp: projection.into(), positions, values, w: [1.; 3], depth };
        compare(&triangle, &Mode::PARALLEL, bounds::DEPTH, Bound::parallel)?;
    }
}
