//! Picking compared with pictures. The face that a ray meets is the face that is drawn, except if the f64 model finds
//! that the pixel's center is too close to an edge, or that two faces are equally deep there.

use embedded_graphics::geometry::Point;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use fixel::{Hit, Window};
use rand::Rng;
use rand::seq::IndexedRandom;

use support::drawing::Drawing;
use support::mode::Mode;
use support::moves::{self, Move, exact, product, rounded};
use support::random::{Random, cases, list};
use support::reference::attributes::weights;
use support::reference::distance::to_segment;
use support::reference::projection::{self, Projection as ModelProjection};
use support::reference::view::{Projected, View, Viewport as ModelViewport};

const SIZE: (u32, u32) = (40, 30);
const LEFT: i32 = -7;
/// A distance from an edge in pixels, with a margin. Rounding moves a vertex by up to 1/512 pixel along both axes, so
/// it moves an edge by up to 0.0028 pixels.
const EDGE: f64 = 0.005;

/// The smallest and the largest depth of a face within [`EDGE`] of a position on the screen, in units of 1/65536.
fn depths(model: &ModelProjection, corners: &[Projected; 3], at: [f64; 2]) -> [f64; 2] {
    let screen = corners.map(|corner| corner.screen);
    let around = [-EDGE, EDGE];
    let found = around
        .into_iter()
        .flat_map(|x| around.map(|y| [at[0] + x, at[1] + y]))
        .filter_map(|at| {
            // Depth is linear on the screen.
            let weights = weights(&screen, at)?.value;
            Some(
                weights
                    .iter()
                    .zip(corners)
                    .map(|(w, corner)| w * model.depth(corner.distance))
                    .sum::<f64>(),
            )
        });
    found.fold([f64::MAX, f64::MIN], |[low, high], depth| {
        [low.min(depth), high.max(depth)]
    })
}

/// Checks that the numbers of a hit agree with each other and with the corners of its face.
fn check_numbers(hit: &Hit, ray: Ray, corners: [Vec3; 3]) {
    let sum: i32 = hit.barycentric.iter().map(|part| part.to_bits()).sum();
    assert_eq!(sum, 1 << 30, "{hit:?}");
    let parts = hit.barycentric.map(f64::from);
    let face = corners.map(exact);
    for (axis, found) in exact(hit.point).into_iter().enumerate() {
        let mix: f64 = parts
            .iter()
            .zip(face)
            .map(|(part, at)| part * at[axis])
            .sum();
        assert!(
            (mix - found).abs() <= 2_f64.powi(-16),
            "{hit:?}: {mix} along axis {axis}"
        );
    }
    let along = support::reference::linear::subtract(exact(hit.point), exact(ray.origin));
    let distance = support::reference::linear::length(along);
    assert!(
        (distance - f64::from(hit.distance)).abs() <= 2_f64.powi(-14),
        "{hit:?}: {distance}"
    );
}

