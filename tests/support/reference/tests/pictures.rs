//! Pictures of whole meshes.

use super::*;
use raster::*;

/// A view of 8x8 pixels with a focal length of 8: at distance 1, one unit is 8 pixels.
fn view() -> view::View {
    view::View {
        eye: linear::IDENTITY,
        projection: projection::focal(8., (8, 8), 0.25, 8.),
        viewport: view::Viewport::new(8, 8),
    }
}

/// A square from `low` to `high` that faces the eye at this distance. The attributes of the square are x and y.
fn square(low: [f64; 2], high: [f64; 2], distance: f64) -> ([[f64; 3]; 4], [[[f64; 2]; 3]; 2]) {
    let [a, b, c, d] = [low, [high[0], low[1]], high, [low[0], high[1]]];
    (
        [a, b, c, d].map(|[x, y]| [x, y, -distance]),
        [[a, b, c], [a, c, d]],
    )
}

const FACES: [[usize; 3]; 4] = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];

#[test]
fn the_nearer_surface_shows() {
    // The square from −0.25 to 0.25 at distance 1 covers pixels 2..6. The square from −1 to 0 at distance 2 covers
    // pixels 0..4 of the lower rows.
    let (near, near_uv) = square([-0.25; 2], [0.25; 2], 1.);
    let (far, far_uv) = square([-1.; 2], [0.; 2], 2.);
    let mesh = Mesh {
        positions: &[near, far].concat(),
        faces: &FACES,
        attributes: &[near_uv, far_uv].concat(),
    };
    let (pieces, picture) = draw(&mesh, &view(), Cull::Back, 0.);
    assert_eq!(pieces.len(), 4);
    assert_eq!(
        coverage::picture(&picture.counts(), 8),
        [
            "........", "........", "..1111..", "..1111..", "112211..", "112211..", "1111....",
            "1111...."
        ]
    );
    let both = picture.nearest([3, 4]).unwrap();
    assert!(both.face < 2);
    // Pixel (3, 4) is at x = −½/8, y = −½/8, and a pixel is 1/8 wide there.
    close(both.value.attributes, [-0.0625, -0.0625]);
    close(both.value.dx, [0.125, 0.]);
    close(both.value.dy, [0., -0.125]);
    close(
        [both.distance, both.value.w, both.depth],
        [1., 1., 65535. / 4.],
    );
    let hidden = &picture.at([3, 4])[1];
    close(hidden.value.attributes, [-0.125, -0.125]);
    close([hidden.depth], [65535. / 8.]);
    assert_eq!(picture.candidates([3, 4], 1.).count(), 1);
    assert_eq!(picture.candidates([3, 4], 8192.).count(), 2);
    assert_eq!(picture.nearest([7, 7]), None);
    // The whole mesh faces the eye.
    assert!(draw(&mesh, &view(), Cull::Front, 0.).0.is_empty());
}

#[test]
fn a_margin_finds_neighbors() {
    let (positions, attributes) = square([-0.25; 2], [0.25; 2], 1.);
    let mesh = Mesh {
        positions: &positions,
        faces: &FACES[..2],
        attributes: &attributes,
    };
    let (_, picture) = draw(&mesh, &view(), Cull::Back, 0.6);
    // The pixel's center is half a pixel outside the surface. The surface is extended in its plane.
    let hit = picture.candidates([1, 3], 0.).next().unwrap();
    close([hit.gap], [0.5]);
    close(hit.value.attributes, [-0.3125, 0.0625]);
    assert_eq!(picture.nearest([1, 3]), None);
    // One triangle owns a center on the diagonal. The other triangle is a neighbor at distance 0.
    let on = picture.at([3, 4]);
    assert_eq!(on.iter().filter(|hit| hit.gap == 0.).count(), 1);
    assert_eq!(on.len(), 2);
}

#[test]
fn given_snapped_corners_are_used_unchanged() {
    let (positions, attributes) = square([-0.25; 2], [0.25; 2], 1.);
    let mesh = Mesh {
        positions: &positions,
        faces: &FACES[..2],
        attributes: &attributes,
    };
    let view = view();
    let snapped = pieces(&mesh, &view)
        .into_iter()
        // Move each corner one pixel to the right of its own position, which is found by its index.
        .map(|piece| {
            piece.snap(|source, _| {
                let [x, y] = view::snap(view.project(positions[source.unwrap()]).screen);
                [x + 256, y]
            })
        })
        .collect();
    let pieces = culled(snapped, Cull::Back);
    let picture = render(&pieces, &view.projection, view.viewport, (8, 8), 0.);
    assert_eq!(picture.counts().iter().sum::<u32>(), 16);
    // Pixel (2, 2) had this value before the move.
    close(
        picture.nearest([3, 2]).unwrap().value.attributes,
        [-0.1875, 0.1875],
    );
}

