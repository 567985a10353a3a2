//! The effect of a sine's error, in pixels. A model tumbles twice: with the crate's sine, which is a polynomial, and
//! with micromath's approximation.

use std::collections::HashMap;

use fixel::prelude::*;
use fixel::view::Perspective;
use micromath::F32Ext;

use support::drawing::Drawing;
use support::mode::Mode;
use support::moves::{radians, rounded};
use support::random::sampled;
use support::reference::linear::{self, Matrix};
use support::reference::scenes::{SIZE, Shape, cube, sphere, view};
use support::spread::Spread;

/// The number of angles in a turn. This number is not a multiple of four, so that each quadrant has other angles.
const ANGLES: u32 = 719;
/// The focal length of the measured scenes, in pixels.
const FOCAL: f64 = 200.;
/// The side of a texture, in texels.
const TEXELS: f64 = 64.;

/// Sine and cosine by micromath. The calls name the trait, because `x.sin()` would call std's function.
fn approximate(angle: f64) -> [f64; 2] {
    let x = angle as f32;
    [F32Ext::sin(x), F32Ext::cos(x)].map(f64::from)
}

/// The rotations of a model's turn, in the order of their product.
const AXES: [fn(Angle) -> Transform; 2] = [Transform::rotate_x, Transform::rotate_y];

/// A turn about an axis, from a sine and a cosine that can be off the unit circle. The turn is the product of a
/// rotation by the direction of the point (cosine, sine) and a scale of the two other axes by the point's distance from
/// the origin. The angle is exact to 2⁻³³ of a turn, the scale to 2⁻¹⁷.
fn turn(axis: usize, [sin, cos]: [f64; 2]) -> Transform {
    let scale = Scalar::try_from(sin.hypot(cos)).unwrap();
    let angle = Angle::try_from_radians(sin.atan2(cos)).unwrap();
    let scales = match axis {
        0 => Vec3::new(fx!(1), scale, scale),
        _ => Vec3::new(scale, fx!(1), scale),
    };
    AXES[axis](angle) * Transform::scale_axes(scales)
}

/// The angles about x and y in a step. The model makes two full turns about x while it makes five about y.
fn angles(step: u32) -> [Angle; 2] {
    let turn = ((u64::from(step) << 32) / u64::from(ANGLES)) as u32;
    [2, 5].map(|turns| Angle::from_bits(turn.wrapping_mul(turns)))
}

/// The product of both turns, with the crate's sine.
fn polynomial([x, y]: [Angle; 2]) -> Transform {
    AXES[0](x) * AXES[1](y)
}

/// The product of both turns, with micromath's sine.
fn approximation([x, y]: [Angle; 2]) -> Transform {
    turn(0, approximate(radians(x))) * turn(1, approximate(radians(y)))
}

/// A model with all of its transforms except its turn.
struct Model {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    uvs: Vec<Vec2>,
    uv_faces: Vec<[u16; 3]>,
    place: [f64; 3],
}

impl Model {
    fn new(shape: &Shape, distance: f64) -> Self {
        let index = |i: usize| u16::try_from(i).unwrap();
        let uvs = shape.uvs.iter().flatten();
        Self {
            positions: shape.positions.iter().map(|&p| rounded(p)).collect(),
            faces: shape.faces.iter().map(|face| face.map(index)).collect(),
            uvs: uvs.map(|&[u, v]| Vec2::try_from([u, v]).unwrap()).collect(),
            uv_faces: (0..shape.faces.len())
                .map(|face| [0, 1, 2].map(|corner| index(3 * face + corner)))
                .collect(),
            place: support::moves::exact(rounded([0., 0., -distance])),
        }
    }

    fn drawing(&self, turn: Transform) -> Drawing<'_, Perspective> {
        let projection =
            Projection::from_focal_length(fx!(200), SIZE, fx!(0.25), fx!(100)).unwrap();
        let place = Transform::translate(rounded(self.place));
        Drawing {
            size: SIZE,
            options: DrawOptions::new(),
            mode: Mode::Newton,
            mesh: Mesh::new(&self.positions, &self.faces)
                .and_then(|mesh| mesh.with_uvs(&self.uvs, Some(&self.uv_faces)))
                .unwrap(),
            mvp: projection * (place * turn),
        }
    }

    /// The transform to eye space in f64.
    fn eye(&self, [x, y]: [f64; 2]) -> Matrix {
        linear::product(&[
            linear::translate(self.place),
            linear::rotate_x(x),
            linear::rotate_y(y),
        ])
    }

    /// The texel visible at each pixel.
    fn picture(&self, turn: Transform) -> HashMap<[i32; 2], [i32; 2]> {
        let uv = |vertex: &Corner<'_>| vertex.uv().to_bits();
        let seen = self.drawing(turn).shown(&uv).into_iter();
        let texel = |bits: i32| (f64::from(bits) / 2_f64.powi(20) * TEXELS).floor() as i32;
        seen.map(|seen| (seen.pixel, seen.values.map(texel)))
            .collect()
    }
}

