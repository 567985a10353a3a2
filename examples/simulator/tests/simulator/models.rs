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
    bench.refused("none.obj", &["cannot read model none.obj"]);
    fs::create_dir(bench.path("folder.obj")).unwrap();
    bench.refused("folder.obj", &["cannot read model folder.obj"]);

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
