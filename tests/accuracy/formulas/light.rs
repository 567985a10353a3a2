//! Normals, Lambert's law, and highlights.

use std::array::from_fn;
use std::cell::Cell;
use std::f64::consts::TAU;

use embedded_graphics::pixelcolor::Gray8;
use fixel::Window;
use fixel::math::Direction;
use fixel::prelude::*;
use fixel::shade::{Illumination, SurfacePoint, Viewer};
use rand::Rng;

use support::moves::exact;
use support::random::{Random, cases, within};
use support::reference::linear::{cross, dot, normalized, subtract};

use super::helpers::{all_close, assert_row, close, digits, vec};
use super::rotation::rodrigues;

const PAGE: &str = include_str!("../../../src/guide/mathematics/light.rs");

/// A light that records the normal of the last point.
#[derive(Clone, Copy)]
struct Normal<'a>(&'a Cell<Direction>);

impl Lighting for Normal<'_> {
    type Diffuse = i32;
    type Specular = ();

    fn at(&self, point: &SurfacePoint) -> Illumination {
        self.0.set(point.normal);
        Illumination::white(0)
    }
}

fn components(direction: Direction) -> [f64; 3] {
    direction.components().map(f64::from)
}

/// A vector that is neither short nor long.
fn vector(random: &mut Random) -> Vec3 {
    loop {
        let [x, y, z] = within(random, [-1.0..1.0, -1.0..1.0, -1.0..1.0]);
        if x * x + y * y + z * z > 0.25 {
            return vec(x, y, z);
        }
    }
}

/// The normal of a stretched, mirrored and turned triangle is at right angles to its sides.
#[test]
fn normals_take_the_transpose_of_the_inverse() {
    cases(256, |random| {
        // The triangle has its middle at the origin, and its normal to its front.
        let (a, b) = loop {
            let [a, b] = from_fn(|_| vector(random));
            let normal = cross(exact(a), exact(b));
            if dot(normal, normal) > 0.1 {
                break (a, b);
            }
        };
        let corners = [a, b, -(a + b)];
        let [p, q, r] = corners.map(exact);
        let normal = normalized(cross(subtract(q, p), subtract(r, p)));
        let stretch: [f64; 3] = from_fn(|_| {
            let size = random.random_range(0.5..2.0);
            if random.random() { size } else { -size }
        });
        let stretch = Vec3::try_from(stretch).unwrap();
        let (axis, angle) = (vector(random), Angle::from_bits(random.random()));
        let model = Transform::rotate(axis, angle).unwrap() * Transform::scale_axes(stretch);
        // The sides after the transform. A mirrored triangle turns its corners around.
        let radians = f64::from(angle.to_bits()) / 4_294_967_296.0 * TAU;
        let stretch = exact(stretch);
        let moved = |v: [f64; 3]| {
            let stretched = from_fn(|i| stretch[i] * v[i]);
            rodrigues(normalized(exact(axis)), stretched, radians)
        };
        let sides = [subtract(q, p), subtract(r, p)].map(moved);
        let sign = stretch.iter().product::<f64>().signum();
        let expected = normalized(cross(sides[0], sides[1])).map(|x| x * sign);

        // Look at the triangle from its front, so that it has pixels.
        let rounded = Vec3::try_from(normal).unwrap();
        let normals = [rounded; 3];
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        let mesh = mesh.with_normals(&normals, None).unwrap();
        let eye = Vec3::try_from(expected.map(|x| 8.0 * x)).unwrap();
        let up = if expected[1].abs() < 0.9 {
            Vec3::Y
        } else {
            Vec3::X
        };
        let camera = Camera::look_at(eye, Vec3::ZERO, up).unwrap();
        let window = Window::centered(fx!(8), fx!(8));
        let projection = Projection::orthographic(window, fx!(1), fx!(16)).unwrap();
        let seen = Cell::new(Direction::NONE);
        let mut pixels = [Gray8::new(0); 64 * 64];
        let mut canvas = Canvas::new(&mut pixels, 64, 64).unwrap();
        let both = DrawOptions::new().with_cull(Cull::Nothing);
        let white = Flat::new(Gray8::new(255)).lit(Normal(&seen));
        canvas.draw_with(&both, &mesh, &(projection * camera * model), &white);
        // The mesh's normal is rounded by up to half a unit of 2^-16 along each axis, 0.87 units in all. The transform
        // halves one direction and doubles another, which multiplies an angle by up to four: 3.5 units. The matrix and
        // the direction add less than a tenth.
        all_close(components(seen.get()), expected, 3.6 / 65_536.0);
    });
}

