//! The camera that the program chooses and prints. The camera must show the whole model at any angle, shape, scale and
//! turn.

use std::fmt::Write;

use fixel_assets::vector::{Vector as Point, cross, dot, sub, unit};

use super::program::{Bench, TRIANGLE, printed};

/// A closed box without symmetry.
const CORNERS: [Point; 8] = [
    [-1.0, -0.5, -1.5],
    [1.0, -0.5, -1.5],
    [1.0, 1.5, -1.5],
    [-1.0, 1.0, -1.5],
    [-1.0, -0.5, 1.0],
    [1.0, -0.5, 1.0],
    [1.0, 1.0, 2.0],
    [-1.0, 1.0, 1.0],
];
const FACES: &str = "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";

/// Writes the box with corners that are moved by `place`.
fn write_box(bench: &Bench, name: &str, place: impl Fn(Point) -> Point) {
    let mut text = String::new();
    for [x, y, z] in CORNERS.map(place) {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    bench.write(name, text + FACES);
}

/// Returns the options in the line that the program printed about the camera.
fn camera(said: &str) -> &str {
    let line = said.lines().find_map(|line| line.strip_prefix("camera "));
    line.unwrap_or_else(|| panic!("no camera in: {said}"))
}

/// Returns the numbers after an option of the camera.
fn option(camera: &str, name: &str) -> Vec<f64> {
    let numbers = printed(camera, name).split(',');
    numbers.map(|number| number.parse().unwrap()).collect()
}

fn point(camera: &str, name: &str) -> Point {
    option(camera, name).try_into().unwrap()
}

/// Projects the corners of the box with a printed camera. Returns two ranges of positions in the picture, left and
/// right, and bottom and top, in units of half of the picture from its center; and the distances of the nearest and the
/// farthest corner.
fn outline(camera: &str, size: [u32; 2], place: impl Fn(Point) -> Point) -> [[f64; 2]; 3] {
    let eye = point(camera, "--eye");
    let line = sub(eye, point(camera, "--look-at"));
    let back = unit(line).unwrap();
    let right = unit(cross(point(camera, "--up"), back)).unwrap();
    let up = cross(back, right);
    let half = (option(camera, "--fov")[0].to_radians() / 2.0).tan();
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    // If lines of sight are parallel, everything appears as large as at the target's distance. A point's distance from
    // the target only shifts the point in the picture.
    let parallel = camera
        .split_once("--projection ")
        .map(|(_, kind)| match kind {
            "orthographic" => 0.0,
            "cabinet" => 0.5 * 0.5_f64.sqrt(),
            _ => 0.5_f64.sqrt(),
        });
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for corner in CORNERS.map(place) {
        let from_eye = sub(corner, eye);
        let distance = -dot(from_eye, back);
        let (depth, shift) = match parallel {
            Some(ratio) => (dot(line, back), ratio * (distance - dot(line, back))),
            None => (distance, 0.0),
        };
        let across = (dot(from_eye, right) + shift) / (depth * half * aspect);
        let rise = (dot(from_eye, up) + shift) / (depth * half);
        for (range, value) in range.iter_mut().zip([across, rise, distance]) {
            *range = [range[0].min(value), range[1].max(value)];
        }
    }
    range
}

/// Checks the camera that the program chose for the box: the whole box is between the near and the far plane. Returns
/// the largest distance of a corner from the middle of the picture, the distance of the box's middle from it, in units
/// of half of the picture, and the ratio of the farthest to the nearest corner's distance.
fn fit(said: &str, size: [u32; 2]) -> [f64; 3] {
    let [across, rise, [nearest, farthest]] = outline(camera(said), size, |p| p);
    assert!(option(said, "--near")[0] < nearest, "{said}");
    assert!(option(said, "--far")[0] > farthest, "{said}");
    let sides = [across, rise];
    let reach = |[low, high]: [f64; 2]| high.max(-low);
    let off = sides.map(|[low, high]| (low + high).abs());
    [
        reach(across).max(reach(rise)),
        off[0].max(off[1]),
        farthest / nearest,
    ]
}

#[test]
fn every_angle_and_shape_shows_the_whole_model_as_large_as_possible() {
    let bench = Bench::new("framing");
    write_box(&bench, "box.obj", |p| p);
    let shapes = [
        [320, 240],
        [2, 40],
        [40, 2],
        [64, 64],
        [2000, 30],
        [30, 2000],
    ];
    let angles = [1.0, 5.0, 40.0, 60.0, 80.0, 100.0, 140.0, 170.0, 179.0];
    let views = angles.map(|fov| (fov, [320, 240])).into_iter();
    for (fov, size) in views.chain(shapes.map(|size| (60.0, size))) {
        let view = format!("--fov {fov} --size {}x{}", size[0], size[1]);
        let [most, off, ratio] = fit(&bench.good(format!("box.obj {view}")), size);
        // The model fills 94 % of the picture, or the eye is next to the model. The printed camera is rounded to 1e-5
        // of the model. The rounding has a larger effect on corners close to the eye.
        let fills = (0.938..0.945).contains(&most);
        assert!(
            fills || (most < 0.945 && ratio > 95.0 && fov >= 80.0),
            "{view}: {most}"
        );
        assert!(off < 2e-3, "{view}: {off}");
    }
}

#[test]
fn a_given_eye_or_target_also_shows_the_whole_model() {
    let bench = Bench::new("given");
    write_box(&bench, "box.obj", |p| p);
    for view in [
        "--eye 3,2,5",
        "--eye 0,0,2.5",
        "--eye 0,40,10",
        "--eye 900,20,30",
        "--eye 4,0,0 --look-at 0,1,1",
        "--look-at 1,1,2",
        "--look-at 0,0,20",
        "--look-at 2,2,2 --fov 50",
    ] {
        let [most, off, _] = fit(&bench.good(format!("box.obj {view}")), [320, 240]);
        assert!((0.938..0.945).contains(&most), "{view}: {most}");
        assert!(off < 2e-3 || view.contains("--look-at"), "{view}: {off}");
    }
}

#[test]
fn parallel_pictures_show_the_whole_model_as_large_as_possible() {
    let bench = Bench::new("parallel");
    write_box(&bench, "box.obj", |p| p);
    let given = ["--look-at 2,2,2", "--look-at 0,9,0 --fov 90", "--eye 3,2,5"];
    let free = ["", "--fov 1", "--fov 170"];
    for kind in ["orthographic", "cabinet", "cavalier"] {
        for view in free.iter().chain(&given) {
            for size in [[320, 240], [3, 90], [90, 3]] {
                let view = format!("{view} --projection {kind} --size {}x{}", size[0], size[1]);
                let said = bench.good(format!("box.obj {view} --shade wire"));
                let [most, off, _] = fit(&said, size);
                assert!((0.9399..0.9401).contains(&most), "{view}: {most}");
                let is_given = view.contains("--look-at") || view.contains("--eye");
                assert!(off < 1e-3 || is_given, "{view}: {off}");
            }
        }
    }
}

#[test]
fn points_in_a_line_are_seen_from_nearby() {
    let bench = Bench::new("line");
    // Lines in an arbitrary direction, along an axis, and along the default line of sight.
    for (name, step) in [
        ("a", [1.0, 1.0, 1.0]),
        ("b", [0.0, 2.0, 0.0]),
        ("c", [0.55, 0.6, 1.0]),
    ] {
        let mut text = String::new();
        for k in 0..3 {
            let [x, y, z] = step.map(|x| x * f64::from(k));
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        // A face without any area is refused.
        let [x, y, z] = step;
        writeln!(text, "v {} {y} {z}", x + 1e-5).unwrap();
        let file = format!("{name}.obj");
        bench.write(&file, text + "f 1 4 3\n");
        let said = bench.run(format!("{file} --shade wire"));
        let said = String::from_utf8(said.stdout).unwrap();
        // A line that points away from the eye appears as a point.
        if name != "c" {
            let eye = point(camera(&said), "--eye");
            assert!(eye.iter().all(|x| x.abs() < 10.0), "{name}: {said}");
        }
    }
}

#[test]
fn a_model_of_any_size_is_drawn_alike_and_reported_in_its_own_units() {
    let bench = Bench::new("sizes");
    let draw = |exponent: i32, view: &str| {
        let scale = f64::from(exponent).exp2();
        write_box(&bench, "box.obj", |p| p.map(|x| (x + 0.25) * scale));
        let words = view.split(' ').map(|word| match word.strip_prefix('*') {
            Some(numbers) => {
                let numbers = numbers.split(',');
                let scaled = numbers.map(|x| (x.parse::<f64>().unwrap() * scale).to_string());
                scaled.collect::<Vec<_>>().join(",")
            }
            None => word.into(),
        });
        let view = words.collect::<Vec<_>>().join(" ");
        let said = bench.good(format!("box.obj {view} --crc --dump d.csv"));
        let dump = bench.text("d.csv");
        // The distances in the dump, in units of `scale`.
        let distances = dump.lines().skip(1).map(|row| {
            let cell = row.split(',').nth(4).unwrap();
            cell.parse::<f64>().unwrap() / scale
        });
        (
            printed(&said, "crc").to_string(),
            distances.collect::<Vec<_>>(),
        )
    };
    for view in [
        "--eye *3,2,5 --look-at *0,0,0 --near *0.5 --far *20",
        "--eye *3,2,5 --look-at *0,0,0 --near *0.5 --far *20 --fov 70 --up 0,1,0 --projection perspective",
        "--eye *3,2,5 --look-at *0,0,0 --near *0.5 --far *20 --projection cabinet",
    ] {
        let (crc, distances) = draw(0, view);
        assert!(distances.len() > 5000, "{view}: {}", distances.len());
        for exponent in [-60, -20, 12, 20, 60] {
            let (scaled_crc, scaled) = draw(exponent, view);
            assert_eq!(scaled_crc, crc, "2^{exponent} {view}");
            assert_eq!(scaled, distances, "2^{exponent} {view}");
        }
    }
    // The program prints its camera with as many digits as the model needs, even if an option repeats a default.
    for scale in [1e-6, 3000.0, 1e6] {
        write_box(&bench, "box.obj", |p| p.map(|x| x * scale));
        let said = bench.good("box.obj --crc");
        let again = bench.good("box.obj --crc --up 0,1,0 --projection perspective --fov 40");
        assert_eq!(printed(&said, "crc"), printed(&again, "crc"), "{scale}");
        let [across, ..] = outline(camera(&said), [320, 240], |p| p.map(|x| x * scale));
        assert!(across[1] > 0.7 && across[1] < 0.945, "{scale}: {across:?}");
    }
    // The model is so far from the origin that single precision would have steps of 1/128.
    write_box(&bench, "box.obj", |p| [p[0] + 1e5, p[1] - 1e5, p[2]]);
    let shifted = bench.crc("box.obj");
    write_box(&bench, "box.obj", |p| p);
    assert_eq!(bench.crc("box.obj"), shifted);
}

#[test]
fn the_printed_camera_makes_the_same_picture() {
    let bench = Bench::new("printed");
    for (name, scale) in [("one", 1.0), ("small", 1e-6), ("large", 777_777.0)] {
        let offset = scale * 31.0;
        write_box(&bench, &format!("{name}.obj"), |p| {
            p.map(|x| x * scale + offset)
        });
    }
    let views = [
        "one.obj",
        "small.obj",
        "large.obj",
        "one.obj --fov 100",
        "one.obj --size 90x20 --up 0,0,1",
        "one.obj --look-at 31,31,31",
        "one.obj --eye 34,35,36",
        "one.obj --eye 31.1,31,31",
        "one.obj --frames 3",
        "one.obj --shade depth --depth float",
        "one.obj --projection orthographic",
        "large.obj --projection orthographic --fov 3",
        "small.obj --projection cabinet",
        "one.obj --projection cavalier --look-at 31,32,31",
        "one.obj --projection cabinet --eye 30,40,50",
    ];
    for view in views {
        let said = bench.good(format!("{view} --crc"));
        // Repeat the other options. An option may occur only once.
        let camera_options = ["--eye", "--look-at", "--up", "--fov", "--projection"];
        let words: Vec<&str> = view.split(' ').collect();
        let is_kept = |at: &usize| {
            let is_camera = |at: usize| {
                words
                    .get(at)
                    .is_some_and(|word| camera_options.contains(word))
            };
            !is_camera(*at) && !is_camera(at.wrapping_sub(1))
        };
        let kept = (0..words.len())
            .filter(is_kept)
            .map(|at| words[at])
            .collect::<Vec<_>>()
            .join(" ");
        let again = bench.good(format!("{kept} {} --crc", camera(&said)));
        let words = |said: &str| ["crc", "pixels"].map(|label| printed(said, label).to_string());
        assert_eq!(camera(&said), camera(&again), "{view}");
        assert_eq!(words(&said), words(&again), "{view}");
    }
}

#[test]
fn the_direction_that_is_up_turns_view_turntable_and_cabinet() {
    let bench = Bench::new("upwards");
    write_box(&bench, "y.obj", |p| p);
    write_box(&bench, "z.obj", |[x, y, z]| [x, -z, y]);
    write_box(&bench, "down.obj", |[x, y, z]| [-x, -y, z]);
    write_box(&bench, "x.obj", |[x, y, z]| [y, -x, z]);
    for view in [
        "",
        "--projection cabinet",
        "--projection cavalier",
        "--projection orthographic --shade flat",
        "--frames 2",
        "--frames 7",
        "--frames 7 --projection cabinet",
    ] {
        let crc = |model: &str| {
            let said = bench.good(format!("{model} {view} --size 120x90 --crc"));
            ["crc", "pixels"].map(|label| printed(&said, label).to_string())
        };
        let upright = crc("y.obj");
        assert_eq!(upright, crc("z.obj --up 0,0,1"), "{view}");
        assert_eq!(upright, crc("z.obj --up 0,0,900"), "{view}");
        assert_eq!(upright, crc("down.obj --up 0,-0.001,0"), "{view}");
        assert_eq!(upright, crc("x.obj --up 1,0,0"), "{view}");
    }
}

#[test]
fn a_turning_model_stays_in_the_picture() {
    let bench = Bench::new("turning");
    write_box(&bench, "box.obj", |p| p);
    // Compare the last frame of each run.
    let said = bench.good("box.obj --frames 12 --size 120x90");
    let options = camera(&said);
    let all = bench.good(format!("box.obj --frames 12 {options} --size 120x90"));
    // The same camera draws a wider picture. If nothing was cut off before, no more pixels appear.
    let half = (option(options, "--fov")[0].to_radians() / 2.0).tan() * 2.0;
    let wider = options.replace(
        &format!("--fov {}", option(options, "--fov")[0]),
        &format!("--fov {}", (half.atan() * 2.0).to_degrees()),
    );
    let wide = bench.good(format!("box.obj --frames 12 {wider} --size 240x180"));
    let pixels = |said: &str| printed(said, "pixels").parse::<f64>().unwrap();
    let ratio = pixels(&all) / pixels(&wide);
    assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
}

#[test]
fn both_sides_are_lit_alike() {
    let bench = Bench::new("both-sides");
    // Seen from +z with y up, the light is at (-0.6, 0.9, 1). This sheet shows its front to the viewer, and its back to
    // the light.
    let sheet = "v 0 0 0\nv 1 0 -1.2\nv 0 1 1.8\n";
    bench.write("front.obj", format!("{sheet}f 1 2 3\n"));
    bench.write("back.obj", format!("{sheet}f 3 2 1\n"));
    write_box(&bench, "box.obj", |p| p);
    let view = "--eye 0.5,0.5,5 --look-at 0.5,0.5,0 --shade flat --color rgb888";
    let front = bench.crc(format!("front.obj {view} --cull"));
    assert_eq!(front, bench.crc(format!("front.obj {view}")));
    assert_eq!(front, bench.crc(format!("back.obj {view}")));
    let brightest = |file: &str| {
        let picture = bench.picture(file);
        let background = picture.get_pixel(0, 0).0;
        let pixels = picture.pixels().filter(|pixel| pixel.0 != background);
        pixels.map(|pixel| pixel.0[0]).max().unwrap()
    };
    // Only the ambient light reaches the sheet: 0.3 of clay's 236, rounded.
    assert_eq!(brightest("back.png"), 71);
    // A closed model changes only along its outline, where a front and a back face meet and can be at the same
    // distance.
    for look in ["lit", "gouraud", "flat"] {
        for eye in ["3,2,5", "-3,-2,4", "1,-5,-2"] {
            let view = format!("box.obj --eye {eye} --shade {look}");
            let (front, both) = (bench.draw(format!("{view} --cull")), bench.draw(view));
            let background = *front.get_pixel(0, 0);
            for (x, y, pixel) in front.enumerate_pixels() {
                let same = pixel == both.get_pixel(x, y);
                let outline = || {
                    let around = [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)];
                    let mut around = around.iter().map(|&(x, y)| front.get_pixel(x, y));
                    around.any(|&pixel| pixel == background)
                };
                assert!(same || outline(), "{look} from {eye}: {x},{y}");
            }
        }
    }
}

#[test]
fn faces_wound_against_their_normals_are_lit_from_where_they_are_seen() {
    let bench = Bench::new("wound");
    // A tent with normals that point to the viewer, first with the right winding, then with the wrong one.
    let points = "v -1 0 0\nv 0 0 1\nv 0 1 0.5\nv 1 0 0\nvn -0.7 0.2 0.7\nvn 0.7 0.2 0.7\n";
    let (right, wrong) = (
        "f 1//1 2//1 3//1\nf 2//2 4//2 3//2\n",
        "f 3//1 2//1 1//1\nf 3//2 4//2 2//2\n",
    );
    bench.write("right.obj", format!("{points}{right}"));
    bench.write("wrong.obj", format!("{points}{wrong}"));
    for look in ["gouraud", "flat"] {
        let view = format!("--eye 0,1,5 --shade {look}");
        let plain = bench.crc(format!("right.obj {view} --cull"));
        assert_eq!(plain, bench.crc(format!("right.obj {view}")));
        assert_eq!(plain, bench.crc(format!("wrong.obj {view}")));
    }
}

#[test]
fn faces_that_point_away_are_drawn_and_counted() {
    let bench = Bench::new("away");
    write_box(&bench, "box.obj", |p| p);
    write_box(&bench, "inside-out.obj", |[x, y, z]| [-x, y, z]);
    bench.write("t.obj", TRIANGLE);
    // All pixels are lost, except some at the outline.
    let lost = bench.notes("inside-out.obj");
    let percent = printed(&lost, "a program that culls back faces would lose");
    assert!(percent.parse::<u32>().unwrap() > 95, "{lost}");
    let hidden = bench.notes("inside-out.obj --cull");
    let percent = printed(&hidden, "--cull hides backs of faces in");
    assert!(percent.parse::<u32>().unwrap() > 95, "{hidden}");
    for without in ["box.obj", "inside-out.obj --shade wire", "t.obj"] {
        assert_eq!(bench.notes(without), "", "{without}");
    }
    let closed = bench.notes("box.obj --cull");
    assert!(
        closed.starts_with("note: --cull hides less than 1 % "),
        "{closed}"
    );
    let behind = "t.obj --eye 0.3,0.3,-3 --look-at 0.3,0.3,0";
    let culled = format!("{behind} --cull");
    bench.refused(&culled, &["nothing is visible", "--cull hides their backs"]);
    bench.good(behind);
}

#[test]
fn positions_that_no_face_uses_do_not_count() {
    let bench = Bench::new("unused");
    bench.write("t.obj", TRIANGLE);
    bench.write("u.obj", format!("{TRIANGLE}v 1e6 -1e6 5\n"));
    let crc = |model: &str| {
        let said = bench.good(format!("{model} --crc"));
        let crc = printed(&said, "crc").to_string();
        (crc, camera(&said).to_string())
    };
    assert_eq!(crc("t.obj"), crc("u.obj"));
}

/// The importer has further tests of this note.
#[test]
fn merging_positions_are_noted_with_a_scale_that_keeps_them() {
    let bench = Bench::new("merging");
    let notes = |scale: f64| {
        write_box(&bench, "box.obj", |p| p.map(|x| x * scale));
        bench.notes("box.obj")
    };
    let note = notes(1e-6);
    assert!(
        note.contains("in include_mesh!") && note.contains("become equal to others"),
        "{note}"
    );
    let scale: f64 = printed(&note, "scale =").parse().unwrap();
    assert_eq!(notes(1e-6 * scale), "");
}

#[test]
fn a_model_that_lies_on_its_side_gets_a_hint() {
    let bench = Bench::new("lying");
    // A pyramid on a square base. The base is in the plane z = 0 or y = 0.
    let pyramid = |name: &str, swap: bool| {
        let mut text = String::new();
        for [x, y, z] in [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [0, 0, 2]] {
            let [x, y, z] = if swap { [x, z, -y] } else { [x, y, z] };
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        text += "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
        bench.write(name, text);
    };
    pyramid("z.obj", false);
    pyramid("y.obj", true);
    write_box(&bench, "box.obj", |p| p);
    let hint = "it has a flat base at its lowest z; see --up z";
    assert!(bench.notes("z.obj").contains(hint));
    for without in ["y.obj", "box.obj", "z.obj --up z"] {
        assert_eq!(bench.notes(without), "", "{without}");
    }
}

#[test]
fn a_camera_that_shows_nothing_is_an_error() {
    let bench = Bench::new("nothing");
    write_box(&bench, "box.obj", |p| p);
    bench.write("sliver.obj", "v 0 0 0\nv 1 0 0\nv 1 1e-5 0\nf 1 2 3\n");
    let outside = "the model is outside the picture";
    let aside = "box.obj --eye 0,0,9 --look-at 9,0,8 --fov 20";
    for (arguments, says) in [
        ("sliver.obj", "cover no pixel: try --shade wire"),
        (
            "box.obj --eye 0,0,9 --look-at 0,0,20",
            "the whole model is behind an eye at 0,0,9",
        ),
        (aside, outside),
        (&format!("{aside} --frames 3"), outside),
        (&format!("{aside} --shade wire"), outside),
        (
            "box.obj --eye 0,0,9 --look-at 9,0,9 --projection cabinet --fov 1",
            outside,
        ),
    ] {
        bench.refused(arguments, &["nothing is visible", says]);
    }
    // The sheet shows its back in the first frame, and its front in a later frame. One frame that shows the front is
    // enough.
    let sheet = "v -1 0 0\nv 1 0 0\nv 1 1 0\nv -1 1 0\nf 4 3 2 1\n";
    bench.write("sheet.obj", sheet);
    let view = "sheet.obj --cull --eye 0,0.5,9 --look-at 0,0.5,0";
    bench.refused(view, &["nothing is visible"]);
    bench.good(format!("{view} --frames 4"));
}
