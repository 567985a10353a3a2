//! Depths depend neither on the shader nor, except in `Compact`, on the mode. Hidden pixels leave visible pixels as they
//! are.

use std::any::type_name_of_val;
use std::fmt::Debug;

use embedded_graphics::pixelcolor::{Gray4, Rgb565, Rgb888, RgbColor};
use fixel::canvas::{Biased, DepthBuffer, DepthTest, FloatDepth, TestAndWrite};
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use rand::Rng;
use support::counter::BOTH_SIDES;
use support::erased::Erased;
use support::random::cases;

const SIZE: (u32, u32) = (96, 64);

static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::BLUE, Rgb565::WHITE]];

fn depths<F: DepthBuffer>(
    mesh: &Mesh<'_>,
    (mode, test): (impl Mode, impl DepthTest),
    mvp: &Mvp,
    shader: &impl ShaderFor<Rgb565>,
) -> Vec<u16> {
    let (width, height) = SIZE;
    let mut color = vec![Rgb565::default(); (width * height) as usize];
    let mut depth = vec![0; color.len()];
    let canvas = Canvas::new(&mut color, width, height).unwrap();
    let mut canvas = canvas.with_depth_format::<F>(&mut depth).unwrap();
    let options = BOTH_SIDES.with_mode(mode).with_depth_test(test);
    canvas.draw_with(&options, mesh, mvp, shader);
    depth
}

/// Checks that a shader is drawn with depths equal to the depths of a plain color.
fn check<F: DepthBuffer, Z: DepthTest>(mesh: &Mesh<'_>, test: Z, mvp: &Mvp, mode: impl Mode) {
    let (plain, skin) = (Flat::new(Rgb565::default()), Textured::new(&SKIN));
    let plain = depths::<F>(mesh, (Newton::default(), test), mvp, &plain);
    let depths = depths::<F>(mesh, (mode, test), mvp, &Erased::new(&skin));
    let differ = depths.iter().zip(&plain).filter(|(a, b)| a != b).count();
    assert_eq!(differ, 0, "{}", type_name_of_val(&mode));
}

/// Checks the modes with the most and with the least work for a span.
fn check_ends<F: DepthBuffer, Z: DepthTest>(mesh: &Mesh<'_>, test: Z, mvp: &Mvp) {
    check::<F, Z>(mesh, test, mvp, Newton::default());
    check::<F, Z>(mesh, test, mvp, Affine);
}

/// Checks all modes.
fn check_all<F: DepthBuffer, Z: DepthTest>(mesh: &Mesh<'_>, test: Z, mvp: &Mvp) {
    check_ends::<F, Z>(mesh, test, mvp);
    check::<F, Z>(mesh, test, mvp, Fast::NARROW);
    check::<F, Z>(mesh, test, mvp, Fast::within(fx!(4)));
    check::<F, Z>(mesh, test, mvp, Exact);
}

fn lens() -> Projection {
    Projection::perspective(deg!(60), SIZE, fx!(0.1), fx!(1000)).unwrap()
}

const UVS: [Vec2; 4] = [vec2!(0, 0), vec2!(1, 0), vec2!(1, 1), vec2!(0, 1)];

/// The mesh is a floor, because the modes scale the far spans of a floor before they interpolate.
#[test]
fn a_slope_biases_all_modes_alike() {
    let floor = [
        vec3!(-3, -1, -1),
        vec3!(3, -1, -1),
        vec3!(9, -1, -60),
        vec3!(-9, -1, -60),
    ];
    let corners = [[0, 1, 2], [0, 2, 3]];
    let mesh = Mesh::new(&floor, &corners)
        .unwrap()
        .with_uvs(&UVS, None)
        .unwrap();
    for roll in [deg!(0), deg!(20), deg!(90)] {
        let mvp = lens() * Transform::rotate_z(roll);
        for slope in [fx!(-1), fx!(1), fx!(-7.5)] {
            let test = Biased::new(TestAndWrite, -2, slope);
            check_ends::<LinearDepth, _>(&mesh, test, &mvp);
            check_all::<FloatDepth, _>(&mesh, test, &mvp);
        }
    }
}

