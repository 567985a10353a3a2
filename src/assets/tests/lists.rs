//! The lists of a mesh have the file's values in fixed point, placed, scaled, turned and selected as the options say.

#![allow(clippy::float_cmp)] // the files state these values exactly

mod common;

use common::read;
use fixel_assets::{Lists, Model, Options, Run};

fn obj(text: &str) -> Model {
    read(&[("a.obj", text)]).expect(text)
}

#[track_caller]
fn lists(text: &str, options: &Options) -> Lists {
    obj(text).lists(options).expect(text)
}

/// Half of a square, and the whole of another, in materials and objects of their own, and a line. The first vertex is
/// used by no face.
const PARTS: &str = "v 9 9 9\nv 0 0 0\nv 2 0 0\nv 0 2 0\nv 4 0 0\nv 6 0 0\nv 6 2 0\nv 4 2 0\n\
    vt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.25\nvn 0 0 1\nvn 0 0 3\n\
    o half\nusemtl wood\nf 2/1/1 3/2/1 4/3/1\no whole\nusemtl iron\nf 5//2 6//2 7//2 8//2\nl 2 5\n";

#[test]
fn numbers_are_rounded_to_nearest_and_halves_away_from_zero() {
    // The half of a unit of positions is 2^-17, of texture coordinates 2^-21.
    let half = [17, 21].map(|bits| f64::from(bits).exp2().recip());
    let below = [half[0] * 0.999, half[1] * 0.999];
    let text = format!(
        "v {} {} {}\nv 1.5 -2.25 0\nv 0 32767.99999 -32768\nvt {} {}\nvt {} {}\nvt -3 -0.5\nf 1/1 2/2 3/3\n",
        half[0], -half[0], below[0], half[1], below[1], -half[1], -below[1],
    );
    let lists = lists(&text, &Options::default());
    let one = 1 << 16;
    let positions = [
        [1, -1, 0],
        [one * 3 / 2, -2 * one - one / 4, 0],
        [0, i32::MAX, i32::MIN],
    ];
    assert_eq!(lists.positions, positions);
    // In the file, v points up; in a mesh, down.
    let repeat = 1 << 20;
    let uvs = [[1, repeat], [-1, repeat], [-3 * repeat, repeat * 3 / 2]];
    assert_eq!(lists.uvs, uvs);
    assert_eq!(lists.faces, [[0, 1, 2]]);
    // All corners use the same index for both, and there are no normals and no colors.
    assert_eq!((lists.uv_faces.len(), lists.normal_faces.len()), (0, 0));
    assert_eq!((lists.normals.len(), lists.colors.len()), (0, 0));
}

#[test]
fn models_are_centered_turned_and_scaled() {
    // The box from (1, 2, 3) to (5, 4, 9) has its middle at (3, 3, 6). The point far away belongs to no face.
    let text = "v 1 2 3\nv 5 4 3\nv 1 2 9\nv 1000 0 0\nvn 1 2 3\nf 1//1 2//1 3//1\n";
    let model = obj(text);
    assert_eq!(model.bounds(), [[1.0, 2.0, 3.0], [5.0, 4.0, 9.0]]);
    assert_eq!(model.middle(), [3.0, 3.0, 6.0]);
    let first = |options: Options| {
        let lists = model.lists(&options).unwrap();
        let units = |list: &[[i32; 3]], at: usize| list[at].map(|x| f64::from(x) / 65536.0);
        (units(&lists.positions, 1), units(&lists.normals, 0))
    };
    let plain = Options::default();
    let options = [
        (plain.clone(), [5.0, 4.0, 3.0], [1.0, 2.0, 3.0]),
        (
            Options {
                center: true,
                ..plain.clone()
            },
            [2.0, 1.0, -3.0],
            [1.0, 2.0, 3.0],
        ),
        (
            Options {
                scale: -0.5,
                ..plain.clone()
            },
            [-2.5, -2.0, -1.5],
            [1.0, 2.0, 3.0],
        ),
        // A quarter turn about x: z becomes y, and y becomes −z.
        (
            Options {
                z_up: true,
                ..plain.clone()
            },
            [5.0, 3.0, -4.0],
            [1.0, 3.0, -2.0],
        ),
        (
            Options {
                center: true,
                scale: 0.5,
                z_up: true,
                ..plain
            },
            [1.0, -1.5, -0.5],
            [1.0, 3.0, -2.0],
        ),
    ];
    for (options, position, normal) in options {
        let case = format!("{options:?}");
        assert_eq!(first(options), (position, normal), "{case}");
    }
}

