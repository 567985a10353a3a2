//! Runs the simulator as a user would: what it makes of good input, and what it says to bad.
#![cfg(not(target_os = "none"))]

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// An empty directory of the test's own.
fn directory(test: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("simulator-{test}"));
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    directory
}

/// The example's program, which `cargo test` builds before it runs the tests.
fn program() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let profile = test.parent().and_then(Path::parent).unwrap();
    let program = profile
        .join("examples")
        .join(format!("simulator{}", std::env::consts::EXE_SUFFIX));
    assert!(
        program.exists(),
        "run `cargo test`, or `cargo build --example simulator` first: {} is not there",
        program.display()
    );
    program
}

fn run(directory: &Path, arguments: &str) -> Output {
    Command::new(program())
        .args(arguments.split_whitespace())
        .current_dir(directory)
        .output()
        .unwrap()
}

/// Runs what must succeed; gives what it printed.
fn good(directory: &Path, arguments: &str) -> String {
    let output = run(directory, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

fn files(directory: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(directory)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Runs what must be refused with a message that has all of `says` in it, and leave no file.
fn refused(directory: &Path, arguments: &str, says: &[&str]) {
    let before = files(directory);
    let output = run(directory, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        matches!(output.status.code(), Some(1 | 2)),
        "{arguments}: {:?} {message}",
        output.status
    );
    assert!(!message.contains("panicked"), "{arguments}: {message}");
    for part in says {
        assert!(
            message.contains(part),
            "{arguments}: no '{part}' in: {message}"
        );
    }
    assert_eq!(files(directory), before, "{arguments}: left a file");
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn cameras_without_sense_are_refused() {
    let directory = directory("cameras");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let range = "above 0 and below 180 degrees";
    for (arguments, says) in [
        ("--fov 0", ["field of view is 0 degrees", range]),
        ("--fov 180", ["field of view is 180 degrees", range]),
        ("--fov -60", ["field of view is -60 degrees", range]),
        // 400 degrees are 40 after a turn, but nobody means that.
        ("--fov 400", ["field of view is 400 degrees", range]),
        ("--fov nan", ["--fov", "finite number"]),
        ("--near 0", ["near plane is at 0", "above 0"]),
        ("--near -1", ["near plane is at -1", "above 0"]),
        (
            "--near 5 --far 5",
            ["far plane is at 5", "beyond the near plane at 5"],
        ),
        (
            "--near 5 --far 2",
            ["far plane is at 2", "beyond the near plane at 5"],
        ),
        ("--near 40000", ["--near 40000", "between -32768"]),
        ("--far 1e9", ["--far 1000000000", "between -32768"]),
        (
            "--eye 1,2,3 --look-at 1,2,3",
            ["eye and target are both at (1, 2, 3)", "look at"],
        ),
        (
            "--eye 0,0,5 --look-at 0,0,0 --up 0,0,1",
            ["up is (0, 0, 1)", "parallel to the line of sight"],
        ),
        (
            "--up 0,0,0",
            ["up is (0, 0, 0)", "which is zero or parallel"],
        ),
        ("--eye 0,0,1e6", ["--eye", "cannot be represented"]),
        ("--eye 0,0", ["--eye", "three numbers"]),
        ("--eye 0,zero,0", ["zero", "must be a number"]),
        ("--look-at 0;0;0", ["0;0;0", "must be a number"]),
    ] {
        refused(&directory, &format!("t.obj {arguments}"), &says);
        // A parallel projection has no eye that the near plane must be in front of.
        if !says[0].starts_with("near") {
            let parallel = format!("t.obj --projection orthographic {arguments}");
            refused(&directory, &parallel, &says);
        }
    }
}

#[test]
fn pictures_that_cannot_be_are_refused() {
    let directory = directory("pictures");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    fs::create_dir(directory.join("folder.png")).unwrap();
    for (arguments, says) in [
        ("--size 0x240", ["size is 0x240", "between 1 and"]),
        ("--size 320x0", ["size is 320x0", "between 1 and"]),
        (
            "--size 100000x100000",
            ["size is 100000x100000", "between 1 and"],
        ),
        ("--size 320", ["--size", "such as 320x240"]),
        ("--size -1x5", ["-1x5", ""]),
        ("--bands 0", ["--bands", "0"]),
        ("--frames 0", ["--frames", "0"]),
        ("--frames 2 --out t.png", ["2 frames", ".gif"]),
        ("--rpm fast --frames 2", ["fast", "must be a number"]),
        ("--rpm 1e12 --frames 2", ["1000000000000", "between"]),
        ("--shade shiny", ["shiny", "possible values"]),
        ("--filter soft", ["soft", "possible values"]),
        ("--color cmyk", ["cmyk", "possible values"]),
        ("--projection fisheye", ["fisheye", "possible values"]),
        ("--out t.bmp", ["t.bmp", ".png or .gif"]),
        ("--out picture", ["picture", ".png or .gif"]),
        ("--out none/t.png", ["cannot write none/t.png", ""]),
        ("--out folder.png", ["cannot write folder.png", "directory"]),
        ("--dump none/t.csv", ["cannot write none/t.csv", ""]),
        ("--sparkle", ["--sparkle", ""]),
    ] {
        refused(&directory, &format!("t.obj {arguments}"), &says);
    }
    // The eye that was chosen is beyond the number format.
    let far = ["to see the whole model, the eye must be at", "-32768"];
    refused(&directory, "t.obj --fov 0.0001", &far);
    refused(&directory, "--scene moon", &["moon", "possible values"]);
    refused(&directory, "t.obj --scene cube", &["cannot be used with"]);
    if cfg!(not(feature = "sdl")) {
        refused(
            &directory,
            "t.obj --window",
            &["--window", "--features sdl"],
        );
    }
}

#[test]
fn models_that_cannot_be_read_are_refused() {
    let directory = directory("models");
    for (model, says) in [
        ("v 0 0\nf 1 1 1", ["line 1", "number"]),
        (
            "v 0 0 0\nv 1 zero 0\nf 1 2 1",
            ["line 2", "'zero' is not a number"],
        ),
        (
            "v 0 0 0\nv 1 nan 0\nf 1 2 1",
            ["line 2", "coordinate nan cannot"],
        ),
        ("# far\nv 0 0 40000\nf 1 1 1", ["line 2", "40000"]),
        (
            "v 0 0 -1e9\nf 1 1 1",
            ["line 1", "between -32768 and 32767"],
        ),
        (
            "v 0 0 0\nvt 0 0\nvt 0 3000\nf 1 1 1",
            [
                "line 3",
                "3000 cannot be represented: it must lie between -2046.99999 and 2047",
            ],
        ),
        (
            "v 0 0 0\nvt -3000 0\nf 1 1 1",
            [
                "line 2",
                "-3000 cannot be represented: it must lie between -2048 and 2047",
            ],
        ),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4", ["line 4", "position"]),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4",
            ["line 4", "position"],
        ),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2", ["line 4", ""]),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1",
            ["line 4", "texture coordinate"],
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//2 2//2 3//2",
            ["line 4", "normal"],
        ),
        ("v 0 0 0\nv 1 0 0\nf 1 2", ["line 3", "at least 3 corners"]),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x", ["line 4", ""]),
        (
            "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\n\r\nf a b c\r\n",
            ["line 5", ""],
        ),
        ("v 0 0 0\nv 1 0 0\n", ["no faces", ""]),
        ("", ["no faces", ""]),
        ("\u{0}\u{1}binary", ["no faces", ""]),
    ] {
        fs::write(directory.join("bad.obj"), model).unwrap();
        refused(&directory, "bad.obj", &says);
    }
    refused(&directory, "none.obj", &["cannot read model none.obj"]);
    fs::create_dir(directory.join("folder.obj")).unwrap();
    refused(&directory, "folder.obj", &["cannot read model folder.obj"]);

    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    fs::write(directory.join("text.png"), "no picture").unwrap();
    refused(
        &directory,
        "t.obj --texture text.png",
        &["cannot read texture text.png"],
    );
    refused(
        &directory,
        "t.obj --texture none.png",
        &["cannot read texture none.png"],
    );
}

/// Width and height of a PNG, of its header.
fn png_size(path: &Path) -> (u32, u32) {
    let bytes = fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (side(16), side(20))
}

/// The word after `label` in what the simulator printed.
fn printed<'a>(text: &'a str, label: &str) -> &'a str {
    let (_, after) = text
        .split_once(label)
        .unwrap_or_else(|| panic!("no '{label}' in: {text}"));
    after.split_whitespace().next().unwrap()
}