/// The width plus the height of these triangles is at most 43 pixels. At the nearest corner, 1/w is almost twice the
/// least number with the same exponent. Although these triangles are deep, they have small planes.
#[test]
fn small_deep_triangles_have_the_same_depths_in_all_modes() {
    cases(1000, |random| {
        // A corner is up to ten pixels from the middle of the picture. Its distance `w` is in units of 1/256.
        let mut corner = |w: i64| {
            let mut aside = || ((random.random_range(-11_800..11_800) * w) >> 8) as i32;
            Vec3::from_bits([aside(), aside(), -256 * w as i32])
        };
        let positions = [corner(400), corner(256 * 20), corner(256 * 30)];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
        let mesh = mesh.with_uvs(&UVS[..3], None).unwrap();
        let mvp = lens().into();
        check_all::<LinearDepth, _>(&mesh, TestAndWrite, &mvp);
        check_ends::<FloatDepth, _>(&mesh, TestAndWrite, &mvp);
        check_all::<FloatDepth, _>(&mesh, Biased::behind(TestAndWrite), &mvp);
    });
}

/// Draws a mesh with interpolated colors over stored depths.
fn over<C: PixelFormat + Default + PartialEq + Debug>(
    mesh: &Mesh<'_>,
    mode: impl Mode,
    stored: &[u16],
) -> (Vec<C>, Vec<u16>) {
    let (width, height) = SIZE;
    let (mut color, mut depth) = (vec![C::default(); stored.len()], stored.to_vec());
    let canvas = Canvas::new(&mut color, width, height).unwrap();
    let mut canvas = canvas.with_depth(&mut depth).unwrap();
    let options = BOTH_SIDES.with_mode(mode);
    canvas.draw_with(&options, mesh, &Mvp::from(lens()), &Gouraud::new());
    (color, depth)
}

/// Checks that a visible pixel has the color that it has if no pixel is hidden.
fn check_hidden<C: PixelFormat + Default + PartialEq + Debug>(
    mesh: &Mesh<'_>,
    mode: impl Mode,
    stored: &[u16],
) {
    let (alone, depths) = over::<C>(mesh, mode, &vec![0; stored.len()]);
    let found = over::<C>(mesh, mode, stored);
    let all = alone.iter().zip(depths.iter().zip(stored));
    let expected = all.map(|(color, (&depth, &stored))| {
        if depth >= stored {
            (*color, depth)
        } else {
            (C::default(), stored)
        }
    });
    assert_eq!(found, expected.unzip(), "{}", type_name_of_val(&mode));
}

/// Kernels skip hidden pixels at the start of a span. Colors of 4 bits are dithered by the place of a pixel, so they also
/// show whether a kernel loses its place.
#[test]
fn hidden_pixels_change_no_other_pixel() {
    let pixels = (SIZE.0 * SIZE.1) as usize;
    cases(96, |random| {
        let far = random.random_range(1..40);
        let corners = [[-9, -6], [9, -6], [0, 9]].map(|corner| {
            // Some triangles are small on the screen, some fill it.
            let [x, y] = corner.map(|at| at + random.random_range(-4..4));
            let z = random.random_range(far..=2 * far);
            Vec3::new(fx!(1) * x, fx!(1) * y, fx!(-1) * z)
        });
        let colors = [(); 3].map(|()| {
            let [r, g, b] = random.random();
            Rgb888::new(r, g, b)
        });
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        let mesh = mesh.with_colors(&colors, None).unwrap();
        let mut stored = Vec::new();
        while stored.len() < pixels {
            let hides = random.random_ratio(2, 3);
            let run = random.random_range(1..90);
            stored.resize(pixels.min(stored.len() + run), u16::from(hides) * 0xffff);
        }
        check_hidden::<Rgb565>(&mesh, Newton::default(), &stored);
        check_hidden::<Gray4>(&mesh, Newton::default(), &stored);
        check_hidden::<Gray4>(&mesh, Affine, &stored);
        check_hidden::<Rgb565>(&mesh, Fast::NARROW, &stored);
        check_hidden::<Gray4>(&mesh, Exact, &stored);
    });
}
