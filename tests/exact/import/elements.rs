//! Faces and edges, and the elements they refer to.

use fixel::prelude::*;
use rand::Rng;

use super::reading::{SQUARE, ok};
use crate::common::random::{cases, list};

#[test]
fn polygon_becomes_fan_with_its_own_edges() {
    let mesh = ok(&format!("{SQUARE}v -1 0.5 0\nf 1 2 3 4 5"));
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(mesh.edges, [[0, 1], [0, 4], [1, 2], [2, 3], [3, 4]]);
}

#[test]
fn shared_edge_occurs_once() {
    let mesh = ok(&format!("{SQUARE}f 1 2 3\nf 1 3 4\nl 4 3 2\nl 2 4"));
    assert_eq!(mesh.edges, [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
}

/// Many edges that differ only in their last byte, listed twice and in reverse order.
#[test]
fn edges_around_a_hub_are_sorted() {
    let mut text = "v 0 0 0\n".repeat(601);
    for i in (2..=600).rev() {
        text += &format!("f 1 {i} {}\n", i + 1);
    }
    let spokes = (1..=600).map(|i| [0, i]);
    let rim = (1..600).map(|i| [i, i + 1]);
    assert_eq!(ok(&text).edges, spokes.chain(rim).collect::<Vec<_>>());
}

#[test]
fn negative_indices_count_back_from_their_line() {
    let expected = ok(&format!("{SQUARE}f 1 2 3\nf 1 3 4"));
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1";
    assert_eq!(ok(text), expected);
}

#[test]
fn positive_index_may_refer_to_later_lines() {
    assert_eq!(
        ok(&format!("f 1 2 3 4\n{SQUARE}")),
        ok(&format!("{SQUARE}f 1 2 3 4"))
    );
}

/// `include_mesh!` gives the same mesh as reading at run time.
#[test]
fn include_mesh_equals_reading_at_run_time() {
    static HOUSE: Mesh = include_mesh!("../../models/house.obj");
    let mesh = ok(include_str!("../../models/house.obj"));
    assert!(HOUSE.positions().iter().eq(mesh.positions.iter().copied()));
    assert_eq!(HOUSE.faces(), mesh.faces);
    // Euler's formula: 10 corners and 7 polygons, including the ground, have 15 edges; the antenna adds one.
    assert_eq!(HOUSE.edges(), mesh.edges);
    assert_eq!(mesh.edges.len(), 15 + 1);
    assert!(HOUSE.has_uvs());
}

/// The polygons' edges are sorted, and each occurs once.
#[test]
fn edges_are_a_sorted_set() {
    cases(256, |random| {
        let mut text = "v 0 0 0\n".repeat(400);
        let mut expected = std::collections::BTreeSet::new();
        for _ in 0..random.random_range(1..300) {
            let polygon = list(random, 3..6, |random| random.random_range(0..400_u16));
            text += "f";
            for (i, &a) in polygon.iter().enumerate() {
                let b = polygon[(i + 1) % polygon.len()];
                text += &format!(" {}", a + 1);
                if a != b {
                    expected.insert([a.min(b), a.max(b)]);
                }
            }
            text += "\n";
        }
        assert_eq!(ok(&text).edges, expected.into_iter().collect::<Vec<_>>());
    });
}
