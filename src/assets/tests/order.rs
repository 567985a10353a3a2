//! Faces are put into an order in which a draw call projects fewer vertices, and stay the same faces.

mod common;

use std::collections::BTreeSet;
use std::fmt::Write as _;

use common::read;
use fixel_assets::{Lists, Model, Options};
use rand::rngs::SmallRng;
use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};

/// The order in which a model's faces come.
#[derive(Clone, Copy, PartialEq)]
enum Order {
    Rows,
    Shuffled,
}

/// A grid of quads, with other faces between any of its vertices, in up to three materials that follow each other. The
/// last material is transparent.
fn model(random: &mut SmallRng, quads: [u32; 2], others: u32, order: Order) -> Model {
    let [rows, columns] = quads;
    let count = (rows + 1) * (columns + 1);
    let mut numbers: Vec<u32> = (1..=count).collect();
    let mut faces: Vec<[u32; 3]> = (0..rows * columns)
        .flat_map(|at| {
            let first = at / columns * (columns + 1) + at % columns;
            let [a, b, c, d] = [first, first + 1, first + columns + 1, first + columns + 2];
            [[a, b, c], [c, b, d]]
        })
        .collect();
    faces.extend((0..others).map(|_| [0; 3].map(|_| random.random_range(0..count))));
    if order == Order::Shuffled {
        numbers.shuffle(random);
        faces.shuffle(random);
    }
    let mut text = String::from("mtllib a.mtl\n");
    for at in 0..count {
        let [x, y] = [at / (columns + 1), at % (columns + 1)];
        _ = writeln!(
            text,
            "v {x} {y} 0 0.{:02} 0 0\nvt {at} 0\nvn 1 {at} 0",
            at % 100
        );
    }
    let mut starts = [0; 3].map(|_| random.random_range(0..=2 * faces.len()));
    starts.sort_unstable();
    for (at, face) in faces.iter().enumerate() {
        for (start, name) in starts.iter().zip(["wood", "iron", "glass"]) {
            if *start == at {
                _ = writeln!(text, "usemtl {name}");
            }
        }
        let [a, b, c] = face.map(|at| {
            let own = random.random_range(1..=count);
            format!("{0}/{own}/{0}", numbers[at as usize])
        });
        _ = writeln!(text, "f {a} {b} {c}");
    }
    let materials = "newmtl wood\nnewmtl iron\nnewmtl glass\nd 0.5\n";
    read(&[("a.obj", &*text), ("a.mtl", materials)]).unwrap()
}

fn lists(model: &Model, file_order: bool) -> Lists {
    let options = Options {
        file_order,
        ..Options::default()
    };
    model.lists(&options).unwrap()
}

/// A corner's position, texture coordinate, normal and color.
type Values = ([i32; 3], [i32; 2], [i32; 3], [u8; 3]);

/// The values at the three corners of each face.
fn corners(lists: &Lists) -> Vec<[Values; 3]> {
    let own = |faces: &[[u16; 3]], at: usize, corner: usize| match faces {
        [] => lists.faces[at][corner] as usize,
        faces => faces[at][corner] as usize,
    };
    (0..lists.faces.len())
        .map(|at| {
            [0, 1, 2].map(|corner| {
                (
                    lists.positions[own(&[], at, corner)],
                    lists.uvs[own(&lists.uv_faces, at, corner)],
                    lists.normals[own(&lists.normal_faces, at, corner)],
                    lists.colors[own(&lists.color_faces, at, corner)],
                )
            })
        })
        .collect()
}

/// The ends of the edges.
fn edges(lists: &Lists) -> BTreeSet<[[i32; 3]; 2]> {
    let places = |edge: &[u16; 2]| {
        let mut ends = edge.map(|at| lists.positions[usize::from(at)]);
        ends.sort_unstable();
        ends
    };
    lists.edges.iter().map(places).collect()
}

/// How often a draw call projects vertices if it keeps 64 of them, each in a slot by its index.
fn projections(lists: &Lists) -> usize {
    let mut slots = [None; 64];
    let corners = lists.faces.as_flattened().iter();
    corners
        .filter(|&&at| slots[usize::from(at) % 64].replace(at) != Some(at))
        .count()
}

#[test]
fn faces_and_edges_stay_the_same_in_their_parts_and_are_projected_less() {
    for seed in 0..200 {
        let random = &mut SmallRng::seed_from_u64(seed);
        let quads = [random.random_range(1..20), random.random_range(1..20)];
        let order = [Order::Rows, Order::Shuffled][usize::from(seed % 4 > 0)];
        let others = random.random_range(0..40);
        let model = model(random, quads, others, order);
        let (before, after) = (lists(&model, true), lists(&model, false));
        assert!(projections(&after) <= projections(&before), "seed {seed}");
        assert_eq!(after, lists(&model, false), "seed {seed}");
        assert_eq!(edges(&after), edges(&before), "seed {seed}");
        assert!(after.edges.is_sorted_by(|a, b| a < b), "seed {seed}");
        let [mut before, mut after] = [before, after].map(|lists| corners(&lists));
        for run in model.runs() {
            let [start, end] = run.faces;
            let is_opaque = run.material != Some(2);
            for faces in [&mut before, &mut after] {
                faces[start..end].sort_unstable_by_key(|face| is_opaque.then_some(*face));
            }
        }
        assert_eq!(after, before, "seed {seed}");
    }
}

/// Any order of the faces of a grid takes at least one projection for each vertex.
#[test]
fn a_shuffled_grid_takes_a_fifth_more_projections_than_it_has_vertices() {
    for seed in 0..8 {
        let random = &mut SmallRng::seed_from_u64(seed);
        let mut model = model(random, [40, 50], 0, Order::Shuffled);
        for triangle in &mut model.triangles {
            triangle.material = None;
        }
        let (before, after) = (lists(&model, true), lists(&model, false));
        assert!(projections(&before) > 5 * before.positions.len());
        let (count, vertices) = (projections(&after), after.positions.len());
        assert!(
            5 * count <= 6 * vertices,
            "seed {seed}: {count} for {vertices}"
        );
    }
}

#[test]
fn an_order_that_cannot_be_better_is_kept() {
    for columns in [5, 20, 50] {
        let random = &mut SmallRng::seed_from_u64(1);
        let model = model(random, [20, columns], 0, Order::Rows);
        assert_eq!(lists(&model, false), lists(&model, true));
    }
}

/// Two poses of one model can be keyframes.
#[test]
fn models_with_the_same_faces_get_the_same_order() {
    let random = &mut SmallRng::seed_from_u64(1);
    let mut model = model(random, [20, 20], 20, Order::Shuffled);
    let first = lists(&model, false);
    for [x, y, z] in &mut model.positions {
        (*x, *y, *z) = (*y, -*x, 5.0 + *x * *y);
    }
    let second = lists(&model, false);
    assert_ne!(
        (&first.faces, &first.positions),
        (&lists(&model, true).faces, &second.positions)
    );
    assert_eq!(
        (first.faces, first.uv_faces),
        (second.faces, second.uv_faces)
    );
    assert_eq!(first.edges, second.edges);
}
