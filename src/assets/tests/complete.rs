//! Normals and texture coordinates that a file lacks have the values that follow from its geometry.

#![allow(clippy::cast_precision_loss, clippy::float_cmp)] // small counts; the file states the compared values exactly

mod common;

use std::collections::HashSet;
use std::fmt::Write;

use common::{notes, read};
use fixel_assets::Model;
use fixel_assets::vector::{Vector, add, along, cross, sub, unit};

/// Reads a model, and adds what it lacks.
fn completed(text: &str) -> Model {
    let mut model = read(&[("a.obj", text)]).expect(text);
    assert!(model.notes.is_empty(), "{:?}", notes(&model));
    model.complete();
    model
}

/// The normals of a triangle's corners.
fn normals(model: &Model, triangle: usize) -> [Vector; 3] {
    let corners = model.triangles[triangle].corners;
    corners.map(|corner| model.normals[corner.normal.expect("a normal") as usize])
}

/// Checks a normal. A computed normal has length 1, and its rounding errors are far below 1e-12: coordinates are near
/// 1, and have errors of 2^-52.
#[track_caller]
fn assert_near(normal: Vector, wanted: Vector, case: &str) {
    let off = sub(normal, unit(wanted).expect("a direction"));
    let is_near = off.iter().all(|x| x.abs() < 1e-12);
    assert!(is_near, "{case}: {normal:?}, not along {wanted:?}");
}

/// A flat face at the point [`POINT`]: its normal's direction, and the length of that normal, which is twice the area.
type Face = (Vector, f64);

/// The common point of some faces.
const POINT: Vector = [1.0, 2.0, 3.0];

/// The text of triangles that share only [`POINT`], as their first corner. The words of `before` come before each face.
fn around(faces: &[Face], before: &[&str]) -> String {
    let mut text = "v 1 2 3\n".to_string();
    for (at, &(normal, area)) in faces.iter().enumerate() {
        let normal = unit(normal).unwrap();
        // Any direction will do that differs much from the normal. The other corners of no two faces agree.
        let other = if normal[1].abs() < 0.9 {
            [0.0, 1.0, 0.0]
        } else {
            [1.0, 0.0, 0.0]
        };
        let right = unit(cross(other, normal)).unwrap();
        let up = cross(normal, right);
        let height = 1.0 + at as f64 / 10.0;
        for [x, y, z] in [along(POINT, right, area / height), along(POINT, up, height)] {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        let before = before.get(at).unwrap_or(&"");
        writeln!(text, "{before}f 1 {} {}", 2 * at + 2, 2 * at + 3).unwrap();
    }
    text
}

/// A direction in the plane y = 0, by its angle from z in degrees.
fn angled(degrees: f64) -> Vector {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [sin, 0.0, cos]
}

/// The sum of normals, weighted by area.
fn sum<'a>(faces: impl IntoIterator<Item = &'a Face>) -> Vector {
    let add = |sum, &(normal, area): &Face| along(sum, unit(normal).unwrap(), area);
    faces.into_iter().fold([0.0; 3], add)
}

/// Faces by their angles and areas: each must get the sum of those at most 60 degrees from it.
#[track_caller]
fn assert_creases(angles: &[(f64, f64)]) {
    let face = |&(angle, area): &(f64, f64)| (angled(angle), area);
    let model = completed(&around(&angles.iter().map(face).collect::<Vec<_>>(), &[]));
    for (at, &(angle, area)) in angles.iter().enumerate() {
        let near = angles
            .iter()
            .filter(|other| (other.0 - angle).abs() <= 60.0);
        let [shared, others @ ..] = normals(&model, at);
        assert_near(
            shared,
            sum(&near.map(face).collect::<Vec<_>>()),
            &format!("{angle}"),
        );
        // The other corners belong to this face alone.
        for other in others {
            assert_near(other, angled(angle), &format!("{angle}, {area}"));
        }
    }
}