#[test]
fn brightness_is_lamberts_cosine() {
    let sun = Light::new(Vec3::Y, fx!(0), fx!(1)).unwrap();
    for degrees in [0_i16, 30, 60, 80, 120] {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let normal = Direction::of(vec(sine, cosine, 0.0));
        let found = f64::from(sun.brightness(normal)) / 65_536.0;
        // The normal's components are rounded by up to half a unit of 2^-16, and so is the brightness.
        close(found, cosine.max(0.0), 1.5 / 65_536.0);
        let width = if cosine > 0.0 {
            digits(1.0 / cosine, 3)
        } else {
            "none".into()
        };
        assert_row(PAGE, &[format!("{degrees}°"), width, digits(found, 3)]);
    }
}

/// The highlight of a light from `toward`, as a viewer in the direction `eye` sees it.
fn highlight(normal: Vec3, toward: Vec3, eye: Vec3, exponent: u8) -> f64 {
    let normal = Direction::of(normal);
    let point = SurfacePoint {
        normal,
        face: normal,
        position: Vec3::ZERO,
    };
    let sun = Light::new(toward, fx!(0), fx!(1)).unwrap();
    let shiny = sun
        .shiny(Viewer::toward(eye).unwrap(), exponent, fx!(1))
        .unwrap();
    f64::from(shiny.at(&point).specular) / 65_536.0
}

/// The rounding of two products to units of 2^-16, and less than a unit for the power.
const SHINE: f64 = 3.0 / 65_536.0;

#[test]
fn highlights_follow_blinn() {
    cases(256, |random| {
        let [n, l, v] = from_fn(|_| vector(random));
        let exponent = random.random_range(1..100);
        let [normal, light, eye] = [n, l, v].map(|v| normalized(exact(v)));
        // The mirror image is at the same angle to the normal, and in the same plane as the light.
        let mirrored: [f64; 3] = from_fn(|i| 2.0 * dot(normal, light) * normal[i] - light[i]);
        close(dot(mirrored, mirrored), 1.0, 1e-12);
        close(dot(mirrored, normal), dot(light, normal), 1e-12);
        let expected = if dot(normal, light) > 0.0 {
            let h = normalized(from_fn(|i| light[i] + eye[i]));
            dot(normal, h).max(0.0).powi(exponent.into())
        } else {
            0.0
        };
        close(highlight(n, l, v, exponent), expected, SHINE);
    });
}

/// With half the angle, Blinn needs four times the exponent.
#[test]
fn the_guides_table_of_highlights() {
    for degrees in [0_i16, 10, 20, 30, 40] {
        // The eye is on the normal, so r is at the angle from the eye, and h at half the angle from the normal.
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let blinn = highlight(Vec3::Z, vec(sine, 0.0, cosine), Vec3::Z, 32);
        close(
            blinn,
            (f64::from(degrees) / 2.0).to_radians().cos().powi(32),
            SHINE,
        );
        let row = [
            format!("{degrees}°"),
            digits(cosine.powi(8), 3),
            digits(blinn, 3),
        ];
        assert_row(PAGE, &row);
    }
    // By hand: r · v = 0.8, and (n · h)² = 0.9.
    assert_eq!(digits(0.8_f64.powi(8), 3), "0.168");
    close(
        highlight(Vec3::Z, vec3!(3, 0, 4), Vec3::Z, 8),
        0.9_f64.powi(4),
        SHINE,
    );
}
