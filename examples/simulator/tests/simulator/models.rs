//! Models that cannot be read, and models that must be visible as a whole.

use std::fmt::Write;
use std::fs;

use super::program::{Bench, TRIANGLE, printed};

#[test]
fn models_that_cannot_be_read_are_refused() {
    let bench = Bench::new("models");
    for model in ["v 0 0 0\nv 1 0 0\n", "", "\u{0}\u{1}binary"] {
        bench.write("bad.obj", model);
        bench.refused("bad.obj", &["model bad.obj: "]);
    }
    bench.refused("none.obj", &["model none.obj: it cannot be read: "]);
    fs::create_dir(bench.path("folder.obj")).unwrap();
    bench.refused("folder.obj", &["model folder.obj: it cannot be read: "]);

    bench.write("t.obj", TRIANGLE);
    bench.write("text.png", "no picture");
    for name in ["text.png", "none.png"] {
        let says = format!("cannot read texture {name}");
        bench.refused(format!("t.obj --texture {name}"), &[&says]);
    }
}

#[test]
fn a_model_fills_the_picture() {
    let bench = Bench::new("fills");
    // A plate far from the origin, in a difficult dialect: CRLF, a quad, negative indices, and neither vt nor vn.
    let model = "v 100 -50 7\r\nv 104 -50 7\r\nv 104 -48 7\r\nv 100 -48 7\r\nf -4 -3 -2 -1\r\n";
    bench.write("quad.obj", model);
    for projection in ["perspective", "orthographic", "cabinet", "cavalier"] {
        let said = bench.good(format!(
            "quad.obj --size 160x80 --projection {projection} --dump d.csv"
        ));
        let dump = bench.text("d.csv");
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
        // The plate fills 94 % of the width or of the height, and it is in the middle.
        let ((left, right), (top, bottom)) = (range(0), range(1));
        let fills = right - left > 145 || bottom - top > 71;
        assert!(fills, "{projection}: {left}..{right}, {top}..{bottom}");
        let is_central = (left + right).abs_diff(159) <= 3 && (top + bottom).abs_diff(79) <= 3;
        assert!(is_central, "{projection}: {left}..{right}, {top}..{bottom}");
    }
}

#[test]
fn the_widest_view_is_drawn() {
    let bench = Bench::new("wide");
    bench.write("t.obj", TRIANGLE);
    // The chosen eye is next to the model, but not inside it.
    let said = bench.good("t.obj --fov 170");
    assert_ne!(printed(&said, "pixels"), "0");
}

#[test]
fn a_model_of_many_points_is_drawn_in_parts() {
    let bench = Bench::new("many");
    // 300 x 300 points are more than 16-bit indices can address.
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
    bench.write("grid.obj", model);
    let view = "--eye 149.5,149.5,400 --look-at 149.5,149.5,0 --size 100x100 --fov 40";
    let said = bench.good(format!("grid.obj {view}"));
    // The view shows 2 · 400 · tan 20° = 291.2 of the plate's 299 units, so the plate covers every pixel exactly once.
    assert_eq!(printed(&said, "pixels"), "10000");
    assert_eq!(printed(&said, "triangles"), (299 * 299 * 2).to_string());
}

/// The triangle with corners 0,0,0 and 1,0,0 and 0,1,0, in many nodes.
const INSTANCES: &str = r#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": [INDICES]}], "nodes": [NODES],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36,
"uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}"#;

/// Hidden faces take time, too, so the viewer bounds the pixels that it draws, whatever the model: faces may be the same,
/// parallel and seen at their edges in the first frame, or instances of a mesh.
#[test]
fn faces_that_cover_the_picture_too_often_are_refused() {
    let bench = Bench::new("layers");
    let same = |count: usize| TRIANGLE.to_string() + &"f 1 2 3\n".repeat(count);
    let parallel = |count: usize| {
        let mut obj = String::new();
        for k in 0..count {
            let x = f64::from(u32::try_from(k).unwrap()) * 1e-5;
            writeln!(obj, "v {x} -1 -1\nv {x} -1 1\nv {x} 1 0\nf -3 -2 -1").unwrap();
        }
        obj
    };
    let instances = |count: usize| {
        let indices: Vec<_> = (0..count).map(|index| index.to_string()).collect();
        INSTANCES
            .replace("INDICES", &indices.join(","))
            .replace("NODES", &vec![r#"{"mesh":0}"#; count].join(","))
    };
    let turning = "--eye 0,0,3 --frames 8 --out turning.gif";
    let counts = [100, 10_000];
    for (name, [good, bad], options) in [
        ("same.obj", counts.map(same), ""),
        ("parallel.obj", counts.map(parallel), "--eye 3,0,0"),
        ("turning.obj", counts.map(parallel), turning),
        ("instances.gltf", counts.map(instances), ""),
    ] {
        bench.write(name, good);
        bench.good(format!("{name} {options} --size 64x48"));
        let _ = fs::remove_file(bench.path("turning.gif"));
        bench.write(name, bad);
        let says = ["faces cover the picture", "at most 200 times", "--eye"];
        bench.refused(format!("{name} {options}"), &says);
    }
}

#[test]
fn messages_name_what_a_file_is_and_name_it_once() {
    let bench = Bench::new("named");
    bench.write("a.glb", "version https://git-lfs.github.com/spec/v1\n");
    bench.write("b.obj", "<!DOCTYPE html>");
    bench.write("c.obj", "v 1 1 1\nf 1 1 1\n");
    bench.write("d.obj", "v 1 1 1\np 1\n");
    bench.write("e.obj", "v 0 0 0\nv 1\n");
    for (name, says) in [
        (
            "a.glb",
            "it is a Git LFS pointer in place of the file: fetch the file itself with git lfs pull",
        ),
        (
            "b.obj",
            "it is an HTML file: download the file itself, not the page about it",
        ),
        (
            "c.obj",
            "there is nothing to see: all points of its faces are at 1,1,1",
        ),
        (
            "d.obj",
            "it has points or lines, but no faces: only faces are drawn; not drawn: points",
        ),
        (
            "e.obj",
            "line 2: 'v 1' is not a position: it needs 3 numbers",
        ),
    ] {
        let message = bench.refused(name, &[]);
        assert_eq!(message, format!("error: model {name}: {says}\n"));
    }
    bench.write("t.obj", TRIANGLE);
    bench.write("t.png", "II*\0");
    let message = bench.refused("t.obj --texture t.png", &[]);
    let says = "it is a TIFF file: PNG, JPEG, BMP, TGA, GIF and WebP can be read";
    assert_eq!(
        message,
        format!("error: cannot read texture t.png: {says}\n")
    );
}

/// These would never end.
#[cfg(unix)]
#[test]
fn pipes_and_devices_are_refused() {
    let bench = Bench::new("endless");
    let pipe = bench.path("pipe.obj");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    bench.write("t.obj", format!("mtllib pipe.obj\n{TRIANGLE}"));
    let says = "it is a pipe or a device, not a file";
    bench.refused("pipe.obj", &[says]);
    bench.refused("/dev/zero", &[says]);
    bench.refused("t.obj --texture /dev/zero", &[says]);
    bench.write("m.mtl", "newmtl a\nmap_Kd /dev/zero\n");
    bench.write("u.obj", format!("mtllib m.mtl\nusemtl a\n{TRIANGLE}"));
    for model in ["t.obj", "u.obj"] {
        let notes = bench.notes(format!("{model} --out o.png"));
        assert!(notes.contains("note: cannot read "), "{notes}");
    }
}