#[test]
fn faces_up_to_60_degrees_apart_share_normals_weighted_by_area() {
    assert_creases(&[(0.0, 1.0), (59.9, 3.0)]);
    assert_creases(&[(0.0, 1.0), (60.1, 3.0)]);
    assert_creases(&[(-20.0, 5.0), (35.0, 0.25)]);
    // Each face counts the faces near itself: the second face counts all, the others only two.
    assert_creases(&[(0.0, 1.0), (50.0, 2.0), (100.0, 3.0)]);
    assert_creases(&[
        (50.0, 2.0),
        (100.0, 3.0),
        (0.0, 1.0),
        (150.0, 1.0),
        (179.0, 0.5),
    ]);
    // Few faces are compared one by one, even if some have nearly the same direction.
    assert_creases(&[(0.0, 1.0), (2.0, 100.0), (61.5, 1.0)]);
}

#[test]
fn many_faces_around_a_point_follow_the_rule_of_60_degrees() {
    // In each of these directions lie many faces, so whole groups of faces are compared.
    let many = |directions: &[f64]| {
        let faces = (0..30).flat_map(|at| {
            let area = 0.5 + f64::from(at) / 8.0;
            directions.iter().map(move |&angle| (angle, area))
        });
        assert_creases(&faces.collect::<Vec<_>>());
    };
    many(&[0.0, 45.0, 90.0, 135.0, 180.0]);
    // The first two are in groups of their own, because the third is within 60 degrees of only one.
    many(&[0.0, 15.0, 70.0]);
    // 16 faces lie around each axis, 10 degrees from it. So faces of one axis are at most 20 degrees apart, and faces
    // of two axes at least 70 degrees.
    let tilt = 10_f64.to_radians().tan();
    let mut faces: Vec<Face> = Vec::new();
    for axis in 0..6 {
        for turn in 0..16 {
            let (sin, cos) = (f64::from(turn) * 22.5).to_radians().sin_cos();
            let mut normal = [0.0; 3];
            normal[axis / 2] = if axis % 2 == 0 { 1.0 } else { -1.0 };
            normal[(axis / 2 + 1) % 3] = tilt * sin;
            normal[(axis / 2 + 2) % 3] = tilt * cos;
            faces.push((normal, 1.0 + f64::from(turn)));
        }
    }
    let model = completed(&around(&faces, &[]));
    for (at, group) in faces.chunks(16).enumerate() {
        for face in 16 * at..16 * at + 16 {
            assert_near(
                normals(&model, face)[0],
                sum(group),
                &format!("face {face}"),
            );
        }
    }
}

#[test]
fn smoothing_groups_replace_the_rule_of_60_degrees() {
    let angles = [0.0, 120.0, 10.0, 20.0, 30.0, 150.0];
    let words = ["s 1\n", "s 1\n", "s 2\n", "s off\n", "s off\n", "s 2\n"];
    let faces = angles.map(|angle| (angled(angle), 1.0 + angle / 100.0));
    let model = completed(&around(&faces, &words));
    let normal = |at: usize| normals(&model, at)[0];
    for (at, group) in [(0, [0, 1]), (1, [0, 1]), (2, [2, 5]), (5, [2, 5])] {
        assert_near(normal(at), sum(group.map(|at| &faces[at])), words[at]);
    }
    for at in [3, 4] {
        assert_near(normal(at), angled(angles[at]), "flat");
    }
    // A face without any statement of smoothing still follows the rule.
    let model = completed(&around(&faces, &["", "s 1\n", "", "", "", ""]));
    let near = [0, 2, 3, 4].map(|at| &faces[at]);
    assert_near(normals(&model, 0)[0], sum(near), "no group");
}

/// A box with the corners (10, 20, 30) and (14, 22, 31), of 6 squares over 8 positions, and a point far away that no
/// face uses.
const BOX: &str = "\
    v 10 20 30\nv 14 20 30\nv 10 22 30\nv 14 22 30\nv 10 20 31\nv 14 20 31\nv 10 22 31\nv 14 22 31\nv -900 800 nan\n\
    f 2 4 8 6\nf 1 5 7 3\nf 3 7 8 4\nf 1 2 6 5\nf 5 6 8 7\nf 1 3 4 2\n";

/// The outward normals of the sides of [`BOX`].
const SIDES: [Vector; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];

