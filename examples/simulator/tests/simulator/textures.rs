//! Textures: what the program does with pictures after it has read them.

use image::{Rgb, RgbImage};

use super::program::{Bench, printed};

/// A smooth picture.
fn colors(width: u32, height: u32) -> RgbImage {
    let color = |x, y| Rgb([x * 255 / width, y * 255 / height, 128].map(|value| value as u8));
    RgbImage::from_fn(width, height, color)
}

#[test]
fn a_texture_is_drawn_texel_by_texel_or_resampled() {
    let bench = Bench::new("textures");
    // A square of one unit, two units from the eye, fills the picture. Each pixel shows one texel.
    let square =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    bench.write("s.obj", square);
    let view = "--eye 0.5,0.5,2 --look-at 0.5,0.5,0 --fov 28.072486935852957 --near 1 --far 3";
    let look = "--size 64x64 --shade texture --color rgb888 --out o.png";
    // Other sizes are resampled. A ramp of colors stays a ramp, except at the picture's border, where neighbors are
    // missing.
    for (width, height, within) in [(64, 64, 0), (48, 80, 8), (85, 52, 8)] {
        colors(width, height).save(bench.path("skin.png")).unwrap();
        let said = bench.good(format!("s.obj --texture skin.png {view} {look}"));
        assert_eq!(printed(&said, "pixels"), "4096");
        let found = bench.picture("o.png");
        for (found, wanted) in found.pixels().zip(colors(64, 64).pixels()) {
            for (found, wanted) in found.0.into_iter().zip(wanted.0) {
                assert!(found.abs_diff(wanted) <= within, "{width}x{height}");
            }
        }
    }
    let whole = bench.read("skin.png");
    bench.write("cut.png", &whole[..whole.len() / 2]);
    let says = ["cannot read texture cut.png: "];
    bench.refused("s.obj --texture cut.png", &says);
}
