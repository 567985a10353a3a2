//! Polygons are cut into triangles that cover them, and turn the same way.

#![allow(clippy::float_cmp)] // the files state these values exactly

mod common;

use common::{notes, read};
use fixel_assets::Model;
use fixel_assets::vector::{Vector, add, cross, dot, length, sub};

/// Reads one polygon with these corners.
fn polygon(corners: &[Vector]) -> Model {
    let vertex = |[x, y, z]: &Vector| format!("v {x} {y} {z}\n");
    let text: String = corners.iter().map(vertex).collect();
    let number = |at: usize| format!(" {at}");
    let face: String = (1..=corners.len()).map(number).collect();
    let model = read(&[("a.obj", format!("{text}f{face}\n"))]).unwrap();
    assert!(model.notes.is_empty(), "{:?}", notes(&model));
    model
}

fn triangles(model: &Model) -> Vec<[u32; 3]> {
    let corners = model.triangles.iter().map(|triangle| triangle.corners);
    corners
        .map(|corners| corners.map(|corner| corner.position))
        .collect()
}

/// Moves points of a plane into space: along two axes, and far from the origin.
fn placed(points: &[[f64; 2]], right: Vector, up: Vector) -> Vec<Vector> {
    let at = |&[x, y]: &[f64; 2]| {
        let offset = [0, 1, 2].map(|axis| right[axis] * x + up[axis] * y);
        add([1000.0, -2000.0, 3000.0], offset)
    };
    points.iter().map(at).collect()
}

/// An L of area 5, counter-clockwise from each of its corners in turn.
const L: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [3.0, 0.0],
    [3.0, 1.0],
    [1.0, 1.0],
    [1.0, 3.0],
    [0.0, 3.0],
];

/// A comb of area 12, with three teeth of different lengths.
const COMB: [[f64; 2]; 12] = [
    [0.0, 0.0],
    [5.0, 0.0],
    [5.0, 4.0],
    [4.0, 4.0],
    [4.0, 1.0],
    [3.0, 1.0],
    [3.0, 3.0],
    [2.0, 3.0],
    [2.0, 1.0],
    [1.0, 1.0],
    [1.0, 3.0],
    [0.0, 3.0],
];

