//! Checksums of the pictures of the measured scenes and of the project's own scene.
//!
//! A checksum may change only on purpose: look at the pictures that the failing test names, explain the change in the
//! commit, and renew the checksum and the picture. The first picture of each scene is kept in this folder, and so are
//! the pictures of all features. `.ci/run` checks that firmware draws the same pictures.

mod kept;
mod words;

use embedded_graphics::pixelcolor::raw::{BigEndian, ToBytes};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mode::{Affine, Compact, Exact, Fast, Mode, Newton};
use fixel::prelude::*;

use self::kept::{Picture, check};
use crate::examples::lighthouse;
use crate::examples::scenes::{self, HEIGHT, WIDTH};
use support::erased::Erased;

/// `Exact` defines the result of the other modes.
const PASS: DrawOptions<Exact> = DrawOptions::new().with_mode(Exact);

pub type Target<'a> = Canvas<'a, Rgb565, BigEndian, LinearDepth>;

/// Draws a picture, and counts the pixels drawn. The checksum is the CRC-32 of the picture's bytes, more significant
/// byte first.
fn picture(name: &str, stated: u32, draw: &dyn Fn(&mut Target<'_>)) -> (Picture, usize) {
    let mut pixels = vec![[0; 2]; (WIDTH * HEIGHT) as usize];
    let mut depths = vec![0; pixels.len()];
    let canvas = Canvas::<_, BigEndian>::new(&mut pixels, WIDTH, HEIGHT).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    canvas.clear(Rgb565::BLACK);
    draw(&mut canvas);
    let picture = Picture {
        name: name.to_string(),
        stated,
        checksum: crc32fast::hash(canvas.as_bytes()),
        // Each color of 16 bits has its own color of 24 bits.
        rgb: canvas
            .pixels()
            .flat_map(|color| Rgb888::from(color).to_be_bytes())
            .collect(),
    };
    (picture, depths.iter().filter(|&&depth| depth > 0).count())
}

/// Checks a scene's poses against their checksums. Returns the mean number of pixels drawn in a pose.
fn poses(scene: &str, stated: &[u32], draw: &dyn Fn(i32, &mut Target<'_>)) -> usize {
    let poses = (0..).zip(stated).map(|(k, stated)| {
        let name = format!("pose {k}");
        picture(&name, *stated, &|canvas| draw(k, canvas))
    });
    let (pictures, pixels): (Vec<_>, Vec<_>) = poses.unzip();
    check(scene, WIDTH as usize, 1, &pictures);
    pixels.iter().sum::<usize>().div_ceil(pixels.len())
}

#[test]
fn checksums_of_the_floor() {
    let pixels = poses("floor", &[0xcea2_0ac4], &|k, canvas| {
        scenes::floor(canvas, &PASS, &scenes::floor_mvp(k).unwrap());
    });
    assert_eq!(pixels, 47_610);
}

#[test]
fn checksums_of_the_cube() {
    const CRC: [u32; 8] = [
        0xa794_e6c7,
        0x5a50_131f,
        0x9303_8f3d,
        0x74ea_8a67,
        0x977b_e121,
        0x5be7_c2f5,
        0x0c11_f830,
        0xedad_0d90,
    ];
    let pixels = poses("cube", &CRC, &|k, canvas| {
        scenes::cube(canvas, &PASS, &scenes::cube_mvp(k).unwrap());
    });
    assert_eq!(pixels, 30_716);
}

#[test]
fn checksums_of_the_sphere() {
    const CRC: [u32; 8] = [
        0x68f1_34c5,
        0xf88b_8fe9,
        0x8b37_7054,
        0xd04c_eb25,
        0xed0e_2476,
        0x1596_6a58,
        0x7e38_1dc7,
        0xd01a_b1a1,
    ];
    let pixels = poses("sphere", &CRC, &|k, canvas| {
        scenes::sphere(canvas, &PASS, &scenes::sphere_mvp(k).unwrap());
    });
    assert_eq!(pixels, 30_526);
}

#[test]
fn checksums_of_the_flat_sphere() {
    const CRC: [u32; 8] = [
        0xed76_e033,
        0xfdbf_f1fe,
        0x5d7e_ec78,
        0xe9b9_1ad0,
        0x702a_973f,
        0x0249_32c5,
        0xf707_4a99,
        0x7d26_1f71,
    ];
    let pixels = poses("flat_sphere", &CRC, &|k, canvas| {
        scenes::sphere_flat(canvas, &PASS, &scenes::sphere_mvp(k).unwrap());
    });
    assert_eq!(pixels, 30_526);
}

/// Draws the lighthouse in color. (`lighthouse::draw` would also compile the night of displays without colors.)
pub fn draw_lighthouse(canvas: &mut Target<'_>) {
    let projection = lighthouse::projection((WIDTH, HEIGHT)).unwrap();
    let mvp = projection * lighthouse::camera().unwrap() * Transform::IDENTITY;
    let waves = lighthouse::waves::<Rgb565>();
    let skin = lighthouse::skin::<Rgb565>().unwrap();
    let shaders = (&Erased::new(&waves), &Erased::new(&skin));
    lighthouse::sky(canvas);
    lighthouse::surfaces(canvas, &PASS, &mvp, shaders);
    lighthouse::caption(canvas);
}

#[test]
fn checksum_of_the_lighthouse() {
    poses("lighthouse", &[0x081f_5f38], &|_, canvas| {
        draw_lighthouse(canvas);
    });
}

/// Checks three pictures in a mode: the floor, and one pose each of the cube and of the sphere.
fn scenes_in<I: Mode>(name: &str, mode: I, [floor, cube, sphere]: [u32; 3]) {
    let options = DrawOptions::new().with_mode(mode);
    let pictures = [
        picture("floor", floor, &|canvas| {
            scenes::floor(canvas, &options, &scenes::floor_mvp(0).unwrap());
        }),
        picture("cube", cube, &|canvas| {
            scenes::cube(canvas, &options, &scenes::cube_mvp(2).unwrap());
        }),
        picture("sphere", sphere, &|canvas| {
            scenes::sphere(canvas, &options, &scenes::sphere_mvp(1).unwrap());
        }),
    ];
    check(
        name,
        WIDTH as usize,
        0,
        &pictures.map(|(picture, _)| picture),
    );
}

#[test]
fn checksums_in_every_mode() {
    let exact = [0xcea2_0ac4, 0x9303_8f3d, 0xf88b_8fe9];
    scenes_in("Exact", Exact, exact);
    // `Compact` can round values differently, but this changes no texel of these scenes.
    scenes_in("Compact", Compact, exact);
    // `Newton` does not divide, and keeps red and blue in one number. Therefore some of the sphere's colors have an
    // error of a fourteenth of a step.
    scenes_in(
        "Newton",
        Newton::default(),
        [0xcea2_0ac4, 0x9303_8f3d, 0x1014_91dc],
    );
    let fast = [0xcea2_0ac4, 0xad31_9453, 0x1014_91dc];
    scenes_in("Fast", Fast::within(fx!(0.25)), fast);
    scenes_in("Affine", Affine, [0x96f7_ce3f, 0x713d_66be, 0x1014_91dc]);
}
