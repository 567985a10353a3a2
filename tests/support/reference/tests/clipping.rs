//! Polygons and segments clipped to planes.

use super::*;
use clip::*;

fn vertex<const N: usize>(position: [f64; 4], attributes: [f64; N]) -> ClipVertex<N> {
    ClipVertex {
        position,
        attributes,
        source: Some(0),
    }
}

#[test]
fn a_corner_behind_the_near_plane_becomes_two() {
    // Two corners are inside the near plane by 1, and one corner is outside by 1, so the new corners are halfway
    // between them.
    let inside = polygon(
        &[
            vertex([0., 0., 0., 1.], [0.]),
            vertex([1., 0., 0., 1.], [2.]),
            vertex([0., 1., -2., 1.], [8.]),
        ],
        &DEPTH_PLANES,
    );
    let cut = |position, attribute| ClipVertex {
        source: None,
        ..vertex(position, [attribute])
    };
    let expected = [
        cut([0., 0.5, -1., 1.], 4.),
        vertex([0., 0., 0., 1.], [0.]),
        vertex([1., 0., 0., 1.], [2.]),
        cut([0.5, 0.5, -1., 1.], 5.),
    ];
    assert_eq!(inside, expected);
    assert_eq!(fan(&inside).len(), 2);
}

#[test]
fn polygons_inside_stay_and_polygons_outside_vanish() {
    let triangle = [[0., 0., 0., 1.], [1., 0., 0., 1.], [0., -1., 1., 1.]];
    let whole = triangle.map(|p| vertex(p, []));
    assert_eq!(polygon(&whole, &ALL_PLANES), whole);
    let behind = triangle.map(|[x, y, _, w]| vertex([x, y, -2., w], []));
    assert_eq!(polygon(&behind, &ALL_PLANES), []);
    assert!(fan::<0>(&[]).is_empty());
}

#[test]
fn a_large_triangle_is_clipped_to_the_view() {
    // The visible part of the plane z = 0 is a square.
    let big = [[-9., -9., 0., 1.], [9., -9., 0., 1.], [0., 9., 0., 1.]];
    let inside = polygon(&big.map(|p| vertex(p, [p[0], p[1]])), &ALL_PLANES);
    assert_eq!(inside.len(), 4);
    for v in inside {
        close([v.position[0].abs(), v.position[1].abs()], [1., 1.]);
        close(v.attributes, [v.position[0], v.position[1]]);
    }
}

#[test]
fn triangles_that_share_an_edge_clip_it_alike() {
    let mut random = Random(1);
    let mut number = || f64::from(random.range(-1000, 1000)) / 300.;
    for _ in 0..1000 {
        let ends = [(); 2].map(|()| vertex([(); 4].map(|()| number()), [number()]));
        let [a, b] = ends;
        let forth = segment(ends, &[NEAR]);
        let back = segment([b, a], &[NEAR]).map(|[b, a]| [a, b]);
        assert_eq!(forth, back);
        for end in forth.iter().flatten() {
            assert!(side(&NEAR, &end.position) > -EPSILON);
        }
    }
}