#[test]
fn without_arguments_it_draws_its_own_scene_and_says_where() {
    let directory = directory("scene");
    let said = good(&directory, "");
    assert!(said.contains("lighthouse.png"), "{said}");
    assert_eq!(files(&directory), ["lighthouse.png"]);
    assert_eq!(png_size(&directory.join("lighthouse.png")), (320, 240));
}

#[test]
fn a_model_fills_the_picture() {
    let directory = directory("fills");
    // A plate far from the origin, in the dialects: CRLF, a quad, negative indices, no vt or vn.
    let model = "v 100 -50 7\r\nv 104 -50 7\r\nv 104 -48 7\r\nv 100 -48 7\r\nf -4 -3 -2 -1\r\n";
    fs::write(directory.join("quad.obj"), model).unwrap();
    for projection in ["perspective", "orthographic", "cabinet", "cavalier"] {
        let said = good(
            &directory,
            &format!("quad.obj --size 160x80 --projection {projection} --dump d.csv"),
        );
        let dump = fs::read_to_string(directory.join("d.csv")).unwrap();
        let mut rows = dump.lines();
        assert_eq!(rows.next(), Some("x,y,u,v,w,depth"));
        let places: Vec<[u32; 2]> = rows
            .map(|row| {
                let mut cells = row.split(',').map(str::parse);
                let mut cell = || cells.next().unwrap().unwrap();
                [cell(), cell()]
            })
            .collect();
        assert_eq!(printed(&said, "pixels"), places.len().to_string());
        let range = |axis: usize| {
            let all = || places.iter().map(|place| place[axis]);
            (all().min().unwrap(), all().max().unwrap())
        };
        // It takes 94 % of the width or of the height, in the middle.
        let ((left, right), (top, bottom)) = (range(0), range(1));
        let fills = right - left > 145 || bottom - top > 71;
        assert!(fills, "{projection}: {left}..{right}, {top}..{bottom}");
        assert!(
            (left + right).abs_diff(159) <= 3,
            "{projection}: {left}..{right}"
        );
        assert!(
            (top + bottom).abs_diff(79) <= 3,
            "{projection}: {top}..{bottom}"
        );
    }
}

