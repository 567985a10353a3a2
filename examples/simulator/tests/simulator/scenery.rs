//! Checks pixels of pictures with backgrounds, lights, fog, edges, samples and tiles.

use std::fmt::Write;

use super::program::Bench;

/// A square of two units in the plane z = 0 that faces the viewer, and a square behind it to the right.
const SQUARES: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n\
                       v 1 -1 -8\nv 9 -1 -8\nv 9 9 -8\nv 1 9 -8\nf 1 2 3 4\nf 5 6 7 8\n";
/// A view with four pixels per unit. The front square is in the middle.
const FRONT: &str =
    "--eye 0,0,5 --look-at 0,0,0 --projection orthographic --near 1 --far 20 --size 32x32";

type Rgb = [u8; 3];

/// Draws a picture. Returns its pixels row by row.
fn draw(bench: &Bench, arguments: impl AsRef<str>) -> Vec<Rgb> {
    bench
        .draw(arguments)
        .pixels()
        .map(|pixel| pixel.0)
        .collect()
}

fn squares(test: &str) -> Bench {
    let bench = Bench::new(test);
    bench.write("s.obj", SQUARES);
    bench
}

#[test]
fn a_background_has_the_color_that_was_asked_for() {
    let bench = squares("background");
    let corner = |look: &str| draw(&bench, format!("s.obj {FRONT} --fov 80 {look}"))[31 * 32];
    for (look, color) in [
        ("--color rgb888 --background 123456", [0x12, 0x34, 0x56]),
        ("--color rgb888 --background #123456", [0x12, 0x34, 0x56]),
        ("--background ff0000", [255, 0, 0]),
        ("--shade depth --background 00ff00", [0, 255, 0]),
    ] {
        assert_eq!(corner(look), color, "{look}");
    }
    // A gray background is dithered, too.
    let gray = draw(
        &bench,
        format!("s.obj {FRONT} --fov 80 --color mono --background 808080"),
    );
    let top = gray[..32 * 4].iter();
    let white = top.filter(|pixel| pixel[0] == 255).count();
    assert!((48..80).contains(&white), "{white} of 128");
}

#[test]
fn lights_add_up_in_their_colors() {
    let bench = squares("lights");
    let middle = |look: &str| {
        let all = format!("s.obj {FRONT} --color rgb888 {look}");
        draw(&bench, &all)[16 * 32 + 14]
    };
    for shade in ["gouraud", "flat"] {
        // Clay is (236, 214, 190). A light from straight ahead gives 0.7 of this color, and a light at 60 degrees gives
        // half as much.
        for (look, wanted) in [
            ("0 --light 0,0,1", [165.2, 149.8, 133.0]),
            ("0 --light 0,0,200", [165.2, 149.8, 133.0]),
            ("0 --light 1.7320508,0,1", [82.6, 74.9, 66.5]),
            ("0 --light 0,0,-1", [0.0; 3]),
            ("0 --light 0,0,1,ff0000", [165.2, 0.0, 0.0]),
            (
                "0 --light 0,0,1,ff0000 --light 0,0,1,0000ff",
                [165.2, 0.0, 133.0],
            ),
            (
                "0 --light 1.7320508,0,1 --light 1.7320508,0,1",
                [165.2, 149.8, 133.0],
            ),
            ("1 --light 0,0,-1", [236.0, 214.0, 190.0]),
        ] {
            let found = middle(&format!("--shade {shade} --ambient {look}"));
            let mut pairs = found.into_iter().zip(wanted);
            let is_near = pairs.all(|(found, wanted)| (f64::from(found) - wanted).abs() <= 1.0);
            assert!(is_near, "{shade} {look}: {found:?} for {wanted:?}");
        }
    }
}

#[test]
fn fog_hides_by_distance() {
    let bench = squares("fog");
    // The front square is at a distance of 5.
    let middle = |fog: &str| {
        let all = format!("s.obj {FRONT} --shade texture --color rgb888 {fog}");
        draw(&bench, &all)[16 * 32 + 14]
    };
    let bare = middle("");
    assert_eq!(middle("--fog 6,9,ff0000"), bare);
    assert_eq!(middle("--fog 1,4,ff0000"), [255, 0, 0]);
    assert_eq!(middle("--fog 1,4 --background 00ff00"), [0, 255, 0]);
    // Half of the color shows. The error is up to 1/256, one step of the blend, plus up to 1/200 by the fog's density.
    let half = middle("--fog 3,7,000000");
    for (half, bare) in half.iter().zip(bare) {
        assert!(
            (f64::from(*half) - f64::from(bare) / 2.0).abs() <= 3.0,
            "{half} of {bare}"
        );
    }
    // In format mono, textures have another color type than the canvas. Fog and background must still have the same
    // color, black.
    let hidden = draw(
        &bench,
        format!("s.obj {FRONT} --shade texture --color mono --fog 1,4"),
    );
    assert!(hidden.iter().all(|&pixel| pixel == [0; 3]));
    let notes = |fog: &str| bench.notes(format!("s.obj {FRONT} --shade texture {fog}"));
    assert!(!notes("--fog 1,6").contains("fog"));
    assert!(notes("--fog 1,4").contains("all faces in view are behind the fog"));
}

