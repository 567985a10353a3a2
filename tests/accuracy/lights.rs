//! Lights compared with the formulas in f64.

use std::array;

use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888, RgbColor};
use fixel::Window;
use fixel::math::Direction;
use fixel::prelude::*;
use fixel::shade::{Channels as _, SurfacePoint};
use rand::Rng;
use rand::seq::IndexedRandom;

use support::random::{Random, cases};
use support::recorder::record;
use support::reference::light::{Point, Source};
use support::reference::linear::{self, dot, length, normalized, subtract};

const UNIT: f64 = 65_536.;

/// Half a step of eight bits: the error that the crate promises.
const HALF_STEP: f64 = UNIT / 510.;

/// The error of a lamp's light, in units of 2^-16.
///
/// The vector to the lamp and the normal are truncated to mantissas of 14 bits or more. Truncation turns each of the
/// two vectors by up to √3 · 2^-14, which is 1.06e-4. The reciprocal root adds 2.3e-4, so the cosine has an error of
/// 4.4e-4.
///
/// The falloff uses s, the square of the distance divided by the range. The truncated vector adds an error of
/// 2.1e-4 to s, and the 13 bits of the square and of the reciprocal add 1.85e-4. Both errors are relative to s. The
/// formula (1 - s)² turns their sum of 4e-4 into an error of at most half as much. Two factors of 15 bits add 6.1e-5.
/// The product of these factors with the brightness keeps 14 bits, and adds 6.1e-5.
///
/// The light keeps 13 bits, which adds 1.22e-4. The rounding of the brightness adds 1.5e-5, and the rounding of the
/// result 1.5e-5. The total is 9.2e-4: 60 units.
const LAMP_ERROR: f64 = 60.;

fn f64s(v: Vec3) -> [f64; 3] {
    v.to_bits().map(|bits| f64::from(bits) / UNIT)
}

fn vector(random: &mut Random) -> Vec3 {
    let size = f64::from(random.random_range(0..12_i32)).exp2();
    let v: [f64; 3] = array::from_fn(|_| random.random_range(-1.0..1.0) * size);
    Vec3::try_from(v).unwrap()
}

fn scalar(random: &mut Random, low: f64, high: f64) -> Scalar {
    Scalar::try_from(random.random_range(low..=high)).unwrap()
}

/// A point of a surface in the number formats of the crate and of the model.
fn surface(normal: Vec3, position: Vec3) -> Option<(SurfacePoint, Point)> {
    let normal = Direction::of(normal);
    let exact = normal.components().map(f64::from);
    let point = Point {
        at: f64s(position),
        normal: exact,
    };
    let found = SurfacePoint {
        normal,
        face: normal,
        position,
    };
    (normal != Direction::NONE).then_some((found, point))
}

fn diffuse(light: &impl Lighting, point: &SurfacePoint) -> f64 {
    let diffuse = light.at(point).diffuse.rgb();
    assert!(diffuse[0] == diffuse[1] && diffuse[0] == diffuse[2]);
    f64::from(diffuse[0])
}

/// Compares the diffuse brightness of a surface with the model's brightness.
#[track_caller]
fn compare_diffuse(
    light: &impl Lighting,
    source: &Source,
    (point, exact): (&SurfacePoint, Point),
    tolerance: f64,
) {
    let (found, expected) = (diffuse(light, point), source.diffuse(exact) * UNIT);
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} is not {expected}"
    );
}

/// The number of random inputs that a test checks.
const CASES: u32 = 4000;

/// The light is within [`LAMP_ERROR`] of the model's light, up to the range and beyond it.
#[test]
fn lamps_follow_lambert_and_their_falloff() {
    cases(CASES, |random| {
        loop {
            let (normal, position, way) = (vector(random), vector(random), vector(random));
            let reach = random.random_range(0.2..30.);
            let brightness = scalar(random, 0., 1.);
            let range =
                Scalar::try_from((length(f64s(way)) * reach).max(1. / 256.)).unwrap_or(Scalar::MAX);
            let lamp = PointLight::new(position + way, brightness, range).unwrap();
            if way == Vec3::ZERO {
                continue;
            }
            let Some((point, exact)) = surface(normal, position) else {
                continue;
            };
            let source = Source::Lamp {
                at: f64s(position + way),
                brightness: f64::from(brightness),
                range: f64::from(range),
                cone: None,
            };
            compare_diffuse(&lamp, &source, (&point, exact), LAMP_ERROR);
            break;
        }
    });
}