#[test]
fn the_widest_view_and_an_empty_one_are_drawn() {
    let directory = directory("wide");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    // The chosen eye is next to the model, but not in it.
    let said = good(&directory, "t.obj --fov 170");
    assert_ne!(printed(&said, "pixels"), "0");
    let said = good(&directory, "t.obj --near 100 --far 200");
    assert!(said.contains("nothing of it is in the picture"), "{said}");
}

#[test]
fn bands_are_the_frame() {
    let directory = directory("bands");
    for scene in [
        "",
        "--scene floor",
        "--scene cube",
        "--scene sphere",
        "--scene sphere-flat",
    ] {
        let whole = good(&directory, &format!("{scene} --crc --dump whole.csv"));
        let dump = fs::read(directory.join("whole.csv")).unwrap();
        for rows in [1, 7, 16, 1000] {
            let banded = good(
                &directory,
                &format!("{scene} --crc --dump bands.csv --bands {rows}"),
            );
            assert_eq!(
                printed(&whole, "crc"),
                printed(&banded, "crc"),
                "{scene} {rows}"
            );
            let same = dump == fs::read(directory.join("bands.csv")).unwrap();
            assert!(
                same,
                "dumps of {scene} whole and in bands of {rows} rows differ"
            );
        }
    }
}

#[test]
fn the_dump_is_exact_and_in_row_order() {
    let directory = directory("dump");
    // A square that fills the frame, straight ahead, one unit of u and v.
    fs::write(
        directory.join("square.obj"),
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n",
    )
    .unwrap();
    good(
        &directory,
        "square.obj --size 4x4 --eye 0,0,1 --look-at 0,0,0 --fov 90 --near 0.5 --far 2 --dump d.csv",
    );
    let dump = fs::read_to_string(directory.join("d.csv")).unwrap();
    let rows: Vec<&str> = dump.lines().collect();
    assert_eq!(rows.len(), 17);
    for (at, row) in rows[1..].iter().enumerate() {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let at = f64::from(u8::try_from(at).unwrap());
        let (x, y) = (at % 4.0, (at / 4.0).floor());
        assert_eq!(cells[..2], [x, y], "{row}");
        // At the middle of a pixel, v down; a few units of 2^-24.
        assert!(((x + 0.5) / 4.0 - cells[2]).abs() < 1e-6, "{row}");
        assert!(((y + 0.5) / 4.0 - cells[3]).abs() < 1e-6, "{row}");
        assert!((cells[4] - 1.0).abs() < 1e-4, "{row}");
        // 65535 · near / w, rounded down
        assert!((cells[5] - 32767.0).abs() <= 1.0, "{row}");
    }
}

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
fn a_filter_changes_colors_only() {
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

#[test]
fn an_animation_turns() {
    let directory = directory("animation");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let said = good(&directory, "t.obj --two-sided --size 32x32 --frames 4");
    assert!(said.contains("t.gif"), "{said}");
    let gif = fs::read(directory.join("t.gif")).unwrap();
    assert_eq!(&gif[..6], b"GIF89a");
    assert_eq!(gif[6..10], [32, 0, 32, 0]);
    assert_eq!(files(&directory), ["t.gif", "t.obj"]);
}

#[test]
fn a_model_of_many_points_is_drawn_in_parts() {
    let directory = directory("many");
    // 300 x 300 points, more than 16-bit indices can name.
    let mut model = String::new();
    for y in 0..300 {
        for x in 0..300 {
            writeln!(model, "v {x} {y} 0").unwrap();
        }
    }
    for y in 0..299 {
        for x in 1..300 {
            let at = y * 300 + x;
            writeln!(model, "f {at} {} {} {}", at + 1, at + 301, at + 300).unwrap();
        }
    }
    fs::write(directory.join("grid.obj"), model).unwrap();
    let view = "--eye 149.5,149.5,400 --look-at 149.5,149.5,0 --size 100x100 --fov 40";
    let said = good(&directory, &format!("grid.obj {view}"));
    // 2 · 400 · tan 20° = 291.2 units of the plate's 299 are seen: every pixel, each once.
    assert_eq!(printed(&said, "pixels"), "10000");
    assert_eq!(printed(&said, "triangles"), (299 * 299 * 2).to_string());
}

#[test]
fn help_teaches() {
    let said = good(&directory("help"), "--help");
    for part in ["Examples", "--two-sided", "default", "Camera:", "below 180"] {
        assert!(said.contains(part), "no '{part}' in: {said}");
    }
}
