//! Models that cannot be read, and models that must be visible as a whole.

use std::fmt::Write;
use std::fs;

use super::program::{TRIANGLE, directory, good, printed, refused};

#[test]
fn models_that_cannot_be_read_are_refused() {
    let directory = directory("models");
    for model in ["v 0 0 0\nv 1 0 0\n", "", "\u{0}\u{1}binary"] {
        fs::write(directory.join("bad.obj"), model).unwrap();
        refused(&directory, "bad.obj", &["model bad.obj: "]);
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

#[test]
fn a_model_fills_the_picture() {
    let directory = directory("fills");
    // A plate far from the origin, in a difficult dialect: CRLF, a quad, negative indices, and neither vt nor vn.
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
        // The plate fills 94 % of the width or of the height, and it is in the middle.
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
fn the_widest_view_is_drawn() {
    let directory = directory("wide");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    // The chosen eye is next to the model, but not inside it.
    let said = good(&directory, "t.obj --fov 170");
    assert_ne!(printed(&said, "pixels"), "0");
}

#[test]
fn a_model_of_many_points_is_drawn_in_parts() {
    let directory = directory("many");
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
    fs::write(directory.join("grid.obj"), model).unwrap();
    let view = "--eye 149.5,149.5,400 --look-at 149.5,149.5,0 --size 100x100 --fov 40";
    let said = good(&directory, &format!("grid.obj {view}"));
    // The view shows 2 · 400 · tan 20° = 291.2 of the plate's 299 units, so the plate covers every pixel exactly once.
    assert_eq!(printed(&said, "pixels"), "10000");
    assert_eq!(printed(&said, "triangles"), (299 * 299 * 2).to_string());
}