#[test]
fn edges_of_a_box_stay_sharp() {
    let model = completed(BOX);
    for at in 0..12 {
        for normal in normals(&model, at) {
            assert_near(normal, SIDES[at / 2], "a side");
        }
    }
    // Corners with equal normals share one.
    assert_eq!(model.normals.len(), 6);
}

#[test]
fn a_point_that_is_repeated_is_smooth() {
    // The ridge of a roof, whose halves have points of their own there: −0 is 0.
    let text = "v 0 0 0\nv 0 1 0\nv 4 0 -1\nv -0 -0 0\nv -0.0 1 0\nv -4 0 -1\nf 1 3 2\nf 4 5 6\n";
    let model = completed(text);
    // The halves are symmetric, so the normals along the ridge point up.
    let up = [0.0, 0.0, 1.0];
    let [first, second] = [0, 1].map(|at| normals(&model, at));
    for normal in [first[0], first[2], second[0], second[1]] {
        assert_near(normal, up, "the ridge");
    }
    assert_near(first[1], [1.0, 0.0, 4.0], "the right half");
    assert_near(second[2], [-1.0, 0.0, 4.0], "the left half");
}

#[test]
fn normals_of_the_file_stay() {
    // The first face has normals at two corners, of any length. The others get the mean.
    let text = "v 0 0 0\nv 0 1 0\nv 4 0 -1\nv -4 0 -1\nvn 3 0 0\nf 1//1 3 2//1\nf 1 2 4\n";
    let model = completed(text);
    let [first, second] = [0, 1].map(|at| normals(&model, at));
    assert_eq!([first[0], first[2]], [[3.0, 0.0, 0.0]; 2]);
    assert_near(first[1], [1.0, 0.0, 4.0], "its own");
    assert_near(second[0], [0.0, 0.0, 1.0], "the mean");
    let all = text.replace("f 1//1 3 2//1\nf 1 2 4", "f 1//1 3//1 2//1");
    assert_eq!(completed(&all).normals, [[3.0, 0.0, 0.0]]);
}

#[test]
fn faces_without_area_change_no_normal() {
    // The second face has no area. Its corners take the normal of the face that they touch.
    let text = "v 0 0 0\nv 1 0 0\nv 0 0 -1\nv 5 5 5\nf 1 2 3\nf 1 2 2\nf 4 4 4\n";
    let model = completed(text);
    for at in [0, 1] {
        for normal in normals(&model, at) {
            assert_near(normal, [0.0, 1.0, 0.0], "the face");
        }
    }
    // Where no face has a direction, the normal is z.
    assert_eq!(normals(&model, 2), [[0.0, 0.0, 1.0]; 3]);
}

/// The texture coordinates of a triangle's corners, by their positions.
fn placed(model: &Model, triangle: usize) -> [(Vector, [f64; 2]); 3] {
    model.triangles[triangle].corners.map(|corner| {
        let uv = corner.uv.expect("a texture coordinate");
        (
            model.positions[corner.position as usize],
            model.uvs[uv as usize],
        )
    })
}

#[test]
fn sides_of_a_box_show_the_picture_upright_from_outside() {
    let model = completed(BOX);
    assert!(!model.had_uvs);
    // For each side, as someone outside sees it: the corner at the top left, to its right, and below it. (From above,
    // the far side is up; from below, the near side.) The longest side of the box, 4, is one picture wide.
    let [x, y, z] = [[10.0, 14.0], [20.0, 22.0], [30.0, 31.0]];
    let at = |i: usize, j: usize, k: usize| [x[i], y[j], z[k]];
    let corners = [
        [at(1, 1, 1), at(1, 1, 0), at(1, 0, 1)],
        [at(0, 1, 0), at(0, 1, 1), at(0, 0, 0)],
        [at(0, 1, 0), at(1, 1, 0), at(0, 1, 1)],
        [at(0, 0, 1), at(1, 0, 1), at(0, 0, 0)],
        [at(0, 1, 1), at(1, 1, 1), at(0, 0, 1)],
        [at(1, 1, 0), at(0, 1, 0), at(1, 0, 0)],
    ];
    let sizes = [
        [0.25, 0.5],
        [0.25, 0.5],
        [1.0, 0.25],
        [1.0, 0.25],
        [1.0, 0.5],
        [1.0, 0.5],
    ];
    for (side, ([left, right, below], [width, height])) in corners.iter().zip(sizes).enumerate() {
        let found = [2 * side, 2 * side + 1].map(|at| placed(&model, at));
        let found: HashSet<_> = found
            .as_flattened()
            .iter()
            .map(|(p, uv)| (p.map(f64::to_bits), uv.map(f64::to_bits)))
            .collect();
        let wanted = [
            (*left, [0.0, 0.0]),
            (*right, [width, 0.0]),
            (*below, [0.0, height]),
            (sub(add(*right, *below), *left), [width, height]),
        ];
        // All these numbers are exact, so their bits agree.
        let wanted = wanted.map(|(p, uv)| (p.map(f64::to_bits), uv.map(f64::to_bits)));
        assert_eq!(found, HashSet::from(wanted), "side {side}");
    }
}