#[test]
fn normals_of_any_length_keep_their_direction() {
    let normal = |text: &str| {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn {text}\nf 1//1 2//1 3//1\n");
        lists(&text, &Options::default()).normals[0].map(|x| f64::from(x) / 65536.0)
    };
    assert_eq!(normal("0.5 -0.25 0.125"), [0.5, -0.25, 0.125]);
    assert_eq!(normal("100 -200 8191"), [100.0, -200.0, 8191.0]);
    // A short or a long normal gets a component of 1 or −1.
    assert_eq!(normal("1e-9 -2e-9 0.5e-9"), [0.5, -1.0, 0.25]);
    assert_eq!(normal("20000 0 40000"), [0.5, 0.0, 1.0]);
    assert_eq!(normal("-1e20 0 1e19")[..2], [-1.0, 0.0]);
}

#[test]
fn coordinates_beyond_the_range_are_refused_with_a_scale_that_fits() {
    let model = obj("v 0 0 0\nv 0 -40000 0\nv 1 0 0\nf 1 2 3\n");
    let refused = model.lists(&Options::default()).unwrap_err();
    let wanted = "a coordinate is 40000: it must lie between -32768 and 32767.99999; with scale = 0.5 it does";
    assert_eq!(refused, wanted);
    for scale in [0.5, -0.5] {
        let options = Options {
            scale,
            ..Options::default()
        };
        assert!(model.lists(&options).is_ok());
    }
    // The middle at the origin can suffice, and counts in the scale.
    let options = Options {
        center: true,
        ..Options::default()
    };
    assert_eq!(model.lists(&options).unwrap().positions[1][1], -20000 << 16);
    let far = obj("v 0 0 0\nv 0 -400000 0\nv 1 0 0\nf 1 2 3\n");
    let refused = far.lists(&options).unwrap_err();
    assert!(
        refused.contains("is 200000") && refused.contains("scale = 0.125"),
        "{refused}"
    );
    let most = obj("v 32767.99999 0 -32768\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert!(most.lists(&Options::default()).is_ok());
}

#[test]
fn attributes_have_indices_of_their_own_where_they_differ_from_the_positions() {
    let lists = lists(PARTS, &Options::default());
    assert_eq!(lists.faces, [[0, 1, 2], [3, 4, 5], [3, 5, 6]]);
    let missing = u16::MAX;
    assert_eq!(lists.uv_faces, [[0, 1, 2], [missing; 3], [missing; 3]]);
    assert_eq!(lists.normal_faces, [[0; 3], [1; 3], [1; 3]]);
    let edges = [
        [0, 1],
        [0, 2],
        [0, 3],
        [1, 2],
        [3, 4],
        [3, 6],
        [4, 5],
        [5, 6],
    ];
    assert_eq!(lists.edges, edges);
    // Three of each, but not in the same order.
    let turned = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/2 2/3 3/1\n";
    assert_eq!(
        self::lists(turned, &Options::default()).uv_faces,
        [[1, 2, 0]]
    );
    // One texture coordinate more than positions, but the same indices: no list is needed for four that are used.
    let unused = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 5 5\nf 1/1 2/2 3/3\n";
    assert_eq!(self::lists(unused, &Options::default()).uv_faces.len(), 0);
}

#[test]
fn colors_follow_their_corners() {
    // The vertex that no face uses, and its color, are left out.
    let text = "v 0 0 0 0 0 0\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 2 3 4\n";
    let lists = lists(text, &Options::default());
    assert_eq!(lists.colors, [[255, 0, 0], [0, 255, 0], [0, 0, 255]]);
    assert_eq!((lists.positions.len(), lists.color_faces.len()), (3, 0));
}

#[test]
fn options_select_faces() {
    let select = |part: Option<&str>, object: Option<&str>| {
        let (part, object) = (part.map(String::from), object.map(String::from));
        obj(PARTS).lists(&Options {
            part,
            object,
            ..Options::default()
        })
    };
    let half = select(Some("wood"), None).unwrap();
    let two = 2 << 16;
    assert_eq!(half.positions, [[0, 0, 0], [two, 0, 0], [0, two, 0]]);
    assert_eq!(half.faces, [[0, 1, 2]]);
    // The line to the other square is gone, and so are the values that only others use.
    assert_eq!(half.edges, [[0, 1], [0, 2], [1, 2]]);
    assert_eq!((half.uvs.len(), half.normals.len()), (3, 1));
    assert_eq!(select(None, Some("half")).unwrap(), half);
    assert_eq!(select(Some("wood"), Some("half")).unwrap(), half);
    let whole = select(None, Some("whole")).unwrap();
    assert_eq!(whole.faces, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(whole.edges, [[0, 1], [0, 3], [1, 2], [2, 3]]);
    assert_eq!((whole.uvs.len(), whole.uv_faces.len()), (0, 0));
    assert_eq!(whole.normals, [[0, 0, 3 << 16]]);
    // A part of one model is placed as the whole model is, so that its parts fit together.
    let options = Options {
        center: true,
        object: Some("whole".into()),
        ..Options::default()
    };
    let lists = obj(PARTS).lists(&options).unwrap();
    assert_eq!(lists.positions[0], [1 << 16, -1 << 16, 0]);
    let refused = [
        (
            Some("gold"),
            None,
            "there is no material 'gold': the names are 'wood', 'iron'",
        ),
        (
            None,
            Some("all"),
            "there is no object 'all': the names are 'half', 'whole'",
        ),
        (
            Some("wood"),
            Some("whole"),
            "the options select no face: a face must have the material and the object that they name",
        ),
    ];
    for (part, object, says) in refused {
        assert_eq!(select(part, object).unwrap_err(), says);
    }
}

#[test]
fn indices_have_16_bits() {
    let text = |count: u32| {
        let corner = |at: u32| format!("v {} {} 0\n", at % 256, at / 256);
        let corners: String = (0..count).map(corner).collect();
        let face = |at: u32| format!("f 1 {} {}\n", at, at + 1);
        corners + &(2..count).map(face).collect::<String>()
    };
    let lists = lists(&text(65_536), &Options::default());
    assert_eq!(lists.faces[65_533], [0, 65_534, 65_535]);
    let refused = obj(&text(65_537)).lists(&Options::default()).unwrap_err();
    let wanted = "it has 65537 positions: a mesh can have at most 65536; include the parts of its materials one by one";
    assert_eq!(refused, wanted);
}

/// Some coordinates are a millionth, or a millionth apart, and one is `far`.
fn merging(far: f64, scale: f64) -> Option<String> {
    let text = format!("v 0 0 0\nv 1e-6 0 0\nv 0 1e-6 0\nv {far} 0 0\nf 1 2 3\nf 1 2 4\n");
    obj(&text).merging(scale)
}

#[test]
fn a_note_says_which_scale_keeps_positions_apart() {
    // A unit is 2^-16, and half of it is rounded up. So the least sufficient power of two is 2^3: 2^-17 is 7.6e-6.
    let says = |scale: i32| {
        let what = "2 of 4 positions become equal to others when rounded to 1/65536";
        format!("{what}: scale = {scale} keeps them apart")
    };
    assert_eq!(merging(0.01, 1.0), Some(says(8)));
    assert_eq!(merging(0.01, 8.0), None);
    // A negative scale stays negative.
    assert_eq!(merging(0.01, -1.0), Some(says(-8)));
    assert_eq!(merging(0.01, -8.0), None);
    // Far from the origin, only a centered model fits at the scale.
    let far = obj("v 20000 0 0\nv 20000.000001 0 0\nv 20000 0.001 0\nf 1 2 3\n");
    for (scale, wanted) in [(1.0, "center, scale = 8 "), (-1.0, "center, scale = -8 ")] {
        let note = far.merging(scale).unwrap();
        assert!(note.contains(wanted), "{note}");
    }
    // Positions closer together than 1/65,536 of the size of the model count as one position.
    assert_eq!(merging(1.0, 1.0), None);
    // These positions are far out of the range of every scale near 1, and do not keep the search from its end.
    let huge = obj("v 0 0 0\nv 1e30 0 0\nv 9e29 1e29 0\nf 1 2 3\n");
    assert_eq!([1.0, -1.0].map(|scale| huge.merging(scale)), [None, None]);
}

#[test]
fn runs_are_faces_of_one_material() {
    let run = |start, end, material| Run {
        faces: [start, end],
        material,
    };
    let runs = obj(&format!(
        "{PARTS}usemtl wood\nf 2 3 4\nf 2 4 3\nusemtl\nf 3 4 5\n"
    ))
    .runs();
    let wanted = [
        run(0, 1, Some(0)),
        run(1, 3, Some(1)),
        run(3, 5, Some(0)),
        run(5, 6, None),
    ];
    assert_eq!(runs, wanted);
}

#[test]
fn positions_of_16_bits_keep_as_many_fraction_bits_as_fit() {
    let quantized_positions = |positions: &[[i32; 3]]| {
        let positions = positions.to_vec();
        Lists {
            positions,
            ..Lists::default()
        }
        .quantized_positions()
    };
    // The largest component decides: i16 ends at 32,767.
    assert_eq!(
        quantized_positions(&[[32_767, -32_768, 5]]),
        (vec![[32_767, -32_768, 5]], 16)
    );
    assert_eq!(
        quantized_positions(&[[0, -32_769, 0]]),
        (vec![[0, -16_384, 0]], 15)
    );
    assert_eq!(
        quantized_positions(&[[32_768, 3, -3]]),
        (vec![[16_384, 2, -1]], 15)
    );
    assert_eq!(
        quantized_positions(&[[1 << 16, 6, 10]]),
        (vec![[1 << 14, 2, 3]], 14)
    );
    // 65,535 halved would round up to 32,768, which does not fit.
    assert_eq!(
        quantized_positions(&[[65_535, 0, 0]]),
        (vec![[16_384, 0, 0]], 14)
    );
    assert_eq!(
        quantized_positions(&[[i32::MIN, 0, 32_768]]),
        (vec![[-32_768, 0, 1]], 0)
    );
    // The largest number rounds up beyond i16 even without fraction bits, and is clamped.
    assert_eq!(
        quantized_positions(&[[i32::MAX, 0, 32_767]]),
        (vec![[32_767, 0, 0]], 0)
    );
}

/// The outline of a model with edges that are creases above this angle.
fn outline(text: &str, crease: f64) -> (Vec<[u16; 4]>, usize) {
    lists(text, &Options::default()).outline(crease)
}

#[test]
fn outlines_have_edges_with_both_their_faces() {
    // Two faces that meet at a right angle along the edge from 1 to 2, and a face without area.
    let text = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 -2\nf 1 3 2\nf 1 2 4\nf 1 2 2\n";
    let borders = [[0, 2, 1, 0], [2, 1, 0, 2], [1, 3, 0, 1], [3, 0, 1, 3]];
    let fold = [1, 0, 2, 3];
    let [a, b, c, d] = borders;
    assert_eq!(outline(text, 89.0), (vec![fold, a, b, c, d], 1));
    assert_eq!(outline(text, 91.0), (vec![a, b, fold, c, d], 0));
    // Faces are neighbors where their corners have the same positions, whatever their indices.
    let apart = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 -2\nv 0 0 0\nv 0 1 0\nf 1 3 2\nf 5 6 4\n";
    assert_eq!(
        outline(apart, 89.0),
        (vec![fold, a, b, [5, 3, 4, 5], [3, 4, 5, 3]], 1)
    );
    // Without an angle, an edge within a flat square is still no crease.
    let flat = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let (edges, creases) = outline(flat, 0.0);
    assert_eq!((edges.len(), creases), (5, 0));
    assert!(edges.contains(&[2, 0, 1, 3]));
}

#[test]
fn outlines_of_a_box_are_its_edges() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n\
        f 2 4 8 6\nf 1 5 7 3\nf 3 7 8 4\nf 1 2 6 5\nf 5 6 8 7\nf 1 3 4 2\n";
    let (edges, creases) = outline(text, 30.0);
    // Twelve edges, and a diagonal in each of the six sides.
    assert_eq!((edges.len(), creases), (18, 12));
    for [a, b, ..] in &edges[..12] {
        assert_eq!((a ^ b).count_ones(), 1, "{a} to {b}");
    }
    assert!(edges.iter().all(|[a, _, _, d]| a != d), "no borders");
}
