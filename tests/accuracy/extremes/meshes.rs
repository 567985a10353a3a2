//! Meshes with the largest number of vertices.
//!
//! The bounds are the same as in [`planes`](super::planes).

use fixel::prelude::*;

use super::scene::{ONCE, Random, TriangleView};
use super::table::{Cases, picture};
use super::verdict::{Verdict, Worst};
use support::counter::{BOTH_SIDES, Counter};
use support::moves::{exact, rounded};

/// Columns and rows of vertices. The second grid has the largest number of vertices, and the first grid has one vertex
/// less.
const GRIDS: [(u16, u16); 2] = [(255, 257), (256, 256)];

/// A wavy rug, slightly tilted, in front of the eye. The rug reaches beyond all edges of the picture. Returns its
/// vertices, and the two triangles of each cell.
fn rug(columns: u16, rows: u16) -> (Vec<Vec3>, Vec<[u16; 3]>) {
    let mut random = Random(11);
    let view = TriangleView::ROOM;
    let mut positions = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let part = |at: u16, count: u16| f64::from(at) / f64::from(count - 1) * 2. - 1.;
            let (x, y) = (part(column, columns), part(row, rows));
            // Move each vertex by up to a quarter of a cell. A cell is 0.4 pixels wide.
            let mut aside = || random.between(-0.1, 0.1);
            let at = [52. * x + aside(), 40. * y + aside()];
            let w = 4. + x + 0.1 * (9. * x + 5. * y).sin();
            positions.push(rounded(view.at(at, w)));
        }
    }
    let mut faces = Vec::new();
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            let [a, b] = [row, row + 1].map(|row| row * columns + column);
            faces.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
        }
    }
    (positions, faces)
}

/// Checks the position of every vertex, and that every pixel is covered once.
fn covered_once((columns, rows): (u16, u16)) -> Verdict {
    let (positions, faces) = rug(columns, rows);
    assert!(positions.len() >= 65_535);
    let scene = TriangleView::ROOM.scene([[0., 0., -1.]; 3], ONCE);
    let mut counter = Counter::new(TriangleView::ROOM.size);
    let mut coverage = Worst::default();
    for &position in &positions {
        let place = counter.snapped(&scene.mvp, position).unwrap();
        let wanted = scene.view.project(exact(position)).screen;
        for (at, wanted) in place.into_iter().zip(wanted) {
            let error = (f64::from(at) / 256. - wanted).abs();
            // Coordinates are below 8, and distances at least 3.
            coverage.add(error, 1. / 512. + 1e-4, || format!("{position:?}"));
        }
    }
    let mesh = Mesh::new(&positions, &faces).unwrap();
    let drawn = counter.draw(&BOTH_SIDES, &mesh, &scene.mvp);
    let triangles = usize::try_from(drawn.submitted).unwrap();
    assert_eq!(triangles, faces.len());
    let counts = counter.take();
    assert!(
        counts.iter().all(|&count| count == 1),
        "a pixel is not drawn, or drawn twice"
    );
    Verdict {
        coverage,
        pixels: counts.len(),
        ..Verdict::default()
    }
}

pub static CASES: Cases = Cases::new(|| {
    GRIDS
        .map(|grid| {
            let vertices = u32::from(grid.0) * u32::from(grid.1);
            picture(&format!("mesh of {vertices} vertices"), covered_once(grid))
        })
        .into()
});

#[test]
fn the_largest_meshes_cover_each_pixel_once() {
    assert_eq!(CASES.len(), 2);
}

/// The first three and the last three vertices have the same positions. A triangle of the last three must be drawn like
/// a triangle of the first three.
#[test]
fn the_largest_indices_are_drawn_like_the_smallest() {
    let mut positions = vec![Vec3::ZERO; Mesh::MAX_POSITIONS];
    let corners = [
        vec3!(-0.4, -0.4, -1),
        vec3!(0.4, -0.4, -1),
        vec3!(0, 0.4, -1),
    ];
    positions[..3].copy_from_slice(&corners);
    positions[65_533..].copy_from_slice(&corners);
    let mvp = TriangleView::ROOM.scene([[0., 0., -1.]; 3], ONCE).mvp;
    let counts = [[0, 1, 2], [65_533, 65_534, 65_535]].map(|face| {
        let mut counter = Counter::new(TriangleView::ROOM.size);
        let faces = [face];
        let mesh = Mesh::new(&positions, &faces).unwrap();
        counter.draw(&BOTH_SIDES, &mesh, &mvp);
        counter.take()
    });
    assert_eq!(counts[0], counts[1]);
    assert!(counts[0].iter().sum::<u32>() > 100);
}
