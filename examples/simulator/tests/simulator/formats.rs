//! Formats of models, materials and colors.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use image::{Rgb, RgbImage};

use super::make;
use super::program::{directory, good, printed, refused, run};

const VIEW: &str = "--eye 4,3,5 --look-at 0,0.8,0 --up 0,1,0 --fov 35 --size 96x72";

/// Draws `model`, and returns the checksum of the picture.
fn crc(directory: &Path, model: &str, look: &str) -> String {
    let said = good(
        directory,
        &format!("{model} {VIEW} {look} --crc --out picture.png"),
    );
    assert_ne!(printed(&said, "pixels"), "0", "{model}");
    printed(&said, "crc").into()
}

/// Writes the house in every format. Returns the names of the files.
fn write_all(directory: &Path) -> Vec<&'static str> {
    let write = |name: &'static str, bytes: &[u8]| fs::write(directory.join(name), bytes).unwrap();
    write("house.obj", make::obj(false).as_bytes());
    write("text.stl", make::stl_text().as_bytes());
    write("binary.stl", &make::stl_binary());
    let mut files = vec!["house.obj", "text.stl", "binary.stl"];
    write("text.ply", make::ply_text(false).as_bytes());
    write("binary.ply", &make::ply_binary());
    files.extend(["text.ply", "binary.ply"]);
    write("house.glb", &make::glb(false, ""));
    make::write_gltf(directory, "house.gltf", false, "");
    files.extend(["house.glb", "house.gltf"]);
    files
}

#[test]
fn a_model_looks_the_same_in_every_format() {
    let directory = directory("formats");
    for look in ["--shade normal", "--shade flat", "--shade wire"] {
        let files = write_all(&directory);
        let expected = crc(&directory, files[0], look);
        for file in &files[1..] {
            assert_eq!(crc(&directory, file, look), expected, "{file} {look}");
        }
    }
}

#[test]
fn z_is_up_in_stl_files() {
    let directory = directory("up");
    write_all(&directory);
    let crc = |arguments: &str| {
        let said = good(
            &directory,
            &format!("{arguments} --crc --out p.png --size 64x48"),
        );
        printed(&said, "crc").to_string()
    };
    assert_eq!(crc("text.stl"), crc("house.obj --up 0,0,1"));
    assert_eq!(crc("text.stl --up 0,1,0"), crc("house.obj"));
}

#[test]
fn a_file_of_several_solids_is_read_whole() {
    let directory = directory("solids");
    fs::write(directory.join("one.stl"), make::stl_text()).unwrap();
    let twice = make::stl_text() + "\r\n" + &make::stl_text();
    fs::write(directory.join("two.stl"), twice).unwrap();
    let triangles = |model| printed(&good(&directory, model), "triangles").to_string();
    assert_eq!([triangles("one.stl"), triangles("two.stl")], ["12", "24"]);
}

#[test]
fn vertices_have_their_colors() {
    let directory = directory("colors");
    fs::write(directory.join("house.obj"), make::obj(true)).unwrap();
    let expected = ["texture", "lit", "gouraud", "flat"].map(|shade| {
        (
            shade,
            crc(&directory, "house.obj", &format!("--shade {shade}")),
        )
    });
    // Check two colors of the picture: at the left front corner at the bottom, and at the top of the roof.
    good(
        &directory,
        &format!("house.obj {VIEW} --shade texture --color rgb888 --out p.png"),
    );
    let picture = image::open(directory.join("p.png")).unwrap().into_rgb8();
    let has = |wanted: [u8; 3]| {
        let near = |pixel: &Rgb<u8>| (0..3).all(|at| pixel.0[at].abs_diff(wanted[at]) <= 12);
        picture.pixels().any(near)
    };
    assert!(has(make::color(0)) && has(make::color(8)) && has(make::color(2)));
    let mut files = Vec::new();
    fs::write(directory.join("house.ply"), make::ply_text(true)).unwrap();
    files.push("house.ply");
    fs::write(directory.join("house.glb"), make::glb(true, "")).unwrap();
    files.push("house.glb");
    for file in files {
        for (shade, expected) in &expected {
            let crc = crc(&directory, file, &format!("--shade {shade}"));
            assert_eq!(crc, *expected, "{file} {shade}");
        }
    }
}

/// Saves an image of one color.
fn save(path: &Path, color: [u8; 3]) {
    RgbImage::from_pixel(4, 4, Rgb(color)).save(path).unwrap();
}

