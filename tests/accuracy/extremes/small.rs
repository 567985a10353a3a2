//! Triangles with little area, or none.
//!
//! Corners are snapped to 1/256 pixel. With the snapped corners, coverage is exact and values are within the bounds of
//! the formats, however thin the triangle is.

use std::f64::consts::TAU;

use fixel::prelude::*;

use super::scene::{ONCE, Random, TriangleView, worst};
use super::table::{Cases, picture};
use super::verdict::Verdict;
use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};

/// Triangles at every slope, 5 to 100 pixels long and `width` pixels wide at their middle.
fn slivers(width: f64) -> Verdict {
    let view = TriangleView::ROOM;
    let mut random = Random(6);
    worst((0..120).map(|step| {
        let (sin, cos) = (f64::from(step) / 120. * TAU).sin_cos();
        let half = random.between(2.5, 50.);
        let middle = [random.between(-10., 10.), random.between(-8., 8.)];
        let at = |along: f64, across: f64, w: f64| {
            let [x, y] = middle;
            view.at(
                [
                    x + along * cos - across * sin,
                    y + along * sin + across * cos,
                ],
                w,
            )
        };
        let between = random.between(-half, half);
        let corners = [
            at(-half, 0., random.between(1., 4.)),
            at(half, 0., random.between(1., 4.)),
            at(between, width, random.between(1., 4.)),
        ];
        view.scene(corners, ONCE).judge()
    }))
}

/// Triangles smaller than a pixel.
fn specks() -> Verdict {
    let view = TriangleView::ROOM;
    let mut random = Random(7);
    worst((0..2000).map(|_| {
        let at = [random.between(-40., 40.), random.between(-30., 30.)];
        let mut corner = || {
            let away = [random.between(-0.7, 0.7), random.between(-0.7, 0.7)];
            view.at([at[0] + away[0], at[1] + away[1]], random.between(1., 4.))
        };
        view.scene([corner(), corner(), corner()], ONCE).judge()
    }))
}

pub static CASES: Cases = Cases::new(|| {
    vec![
        picture("slivers 1 pixel wide", slivers(1.)),
        picture("slivers 1/4 pixel wide", slivers(0.25)),
        picture("slivers 1/16 pixel wide", slivers(1. / 16.)),
        picture("triangles within a pixel", specks()),
    ]
});

#[test]
fn errors_of_thin_triangles_are_within_their_bounds() {
    assert_eq!(CASES.len(), 4);
}

const SIZE: (u32, u32) = (24, 24);

/// The number of pixels that triangles cover, and the number of triangles reported as drawn. Corners are in 24.8.
fn drawn(triangles: &[[[i32; 2]; 3]]) -> (usize, u32) {
    let positions: Vec<Vec3> = triangles
        .iter()
        .flatten()
        .copied()
        .map(at_subpixel)
        .collect();
    let faces: Vec<[u16; 3]> = (0..u16::try_from(triangles.len()).unwrap())
        .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
        .collect();
    let mut counter = Counter::new(SIZE);
    let mesh = Mesh::new(&positions, &faces).unwrap();
    let drawn = counter.draw(&BOTH_SIDES, &mesh, &pixel_projection(SIZE));
    let pixels = counter
        .take()
        .into_iter()
        .filter(|&count| count > 0)
        .count();
    (pixels, drawn.drawn)
}

/// Three corners lie on a line. The lines have every slope between positions that are an eighth of a pixel apart.
#[test]
fn corners_in_a_line_draw_nothing() {
    let mut triangles = Vec::new();
    for dx in -24..=24 {
        for dy in -24..=24 {
            for (first, second) in [(1, 3), (-2, 1), (0, 2), (3, 3)] {
                // The first origin is on a pixel center, where the top-left rule decides. The second origin is beside
                // the center.
                for origin in [[3200, 2944], [3000, 3001]] {
                    let at =
                        |times: i32| [origin[0] + 32 * dx * times, origin[1] + 32 * dy * times];
                    triangles.push([at(0), at(first), at(second)]);
                }
            }
        }
    }
    for triangles in triangles.chunks(20_000) {
        assert_eq!(drawn(triangles), (0, 0));
    }
}

/// Two or three corners of a triangle are the same vertex, or different vertices at the same position.
#[test]
fn corners_in_one_place_draw_nothing() {
    let places = [[128, 128], [1000, 2000], [3333, 17]];
    let twice = places
        .iter()
        .flat_map(|&a| places.map(|b| [[a, a, b], [a, b, a], [b, a, a]]));
    let all: Vec<_> = twice.flatten().collect();
    assert_eq!(drawn(&all), (0, 0));
    let positions = places.map(at_subpixel);
    let faces = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [2, 2, 2]];
    let mut counter = Counter::new(SIZE);
    let mesh = Mesh::new(&positions, &faces).unwrap();
    assert_eq!(
        counter
            .draw(&BOTH_SIDES, &mesh, &pixel_projection(SIZE))
            .drawn,
        0
    );
}

/// All vertices of the largest mesh have the same position.
#[test]
fn the_largest_mesh_in_one_place_draws_only_points() {
    for place in [
        Vec3::ZERO,
        vec3!(0, 0, -2),
        Vec3::from_bits([i32::MAX; 3]),
        Vec3::from_bits([i32::MIN; 3]),
    ] {
        let positions = vec![place; 65_536];
        let faces: Vec<[u16; 3]> = (0..65_534).map(|i| [i, i + 1, i + 2]).collect();
        let edges: Vec<[u16; 2]> = (0..65_535).map(|i| [i, i + 1]).collect();
        let mesh = Mesh::new(&positions, &faces)
            .unwrap()
            .with_edges(&edges)
            .unwrap();
        let projection = Projection::perspective(Angle::from_degrees(60), SIZE, fx!(0.1), fx!(100));
        let mvp = projection.unwrap().into();
        let mut counter = Counter::new(SIZE);
        assert_eq!(counter.draw(&BOTH_SIDES, &mesh, &mvp).drawn, 0);
        counter.draw_edges(&DrawOptions::new(), &mesh, &mvp);
        // A line without length is drawn as a point.
        let seen: u32 = if place == vec3!(0, 0, -2) { 65_535 } else { 0 };
        assert_eq!(counter.take().iter().copied().max(), Some(seen));
        counter.draw_points(&DrawOptions::new(), &mesh, &mvp);
        let counts = counter.take();
        // If the position is in front of the eye, every point is drawn, and all points are in the same pixel.
        let seen: u32 = if place == vec3!(0, 0, -2) { 65_536 } else { 0 };
        assert_eq!(counts.iter().copied().max(), Some(seen));
        assert_eq!(counts.iter().sum::<u32>(), seen);
    }
}
