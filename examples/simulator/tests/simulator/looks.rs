//! Shades, colors, filters, depths, and options without effect.

use image::{Rgb, RgbImage};

use super::program::{Bench, TRIANGLE, printed};

#[test]
fn every_look_projection_and_color_gives_a_picture() {
    let bench = Bench::new("looks");
    bench.write(
        "cube.obj",
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
         f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n",
    );
    for shade in [
        "texture", "gouraud", "flat", "lit", "wire", "depth", "normal",
    ] {
        for color in ["rgb565", "rgb888", "gray8", "gray4", "mono"] {
            for projection in ["perspective", "cabinet"] {
                let look = format!("--shade {shade} --color {color} --projection {projection}");
                let said = bench.good(format!("cube.obj --size 64x48 {look}"));
                let pixels: u32 = printed(&said, "pixels").parse().unwrap();
                assert!(pixels > 100, "{look}: {said}");
            }
        }
    }
    assert_eq!(bench.picture("cube.png").dimensions(), (64, 48));
}

#[test]
fn a_filter_changes_only_colors() {
    let bench = Bench::new("filter");
    bench.write("t.obj", TRIANGLE);
    for shade in ["texture", "lit"] {
        for color in ["rgb565", "rgb888", "gray8", "gray4", "mono"] {
            let draw = |filter| {
                let look = format!("--filter {filter} --shade {shade} --color {color}");
                let said = bench.good(format!("t.obj --size 64x48 --crc {look}"));
                let word = |label| printed(&said, label).to_string();
                [word("pixels"), word("crc")]
            };
            let (nearest, bilinear) = (draw("nearest"), draw("bilinear"));
            assert_eq!(nearest[0], bilinear[0], "{shade} {color}");
            assert_ne!(nearest[1], bilinear[1], "{shade} {color}");
        }
    }
}

/// Two plates at 60,000 times the distance of the near plane. One plate is a hundredth farther away than the other. In
/// linear steps, both plates have the same depth, so the last plate in the file shows.
#[test]
fn float_depth_keeps_the_order_of_distant_surfaces() {
    let bench = Bench::new("far");
    let (front, back) = ("f 1//1 2//1 3//1 4//1\n", "f 5//2 6//2 7//2 8//2\n");
    let plates = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nv -9 -9 -6\nv 9 -9 -6\nv 9 9 -6\nv -9 9 -6\n\
                  vn 1 0 0\nvn 0 1 0\n";
    bench.write("a.obj", format!("{plates}{front}{back}"));
    bench.write("b.obj", format!("{plates}{back}{front}"));
    let view =
        "--eye 0,0,600 --look-at 0,0,0 --fov 1 --near 0.01 --far 655 --size 32x24 --shade normal";
    let crc = |model: &str, depth: &str| bench.crc(format!("{model} {view} --depth {depth}"));
    assert_eq!(crc("a.obj", "float"), crc("b.obj", "float"));
    assert_eq!(crc("a.obj", "wide"), crc("b.obj", "wide"));
    assert_eq!(crc("a.obj", "wide"), crc("b.obj", "float"));
    assert_ne!(crc("a.obj", "linear"), crc("b.obj", "linear"));
    assert_eq!(crc("b.obj", "linear"), crc("b.obj", "float"));
}

#[test]
fn an_option_without_effect_is_named() {
    let bench = Bench::new("idle");
    bench.write("t.obj", TRIANGLE);
    let colored = TRIANGLE
        .replace("0\nv", "0 1 0.5 0\nv")
        .replace("1 0\nf", "1 0 0 1 0\nf");
    bench.write("colored.obj", colored);
    let texture = RgbImage::from_fn(4, 4, |x, y| Rgb([if x == y { 9 } else { 250 }, 99, 200]));
    texture.save(bench.path("t.png")).unwrap();
    let shot = |arguments: &str| {
        let (said, notes) = bench.outputs(format!("{arguments} --out out.gif --crc"));
        (
            printed(&String::from_utf8(said).unwrap(), "crc").to_string(),
            notes,
        )
    };
    // Each option, with the rest of its command line. Without the option, the result must be the same.
    for (option, rest) in [
        ("--mode affine", "t.obj --shade flat"),
        ("--mode affine", "t.obj --shade wire"),
        ("--mode fast", "t.obj --shade depth"),
        ("--mode exact", "t.obj --projection cabinet"),
        ("--mode affine", "--scene sphere-flat"),
        ("--texture t.png", "t.obj --shade gouraud"),
        ("--texture t.png", "t.obj --shade normal"),
        ("--filter bilinear", "t.obj"),
        ("--filter bilinear", "colored.obj"),
        ("--filter bilinear", "t.obj --shade wire"),
        ("--light 1,2,3", "t.obj --shade texture"),
        ("--ambient 0.5", "t.obj --shade normal"),
        ("--fog 1,9", "t.obj --shade depth"),
        ("--wire", "t.obj --shade wire"),
        ("--fov 60", "t.obj --projection orthographic --shade normal"),
    ] {
        let (with, notes) = shot(&format!("{rest} {option}"));
        let (without, none) = shot(rest);
        let name = option.split(' ').next().unwrap();
        assert!(
            notes.starts_with(&format!("note: {name}")) && notes.contains(" has no effect "),
            "{rest} {option}: {notes}"
        );
        assert!(!none.contains(name), "{rest}: {none}");
        assert_eq!(with, without, "{rest} {option}");
    }
    for (effective, option) in [
        ("t.obj --mode affine --shade flat --dump d.csv", "--mode"),
        ("t.obj --texture t.png --filter bilinear", "--filter"),
        ("t.obj --fog 1,9 --ambient 0", "--"),
        (
            "t.obj --projection orthographic --eye 0.3,0.3,4 --fov 60",
            "--",
        ),
        ("--mode affine", "--"),
    ] {
        let notes = shot(effective).1;
        assert!(!notes.contains(option), "{effective}: {notes}");
    }
    // Without the shade, the fog would be an error.
    bench.good("t.obj --shade wire --fog 0,1e-9");
}