/// The surfaces are in all directions and along an axis. The surfaces are at all distances, and many are beyond the
/// format's range.
#[test]
fn lamps_light_nothing_beyond_the_longest_range() {
    cases(CASES, |random| {
        loop {
            let normal = vector(random);
            let cut = *[[0, 0], [1, 1], [0, 12]].choose(random).unwrap();
            let [position, at] = random
                .random::<[[i32; 3]; 2]>()
                .map(|[x, y, z]| Vec3::from_bits([x >> cut[0], y >> cut[1], z >> cut[1]]));
            let range = if random.random() {
                i32::MAX
            } else {
                random.random_range(i32::MAX / 4..=i32::MAX)
            };
            let range = Scalar::from_bits(range);
            let lamp = PointLight::new(at, fx!(1), range).unwrap();
            // Most normals point roughly at the lamp.
            let way = subtract(f64s(at), f64s(position));
            let toward: [f64; 3] = array::from_fn(|i| way[i] / length(way).max(1.) * 20.);
            let Some((point, exact)) = surface(normal + Vec3::try_from(toward).unwrap(), position)
            else {
                continue;
            };
            let source = Source::Lamp {
                at: f64s(at),
                brightness: 1.,
                range: f64::from(range),
                cone: None,
            };
            compare_diffuse(&lamp, &source, (&point, exact), LAMP_ERROR);
            break;
        }
    });
}

/// The cosine has an error of 8 units of 2^-30. This error is divided by the width of the cone's edge, and multiplied
/// by up to 1.5 in the smooth step. Three more products are truncated.
#[test]
fn spots_end_softly() {
    cases(CASES, |random| {
        loop {
            let (normal, position, way) = (vector(random), vector(random), vector(random));
            if way == Vec3::ZERO {
                continue;
            }
            // Most axes point roughly at the surface.
            let toward = normalized(f64s(way));
            let aside = f64s(vector(random));
            let aim = random.random_range(0.0..3.) / length(aside).max(0.001);
            let axis: [f64; 3] = array::from_fn(|i| aim * aside[i] - 2. * toward[i]);
            let axis = Vec3::try_from(axis).unwrap();
            let range = Scalar::try_from(length(f64s(way)) * 3.).unwrap_or(Scalar::MAX);
            if axis == Vec3::ZERO || range == Scalar::ZERO {
                continue;
            }
            let inner = random.random_range(0.0..60.);
            let outer = inner + random.random_range(0.05..30.);
            let angles = [inner, outer].map(|angle| Angle::try_from_degrees(angle).unwrap());
            let brightness = scalar(random, 0., 1.);
            let lamp = position + way;
            let spot =
                SpotLight::new(lamp, axis, (angles[0], angles[1]), brightness, range).unwrap();
            let Some((point, exact)) = surface(normal, position) else {
                continue;
            };
            let cosines = angles.map(|angle| {
                (f64::from(angle.to_bits()) / 2_f64.powi(31) * std::f64::consts::PI).cos()
            });
            let source = Source::Lamp {
                at: f64s(lamp),
                brightness: f64::from(brightness),
                range: f64::from(range),
                cone: Some((f64s(axis), cosines)),
            };
            let edge = 1.5 * UNIT * 8. / 2_f64.powi(30) / (cosines[0] - cosines[1]);
            compare_diffuse(&spot, &source, (&point, exact), 11. + edge);
            break;
        }
    });
}

/// The error of the halfway vector is 2^-27 divided by the length of the sum, and is multiplied by the exponent. The
/// power adds 2^-19, and three products are truncated.
#[test]
fn highlights_follow_blinn_and_phong() {
    cases(CASES, |random| {
        loop {
            let (normal, position) = (vector(random), vector(random));
            let (toward, eye) = (vector(random), vector(random));
            let exponent: u8 = random.random();
            let brightness = scalar(random, 0.01, 1.);
            let strength = scalar(random, 0., 1.);
            if toward == Vec3::ZERO || eye == position {
                continue;
            }
            let Some((point, exact)) = surface(normal, position) else {
                continue;
            };
            let sun = Light::new(toward, fx!(0), brightness).unwrap();
            let shiny = sun.shiny(Viewer::at(eye), exponent, strength).unwrap();
            let source = Source::Sun {
                toward: f64s(toward),
                brightness: f64::from(brightness),
            };
            let (light, viewer) = (
                normalized(f64s(toward)),
                normalized(subtract(f64s(eye), exact.at)),
            );
            let sum = length(array::from_fn(|i| light[i] + viewer[i]));
            // Skip surfaces that light grazes, because highlights end abruptly there.
            if dot(light, exact.normal).abs() <= 1e-5 || sum <= 1e-3 {
                continue;
            }
            let found = f64::from(shiny.at(&point).specular);
            let expected =
                source.specular(exact, viewer, exponent.into()) * f64::from(strength) * UNIT;
            let wrong = UNIT * f64::from(exponent) / 2_f64.powi(27) / sum;
            assert!(
                (found - expected).abs() <= 4. + wrong,
                "{found} is not {expected}"
            );
            compare_diffuse(&shiny, &source, (&point, exact), 4.);
            break;
        }
    });
}