/// Four squares side by side: two with textures, one with a color, and one without a material.
fn write_materials(directory: &Path) {
    let mut obj = String::from("mtllib none.mtl\nmtllib some materials.mtl\n");
    for square in 0..4 {
        let (x, v) = (2 * square, 4 * square + 1);
        writeln!(
            obj,
            "v {x} 0 0\nv {} 0 0\nv {} 2 0\nv {x} 2 0",
            x + 2,
            x + 2
        )
        .unwrap();
        if square > 0 {
            writeln!(
                obj,
                "usemtl {}",
                ["", "first one", "second", "third"][square]
            )
            .unwrap();
        }
        writeln!(
            obj,
            "vt 0.5 0.5\nf {v}/1 {}/1 {}/1 {}/1",
            v + 1,
            v + 2,
            v + 3
        )
        .unwrap();
    }
    fs::write(directory.join("squares.obj"), obj).unwrap();
    let mtl = "newmtl first one\nKd 0 0 0\nmap_Kd -s 2 2 -clamp on red texels.png\nnewmtl second\n\
               map_Kd C:\\elsewhere\\green.png\r\n# blue\nnewmtl third\nKd 0 0.2 1\n";
    fs::write(directory.join("some materials.mtl"), mtl).unwrap();
    save(&directory.join("red texels.png"), [250, 10, 20]);
    save(&directory.join("green.png"), [30, 240, 40]);
}

/// The colors at the centers of the four squares.
fn middles(directory: &Path, arguments: &str) -> [[u8; 3]; 4] {
    let view = "--projection orthographic --eye 4,1,5 --look-at 4,1,0 --size 80x40 --color rgb888";
    good(
        directory,
        &format!("squares.obj {view} {arguments} --out p.png"),
    );
    let picture = image::open(directory.join("p.png")).unwrap().into_rgb8();
    [11, 30, 50, 69].map(|x| picture.get_pixel(x, 20).0)
}

#[test]
fn materials_have_colors_and_textures() {
    let directory = directory("materials");
    write_materials(&directory);
    let expected = [[255; 3], [250, 10, 20], [30, 240, 40], [0, 51, 255]];
    assert_eq!(middles(&directory, "--shade texture"), expected);
    // The light comes from the viewer's side, so that colors stay recognizable.
    let lit = middles(&directory, "");
    assert!(
        lit[1][0] > 120 && lit[1][1] < 20 && lit[3][2] > 120 && lit[3][0] == 0,
        "{lit:?}"
    );
    // A texture that the user gives replaces all materials.
    save(&directory.join("own.png"), [9, 99, 199]);
    let own = middles(&directory, "--shade texture --texture own.png");
    assert_eq!(own, [[9, 99, 199]; 4]);
    // A missing file causes a note, but the picture is drawn.
    fs::remove_file(directory.join("green.png")).unwrap();
    let output = run(&directory, "squares.obj");
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success());
    for part in [
        "cannot read materials none.mtl",
        "cannot read texture green.png",
    ] {
        assert!(notes.contains(part), "{notes}");
    }
    assert_eq!(middles(&directory, "--shade texture")[2], [255; 3]);
}

/// The default name of the picture is the name of the model's texture here, so the program must choose another name.
#[test]
fn textures_of_a_model_are_not_overwritten() {
    let directory = directory("own-texture");
    write_materials(&directory);
    let texture = fs::read(directory.join("green.png")).unwrap();
    fs::rename(directory.join("squares.obj"), directory.join("green.obj")).unwrap();
    refused(
        &directory,
        "green.obj --out green.png",
        &["cannot write green.png: it is an input, green.png"],
    );
    for _ in 0..2 {
        let said = good(&directory, "green.obj");
        assert!(said.contains("wrote green-picture.png"), "{said}");
    }
    assert_eq!(fs::read(directory.join("green.png")).unwrap(), texture);
}

