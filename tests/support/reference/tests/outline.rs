//! Positions relative to the outline of a union of triangles.

use super::*;
use silhouette::{Position::*, Silhouette};

fn rectangle(left: f64, top: f64, right: f64, bottom: f64) -> [Corners; 2] {
    let [a, b, c, d] = [[left, top], [right, top], [right, bottom], [left, bottom]];
    [[a, b, c], [a, d, c]]
}

#[test]
fn positions_around_a_square_are_classified() {
    let square = Silhouette::new(&rectangle(2., 2., 12., 12.), 16, 16);
    for (p, d, place) in [
        ([7., 7.], 0.5, Inside), // on the diagonal, which is not a contour edge
        ([2.3, 7.], 0.25, Inside),
        ([2.2, 7.], 0.25, Near),
        ([1.8, 7.], 0.25, Near),
        ([1.7, 7.], 0.25, Outside),
        // The distance to the corner is 0.2·√2 = 0.283.
        ([1.8, 1.8], 0.28, Outside),
        ([1.8, 1.8], 0.29, Near),
    ] {
        assert_eq!(square.classify(p, d), place, "{p:?} {d}");
    }
    assert!(square.contour_within([2.2, 7.], 0.25));
    assert!(!square.contour_within([7., 7.], 0.25));
}

#[test]
fn an_edge_in_front_of_another_surface_is_not_part_of_the_outline() {
    let two = [rectangle(2., 2., 8., 8.), rectangle(5., 4., 14., 6.)].concat();
    let two = Silhouette::new(&two, 16, 16);
    // The left edge of the right rectangle lies inside the left rectangle. The right edge of the left rectangle lies
    // only partly inside the right rectangle.
    assert_eq!(two.classify([5., 5.], 0.5), Inside);
    assert_eq!(two.classify([8., 5.], 0.5), Inside);
    assert_eq!(two.classify([7.9, 4.3], 0.25), Inside);
    assert_eq!(two.classify([7.9, 4.2], 0.25), Near);
    assert!(two.contour_within([5., 5.], 0.5));
}

#[test]
fn surfaces_that_touch_are_one() {
    // A T-junction: a long edge touches two short edges.
    let touching = [
        rectangle(2., 2., 8., 12.),
        rectangle(8., 2., 14., 7.3),
        rectangle(8., 7.3, 14., 12.),
    ];
    let touching = Silhouette::new(&touching.concat(), 16, 16);
    assert_eq!(touching.classify([8., 7.3], 0.5), Inside);
    assert_eq!(touching.classify([8.1, 5.], 0.5), Inside);
    // A second copy of a square does not cover the outline of the first copy.
    let twice = [rectangle(2., 2., 8., 8.); 2].concat();
    let twice = Silhouette::new(&twice, 16, 16);
    assert_eq!(twice.classify([2.1, 5.], 0.25), Near);
}

#[test]
fn positions_around_a_torus_agree_with_sampling() {
    // The test takes many points of a small disc around each center. Either all of these points are in the union, or
    // none, or some.
    let torus = Torus::new(40, 20);
    let d = 0.4;
    let pieces = raster::culled(
        raster::pieces(&torus.mesh(), &Torus::view((64, 48))),
        raster::Cull::Back,
    );
    let triangles: Vec<_> = pieces.iter().map(|piece| piece.screen).collect();
    let outline = Silhouette::new(&triangles, 64, 48);
    let mut hidden = 0;
    let mut found = [0; 3];
    for pixel in Bounds::new(64, 48).pixels() {
        let p = center(pixel);
        let place = outline.classify(p, d);
        found[place as usize] += 1;
        hidden += u32::from(place == Inside && outline.contour_within(p, d));
        let near: Vec<_> = triangles
            .iter()
            .filter(|t| distance::to_triangle(t, p) <= d)
            .collect();
        let near = &near;
        let in_union = |radius: f64| {
            (0..64).filter(move |&i| {
                let (s, c) = (f64::from(i) / 64. * std::f64::consts::TAU).sin_cos();
                let q = [p[0] + radius * c, p[1] + radius * s];
                near.iter().any(|t| distance::to_triangle(t, q) < EPSILON)
            })
        };
        let counts = [0.01, 0.33, 0.66, 0.99].map(|part| in_union(part * d).count());
        match place {
            Inside => assert_eq!(counts, [64; 4], "{p:?}"),
            Outside => assert_eq!(counts, [0; 4], "{p:?}"),
            // The samples can miss triangles that barely reach into the disc.
            Near => {
                let all = counts == [64; 4] || counts == [0; 4];
                let sure = outline.classify(p, d * 0.9) == Near;
                assert!(!(all && sure), "{p:?}");
            }
        }
    }
    // Each case has occurred, including surfaces that end in front of other surfaces.
    assert!(
        found.iter().all(|&n| n > 50) && hidden > 10,
        "{found:?} {hidden}"
    );
}
