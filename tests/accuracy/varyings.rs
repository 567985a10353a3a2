//! Values over random triangles: given the places of the corners, interpolation by itself.

use fixel::number::scalar;
use fixel::prelude::*;
use fixel::view::{Kind, Perspective};
use proptest::prelude::*;

use crate::bounds;
use crate::drawing::Drawing;
use crate::reference::attributes::at_pixel_snapped;
use crate::reference::coverage::covered;

/// More than two runs wide.
const SIZE: (u32, u32) = (160, 48);
const FOCAL: i16 = 200;
/// Distances go from 2^-13 to 2^11.
const NEAR: Scalar = fx!(0.000_061_035_156_25);
/// Values at a corner.
const VALUES: usize = 3;

/// A triangle on the screen, in pixels.
type Shape = [[f64; 2]; 3];

/// Corners on and about the picture, far beyond it, all within a pixel or two, or nearly in line.
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

/// Three distances: nearly alike, as in a picture, or as far apart as can be.
fn distances() -> impl Strategy<Value = [f64; 3]> {
    let apart = |low: f64, high: f64, spread: f64| {
        (low..high, [0.0..spread, 0.0..spread, 0.0..spread])
            .prop_map(|(base, more)| more.map(|more| (base + more).exp2()))
    };
    prop_oneof![
        apart(-4., 10., 0.01),
        apart(-4., 8., 3.),
        apart(-13., -12., 12.),
        apart(-13., -12.9, 23.5),
    ]
}

/// A value at three corners: like a colour, like a texture coordinate, anything, the ends of the
/// format, just below powers of two, which is where a scale has the least room.
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

fn values() -> impl Strategy<Value = [[i32; 3]; VALUES]> {
    prop::array::uniform3(corners())
}

/// Draws a triangle whose corners are `positions`, and compares every pixel with `model`, which
/// gives w at a pixel, and `bound`, what a value may be off by.
fn compare<K: Kind>(
    chain: Chain<K>,
    positions: [Vec3; 3],
    values: &[[i32; 3]; VALUES],
    w: [f64; 3],
    bound: impl Fn([i32; 3], f64) -> f64,
) -> Result<(), TestCaseError> {
    let drawing = Drawing {
        size: SIZE,
        pass: Pass::new().cull(Cull::Nothing),
        mesh: Mesh::new(&positions, &[[0, 1, 2]]).unwrap(),
        chain,
    };
    let [Some(a), Some(b), Some(c)] = drawing.places(&positions)[..] else {
        // Rounding took a corner out of the guard band.
        return Err(TestCaseError::reject("clipped"));
    };
    prop_assume!(a != b && b != c && c != a);
    let seen = drawing.all(&|vertex| {
        let corner = positions.iter().position(|&p| p == vertex.position());
        values.map(|value| value[corner.unwrap()])
    });

    let mut pixels: Vec<_> = seen.iter().map(|seen| seen.pixel).collect();
    pixels.sort_by_key(|[x, y]| (*y, *x));
    let model: Vec<_> = covered([a, b, c], SIZE.0, SIZE.1).collect();
    prop_assert_eq!(pixels, model);

    let attributes = [0, 1, 2].map(|corner: usize| values.map(|v| f64::from(v[corner])));
    for seen in &seen {
        let model = at_pixel_snapped([a, b, c], w, &attributes, seen.pixel).unwrap();
        for (k, &value) in values.iter().enumerate() {
            let error = (f64::from(seen.values[k]) - model.attributes[k]).abs();
            let bound = bound(value, model.w);
            prop_assert!(
                error <= bound,
                "{value:?} at {w:?} on {:?} gives {} at {:?}, not {}: off by {error}, over {bound}",
                [a, b, c],
                seen.values[k],
                seen.pixel,
                model.attributes[k],
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
    fn values_in_perspective(shape in shapes(), w in distances(), values in values()) {
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
        let lens = Projection::<Perspective>::from_focal_length(
            Scalar::from_num(FOCAL), SIZE, NEAR, fx!(32767),
        ).unwrap();
        let bound = |corners, at| bounds::perspective(corners, w, at);
        compare(lens.into(), positions, &values, w, bound)?;
    }

    #[test]
    fn values_in_parallel(
        shape in shapes(),
        z in [0.0..100.0, 0.0..100.0, 0.0..100.0],
        values in values(),
    ) {
        let corner = |i: usize| {
            let [x, y]: [f64; 2] = shape[i];
            let z: f64 = z[i];
            point([x, 48. - y, -z]).unwrap()
        };
        let lens = Projection::orthographic(
            fx!(0), fx!(160), fx!(0), fx!(48), fx!(0), fx!(100),
        ).unwrap();
        let bound = |corners, _| bounds::parallel(corners);
        compare(lens.into(), [corner(0), corner(1), corner(2)], &values, [1.; 3], bound)?;
    }
}