/// In a parallel projection, surfaces at all positions are seen from the same direction.
#[test]
fn parallel_views_light_the_side_that_is_seen() {
    let mut backs = 0;
    cases(CASES, |random| {
        loop {
            let (eye, target) = (vector(random), vector(random));
            let (normal, position, toward) = (vector(random), vector(random), vector(random));
            let Ok(camera) = Camera::look_at(eye, target, Vec3::Y) else {
                continue;
            };
            let window = Window::centered(fx!(2), fx!(2));
            let projection = Projection::orthographic(window, fx!(-1), fx!(1)).unwrap();
            let viewer = Viewer::of(&(projection * camera * Transform::IDENTITY));
            let Some((point, exact)) = surface(normal, position) else {
                continue;
            };
            let seen = dot(exact.normal, normalized(subtract(f64s(eye), f64s(target))));
            // The direction of the view has an error of a few units of 2^-30.
            if toward == Vec3::ZERO || seen.abs() <= 1e-6 {
                continue;
            }
            backs += u32::from(seen < 0.);
            let facing = Point {
                normal: exact.normal.map(|part| part * seen.signum()),
                ..exact
            };
            let sun = Light::new(toward, fx!(0), fx!(1)).unwrap();
            let source = Source::Sun {
                toward: f64s(toward),
                brightness: 1.,
            };
            compare_diffuse(&sun.two_sided(viewer), &source, (&point, facing), 4.);
            break;
        }
    });
    assert!(backs > 1500, "{backs}");
}

