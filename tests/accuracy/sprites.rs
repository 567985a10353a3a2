//! The corners of sprites in eye space and in world space, compared with the f64 model.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::Gray8;
use fixel::Window;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;

use support::moves::{self, Move, exact, number, product, relative, rounded, size};
use support::random::{Random, cases, within};
use support::recorder::Probe;
use support::reference::linear::{Matrix, direction, inverse, length, point};
use support::reference::projection::{self, Projection as ModelProjection};
use support::reference::sprites::Sprite;

const SIZE: (u32, u32) = (64, 48);

/// All properties of sprites except their positions.
#[derive(Clone, Copy, Debug)]
struct Kind {
    size: [f64; 2],
    in_pixels: bool,
    axis: Option<Vec3>,
    anchor: [f64; 2],
    scale: f64,
    angle: Option<Angle>,
}

fn kind(random: &mut Random) -> Kind {
    Kind {
        size: within(random, [0.5..8., 0.5..8.]),
        in_pixels: random.random(),
        axis: random
            .random_bool(0.5)
            .then(|| rounded(anywhere(random, 2.))),
        anchor: within(random, [-0.5..1.5, -0.5..1.5]),
        scale: random.random_range(-2.0..2.),
        angle: random
            .random_bool(0.5)
            .then(|| Angle::from_bits(random.random())),
    }
}

fn anywhere(random: &mut Random, range: f64) -> [f64; 3] {
    within(random, [-range..range, -range..range, -range..range])
}

/// The moves of a camera, which form a rigid transform, and the moves of a model.
fn places(random: &mut Random) -> [Vec<Move>; 2] {
    let [x, y, z] = random.random::<[u32; 3]>().map(Angle::from_bits);
    let factors = within(random, [0.2..3., 0.2..3., -3.0..-0.2]);
    [
        vec![
            moves::to([0., 0., -random.random_range(5.0..40.)]),
            Move::X(x),
            Move::Y(y),
            moves::to(anywhere(random, 5.)),
        ],
        vec![
            moves::to(anywhere(random, 5.)),
            Move::Z(z),
            Move::Scale(rounded(factors)),
        ],
    ]
}

/// The bound of the error of a corner in eye space, along each axis.
fn allowed(all: &[Move], eye: &Matrix, kind: Kind, sprite: &Sprite, ahead: f64) -> f64 {
    // A corner has an error of two half units, plus the error of the transform. Sides have 30 bits; if they are given
    // in pixels, their lengths have the relative error of the distance. A side along an axis has the error of the
    // axis's direction. This error grows as the axis approaches the line of sight.
    let unit = 2_f64.powi(-16);
    let moved = relative(all) * size(all, rounded(sprite.position));
    let [width, height] = sprite.size;
    let (lengths, side) = match kind.angle {
        None => (
            [width * sprite.unit[0], height * sprite.unit[1]],
            2_f64.powi(-27),
        ),
        // A turned side lies along both axes. Of a number with 30 bits, a unit is 2^-29 or less. The corners at an angle
        // of 0 and of 90 degrees have errors of up to two units, and √2 times that when they are mixed. Twice the length
        // of a corner, times the error of 2^-29 of a sine, is another 2√2 units; rounding the sum adds one. In all,
        // there are 6.7 units.
        Some(_) => (
            sprite.unit.map(|unit| width.max(height) * unit),
            2_f64.powi(-26),
        ),
    };
    let largest = lengths.map(f64::abs).into_iter().fold(0., f64::max) * 2.;
    let growth = if kind.in_pixels {
        (moved + unit) / ahead.abs().max(unit)
    } else {
        0.
    };
    let turn = kind.axis.map_or(0., |axis| {
        let turned = direction(eye, exact(axis));
        let aside = turned[0].hypot(turned[1]);
        let linear: Vec<Move> = all
            .iter()
            .filter(|step| !matches!(step, Move::To(_)))
            .copied()
            .collect();
        2. * (relative(&linear) * size(&linear, axis) + 2_f64.powi(-27) * length(turned)) / aside
    });
    unit + moved + largest * (growth + turn + side)
}

fn is_perspective(projection: &ModelProjection) -> bool {
    projection.kind == projection::Kind::Perspective
}

/// Whether a sprite with these corners is well inside the picture and certain to have a pixel.
fn is_shown(projection: &ModelProjection, corners: &[[f64; 3]; 4]) -> bool {
    // A circle with a radius of more than √½ pixel contains the center of a pixel. So a triangle well inside the
    // picture has a pixel if it contains such a circle.
    let w = |corner: &[f64; 3]| {
        if is_perspective(projection) {
            -corner[2]
        } else {
            1.
        }
    };
    let place =
        |corner: &[f64; 3], axis: usize| corner[axis] * projection.matrix[axis][axis] / w(corner);
    let is_inside = |corner: &[f64; 3]| {
        (1. ..90.).contains(&-corner[2])
            && place(corner, 0).abs() < 0.9
            && place(corner, 1).abs() < 0.9
    };
    let radius = {
        let on_screen = |i: usize| {
            let corner = &corners[i];
            let [x, y] = [place(corner, 0), place(corner, 1)];
            [x * f64::from(SIZE.0) / 2., y * f64::from(SIZE.1) / 2.]
        };
        let [a, b, c] = [on_screen(0), on_screen(1), on_screen(2)];
        let side = |[x, y]: [f64; 2], [u, v]: [f64; 2]| (u - x).hypot(v - y);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        area.abs() / (side(a, b) + side(b, c) + side(c, a))
    };
    corners.iter().all(is_inside) && radius > 0.8
}

