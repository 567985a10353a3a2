//! Shades, colors, filters and depths.

use std::fs;

use super::program::{TRIANGLE, directory, good, png_size, printed};

#[test]
fn every_look_projection_and_color_gives_a_picture() {
    let directory = directory("looks");
    fs::write(
        directory.join("cube.obj"),
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
         f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n",
    )
    .unwrap();
    for shade in [
        "texture", "gouraud", "flat", "lit", "wire", "depth", "normal",
    ] {
        for color in ["rgb565", "rgb888", "gray8", "gray4", "mono"] {
            for projection in ["perspective", "cabinet"] {
                let said = good(
                    &directory,
                    &format!(
                        "cube.obj --size 64x48 --shade {shade} --color {color} --projection {projection}"
                    ),
                );
                let pixels: u32 = printed(&said, "pixels").parse().unwrap();
                assert!(pixels > 100, "{shade} {color} {projection}: {said}");
            }
        }
    }
    assert_eq!(png_size(&directory.join("cube.png")), (64, 48));
}

#[test]
fn a_filter_changes_only_colors() {
    let directory = directory("filter");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    for shade in ["texture", "lit"] {
        for color in ["rgb565", "rgb888", "gray8", "gray4", "mono"] {
            let draw = |filter| {
                let look = format!("--filter {filter} --shade {shade} --color {color}");
                let said = good(&directory, &format!("t.obj --size 64x48 --crc {look}"));
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
    let directory = directory("far");
    let (front, back) = ("f 1//1 2//1 3//1 4//1\n", "f 5//2 6//2 7//2 8//2\n");
    let plates = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nv -9 -9 -6\nv 9 -9 -6\nv 9 9 -6\nv -9 9 -6\n\
                  vn 1 0 0\nvn 0 1 0\n";
    fs::write(directory.join("a.obj"), format!("{plates}{front}{back}")).unwrap();
    fs::write(directory.join("b.obj"), format!("{plates}{back}{front}")).unwrap();
    let crc = |model: &str, depth: &str| {
        let view = "--eye 0,0,600 --look-at 0,0,0 --fov 1 --near 0.01 --far 655 --size 32x24";
        let said = good(
            &directory,
            &format!("{model} {view} --shade normal --crc --depth {depth}"),
        );
        printed(&said, "crc").to_string()
    };
    assert_eq!(crc("a.obj", "float"), crc("b.obj", "float"));
    assert_eq!(crc("a.obj", "wide"), crc("b.obj", "wide"));
    assert_eq!(crc("a.obj", "wide"), crc("b.obj", "float"));
    assert_ne!(crc("a.obj", "linear"), crc("b.obj", "linear"));
    assert_eq!(crc("b.obj", "linear"), crc("b.obj", "float"));
}
