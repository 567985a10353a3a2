//! The measured scenes: the number of faces that are kept, and the number of pixels that are covered.

use super::*;
use raster::*;

/// The number of faces that are kept, and the number of pixels that are covered.
fn count((shape, view): (scenes::Shape, view::View), cull: Cull) -> (usize, usize) {
    let (pieces, picture) = draw(&shape.mesh(), &view, cull, 0.);
    let counts = picture.counts();
    // The shapes are convex or flat, so no pixel is covered twice.
    assert!(counts.iter().all(|&n| n <= 1));
    (pieces.len(), counts.iter().filter(|&&n| n > 0).count())
}

#[test]
fn pixels_of_the_floor() {
    assert_eq!(count(scenes::floor(), Cull::Nothing), (2, 47_610));
}

#[test]
fn pixels_of_the_cube() {
    let pixels: usize = (0..scenes::POSES)
        .map(|pose| count(scenes::cube(pose), Cull::Back).1)
        .sum();
    assert_eq!((pixels + 4) / 8, 30_715);
}

#[test]
fn pixels_of_the_sphere() {
    assert_eq!(scenes::sphere(0).0.faces.len(), 1984);
    let (mut faces, mut pixels) = (0, 0);
    for pose in 0..scenes::POSES {
        let (f, p) = count(scenes::sphere(pose), Cull::Back);
        faces += f;
        pixels += p;
    }
    assert_eq!(((faces + 4) / 8, (pixels + 4) / 8), (632, 30_526));
}
