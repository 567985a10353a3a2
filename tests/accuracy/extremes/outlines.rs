//! Triangles that all six planes clip: outlines of nine corners.
//!
//! A plane through the view volume can cut all six sides of the volume. The cut is a hexagon. A triangle in that plane
//! can cut off three corners of the hexagon. The bounds are the same as in [`planes`](super::planes).

use std::f64::consts::TAU;

use fixel::prelude::*;

use super::scene::{Corners, ONCE, Random, TriangleView};
use super::table::{Cases, picture};
use super::verdict::Verdict;

/// The focal length is 2000 pixels and the guard band is ±2048 pixels, so at a distance of w from the eye, the guard
/// band reaches about w to each side. The near and far planes are at 1 and 2.
fn view(viewport: Viewport) -> TriangleView {
    TriangleView {
        size: (64, 64),
        focal: 2000.,
        near: 1.,
        far: 2.,
        viewport: Some(viewport),
        moves: Vec::new(),
    }
}

/// A triangle in the plane x + y = 2w − 3, around the middle of its hexagon.
fn triangle(random: &mut Random) -> Corners {
    let turn = random.next();
    [0., 1., 2.].map(|third: f64| {
        let (sin, cos) = ((turn + third / 3.) * TAU).sin_cos();
        let reach = random.between(1.1, 2.);
        let (x, w) = (1.5 * reach * cos, 1.5 + 0.5 * reach * sin);
        [x, 2. * w - 3. - x, -w]
    })
}

/// Draws ten triangles that become polygons of nine corners when they are clipped. Each of the nine corners in turn is
/// on the canvas.
fn nine_corners() -> Verdict {
    let mut random = Random(14);
    let mut verdict = Verdict::default();
    let mut found = 0;
    while found < 10 {
        let corners = triangle(&mut random);
        let whole = view(Viewport::new(0, 0, 4096, 4096).unwrap()).scene(corners, ONCE);
        let pieces = whole.pieces();
        // Nine corners make a fan of seven triangles.
        if pieces.len() < 7 {
            continue;
        }
        found += 1;
        for [x, y] in pieces.iter().flat_map(|piece| piece.screen) {
            // The viewport moves the corner to the middle of the canvas.
            let [x, y] = [x, y].map(|at| 32 - at as i32);
            let viewport = Viewport::new(x, y, 4096, 4096).unwrap();
            verdict.merge(view(viewport).scene(corners, ONCE).judge());
        }
    }
    verdict
}

pub static CASES: Cases = Cases::new(|| {
    vec![picture(
        "outlines of nine corners, clipped by all six planes",
        nine_corners(),
    )]
});

#[test]
fn all_corners_of_an_outline_are_there() {
    assert_eq!(CASES.len(), 1);
}