fn check<K: ProjectionKind>(
    (projection, model): (Projection<K>, ModelProjection),
    moves: &[Move],
    positions: &[Vec3],
    cull: Cull,
) {
    let faces: Vec<[u16; 3]> = (0..positions.len() as u16 - 2)
        .map(|i| [i, i + 1, i + 2])
        .collect();
    let (transform, eye) = product(moves);
    let viewport = Viewport::new(LEFT, 0, SIZE.0, SIZE.1).unwrap();
    let drawing = Drawing {
        size: SIZE,
        options: DrawOptions::new().with_cull(cull).with_viewport(viewport),
        mode: Mode::Newton,
        mesh: Mesh::new(positions, &faces).unwrap(),
        mvp: projection * transform,
    };
    let view = View {
        eye,
        projection: model,
        viewport: ModelViewport {
            x: LEFT,
            y: 0,
            width: SIZE.0,
            height: SIZE.1,
        },
    };
    // `unit` is the largest size on the screen of a unit of the model, at a distance of 1. `scale` is the moves' part
    // in this size.
    let scale = moves.iter().fold(1., |scale: f64, step| match step {
        Move::Scale(by) => scale * exact(*by).map(f64::abs).into_iter().fold(0., f64::max),
        _ => scale,
    });
    let focal = model.matrix[0][0] * f64::from(SIZE.0) / 2.;
    let unit = 2_f64.powi(-16) * scale * focal;
    let corners =
        |face: usize| faces[face].map(|at| view.project(exact(positions[usize::from(at)])));
    // The f64 model of this test does not clip, so skip scenes with clipped triangles.
    let whole = |face: usize| {
        corners(face)
            .iter()
            .all(|corner| (model.near..model.far).contains(&corner.distance))
    };
    if !(0..faces.len()).all(whole) {
        return;
    }

    let visible = drawing.faces();
    let screen = drawing.options.viewport.unwrap();
    for y in 0..SIZE.1.cast_signed() {
        for x in 0..SIZE.0.cast_signed() + LEFT {
            let ray = screen.ray(Point::new(x, y), &drawing.mvp).unwrap();
            let cull = drawing.options.cull;
            let ray = Ray { cull, ..ray };
            let hit = ray.hit(&drawing.mesh);
            let picked = hit.map(|hit| hit.face);
            let drawn = visible[(y * SIZE.0.cast_signed() + x) as usize];
            let center = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            let both = [picked, drawn].into_iter().flatten();
            let is_beside = |face: usize| {
                let corners = corners(face);
                (0..3).any(|i| {
                    let [from, to] = [corners[i], corners[(i + 1) % 3]];
                    let nearest = if K::PERSPECTIVE { from.w.min(to.w) } else { 1. };
                    to_segment(from.screen, to.screen, center) < EDGE + 2. * unit / nearest
                })
            };
            let is_as_deep = || {
                let (Some(a), Some(b)) = (picked, drawn) else {
                    return false;
                };
                let [a, b] = [a, b].map(|face| depths(&model, &corners(face), center));
                // The margin is a step of the depth buffer, plus a tenth of a step for the errors of both depths.
                a[0] - 1.1 < b[1] && b[0] - 1.1 < a[1]
            };
            assert!(
                picked == drawn || both.clone().any(is_beside) || is_as_deep(),
                "{picked:?} was picked and {drawn:?} drawn at {x}, {y}"
            );

            // The hit's point appears at the pixel, and its barycentric coordinates give the same point.
            let Some(hit) = hit else { continue };
            let place = view.project(exact(hit.point));
            let nearest = if K::PERSPECTIVE { place.w } else { 1. };
            let off = (place.screen[0] - center[0]).hypot(place.screen[1] - center[1]);
            // The point and the ray's origin are rounded to a unit along each of three axes.
            let allowed = 1e-4 + 2. * unit / nearest.min(model.near.abs().max(0.1));
            assert!(
                off <= allowed,
                "{hit:?} is {off} pixels from the ray, over {allowed}"
            );
            check_numbers(
                &hit,
                ray,
                faces[hit.face].map(|at| positions[usize::from(at)]),
            );
        }
    }
}

fn moves(random: &mut Random) -> [Move; 4] {
    let mut factors = [(); 3].map(|()| random.random_range(0.3..3.));
    if random.random() {
        factors[2] = -factors[2];
    }
    [
        moves::to([0., 0., -random.random_range(4.0..30.)]),
        Move::X(Angle::from_bits(random.random())),
        Move::Y(Angle::from_bits(random.random())),
        Move::Scale(rounded(factors)),
    ]
}

fn positions(random: &mut Random) -> Vec<Vec3> {
    list(random, 3..12, |random| {
        rounded([(); 3].map(|()| random.random_range(-3.0..3.)))
    })
}

fn cull(random: &mut Random) -> Cull {
    *[Cull::Nothing, Cull::Back, Cull::Front]
        .choose(random)
        .unwrap()
}

#[test]
fn picked_faces_are_the_drawn_ones_in_perspective() {
    cases(150, |random| {
        let fov = Angle::from_degrees(random.random_range(30..100));
        let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
        let model = projection::perspective(moves::radians(fov), aspect, 0.25, 100.);
        let projection = Projection::perspective(fov, SIZE, fx!(0.25), fx!(100)).unwrap();
        check(
            (projection, model),
            &moves(random),
            &positions(random),
            cull(random),
        );
    });
}

#[test]
fn picked_faces_are_the_drawn_ones_in_parallel() {
    cases(150, |random| {
        let half = random.random_range(3.0..12.);
        let window = Window::centered(
            Scalar::try_from(2. * half).unwrap(),
            Scalar::try_from(1.5 * half).unwrap(),
        );
        let [l, r, b, t] = [window.left, window.right, window.bottom, window.top].map(f64::from);
        let model = projection::orthographic(l, r, b, t, -20., 60.);
        let projection = Projection::orthographic(window, fx!(-20), fx!(60)).unwrap();
        check(
            (projection, model),
            &moves(random),
            &positions(random),
            cull(random),
        );
    });
}