#[test]
fn a_floor_is_clipped_to_the_near_plane() {
    // The floor y = −1 reaches from behind the eye to z = −4, and u = −z. At y on the screen, its distance is 8/(y −
    // 4).
    let positions = [
        [-9., -1., 4.],
        [9., -1., 4.],
        [9., -1., -4.],
        [-9., -1., -4.],
    ];
    let uv = positions.map(|[_, _, z]| [-z]);
    let mesh = Mesh {
        positions: &positions,
        faces: &FACES[..2],
        attributes: &[[uv[0], uv[1], uv[2]], [uv[0], uv[2], uv[3]]],
    };
    let (pieces, picture) = draw(&mesh, &view(), Cull::Back, 0.);
    assert!(pieces.iter().any(|p| p.sources.contains(&None)));
    for y in 0..8 {
        for x in 0..8 {
            let hits = picture.at([x, y]);
            // The far edge is at row 4 + 8/4.
            assert_eq!(hits.len(), usize::from(y >= 6), "{x} {y}");
            for hit in hits {
                let from_horizon = f64::from(y) + 0.5 - 4.;
                close([hit.distance], [8. / from_horizon]);
                close(hit.value.attributes, [8. / from_horizon]);
                close(hit.value.dy, [-8. / from_horizon.powi(2)]);
            }
        }
    }
}

#[test]
fn parallel_rays_have_linear_depth() {
    let view = view::View {
        eye: linear::IDENTITY,
        projection: projection::orthographic(-4., 4., -4., 4., 2., 10.),
        viewport: view::Viewport {
            x: 1,
            ..view::Viewport::new(8, 8)
        },
    };
    // A slope from 3 ahead at x = −8 to 11 ahead at x = 8, over the whole picture and beyond the far plane.
    let positions = [
        [-8., -8., -3.],
        [8., -8., -11.],
        [8., 8., -11.],
        [-8., 8., -3.],
    ];
    let mesh = Mesh {
        positions: &positions,
        faces: &FACES[..2],
        attributes: &[[[]; 3]; 2],
    };
    let (_, picture) = draw(&mesh, &view, Cull::Back, 0.);
    assert!(picture.at([0, 3]).is_empty()); // outside the viewport
    for x in 0..8 {
        let hit = picture.nearest([x + 1, 3]).unwrap();
        let distance = 7. + (f64::from(x) - 3.5) / 2.;
        close([hit.distance, hit.value.w], [distance, 1.]);
        close([hit.depth], [65535. * (10. - distance) / 8.]);
    }
}

#[test]
fn a_torus_has_no_seams() {
    // The torus has 6,000 triangles, and the picture has the size of the measured scenes.
    let torus = Torus::new(60, 50);
    let size = (320, 240);
    let view = Torus::view(size);
    let (pieces, picture) = draw(&torus.mesh(), &view, Cull::Back, 0.);
    let triangles: Vec<_> = pieces.iter().map(|piece| piece.screen).collect();
    let outline = silhouette::Silhouette::new(&triangles, size.0, size.1);
    for pixel in Bounds::new(size.0, size.1).pixels() {
        match outline.classify(center(pixel), 1. / 256.) {
            silhouette::Position::Inside => assert!(picture.nearest(pixel).is_some(), "{pixel:?}"),
            silhouette::Position::Outside => assert!(picture.at(pixel).is_empty(), "{pixel:?}"),
            silhouette::Position::Near => {}
        }
    }
    let counts = picture.counts();
    assert!(counts.contains(&2));
    // Each hit is at the point where the ray through the pixel's center meets the plane of the face.
    for [x, y] in Bounds::new(size.0, size.1).pixels() {
        for hit in picture.at([x, y]) {
            let [right, down] = center([x, y]).map(|at| hit.distance * at / 240.);
            let ray = [
                right - hit.distance * 160. / 240.,
                hit.distance * 0.5 - down,
                -hit.distance,
            ];
            let corners =
                torus.faces[hit.face].map(|i| linear::point(&view.eye, torus.positions[i]));
            let [a, b, c] = corners.map(|corner| linear::subtract(corner, ray));
            let weights = [(b, c), (c, a), (a, b)].map(|(one, other)| {
                linear::dot(
                    linear::cross(one, other),
                    linear::cross(linear::subtract(b, a), linear::subtract(c, a)),
                )
            });
            close([linear::dot(a, linear::cross(b, c))], [0.]);
            let all: f64 = weights.iter().sum();
            for k in 0..2 {
                let expected: f64 = (0..3)
                    .map(|i| weights[i] / all * torus.attributes[hit.face][i][k])
                    .sum();
                close([hit.value.attributes[k]], [expected]);
            }
        }
    }
    // After snapping, front faces overlap or leave gaps only within the distance by which contours move.
    let snapped = pieces
        .into_iter()
        .map(|piece| piece.snap(|_, clip| view::snap(view.on_screen(clip).screen)))
        .collect();
    let pieces = culled(snapped, Cull::Back);
    let snapped = render(&pieces, &view.projection, view.viewport, size, 0.).counts();
    for (pixel, (a, b)) in Bounds::new(size.0, size.1)
        .pixels()
        .zip(counts.into_iter().zip(snapped))
    {
        assert!(
            a == b || outline.contour_within(center(pixel), 1. / 256.),
            "{pixel:?}"
        );
    }
}