/// The distances of vertices on the screen from their positions in f64, in pixels, over all steps.
struct Displaced {
    polynomial: Spread,
    approximation: Spread,
    /// The distances with micromath's sine, divided by the bound from the errors of its sine and cosine.
    explained: Spread,
}

fn displaced(model: &Model) -> Displaced {
    let mut all = Displaced {
        polynomial: Spread::default(),
        approximation: Spread::default(),
        explained: Spread::default(),
    };
    for step in (0..ANGLES).step_by((ANGLES / sampled(ANGLES)) as usize) {
        let angles = angles(step);
        let exact = angles.map(radians);
        let view = view(model.eye(exact));
        let errors = exact.map(|angle| {
            let [sin, cos] = approximate(angle);
            // The scale adds its own error.
            (sin - angle.sin()).hypot(cos - angle.cos()) + 2_f64.powi(-17)
        });
        let places = [polynomial, approximation]
            .map(|turn| model.drawing(turn(angles)).snapped(&model.positions));
        for (i, &position) in model.positions.iter().enumerate() {
            let position = support::moves::exact(position);
            let wanted = view.project(position).screen;
            let away = |place: Option<[i32; 2]>| {
                let [x, y] = place.unwrap().map(|at| f64::from(at) / 256.);
                (x - wanted[0]).hypot(y - wanted[1])
            };
            let [exactly, nearly] = [0, 1].map(|which: usize| away(places[which][i]));
            all.polynomial.add(exactly, i);
            all.approximation.add(nearly, i);
            // `errors` holds √(Δsin² + Δcos²) of each turn. A turn displaces a point at a distance ρ from its axis by
            // up to ρ times this error. The turn about y comes first, then the turn about x. The first turn increases ρ
            // by at most its own error.
            let [x, y, z] = linear::point(&view.eye, position);
            let after = [y, z - model.place[2]];
            let moved = position[0].hypot(position[2]) * errors[1] * (1. + errors[0])
                + after[0].hypot(after[1]) * errors[0];
            // On the screen, s = f p/w. So ds = f/w (dp − p/w dw). If a point moves by d, this is at most f d/w √(1 +
            // |p/w|²). w itself has an error of up to d, so 1/(w − d) replaces 1/w. Rounding moves s by up to 1/512
            // pixel along each axis.
            let slope = (1. + (x * x + y * y) / (z * z)).sqrt();
            let allowed = FOCAL * moved / (-z - moved) * slope + 2_f64.sqrt() / 512. + 1e-4;
            all.explained.add(nearly / allowed, i);
        }
    }
    all
}

/// Prints the errors of a turning model's vertices, and the fraction of its pixels that differ. Compares both with the
/// known errors of the two sines.
fn check(name: &str, model: &Model) {
    let all = displaced(model);
    let pictures = (0..ANGLES).step_by(45).map(|step| {
        let [exact, other] =
            [polynomial, approximation].map(|turn| model.picture(turn(angles(step))));
        let differ = exact
            .iter()
            .filter(|(pixel, texel)| other.get(*pixel) != Some(*texel));
        let lost = other.keys().filter(|pixel| !exact.contains_key(*pixel));
        [differ.count() + lost.count(), exact.len()]
    });
    let [differ, pixels] = pictures.fold([0; 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
    let part = differ as f64 / pixels as f64;
    println!("{name}");
    println!("{}", all.polynomial.line("vertices, polynomial", "px"));
    println!("{}", all.approximation.line("vertices, micromath", "px"));
    println!("  pixels of another texel, micromath: {:.1} %", part * 100.);

    // Positions are rounded to 1/256 pixel along each axis. The sine's error of 1.6e-9 adds only 2e-6 pixel.
    assert!(all.polynomial.max() <= 2_f64.sqrt() / 512. + 1e-4);
    assert!(all.explained.max() <= 1.);
    // An error of 1.1e-3 in sine or cosine, at a radius of at least 1, a focal length of 200 and a distance of at most
    // 1.5, is 0.15 pixel. Both turns together exceed twice this error. If the test used std's sine by mistake, the
    // result would be only 0.003, as with the polynomial.
    assert!((0.15..=0.40).contains(&all.approximation.max()));
    assert!(part > 0.01);
}

#[test]
fn the_error_of_the_sine_on_a_tumbling_cube() {
    check("cube, tumbling", &Model::new(&cube(0).0, 3.133_832_458));
}

#[test]
fn the_error_of_the_sine_on_a_tumbling_sphere() {
    check(
        "sphere, tumbling",
        &Model::new(&sphere(0).0, 2.256_239_223_7),
    );
}
