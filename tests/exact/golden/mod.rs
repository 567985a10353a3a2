//! Checksums of the pictures of the measured scenes and of the project's own scene.
//!
//! A checksum may change only on purpose: look at the picture (`simulator --scene NAME --out NAME.png`), explain the
//! change in the commit, and replace the checksum here. `.ci/run` checks that firmware draws the same pictures.

mod words;

use embedded_graphics::pixelcolor::raw::BigEndian;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mode::{Affine, Compact, Exact, Fast, Mode, Newton};
use fixel::prelude::*;

use crate::examples::lighthouse;
use crate::examples::scenes::{self, HEIGHT, WIDTH};
use support::erased::Erased;

/// `Exact` defines the result of the other modes.
const PASS: DrawOptions<Exact> = DrawOptions::new().with_mode(Exact);

pub type Target<'a> = Canvas<'a, Rgb565, BigEndian, LinearDepth>;

/// The CRC-32 of the picture's bytes, more significant byte first, and the number of pixels drawn.
fn picture(draw: &dyn Fn(&mut Target<'_>)) -> (u32, usize) {
    let mut pixels = vec![[0; 2]; (WIDTH * HEIGHT) as usize];
    let mut depths = vec![0; pixels.len()];
    let canvas = Canvas::<_, BigEndian>::new(&mut pixels, WIDTH, HEIGHT).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    canvas.clear(Rgb565::BLACK);
    draw(&mut canvas);
    let crc = crc32fast::hash(canvas.as_bytes());
    (crc, depths.iter().filter(|&&depth| depth > 0).count())
}

/// The checksums of a scene's eight poses, and the mean number of pixels drawn in a pose.
fn poses(draw: &dyn Fn(i32, &mut Target<'_>)) -> ([u32; 8], usize) {
    let poses = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| picture(&|canvas| draw(k, canvas)));
    let pixels: usize = poses.iter().map(|pose| pose.1).sum();
    (poses.map(|pose| pose.0), pixels.div_ceil(8))
}

#[test]
fn checksums_of_the_floor() {
    let drawn = picture(&|canvas| {
        scenes::floor(canvas, &PASS, &scenes::floor_mvp(0).unwrap());
    });
    assert_eq!(drawn, (0xcea2_0ac4, 47_610));
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
    let drawn = poses(&|k, canvas| {
        scenes::cube(canvas, &PASS, &scenes::cube_mvp(k).unwrap());
    });
    assert_eq!(drawn, (CRC, 30_716));
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
    let drawn = poses(&|k, canvas| {
        scenes::sphere(canvas, &PASS, &scenes::sphere_mvp(k).unwrap());
    });
    assert_eq!(drawn, (CRC, 30_526));
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
    let drawn = poses(&|k, canvas| {
        scenes::sphere_flat(canvas, &PASS, &scenes::sphere_mvp(k).unwrap());
    });
    assert_eq!(drawn, (CRC, 30_526));
}

/// Draws like [`lighthouse::draw`], which would also compile the night of displays without colors.
pub fn draw_lighthouse(canvas: &mut Target<'_>, mvp: &Mvp) {
    let waves = lighthouse::waves::<Rgb565>();
    let skin = lighthouse::skin::<Rgb565>().unwrap();
    canvas.draw_with(&PASS, &lighthouse::SEA, mvp, &Erased::new(&waves));
    canvas.draw_with(&PASS, &lighthouse::ISLAND, mvp, &Erased::new(&skin));
}

#[test]
fn checksum_of_the_lighthouse() {
    let (crc, _) = picture(&|canvas| {
        let projection = lighthouse::projection((WIDTH, HEIGHT)).unwrap();
        let mvp = projection * lighthouse::camera().unwrap() * Transform::IDENTITY;
        lighthouse::sky(canvas);
        draw_lighthouse(canvas, &mvp);
        lighthouse::caption(canvas);
    });
    assert_eq!(crc, 0x3861_112a);
}

/// The checksums of three pictures in a mode: the floor, and one pose each of the cube and of the sphere.
fn scenes_in<I: Mode>(mode: I) -> [u32; 3] {
    let options = DrawOptions::new().with_mode(mode);
    let (floor, _) = picture(&|canvas| {
        scenes::floor(canvas, &options, &scenes::floor_mvp(0).unwrap());
    });
    let (cube, _) = picture(&|canvas| {
        scenes::cube(canvas, &options, &scenes::cube_mvp(2).unwrap());
    });
    let (sphere, _) = picture(&|canvas| {
        scenes::sphere(canvas, &options, &scenes::sphere_mvp(1).unwrap());
    });
    [floor, cube, sphere]
}

#[test]
fn checksums_in_every_mode() {
    let exact = [0xcea2_0ac4, 0x9303_8f3d, 0xf88b_8fe9];
    assert_eq!(scenes_in(Exact), exact);
    // `Compact` can round values differently, but this changes no texel of these scenes.
    assert_eq!(scenes_in(Compact), exact);
    // `Newton` does not divide, and keeps red and blue in one number. Therefore some of the sphere's colors have an
    // error of a fourteenth of a step.
    assert_eq!(scenes_in(Newton), [0xcea2_0ac4, 0x9303_8f3d, 0x1014_91dc]);
    assert_eq!(
        scenes_in(Fast::within(fx!(0.25))),
        [0xcea2_0ac4, 0xad31_9453, 0x1014_91dc]
    );
    assert_eq!(scenes_in(Affine), [0x96f7_ce3f, 0x713d_66be, 0x1014_91dc]);
}
