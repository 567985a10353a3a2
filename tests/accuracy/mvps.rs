//! Products of transforms and perspective projections. The position and the depth of a point are compared with f64.
//! (For parallel projections, see [`parallel`](crate::extremes).)

use std::array;
use std::ops::Range;

use fixel::Window;
use fixel::prelude::*;
use fixel::view::Perspective;
use rand::Rng;

use support::drawing::{Drawing, Spot};
use support::mode::Mode;
use support::moves::{Move, exact, number, product, radians, relative, rounded, size};
use support::random::{Random, cases, list, within};
use support::reference::linear::{Matrix, point};
use support::reference::projection::{self, Projection as ModelProjection};
use support::reference::view::{View, Viewport as ModelViewport};

const SIZE: (u32, u32) = (320, 240);
/// Half of the guard band's width, in pixels.
const GUARD: f64 = 2048.;

/// The number of random inputs that a test checks.
const CASES: u32 = 3000;

fn position(random: &mut Random, range: f64) -> Vec3 {
    rounded(array::from_fn(|_| random.random_range(-range..range)))
}

fn step(random: &mut Random) -> Move {
    let angle = Angle::from_bits(random.random());
    match random.random_range(0..5) {
        0 => Move::To(position(random, 8.)),
        1 => Move::X(angle),
        2 => Move::Y(angle),
        3 => Move::Z(angle),
        _ => {
            let factors = [0.2..3., 0.2..3., -3.0..-0.2];
            Move::Scale(rounded(factors.map(|factor| random.random_range(factor))))
        }
    }
}

/// Moves that place the surroundings of the origin at some distance in front of the eye.
fn mvp(random: &mut Random) -> Vec<Move> {
    let mut moves = list(random, 0..4, step);
    let distance = random.random_range(0.0..60.);
    moves.insert(0, support::moves::to([0., 0., -distance]));
    moves
}

/// The same projection, made by the crate and by the model.
fn perspective(fov: Angle, near: f64, far: f64) -> (Projection<Perspective>, ModelProjection) {
    let [near, far] = [near, far].map(number);
    (
        Projection::perspective(fov, SIZE, near, far).unwrap(),
        projection::perspective(radians(fov), 4. / 3., f64::from(near), f64::from(far)),
    )
}

/// Compares the position of a point with the model's position.
fn compare(
    (projection, model): (Projection<Perspective>, ModelProjection),
    moves: &[Move],
    viewport: Viewport,
    points: &[Vec3],
) {
    let (transform, eye) = product(moves);
    let drawing = Drawing {
        size: SIZE,
        options: DrawOptions::new().with_viewport(viewport),
        mode: Mode::Exact,
        mesh: Mesh::new(&[], &[]).unwrap(),
        mvp: projection * transform,
    };
    compare_spots(
        points,
        &drawing.spots(points),
        (model, eye),
        moves,
        viewport,
    );
}

/// Compares the positions and depths of points with the model, given its projection and its transform to eye space.
fn compare_spots(
    points: &[Vec3],
    spots: &[Option<Spot>],
    (model, eye): (ModelProjection, Matrix),
    moves: &[Move],
    viewport: Viewport,
) {
    let view = View {
        eye,
        projection: model,
        viewport: ModelViewport {
            x: viewport.top_left().x,
            y: viewport.top_left().y,
            width: viewport.size().width,
            height: viewport.size().height,
        },
    };
    let middle = view.viewport.screen([0.; 2]);
    for (&p, &spot) in points.iter().zip(spots) {
        let wanted = view.project(exact(p));
        // The largest coefficient, in pixels, of the rows for x and y, and of the row for depth, which has the guard
        // band's scale.
        let pixels = |axis: usize, size: u32| {
            let row = model.matrix[axis].into_iter();
            f64::from(size) / 2. * row.fold(0., |most: f64, m| most.max(m.abs()))
        };
        let scale = pixels(0, viewport.size().width)
            .max(pixels(1, viewport.size().height))
            .max(GUARD);
        let size = size(moves, p);
        // For a point away from the middle, an error of w also changes x and y.
        let off = [0, 1].map(|axis: usize| (wanted.screen[axis] - middle[axis]).abs());
        let aside = 1. + off[0].max(off[1]) / GUARD;
        let error = relative(moves) * size * scale / wanted.w * aside;
        let depth = model.depth(wanted.distance);
        // To the error of t = w / near · (1 + 2^-16), add 2^-30 each for its reciprocal, for the near plane's
        // reciprocal, and for the scale 65536.
        let depth_error = relative(moves) * size * scale / GUARD * depth / wanted.distance
            + 65536. * 2_f64.powi(-28);
        let margin = error + 2. * SIDE;
        let clear = |margin: f64| {
            off.iter().all(|off| off + margin < GUARD)
                && depth + depth_error + margin < 65535.
                && depth - depth_error - margin > model.depth(model.far)
        };
        let Some(Spot {
            x,
            y,
            depth: stored,
        }) = spot
        else {
            assert!(
                !(wanted.w > 0. && clear(margin)),
                "{p:?} is at {:?}, {} ahead, and was clipped",
                wanted.screen,
                wanted.distance
            );
            continue;
        };
        assert!(wanted.w > 0., "{p:?} is behind the eye");
        for (axis, got) in [x, y].into_iter().enumerate() {
            let exact = wanted.screen[axis] * 256.;
            let by = (f64::from(got) - exact).abs();
            assert!(
                by <= 0.5 + 256. * error,
                "{p:?}: {got} is not {exact}: an error of {by} subpixels, allowed {}",
                0.5 + 256. * error
            );
        }
        let stored = f64::from(stored);
        assert!(
            stored <= depth + depth_error && depth < stored + 1. + depth_error,
            "{p:?}: depth {stored} is not {depth}, within {depth_error}"
        );
    }
}

