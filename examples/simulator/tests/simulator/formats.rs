//! Formats of models, materials and colors.

use std::fmt::Write;
use std::fs;
use std::time::{Duration, Instant};

use image::{Rgb, RgbImage};

use super::program::{Bench, printed};

#[test]
fn z_is_up_in_stl_files() {
    let bench = Bench::new("up");
    let corners = ["0 0 0", "1 0 0", "0 0.5 2"];
    let lines = |word: &str| corners.map(|at| format!("{word} {at}\n")).concat();
    bench.write("t.obj", lines("v") + "f 1 2 3\n");
    bench.write(
        "t.stl",
        format!("solid\nfacet\n{}endsolid\n", lines("vertex")),
    );
    assert_eq!(bench.crc("t.stl"), bench.crc("t.obj --up 0,0,1"));
    assert_eq!(bench.crc("t.stl --up 0,1,0"), bench.crc("t.obj"));
}

/// Saves an image of one color.
fn save(bench: &Bench, name: &str, color: [u8; 3]) {
    let image = RgbImage::from_pixel(4, 4, Rgb(color));
    image.save(bench.path(name)).unwrap();
}

/// Four squares side by side: two with textures, one with a color, and one without a material.
fn write_materials(bench: &Bench) {
    let mut obj = String::from("mtllib none.mtl\nmtllib some materials.mtl\n");
    for (at, material) in ["", "usemtl first one", "usemtl second", "usemtl third"]
        .iter()
        .enumerate()
    {
        let (left, right) = (2 * at, 2 * at + 2);
        writeln!(
            obj,
            "v {left} 0 0\nv {right} 0 0\nv {right} 2 0\nv {left} 2 0\nvt 0.5 0.5"
        )
        .unwrap();
        writeln!(obj, "{material}\nf -4/1 -3/1 -2/1 -1/1").unwrap();
    }
    bench.write("squares.obj", obj);
    let mtl = "newmtl first one\nKd 0 0 0\nmap_Kd -s 2 2 -clamp on red texels.png\nnewmtl second\n\
               map_Kd C:\\elsewhere\\green.png\r\n# blue\nnewmtl third\nKd 0 0.2 1\n";
    bench.write("some materials.mtl", mtl);
    save(bench, "red texels.png", [250, 10, 20]);
    save(bench, "green.png", [30, 240, 40]);
}

/// The colors at the centers of the four squares.
fn middles(bench: &Bench, arguments: &str) -> [[u8; 3]; 4] {
    let view = "--projection orthographic --eye 4,1,5 --look-at 4,1,0 --size 80x40 --color rgb888";
    bench.good(format!("squares.obj {view} {arguments} --out p.png"));
    let picture = bench.picture("p.png");
    [11, 30, 50, 69].map(|x| picture.get_pixel(x, 20).0)
}

#[test]
fn materials_have_colors_and_textures() {
    let bench = Bench::new("materials");
    write_materials(&bench);
    let expected = [[255; 3], [250, 10, 20], [30, 240, 40], [0, 51, 255]];
    assert_eq!(middles(&bench, "--shade texture"), expected);
    // The light comes from the viewer's side, so that colors stay recognizable.
    let lit = middles(&bench, "");
    assert!(
        lit[1][0] > 120 && lit[1][1] < 20 && lit[3][2] > 120 && lit[3][0] == 0,
        "{lit:?}"
    );
    // A texture that the user gives replaces all materials.
    save(&bench, "own.png", [9, 99, 199]);
    let own = middles(&bench, "--shade texture --texture own.png");
    assert_eq!(own, [[9, 99, 199]; 4]);
    // A missing file causes a note, but the picture is drawn.
    fs::remove_file(bench.path("green.png")).unwrap();
    let notes = bench.notes("squares.obj");
    for part in ["materials none.mtl", "texture green.png"] {
        assert!(notes.contains(&format!("cannot read {part}")), "{notes}");
    }
    assert_eq!(middles(&bench, "--shade texture")[2], [255; 3]);
}

/// The default name of the picture is the name of the model's texture here, so the program must choose another name.
#[test]
fn textures_of_a_model_are_not_overwritten() {
    let bench = Bench::new("own-texture");
    write_materials(&bench);
    let texture = bench.read("green.png");
    fs::rename(bench.path("squares.obj"), bench.path("green.obj")).unwrap();
    bench.refused(
        "green.obj --out green.png",
        &["cannot write green.png: it is an input, green.png"],
    );
    for _ in 0..2 {
        let said = bench.good("green.obj");
        assert!(said.contains("wrote green-picture.png"), "{said}");
    }
    assert_eq!(bench.read("green.png"), texture);
}

/// The model is a cone of many triangles. Comparing every pair of triangles would take minutes.
#[test]
fn many_faces_around_a_point_take_linear_time() {
    let bench = Bench::new("cone");
    let mut model = String::from("v 0 1 0\n");
    let count = 150_000;
    for at in 0..count {
        let angle = f64::from(at) / f64::from(count) * std::f64::consts::TAU;
        writeln!(model, "v {:.9} 0 {:.9}", angle.cos(), -angle.sin()).unwrap();
    }
    for at in 0..count {
        writeln!(model, "f 1 {} {}", at + 2, (at + 1) % count + 2).unwrap();
    }
    bench.write("cone.obj", model);
    let start = Instant::now();
    let said = bench.good("cone.obj --size 32x24");
    assert_ne!(printed(&said, "pixels"), "0");
    let took = start.elapsed();
    assert!(took < Duration::from_secs(60), "{took:?}");
}

#[test]
fn mistakes_in_models_are_reported_in_one_line() {
    let bench = Bench::new("wrong");
    let huge = |words: &str| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}\n", words.repeat(4_000_000));
    for (name, text, says) in [
        (
            "a.obj",
            "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n".into(),
            "it is an STL file, not an OBJ file: give it the ending .stl",
        ),
        (
            "b.obj",
            huge("f 1 2 3 "),
            "line 4: a face has more than 1000000",
        ),
        ("c.obj", huge("9"), "only faces are drawn; not drawn: '9999"),
        (
            "d.stl",
            "solid\r\nfacet\r\nvertex 1 Zero 0\r\n".into(),
            "line 3: 'Zero' is not a number",
        ),
    ] {
        bench.write(name, text);
        let message = bench.refused(name, &[says]);
        assert!(
            message.starts_with(&format!("error: model {name}: ")),
            "{message}"
        );
        assert!(
            message.lines().count() == 1 && message.len() < 400,
            "{message}"
        );
    }
}