#[test]
fn convex_polygons_are_fans_around_their_first_corner() {
    let hexagon = [
        [1.0, 0.0],
        [3.0, 0.0],
        [4.0, 2.0],
        [3.0, 4.0],
        [1.0, 4.0],
        [0.0, 2.0],
    ];
    let model = polygon(&placed(&hexagon, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    assert_eq!(
        triangles(&model),
        [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]
    );
    // The sides of the polygon, without the cuts.
    assert_eq!(
        model.edges,
        [[0, 1], [0, 5], [1, 2], [2, 3], [3, 4], [4, 5]]
    );
    // The first corner of this arrow sees the whole arrow, although it is concave.
    let arrow = [[0.0, 2.0], [-2.0, -1.0], [0.0, 0.0], [2.0, -1.0]];
    let model = polygon(&placed(&arrow, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]));
    assert_eq!(triangles(&model), [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn concave_polygons_are_covered_once() {
    // In each of these planes, the polygon has another axis and sign of its normal, or none of them.
    let axes = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.6, 0.0, 0.8],
        [0.48, 0.6, -0.64],
    ];
    for (shape, area) in [(&L[..], 5.0), (&COMB[..], 12.0)] {
        for (right, up) in axes.iter().flat_map(|a| axes.map(|b| (*a, b))) {
            let normal = cross(right, up);
            if dot(right, up) != 0.0 || length(normal) == 0.0 {
                continue;
            }
            for first in 0..shape.len() {
                let mut points = shape.to_vec();
                points.rotate_left(first);
                let model = polygon(&placed(&points, right, up));
                assert_eq!(model.triangles.len(), points.len() - 2);
                // No triangle is turned, and together they have the area of the polygon: none overlap.
                let mut twice = Vec::new();
                for corners in triangles(&model) {
                    let [a, b, c] = corners.map(|at| model.positions[at as usize]);
                    twice.push(dot(cross(sub(b, a), sub(c, a)), normal));
                }
                // Coordinates near 4000 are rounded to 2^-41.
                assert!(
                    twice.iter().all(|area| *area > -1e-9),
                    "{right:?} {up:?}: {twice:?}"
                );
                let sum = twice.iter().sum::<f64>();
                assert!((sum - 2.0 * area).abs() < 1e-9, "{right:?} {up:?}: {sum}");
            }
        }
    }
}

#[test]
fn small_polygons_far_from_the_origin_keep_their_shape() {
    // All coordinates are whole multiples of 2^-21 below 2^32, so f64 holds them exactly, but not their products.
    let (unit, far) = (f64::from(1 << 21).recip(), f64::from(1_u32 << 31));
    let dart = [[7.0, 17.0], [24.0, 2.0], [5.0, 34.0], [22.0, 4.0]];
    let model = polygon(&dart.map(|[x, y]| [far + x * unit, far + y * unit, far]));
    // Twice the areas of the triangles, in units. Half of the fan around the first corner would be turned.
    let twice = triangles(&model).into_iter().map(|corners| {
        let [a, b, c] = corners.map(|at| model.positions[at as usize]);
        cross(sub(b, a), sub(c, a))[2] / (unit * unit)
    });
    let twice: Vec<f64> = twice.collect();
    assert!(twice.iter().all(|area| *area > 0.0), "{twice:?}");
    assert_eq!(twice.iter().sum::<f64>(), 30.0);
}

#[test]
fn polygons_that_cross_themselves_or_have_no_area_stay_fans() {
    let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 3.0]];
    let line = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [3.0, 0.0]];
    for points in [bow, line] {
        let vertex = |[x, y]: [f64; 2]| format!("v {x} {y} 0\n");
        let text = points.map(vertex).concat();
        // The second face has an area: a model without any is refused.
        let text = format!("{text}v 0 0 1\nf 1 2 3 4\nf 1 2 5\n");
        let model = read(&[("a.obj", text)]).unwrap();
        assert_eq!(triangles(&model)[..2], [[0, 1, 2], [0, 2, 3]]);
    }
}

#[test]
fn a_normal_without_direction_becomes_that_of_the_polygon() {
    // At its first three corners, this polygon turns the other way.
    let text = "v 0 1 0\nv 1 1 0\nv 1 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nvn 0 0 0\nvn 1 0 0\nf 1//1 2//1 3//1 4//2 5//1 6//1\n";
    let model = read(&[("a.obj", text)]).unwrap();
    for corner in model.triangles.iter().flat_map(|triangle| triangle.corners) {
        let normal = model.normals[corner.normal.unwrap() as usize];
        let wanted = if corner.position == 3 {
            [1.0, 0.0, 0.0]
        } else {
            [0.0, 0.0, 1.0]
        };
        assert_eq!(normal, wanted);
    }
}

#[test]
fn notes_have_limited_length() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    let library = |at: u32| format!("mtllib {at}.mtl\n");
    let libraries = |count: u32| (0..count).map(library).collect::<String>();
    let noted = |text: String| notes(&read(&[("a.obj", text)]).unwrap());
    let all = noted(format!("{square}{}", libraries(32)));
    assert_eq!(all.len(), 32);
    assert!(
        all[31].starts_with("cannot read materials 31.mtl"),
        "{}",
        all[31]
    );
    // Sentences beyond the 32nd are only counted. A known sentence still counts for itself.
    let all = noted(format!("{square}l 1 9\n{}l 1 9\n", libraries(40)));
    assert_eq!(all.len(), 33);
    assert_eq!(all[0], "a line is left out: an end is missing (2 times)");
    assert_eq!(all[32], "there are 9 other notes");
}