/// Surfaces with vertex colors, a texture or both are drawn with every light, with fog and without it.
#[test]
fn every_surface_takes_every_light_and_fog() {
    let bench = Bench::new("surfaces");
    let square = |color: &str| {
        let corners = ["-1 -1", "1 -1", "1 1", "-1 1"].map(|xy| format!("v {xy} 0 {color}\n"));
        corners.concat() + "vt 0.5 0.5\nf 1/1 2/1 3/1 4/1\n"
    };
    bench.write("bare.obj", square(""));
    bench.write("colored.obj", square("1 0.5 0"));
    let texture = image::RgbImage::from_pixel(4, 4, image::Rgb([100, 200, 250]));
    texture.save(bench.path("skin.png")).unwrap();
    for (model, surface) in [
        ("colored.obj", [255.0, 127.5, 0.0]),
        ("bare.obj --texture skin.png", [100.0, 200.0, 250.0]),
        ("colored.obj --texture skin.png", [100.0, 100.0, 0.0]),
    ] {
        for (shade, light) in [
            ("texture", [1.0; 3]),
            ("lit --ambient 0 --light 0,0,1", [0.7; 3]),
            ("lit --ambient 0 --light 0,0,1,ff0000", [0.7, 0.0, 0.0]),
            ("flat --ambient 0 --light 0,0,1", [0.7; 3]),
            ("flat --ambient 0 --light 0,0,1,00ff00", [0.0, 0.7, 0.0]),
        ] {
            // The shade `flat` ignores textures.
            if shade.starts_with("flat") && model.contains("--texture") {
                continue;
            }
            // The square is at a distance of 5.
            for (fog, clear) in [("", 1.0), ("--fog 3,7,000000", 0.5)] {
                for filter in ["nearest", "bilinear"] {
                    // The error comes from rounding and from the fog's steps. With Rgb565, channels of five bits are
                    // rounded twice, once in the stored texture and once on the canvas. Each adds up to half a step to
                    // the error.
                    for (color, within) in [("rgb888", 3.0), ("rgb565", 3.0 + 255.0 / 31.0)] {
                        let look = format!(
                            "{model} {FRONT} --shade {shade} {fog} --filter {filter} --color {color}"
                        );
                        let found = draw(&bench, &look)[16 * 32 + 14];
                        for channel in 0..3 {
                            let wanted = surface[channel] * light[channel] * clear;
                            let error = (f64::from(found[channel]) - wanted).abs();
                            assert!(error <= within, "{look}: {found:?}, {channel}: {wanted}");
                        }
                    }
                }
            }
        }
    }
}

/// Fog is in the model's own units, and can reach as far as the format allows.
#[test]
fn fog_is_as_large_as_the_model() {
    let bench = Bench::new("fog-units");
    let middle = |scale: f64, fog: [f64; 2]| {
        let mut text = String::new();
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            writeln!(text, "v {} {} 0", x * scale, y * scale).unwrap();
        }
        bench.write("s.obj", text + "f 1 2 3 4\n");
        let [near, far] = fog.map(|x| x * scale);
        let view = format!(
            "--eye 0,0,{} --look-at 0,0,0 --fov 60 --size 32x32",
            5.0 * scale
        );
        let look = format!("s.obj {view} --shade flat --color rgb888 --fog {near},{far},000000");
        draw(&bench, &look)[16 * 32 + 16]
    };
    // At a distance of 5, half of the color shows at any scale, except for the error of the fog's steps.
    for fog in [[3.0, 7.0], [-995.0, 1005.0]] {
        let half = middle(1.0, fog);
        assert!((70..150).contains(&half[0]), "{half:?}");
        for scale in [1e-6, 1e6] {
            let other = middle(scale, fog);
            assert!(half[0].abs_diff(other[0]) <= 2, "{scale}: {other:?}");
        }
    }
}

#[test]
fn edges_lie_over_the_surface() {
    let bench = squares("wire");
    for color in ["rgb888", "gray8", "rgb565"] {
        for shade in ["lit", "flat", "normal"] {
            let look =
                format!("s.obj --size 64x48 --shade {shade} --color {color} --background ffffff");
            let (bare, wired) = (draw(&bench, &look), draw(&bench, format!("{look} --wire")));
            let edges = draw(&bench, "s.obj --size 64x48 --shade wire --color rgb888");
            let mut black = 0;
            for ((bare, wired), edge) in bare.iter().zip(&wired).zip(&edges) {
                assert!(wired == bare || *wired == [0; 3]);
                // The surface hides no edge in this view, so every edge shows.
                assert_eq!(*wired == [0; 3], *edge == [255; 3], "{shade} {color}");
                black += u32::from(*wired == [0; 3]);
            }
            assert!(black > 60, "{black}");
        }
    }
}

