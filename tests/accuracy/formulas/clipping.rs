//! Edges that reach through the near plane.

use std::array::from_fn;

use embedded_graphics::pixelcolor::BinaryColor;
use fixel::Window;
use fixel::prelude::*;
use rand::Rng;

use support::counter::{BOTH_SIDES, Counter};
use support::moves::exact;
use support::random::{cases, within};
use support::reference::distance::to_segment;

use super::helpers::{assert_row, close, digits, vec};

const SIZE: u32 = 64;

/// The part of an edge that is drawn ends at t = (w₀ − n)/(w₀ − w₁).
#[test]
fn an_edge_is_cut_at_its_fraction() {
    cases(256, |random| {
        // The first end and a point in the near plane, n = 1, are in view.
        let w = random.random_range(1.5..8.0);
        let [x, y, u, v] = within(random, [-0.9..0.9, -0.9..0.9, -0.9..0.9, -0.9..0.9]);
        let (inside, on_plane) = ([x * w, y * w, -w], [u, v, -1.0]);
        // The second end lies beyond the plane, and mostly behind the eye.
        let beyond = random.random_range(0.1..3.0);
        let outside: [f64; 3] = from_fn(|i| on_plane[i] + beyond * (on_plane[i] - inside[i]));
        let ends = [inside, outside].map(|[x, y, z]| vec(x, y, z));

        let [from, to] = ends.map(exact);
        let t = (-from[2] - 1.0) / (-from[2] + to[2]);
        let corner: [f64; 3] = from_fn(|i| from[i] + t * (to[i] - from[i]));
        close(corner[2], -1.0, 1e-12);

        let edge = Mesh::new(&ends, &[])
            .unwrap()
            .with_edges(&[[0, 1]])
            .unwrap();
        let window = Window::centered(fx!(2), fx!(2));
        let projection = Projection::frustum(window, fx!(1), fx!(9)).unwrap();
        let mut pixels = [BinaryColor::Off; (SIZE * SIZE) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
        canvas.draw(
            edge.edges(LineStyle::HAIRLINE),
            &projection,
            &Flat::new(BinaryColor::On),
        );
        let place = |[x, y, z]: [f64; 3]| [32.0 * (1.0 - x / z), 32.0 * (1.0 + y / z)];
        let shown = [place(from), place(corner)];
        let drawn: Vec<[f64; 2]> = (0..SIZE * SIZE)
            .filter(|&at| pixels[at as usize].is_on())
            .map(|at| [f64::from(at % SIZE) + 0.5, f64::from(at / SIZE) + 0.5])
            .collect();
        // A hairline has the pixels that contain its ends, whose centers are at most √½ away. Its other pixels have
        // centers at most half a pixel away. Corners are rounded to 1/256 pixel.
        let slack = 0.5_f64.sqrt() + 1.0 / 256.0;
        for &center in &drawn {
            assert!(
                to_segment(shown[0], shown[1], center) <= slack,
                "{center:?} of {shown:?}"
            );
        }
        // The pixel of an end's row or column has its center at most half a pixel away along the longer axis, and half a
        // pixel from the line, which moves by at most half a pixel over that distance.
        let slack = 1.25_f64.sqrt() + 1.0 / 256.0;
        for end in shown {
            let near = |center: &[f64; 2]| (center[0] - end[0]).hypot(center[1] - end[1]);
            assert!(drawn.iter().any(|center| near(center) <= slack), "{end:?}");
        }
    });
}

/// Two triangles walk the edge that they share, and that the near plane cuts, in opposite directions. Together, they have
/// each pixel once, and leave out no pixel between them.
#[test]
fn triangles_that_share_a_cut_edge_leave_no_gap() {
    cases(512, |random| {
        // A point ahead and a point behind; then a corner far to the left and a corner far to the right.
        let mut end = |z: f64| {
            let [x, y] = within(random, [-1.0..1.0, -1.0..1.0]);
            vec(x, y, z)
        };
        let (ahead, behind) = (end(-3.0), end(2.0));
        let corners = [ahead, behind, vec3!(-90, 1, -2), vec3!(90, -1, -2)];
        let window = Window::centered(fx!(2), fx!(2));
        let projection = Projection::frustum(window, fx!(1), fx!(900)).unwrap();
        let mut counter = Counter::new((SIZE, SIZE));
        let mut count = |faces: &[[u16; 3]]| {
            let mesh = Mesh::new(&corners, faces).unwrap();
            let drawn = counter.draw(&BOTH_SIDES, &mesh, &projection.into());
            assert_eq!(drawn.clipped as usize, faces.len());
            counter.take()
        };
        let [left, right] = [count(&[[0, 1, 2]]), count(&[[1, 0, 3]])];
        let both = count(&[[0, 1, 2], [1, 0, 3]]);
        let width = SIZE as usize;
        for (row, counts) in both.chunks(width).enumerate() {
            let has = |side: &[u32]| side[row * width..][..width].contains(&1);
            if has(&left) && has(&right) {
                let runs: Vec<_> = counts
                    .split(|&count| count == 0)
                    .filter(|run| !run.is_empty())
                    .collect();
                assert_eq!(runs.len(), 1, "row {row} of {corners:?}: {counts:?}");
                assert!(
                    runs[0].iter().all(|&count| count == 1),
                    "row {row}: {counts:?}"
                );
            }
        }
    });
}

/// With rounding, a cut depends on the end from which it is computed.
#[test]
fn the_guides_table_of_a_cut() {
    let page = include_str!("../../../src/guide/mathematics/clipping.rs");
    for (name, from, to, distances) in [
        ("the inside end", 0_i32, 1000, [1, 2]),
        ("the outside end", 1000, 0, [2, 1]),
    ] {
        // Rounded down, in units of 1/256.
        let t = (256 * distances[0]) / (distances[0] + distances[1]);
        let step = ((to - from) * t).div_euclid(256);
        let row = [
            name.into(),
            format!("{t}/256"),
            digits(step.into(), 0),
            (from + step).to_string(),
        ];
        assert_row(page, &row);
    }
}