/// The whole pipeline is tested, at vertices and at faces. Lights keep their places in the world while model and camera
/// turn.
#[test]
fn corners_and_faces_are_lit_in_world_space() {
    cases(CASES, |random| {
        loop {
            let mut point = |size: f64| {
                let point: [f64; 3] = array::from_fn(|_| random.random_range(-size..size));
                Vec3::try_from(point).unwrap()
            };
            let (at, lamp) = (point(3.), point(4.));
            let positions = [point(1.), point(1.), point(1.)];
            let angles: [f64; 3] = array::from_fn(|_| random.random_range(-180.0..180.));
            let angles = angles.map(|angle| Angle::try_from_degrees(angle).unwrap());
            let color: [u8; 3] = random.random();
            let model = Transform::translate(at)
                * Transform::rotate_x(angles[0])
                * Transform::rotate_y(angles[1])
                * Transform::rotate_z(angles[2]);
            let radians = angles
                .map(|angle| f64::from(angle.to_bits()) / 2_f64.powi(31) * std::f64::consts::PI);
            let matrix = linear::product(&[
                linear::translate(f64s(at)),
                linear::rotate_x(radians[0]),
                linear::rotate_y(radians[1]),
                linear::rotate_z(radians[2]),
            ]);
            let world = positions.map(|p| linear::point(&matrix, f64s(p)));
            let face = linear::cross(subtract(world[1], world[0]), subtract(world[2], world[0]));
            let normal = normalized(face);
            let middle: [f64; 3] = array::from_fn(|i| world.iter().map(|p| p[i]).sum::<f64>() / 3.);
            // Skip surfaces near the lamp. Directions are inexact there, because positions have steps of 2^-16.
            let nearest = world
                .iter()
                .chain([&middle])
                .map(|p| length(subtract(f64s(lamp), *p)));
            let eye = vec3!(0.5, 1, 9);
            let toward_eye = normalized(subtract(f64s(eye), world[0]));
            if length(face) <= 0.05
                || nearest.fold(f64::MAX, f64::min) <= 0.1
                || dot(normal, toward_eye).abs() <= 1e-3
            {
                continue;
            }

            let camera = Camera::look_at(eye, Vec3::ZERO, Vec3::Y).unwrap();
            let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.1), fx!(100)).unwrap();
            let mvp = projection * camera * model;
            let viewer = Viewer::of(&mvp);
            let tint = Rgb888::new(color[0], color[1], color[2]);
            let sun = Light::new(vec3!(1, 2, 3), fx!(0.125), fx!(0.25)).unwrap();
            let point_light = PointLight::new(lamp, fx!(0.5), fx!(6)).unwrap();
            let lights = (sun, point_light.colored(tint)).two_sided(viewer);

            let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
            let mut pixels = vec![Rgb888::BLACK; 64 * 64];
            let options = DrawOptions::new().with_cull(Cull::Nothing);
            let white = Flat::<Rgb888>::rgb(Rgb888::WHITE);
            let mut canvas = Canvas::new(&mut pixels, 64, 64).unwrap();
            let at_corners = record::<_, 3>(white.lit(lights), |shader| {
                canvas.draw_with(&options, &mesh, &mvp, shader);
            });
            let at_faces = record::<_, 0>(white.lit_faces(lights), |shader| {
                canvas.draw_with(&options, &mesh, &mvp, shader);
            });
            let facing = dot(normal, toward_eye) > 0.;
            let expected = |at: [f64; 3]| {
                let normal = if facing { normal } else { normal.map(|x| -x) };
                let point = Point { at, normal };
                let sun = Source::Sun {
                    toward: [1., 2., 3.],
                    brightness: 0.25,
                }
                .diffuse(point)
                    + 0.125;
                let lamp = Source::Lamp {
                    at: f64s(lamp),
                    brightness: 0.5,
                    range: 6.,
                    cone: None,
                }
                .diffuse(point);
                color.map(|c| (sun + lamp * f64::from(c) / 255.).min(1.))
            };
            for (_, found) in at_corners.corners {
                for (found, expected) in found.into_iter().zip(world.map(expected)) {
                    for (found, expected) in found.into_iter().zip(expected) {
                        let error = f64::from(found) - expected * UNIT;
                        assert!(
                            error.abs() <= HALF_STEP,
                            "{found} is not {}",
                            expected * UNIT
                        );
                    }
                }
            }
            for color in at_faces.seen.iter().filter_map(|seen| seen.color) {
                let found = [color.r(), color.g(), color.b()];
                for (found, expected) in found.into_iter().zip(expected(middle)) {
                    let error = f64::from(found) - expected * 255.;
                    // The brightness has an error of half a step, and rounding the color adds half a step.
                    assert!(error.abs() <= 1., "{found} is not {}", expected * 255.);
                }
            }
            break;
        }
    });
}

/// The outside of a closed model has the same light whether the model is drawn one-sided or two-sided.
#[test]
fn a_closed_model_is_lit_alike_with_one_side_and_with_two() {
    static BALL: Mesh = shape!(sphere(24, 16));
    let projection = Projection::perspective(deg!(40), (1, 1), fx!(0.1), fx!(100)).unwrap();
    let camera = Camera::look_at(vec3!(1, 2, 3), Vec3::ZERO, Vec3::Y).unwrap();
    for model in [
        Transform::IDENTITY,
        Transform::scale_axes(vec3!(-1, 0.5, 1)),
    ] {
        let mvp = projection * camera * model;
        let sun = Light::new(vec3!(3, -1, 1), fx!(0.1), fx!(0.9)).unwrap();
        let white = Flat::new(Gray8::WHITE);
        let draw = |two_sided: bool| {
            let (mut pixels, mut depth) = ([Gray8::BLACK; 64 * 64], [0; 64 * 64]);
            let mut canvas = Canvas::new(&mut pixels, 64, 64)
                .unwrap()
                .with_depth(&mut depth)
                .unwrap();
            let nothing = DrawOptions::new().with_cull(Cull::Nothing);
            if two_sided {
                canvas.draw_with(
                    &nothing,
                    &BALL,
                    &mvp,
                    &white.lit(sun.two_sided(Viewer::of(&mvp))),
                );
            } else {
                canvas.draw_with(&nothing, &BALL, &mvp, &white.lit(sun));
            }
            pixels
        };
        let [one, two] = [false, true].map(draw);
        assert!(one.iter().filter(|pixel| pixel.luma() > 100).count() > 200);
        assert_eq!(one.iter().zip(&two).filter(|(a, b)| a != b).count(), 0);
    }
}