/// A plate in the plane z = 0, with this many squares along each side. `fold` bends its halves away from the viewer.
fn plate(squares: u32, fold: f64) -> String {
    let mut text = String::new();
    let at = |k: u32| f64::from(k) / f64::from(squares);
    for (y, x) in (0..=squares).flat_map(|y| (0..=squares).map(move |x| (y, x))) {
        let z = (at(x) - 0.5).abs() * -fold;
        writeln!(text, "v {} {} {z}", at(x), at(y)).unwrap();
    }
    for (y, x) in (0..squares).flat_map(|y| (1..=squares).map(move |x| (y, x))) {
        let [a, b] = [y * (squares + 1) + x, (y + 1) * (squares + 1) + x];
        writeln!(text, "f {a} {} {} {b}", a + 1, b + 1).unwrap();
    }
    text
}

#[test]
fn edges_that_would_fill_the_picture_become_an_outline() {
    let bench = Bench::new("dense");
    bench.write("p.obj", plate(40, 0.0));
    for (size, is_dense) in [("64x48", true), ("640x480", false)] {
        let look = format!("p.obj --size {size} --shade wire --color mono");
        let notes = bench.notes(&look);
        assert_eq!(
            notes.contains("only outlines and creases"),
            is_dense,
            "{notes}"
        );
        let pixels = draw(&bench, look);
        let white = pixels.iter().filter(|pixel| pixel[0] > 0).count();
        // If the edges are dense, only the outline is drawn, which has four sides of 45 to 60 pixels each. Otherwise,
        // all edges are drawn.
        assert_eq!(white < 250, is_dense, "{size}: {white}");
        assert!(white > 100, "{size}: {white}");
    }
}

/// Halves that meet at 90 degrees have a crease between them; the borders show from both sides.
#[test]
fn an_outline_has_creases_and_borders() {
    let bench = Bench::new("outline");
    for (fold, z, has_crease) in [(1.0, 3, true), (1.0, -3, true), (0.3, 3, false)] {
        bench.write("p.obj", plate(40, fold));
        let view = format!("--eye 0.5,0.5,{z} --look-at 0.5,0.5,0 --fov 25 --size 64x48");
        let pixels = draw(&bench, format!("p.obj {view} --shade wire --color mono"));
        let row: Vec<usize> = (0..64).filter(|x| pixels[24 * 64 + x][0] > 0).collect();
        let is_crease = |x: &&usize| x.abs_diff(32) <= 2;
        assert_eq!(
            row.iter().filter(is_crease).count(),
            usize::from(has_crease),
            "{fold} {z}: {row:?}"
        );
        // The left and the right border.
        assert!(
            row[0] < 20 && row[row.len() - 1] > 44,
            "{fold} {z}: {row:?}"
        );
        assert!(
            row.len() <= 2 + usize::from(has_crease),
            "{fold} {z}: {row:?}"
        );
    }
}

/// Two squares side by side, in two grays.
fn grays(left: f64, right: f64) -> String {
    let mut text = String::new();
    for (x, gray) in [(0.0, left), (1.0, right)] {
        for (dx, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            writeln!(text, "v {} {y} 0 {gray} {gray} {gray}", x + dx).unwrap();
        }
    }
    text + "f 1 2 3 4\nf 5 6 7 8\n"
}

#[test]
fn a_model_differs_from_its_background_and_in_mono_its_parts_differ() {
    let bench = Bench::new("apart");
    let view = "--shade texture --eye 1,0.5,3 --look-at 1,0.5,0 --fov 50 --size 64x48";
    let shot = |grays: String, look: &str| {
        bench.write("g.obj", grays);
        draw(&bench, format!("g.obj {view} {look}"))
    };
    for color in ["rgb888", "gray8", "gray4", "mono"] {
        for gray in [0.0, 0.1, 1.0] {
            let found = shot(grays(gray, gray), &format!("--color {color}"));
            let (corner, middle) = (found[0][0], found[24 * 64 + 32][0]);
            assert!(
                corner.abs_diff(middle) > 40,
                "{color} {gray}: {corner} {middle}"
            );
        }
    }
    // Without stretching, about half of each square's pixels would be white.
    let found = shot(grays(0.48, 0.55), "--color mono");
    let white = |from: usize| {
        let inner = (18..30).flat_map(|y| (from..from + 8).map(move |x| y * 64 + x));
        inner.filter(|&at| found[at][0] == 255).count()
    };
    assert_eq!([white(20), white(36)], [0, 96]);
}
