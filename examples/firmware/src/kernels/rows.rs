//! Measures spheres of the same size with different numbers of vertices in their rows, and spheres with different
//! numbers of triangles. No number of vertices may take much more time than the next number.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mesh::{Buffers, Shape};
use fixel::prelude::*;
use static_cell::ConstStaticCell;

use super::common::scenes;
use super::frames::Frame;
use super::ticks::Stopwatch;

/// The numbers of vertices in a row of a sphere: numbers near powers of two, and near the number of vertices that a
/// draw call keeps.
const ROWS: [(&str, u32); 17] = [
    ("rows-of-31", 31),
    ("rows-of-32", 32),
    ("rows-of-33", 33),
    ("rows-of-47", 47),
    ("rows-of-48", 48),
    ("rows-of-62", 62),
    ("rows-of-63", 63),
    ("rows-of-64", 64),
    ("rows-of-65", 65),
    ("rows-of-96", 96),
    ("rows-of-127", 127),
    ("rows-of-128", 128),
    ("rows-of-129", 129),
    ("rows-of-200", 200),
    ("rows-of-255", 255),
    ("rows-of-256", 256),
    ("rows-of-300", 300),
];

/// The approximate number of triangles of each of these spheres.
const TRIANGLES: u32 = 2000;

/// Spheres: the number of slices, which is also the number of stacks, and two names with the number of triangles. The
/// first name is for interpolated colors, the second for one color. The measured sphere has 32 slices and stacks.
const SIZES: [(u32, [&str; 2]); 6] = [
    (16, ["sphere-480", "sphere-flat-480"]),
    (32, ["sphere-1984", "sphere-flat-1984"]),
    (48, ["sphere-4512", "sphere-flat-4512"]),
    (56, ["sphere-6160", "sphere-flat-6160"]),
    (63, ["sphere-7812", "sphere-flat-7812"]),
    (64, ["sphere-8064", "sphere-flat-8064"]),
];

/// Spheres whose light is computed, and the names of their rows.
const LIT: [(u32, &str); 3] = [
    (16, "sphere-lit-480"),
    (32, "sphere-lit-1984"),
    (63, "sphere-lit-7812"),
];

/// The number of vertices of the largest sphere.
const MOST: usize = 65 * 65;
static POSITIONS: ConstStaticCell<[Vec3; MOST]> = ConstStaticCell::new([Vec3::ZERO; MOST]);
static COLORS: ConstStaticCell<[Rgb888; MOST]> = ConstStaticCell::new([Rgb888::BLACK; MOST]);
static UVS: ConstStaticCell<[Vec2; MOST]> = ConstStaticCell::new([Vec2::ZERO; MOST]);
static NORMALS: ConstStaticCell<[Vec3; MOST]> = ConstStaticCell::new([Vec3::ZERO; MOST]);
static FACES: ConstStaticCell<[[u16; 3]; 8064]> = ConstStaticCell::new([[0; 3]; 8064]);

/// Draws the spheres with interpolated colors and a depth buffer, and in one color without a depth buffer; lit and
/// textured spheres with a depth buffer.
pub fn measure(watch: &mut Stopwatch, frame: &mut Frame) -> Result<(), Error> {
    let (positions, faces, colors) = (POSITIONS.take(), FACES.take(), COLORS.take());
    let (red, options) = (Flat::new(Rgb565::RED), DrawOptions::new());
    for (slices, [colored, flat]) in SIZES {
        let sphere = Shape::sphere(slices, slices)?;
        let ball = sphere.build(Buffers::new(&mut *positions, &mut *faces))?;
        let places = ball.positions();
        for (color, at) in colors.iter_mut().zip(0..places.len()) {
            // The normal of a unit sphere equals the position.
            let normal = places.get(at).unwrap_or(Vec3::ZERO).to_bits();
            let [r, g, b] = scenes::lit(normal);
            *color = Rgb888::new(r, g, b);
        }
        let ball = ball.with_colors(&colors[..places.len()], None)?;
        let (mode, posed) = (("newton", &options), scenes::sphere_mvp);
        frame.mesh(watch, mode, (colored, &ball, posed), &Gouraud::new(), true)?;
        frame.mesh(watch, mode, (flat, &ball, posed), &red, false)?;
    }
    let (mode, posed) = (("newton", &options), scenes::sphere_mvp);
    let sun = black_box(Light::new(vec3!(2, 3, 6), fx!(0.25), fx!(0.75))?);
    let clay = Flat::rgb(Rgb888::new(250, 170, 90)).lit(sun);
    let skin = Textured::new(&scenes::CHECKER);
    let (uvs, normals) = (UVS.take(), NORMALS.take());
    for (slices, name) in LIT {
        let ball = Shape::sphere(slices, slices)?.build(Buffers {
            uvs: &mut *uvs,
            normals: &mut *normals,
            ..Buffers::new(&mut *positions, &mut *faces)
        })?;
        frame.mesh(watch, mode, (name, &ball, posed), &clay, true)?;
        if slices == 32 {
            frame.mesh(watch, mode, ("sphere-textured", &ball, posed), &skin, true)?;
            let lit = skin.lit(sun);
            frame.mesh(
                watch,
                mode,
                ("sphere-textured-lit", &ball, posed),
                &lit,
                true,
            )?;
        }
    }
    let mvp = scenes::sphere_mvp(0)?;
    for (name, length) in ROWS {
        let slices = length - 1;
        let sphere = Shape::sphere(slices, TRIANGLES / (2 * slices) + 1)?;
        let ball = sphere.build(Buffers::new(&mut *positions, &mut *faces))?;
        let mut canvas = frame.canvas()?;
        let ticks = watch.time(|| {
            let drawn = canvas.draw(&ball, &mvp, &red);
            assert!(drawn.drawn > 0 && drawn.clipped == 0);
            Ok::<_, Error>(())
        })?;
        watch.print(name, "triangle", ball.faces().len() as u32, ticks);
    }
    Ok(())
}