fn check<K: ProjectionKind>(
    (projection, model): (Projection<K>, ModelProjection),
    places: &[Vec<Move>; 2],
    kind: Kind,
    position: Vec3,
) {
    let [(view, _), (place, _)] = [product(&places[0]), product(&places[1])];
    let mvp = projection * Camera::from_view(view) * place;
    compare(model, places, kind, position, &mvp);
}

/// Compares the corners of sprites with the model's corners.
fn compare<K: ProjectionKind>(
    projection: ModelProjection,
    [camera, model]: &[Vec<Move>; 2],
    kind: Kind,
    position: Vec3,
    mvp: &Mvp<K>,
) {
    let all = [&camera[..], &model[..]].concat();
    let ((_, view_matrix), (_, eye)) = (product(camera), product(&all));

    let [width, height] = kind.size.map(number);
    let positions = [position];
    let make = if kind.in_pixels {
        Sprites::in_pixels
    } else {
        Sprites::new
    };
    let [u, v] = kind.anchor.map(|x| TexCoord::try_from(x).unwrap());
    let scales = [Scalar::try_from(kind.scale).unwrap()];
    let mut sprites = make(&positions, (width, height))
        .unwrap()
        .with_anchor(Vec2::new(u, v))
        .with_scales(&scales)
        .unwrap();
    if let Some(axis) = kind.axis {
        let Ok(turning) = sprites.with_axis(axis) else {
            return;
        };
        sprites = turning;
    }

    // In the model, a length in pixels becomes a length in eye space at the sprite's distance.
    let ahead = if is_perspective(&projection) {
        -point(&eye, exact(position))[2]
    } else {
        1.
    };
    let factors = [(0, SIZE.0), (1, SIZE.1)].map(|(axis, size): (usize, u32)| {
        let pixel = 2. / (projection.matrix[axis][axis] * f64::from(size));
        let unit = if kind.in_pixels {
            pixel * ahead.max(0.)
        } else {
            1.
        };
        unit * f64::from(scales[0])
    });
    let sprite = Sprite {
        position: exact(position),
        size: [width, height].map(f64::from),
        unit: factors,
        angle: kind.angle.map_or(0., moves::radians),
        anchor: [f64::from(u), f64::from(v)],
        axis: kind.axis.map(exact),
    };
    let expected = sprite.corners(&eye);

    let allowed = allowed(&all, &eye, kind, &sprite, ahead);

    let seen = RefCell::new(Vec::new());
    let probe = Probe {
        values: &|corner| {
            seen.borrow_mut()
                .push((corner.position(), corner.world_position()));
            [0; 1]
        },
        color: Some(Gray8::new(1)),
    };
    let mut pixels = vec![Gray8::new(0); (SIZE.0 * SIZE.1) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
    match kind.angle {
        None => canvas.draw(&sprites, mvp, &probe),
        Some(angle) => canvas.draw(&sprites.with_angles(&[angle]).unwrap(), mvp, &probe),
    };
    if is_shown(&projection, &expected) {
        assert!(!seen.borrow().is_empty(), "{sprite:?} has no pixels");
    }
    let (back, unit) = (inverse(&view_matrix).unwrap(), 2_f64.powi(-16));
    for (i, (at, world)) in seen.into_inner().into_iter().enumerate() {
        // These are the corners of both triangles. One of the triangles can be without pixels.
        let corner = |i: usize| [0, 1, 2, 2, 1, 3].map(|i: usize| expected[i])[i % 6];
        let off = |corner: [f64; 3], at: Vec3| {
            let at = exact(at);
            (0..3)
                .map(|axis| (corner[axis] - at[axis]).abs())
                .fold(0., f64::max)
        };
        let (first, second) = (corner(i), corner(i + 3));
        let best = if off(first, at) < off(second, at) {
            first
        } else {
            second
        };
        assert!(
            off(best, at) <= allowed,
            "{at:?} is not {best:?}, within {allowed}"
        );
        // The camera's rotation adds up the errors along three axes, and rounding adds half a unit.
        let there = point(&back, best);
        let allowed = 3_f64.sqrt() * allowed
            + unit
            + relative(camera) * (size(camera, at) + length(best) + size(camera, Vec3::ZERO));
        assert!(
            off(there, world) <= allowed,
            "{world:?} is not {there:?} in the world"
        );
    }
}

#[test]
fn corners_in_perspective_are_the_models() {
    cases(3000, |random| {
        let fov = Angle::from_degrees(random.random_range(40..120));
        let (near, far) = (fx!(0.5), fx!(100));
        let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
        let model = projection::perspective(moves::radians(fov), aspect, 0.5, 100.);
        let projection = Projection::perspective(fov, SIZE, near, far).unwrap();
        let position = rounded(anywhere(random, 4.));
        check((projection, model), &places(random), kind(random), position);
    });
}

#[test]
fn corners_in_parallel_are_the_models() {
    cases(3000, |random| {
        let half = Scalar::try_from(random.random_range(4..20)).unwrap();
        let window = Window {
            left: -half,
            right: half,
            bottom: -half,
            top: half,
        };
        let edge = f64::from(half);
        let model = projection::orthographic(-edge, edge, -edge, edge, 0., 100.);
        let projection = Projection::orthographic(window, fx!(0), fx!(100)).unwrap();
        let position = rounded(anywhere(random, 4.));
        check((projection, model), &places(random), kind(random), position);
    });
}