#[test]
fn slanted_faces_take_the_side_that_they_face_most() {
    // The side is the axis of the greatest component of the normal, and its sign.
    for (normal, side) in [
        ([0.8, 0.5, -0.3], 0),
        ([-0.8, -0.5, 0.7], 1),
        ([0.7, 0.8, 0.7], 2),
        ([0.5, -0.6, 0.5], 3),
        ([-0.6, 0.5, 0.7], 4),
        ([0.6, -0.6, -0.61], 5),
    ] {
        let model = completed(&around(&[(normal, 2.0)], &[]));
        let [low, high] = model.bounds();
        let size = sub(high, low).into_iter().fold(0.0, f64::max);
        for (p, [u, v]) in placed(&model, 0) {
            let from_low = [0, 1, 2].map(|axis| (p[axis] - low[axis]) / size);
            let from_high = [0, 1, 2].map(|axis| (high[axis] - p[axis]) / size);
            let wanted = [
                [from_high[2], from_high[1]],
                [from_low[2], from_high[1]],
                [from_low[0], from_low[2]],
                [from_low[0], from_high[2]],
                [from_low[0], from_high[1]],
                [from_high[0], from_high[1]],
            ][side];
            let is_near = (u - wanted[0]).abs() < 1e-12 && (v - wanted[1]).abs() < 1e-12;
            assert!(is_near, "{normal:?}: {u} {v}, not {wanted:?}");
        }
    }
}

#[test]
fn texture_coordinates_of_the_file_stay() {
    let square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 7 0.25\n";
    let model = completed(&format!("{square}f 1/1 2/1 3/1\nf 1 3 4\n"));
    assert!(!model.had_uvs);
    assert_eq!(placed(&model, 0).map(|(_, uv)| uv), [[7.0, 0.75]; 3]);
    let other = placed(&model, 1).map(|(_, uv)| uv);
    assert_eq!(other, [[0.0, 1.0], [1.0, 0.0], [0.0, 0.0]]);
    let model = completed(&format!("{square}f 1/1 2/1 3/1\n"));
    assert!(model.had_uvs);
    assert_eq!(model.uvs, [[7.0, 0.75]]);
}

#[test]
fn normals_behind_their_face_are_turned() {
    // The faces look towards z. Only the second has all normals behind it, and shares them with the third and fourth.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 1 0 -2\nvn 0 1 -1\n\
        f 1//1 2//1 3//1\nf 1//2 2//2 3//3\nf 1//2 2//2 3//1\nf 1//2 2//2 3\n";
    let mut model = read(&[("a.obj", text)]).unwrap();
    model.turn_normals();
    let [front, behind, turned] = [[0.0, 0.0, 2.0], [1.0, 0.0, -2.0], [-1.0, 0.0, 2.0]];
    assert_eq!(normals(&model, 0), [front; 3]);
    assert_eq!(normals(&model, 1), [turned, turned, [0.0, -1.0, 1.0]]);
    assert_eq!(normals(&model, 2), [behind, behind, front]);
    let corners = model.triangles[3].corners.map(|corner| corner.normal);
    assert_eq!(corners, [Some(1), Some(1), None]);
    // Each normal that turns gets one new entry.
    assert_eq!(model.normals.len(), 5);
}