#[test]
fn nodes_are_moved_and_mirrored() {
    let directory = directory("nodes");
    let placed = |name: &str, f: fn([f32; 3]) -> [f32; 3], turned: bool| {
        let mut text = String::new();
        for [x, y, z] in make::POSITIONS.map(f) {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        for face in make::FACES {
            let [a, b, c] = face.map(|index| index + 1);
            let [b, c] = if turned { [c, b] } else { [b, c] };
            writeln!(text, "f {a} {b} {c}").unwrap();
        }
        fs::write(directory.join(name), text).unwrap();
        crc(&directory, name, "--shade flat")
    };
    let crc_of = |node: &str| {
        fs::write(directory.join("node.glb"), make::glb(false, node)).unwrap();
        crc(&directory, "node.glb", "--shade flat")
    };
    // The node rotates by half a turn about y, doubles the width, and moves.
    let moved = placed(
        "moved.obj",
        |[x, y, z]| [0.5 - 2.0 * x, y - 0.25, -z],
        false,
    );
    let node = r#", "translation": [0.5, -0.25, 0], "rotation": [0, 1, 0, 0], "scale": [2, 1, 1]"#;
    assert_eq!(crc_of(node), moved);
    let mirrored = placed("mirrored.obj", |[x, y, z]| [-x, y, z], true);
    assert_eq!(
        crc_of(r#", "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"#),
        mirrored
    );
}

#[test]
fn concave_polygons_are_filled_within() {
    let directory = directory("concave");
    let points = "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\n";
    // The fans around the second and the fifth corner leave the L. The last polygon crosses itself.
    for (at, polygon) in ["1 2 3 4 5 6", "2 3 4 5 6 1", "5 6 1 2 3 4", "3 4 5 6 1 2"]
        .iter()
        .enumerate()
    {
        fs::write(
            directory.join(format!("{at}.obj")),
            format!("{points}f {polygon}\n"),
        )
        .unwrap();
    }
    fs::write(
        directory.join("pieces.obj"),
        format!("{points}f 1 2 3 4\nf 1 4 5 6\n"),
    )
    .unwrap();
    let view =
        "--projection orthographic --eye 2,2,5 --look-at 2,2,0 --shade normal --crc --out p.png";
    let crc = |model: &str| {
        let said = good(&directory, &format!("{model} {view}"));
        printed(&said, "crc").to_string()
    };
    let expected = crc("pieces.obj");
    for at in 0..4 {
        assert_eq!(crc(&format!("{at}.obj")), expected, "{at}");
    }
}

/// The model is a cone of many triangles. Comparing every pair of triangles would take minutes.
#[test]
fn many_faces_around_a_point_take_linear_time() {
    let directory = directory("cone");
    let mut model = String::from("v 0 1 0\n");
    let count = 150_000;
    for at in 0..count {
        let angle = f64::from(at) / f64::from(count) * std::f64::consts::TAU;
        writeln!(model, "v {:.9} 0 {:.9}", angle.cos(), -angle.sin()).unwrap();
    }
    for at in 0..count {
        writeln!(model, "f 1 {} {}", at + 2, (at + 1) % count + 2).unwrap();
    }
    fs::write(directory.join("cone.obj"), model).unwrap();
    let start = Instant::now();
    let said = good(&directory, "cone.obj --size 32x24");
    assert_ne!(printed(&said, "pixels"), "0");
    let took = start.elapsed();
    assert!(took < Duration::from_secs(60), "{took:?}");
}

#[test]
fn mistakes_in_models_are_reported_in_one_line() {
    let directory = directory("wrong");
    let text = |text: &str| text.as_bytes().to_vec();
    let utf_16: Vec<u8> = "\u{feff}v 0 0 0\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let stl = make::stl_binary();
    let huge = |words: &str| {
        format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}\n", words.repeat(4_000_000)).into_bytes()
    };
    let cases = vec![
        ("a.obj", utf_16, "its text is UTF-16: save it as UTF-8"),
        (
            "b.obj",
            stl.clone(),
            "it is an STL file, not an OBJ file: give it the ending .stl",
        ),
        (
            "c.obj",
            make::stl_text().into_bytes(),
            "it is an STL file, not an OBJ file",
        ),
        (
            "d.stl",
            make::ply_text(false).into_bytes(),
            "it is a PLY file, not an STL file",
        ),
        (
            "e.stl",
            make::obj(false).into_bytes(),
            "it is text, and does not begin with 'solid'",
        ),
        (
            "p.stl",
            stl_line("vertex 1 Zero 0"),
            "line 5: 'Zero' is not a number",
        ),
        ("i.stl", text("solid\nendsolid\n"), "it has no faces"),
        ("j.obj", text("  \n"), "it is empty"),
        (
            "k.obj",
            huge("f 1 2 3 "),
            "line 4: a face has more than 1000000",
        ),
        (
            "l.obj",
            huge("9"),
            "there is nothing to draw: not drawn: '9999",
        ),
        (
            "m.obj",
            [text("v 0 0 0\nf"), text(" 1").repeat(1_100_000)].concat(),
            "line 2: a face has more than 1000000",
        ),
    ];
    refuse_all(&directory, cases);
}

/// STL text with Windows line ends and a mistake in line 5.
fn stl_line(fifth: &str) -> Vec<u8> {
    let lines = format!(
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n{fifth}\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"
    );
    lines.replace('\n', "\r\n").into_bytes()
}

/// Runs the program with each file. A case consists of the file's name, the file's contents, and a text that the
/// message must contain.
fn refuse_all(directory: &Path, cases: Vec<(&str, Vec<u8>, &str)>) {
    for (name, bytes, says) in cases {
        fs::write(directory.join(name), bytes).unwrap();
        let output = run(directory, name);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{name}: {message}");
        assert_eq!(message.lines().count(), 1, "{name}: {message}");
        assert!(
            message.starts_with(&format!("error: model {name}: ")),
            "{message}"
        );
        assert!(message.contains(says), "{name}: no '{says}' in: {message}");
        assert!(message.len() < 400, "{message}");
    }
}
