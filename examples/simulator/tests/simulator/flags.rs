//! Options that have no effect, and the meaning of --tolerance.

use std::fs;
use std::path::Path;

use image::{Rgb, RgbImage};

use super::program::{TRIANGLE, directory, good, printed, run};

#[test]
fn an_option_without_effect_is_named() {
    let directory = directory("idle");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let colored = TRIANGLE
        .replace("0\nv", "0 1 0.5 0\nv")
        .replace("1 0\nf", "1 0 0 1 0\nf");
    fs::write(directory.join("colored.obj"), colored).unwrap();
    let texture = RgbImage::from_pixel(4, 4, Rgb([9, 99, 200]));
    texture.save(directory.join("t.png")).unwrap();
    let shot = |arguments: &str| {
        let output = run(&directory, &format!("{arguments} --out out.gif --crc"));
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{arguments}: {errors}");
        let said = String::from_utf8(output.stdout).unwrap();
        (printed(&said, "crc").to_string(), errors)
    };
    // Each option with the rest of its command line: without the option, the run must be the same.
    for (option, rest) in [
        ("--tolerance 3", "t.obj"),
        ("--tolerance 3", "t.obj --mode exact"),
        ("--tolerance 3", "--scene cube"),
        ("--tolerance 3", "t.obj --mode fast"),
        ("--mode affine", "t.obj --shade flat"),
        ("--mode affine", "t.obj --shade wire"),
        ("--mode fast", "t.obj --shade depth"),
        ("--mode exact", "t.obj --projection cabinet"),
        ("--mode affine", "--projection orthographic"),
        ("--mode affine", "--scene sphere-flat"),
        ("--depth float", "--scene sphere-flat"),
        ("--texture t.png", "t.obj --shade gouraud"),
        ("--texture t.png", "t.obj --shade normal"),
        ("--filter bilinear", "t.obj"),
        ("--filter bilinear", "colored.obj"),
        ("--tolerance 3", "colored.obj --mode fast"),
        ("--tolerance 3", "--scene sphere --mode fast"),
        ("--depth wide", "t.obj --shade wire"),
        ("--filter bilinear", "t.obj --shade wire"),
        ("--two-sided", "t.obj --shade wire"),
        ("--rpm 7", "t.obj"),
        ("--fov 60", "t.obj --projection orthographic --shade normal"),
    ] {
        let (with, notes) = shot(&format!("{rest} {option}"));
        let (without, none) = shot(rest);
        let name = option.split(' ').next().unwrap();
        assert!(
            notes.starts_with(&format!("note: {name}")) && notes.contains(" has no effect "),
            "{rest} {option}: {notes}"
        );
        assert_eq!(none, "", "{rest}");
        assert_eq!(with, without, "{rest} {option}");
    }
    for effective in [
        "t.obj --shade lit --mode fast --tolerance 3",
        "t.obj --mode fast --tolerance 3 --dump d.csv",
        "t.obj --mode affine --shade flat --dump d.csv",
        "t.obj --texture t.png --filter bilinear",
        "t.obj --two-sided",
        "t.obj --frames 2 --rpm 7",
        "t.obj --projection orthographic --eye 0.3,0.3,4 --fov 60",
        "--mode affine",
    ] {
        assert_eq!(shot(effective).1, "", "{effective}");
    }
}

/// A floor that shows its texture once. The camera is tilted sideways, so that distances change along each row.
const FLOOR: &str =
    "v -1 0 0\nv 1 0 0\nv 1 0 -8\nv -1 0 -8\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
const VIEW: &str = "floor.obj --eye 0.5,1,1 --look-at 0.5,0,-4 --up 1,1,0 --fov 70 --shade texture";

fn noise(side: u32) -> RgbImage {
    RgbImage::from_fn(side, side, |x, y| {
        let hash = (x * 7919 + y * 104_729).wrapping_mul(2_654_435_761) >> 8;
        let [a, b, c, _] = hash.to_le_bytes();
        Rgb([a, b, c])
    })
}

/// Returns u and v of each pixel of the dump.
fn dumped(directory: &Path, arguments: &str) -> Vec<[f64; 2]> {
    good(directory, &format!("{arguments} --dump d.csv"));
    let dump = fs::read_to_string(directory.join("d.csv")).unwrap();
    let cell = |row: &str, at| row.split(',').nth(at).unwrap().parse().unwrap();
    dump.lines()
        .skip(1)
        .map(|row| [cell(row, 2), cell(row, 3)])
        .collect()
}

#[test]
fn a_tolerance_is_in_texels_of_the_given_texture() {
    let directory = directory("tolerance");
    fs::write(directory.join("floor.obj"), FLOOR).unwrap();
    // The dump.
    for side in [16_u32, 64, 1500] {
        noise(side).save(directory.join("given.png")).unwrap();
        let view = format!("{VIEW} --texture given.png");
        let exact = dumped(&directory, &format!("{view} --mode exact"));
        for tolerance in [0.25, 2.0] {
            let fast = dumped(
                &directory,
                &format!("{view} --mode fast --tolerance {tolerance}"),
            );
            assert_eq!(fast.len(), exact.len());
            let error =
                |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
            let worst = fast.iter().zip(&exact).map(error).fold(0.0, f64::max) * f64::from(side);
            // The reciprocals add 2^-13 of the largest coordinate, which is 1.
            let most = tolerance + f64::from(side) / 8192.0;
            assert!(worst <= most, "{side} {tolerance}: {worst}");
            // On a small texture, even the longest possible pieces have a smaller error.
            assert!(
                side < 1500 || worst > tolerance / 10.0,
                "{tolerance}: {worst}"
            );
        }
    }
    // The picture. The program reduces 2048 texels to 1024, so two given texels are one drawn texel.
    let given = noise(2048);
    let drawn = RgbImage::from_fn(1024, 1024, |x, y| {
        let four =
            [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| given.get_pixel(2 * x + i, 2 * y + j));
        let sum = |channel: usize| {
            four.iter()
                .map(|pixel| u16::from(pixel[channel]))
                .sum::<u16>()
        };
        Rgb([0, 1, 2].map(|channel| u8::try_from((sum(channel) + 2) / 4).unwrap()))
    });
    given.save(directory.join("given.png")).unwrap();
    drawn.save(directory.join("drawn.png")).unwrap();
    let crc = |texture: &str, tolerance: f64| {
        let look = format!("--mode fast --tolerance {tolerance} --texture {texture} --crc");
        printed(&good(&directory, &format!("{VIEW} {look}")), "crc").to_string()
    };
    assert_eq!(crc("given.png", 1.0), crc("drawn.png", 0.5));
    assert_ne!(crc("given.png", 1.0), crc("drawn.png", 1.0));
}
