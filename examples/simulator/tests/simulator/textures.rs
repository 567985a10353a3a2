//! Textures: what the program does with pictures after it has read them.

use std::fs;

use image::{Rgb, RgbImage};

use super::program::{directory, good, printed, refused};

/// A smooth picture.
fn colors(width: u32, height: u32) -> RgbImage {
    let color = |x, y| Rgb([x * 255 / width, y * 255 / height, 128].map(|value| value as u8));
    RgbImage::from_fn(width, height, color)
}

#[test]
fn a_texture_is_drawn_texel_by_texel_or_resampled() {
    let directory = directory("textures");
    // A square of one unit, two units from the eye, fills the picture. Each pixel shows one texel.
    let square =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    fs::write(directory.join("s.obj"), square).unwrap();
    let view = "--eye 0.5,0.5,2 --look-at 0.5,0.5,0 --fov 28.072486935852957 --near 1 --far 3";
    let look = "--size 64x64 --shade texture --color rgb888 --out o.png";
    // Other sizes are resampled. A ramp of colors stays a ramp, except at the picture's border, where neighbors are
    // missing.
    for (width, height, within) in [(64, 64, 0), (48, 80, 8), (85, 52, 8)] {
        colors(width, height)
            .save(directory.join("skin.png"))
            .unwrap();
        let said = good(
            &directory,
            &format!("s.obj --texture skin.png {view} {look}"),
        );
        assert_eq!(printed(&said, "pixels"), "4096");
        let found = image::open(directory.join("o.png")).unwrap().into_rgb8();
        for (found, wanted) in found.pixels().zip(colors(64, 64).pixels()) {
            for (found, wanted) in found.0.into_iter().zip(wanted.0) {
                assert!(found.abs_diff(wanted) <= within, "{width}x{height}");
            }
        }
    }
    let whole = fs::read(directory.join("skin.png")).unwrap();
    fs::write(directory.join("cut.png"), &whole[..whole.len() / 2]).unwrap();
    let says = ["cannot read texture cut.png: "];
    refused(&directory, "s.obj --texture cut.png", &says);
}