/// A point that is this close to a plane, in pixels or in steps of depth, can be clipped or not. The crate's near plane
/// is nearer by 2⁻²⁷ of its distance.
const SIDE: f64 = 1. / 16384.;

fn viewport(random: &mut Random) -> Viewport {
    let (x, y) = (random.random_range(-50..200), random.random_range(-50..100));
    let (width, height) = (random.random_range(1..400), random.random_range(1..300));
    Viewport::new(x, y, width, height).unwrap()
}

fn points(random: &mut Random) -> Vec<Vec3> {
    list(random, 1..20, |random| position(random, 6.))
}

/// A window with left and lower sides in the range `corner`, and a width and a height in the range `size`.
fn window(random: &mut Random, corner: Range<f64>, size: Range<f64>) -> Window {
    let [left, bottom] = [(); 2].map(|()| random.random_range(corner.clone()));
    let [width, height] = [(); 2].map(|()| random.random_range(size.clone()));
    let [left, right, bottom, top] = [left, left + width, bottom, bottom + height].map(number);
    Window {
        left,
        right,
        bottom,
        top,
    }
}

#[test]
fn transformed_points_are_the_models() {
    cases(CASES, |random| {
        let (moves, p) = (list(random, 0..6, step), position(random, 100.));
        let (transform, matrix) = product(&moves);
        let (got, wanted) = (exact(transform.point(p)), point(&matrix, exact(p)));
        // Rounding the result adds half a unit to the errors of the mantissas.
        let error = 2_f64.powi(-17) + relative(&moves) * size(&moves, p);
        for axis in 0..3 {
            let by = (got[axis] - wanted[axis]).abs();
            assert!(
                by <= error,
                "{p:?} goes to {got:?}, not {wanted:?}: an error of {by}, over {error}"
            );
        }
    });
}

#[test]
fn points_in_perspective_are_the_models() {
    cases(CASES, |random| {
        let fov = Angle::try_from_degrees(random.random_range(20.0..140.)).unwrap();
        let [near, far] = within(random, [0.01..2., 10.0..1000.]);
        let projection = perspective(fov, near, far);
        compare(projection, &mvp(random), viewport(random), &points(random));
    });
}

#[test]
fn points_in_a_frustum_are_the_models() {
    cases(CASES, |random| {
        let window = window(random, -3.0..1., 0.5..4.);
        let near = Scalar::try_from(random.random_range(0.5..2.)).unwrap();
        let projection = Projection::frustum(window, near, fx!(100)).unwrap();
        let [l, r, b, t, n] =
            [window.left, window.right, window.bottom, window.top, near].map(f64::from);
        let model = projection::frustum(l, r, b, t, n, 100.);
        let viewport = Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap();
        compare((projection, model), &mvp(random), viewport, &points(random));
    });
}

#[test]
fn depth_falls_with_distance() {
    cases(CASES, |random| {
        let [near, far] = within(random, [0.01..2., 10.0..1000.]);
        let projection = perspective(Angle::from_degrees(90), near, far);
        let (transform, _) = product(&mvp(random));
        let points = points(random);
        let drawing = Drawing {
            size: SIZE,
            options: DrawOptions::new(),
            mode: Mode::Exact,
            mesh: Mesh::new(&[], &[]).unwrap(),
            mvp: projection.0 * transform,
        };
        let mut depths: Vec<(i32, u16)> = points
            .iter()
            .zip(drawing.spots(&points))
            .filter_map(|(&p, spot)| Some((transform.point(p).z.to_bits(), spot?.depth)))
            .collect();
        // Points are sorted from far to near, because z rises. If two points are less than one unit apart, either order
        // is right.
        depths.sort_unstable();
        for pair in depths.windows(2) {
            let [(far, far_depth), (near, near_depth)] = pair else {
                continue;
            };
            assert!(
                far_depth <= near_depth || near - far <= 1,
                "depth {far_depth} at {far}, {near_depth} at {near}"
            );
        }
    });
}
