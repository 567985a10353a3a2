//! OBJ and MTL files as real programs write them are read, and notes say what was replaced or left out.

#![allow(clippy::float_cmp)] // the files state these values exactly

mod common;

use std::collections::HashSet;

use common::{notes, read};
use fixel_assets::{Alpha, Material, Model, Options, Smoothing};

/// A square of two triangles.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn obj(text: &str) -> Result<Model, String> {
    read(&[("a.obj", text)])
}

/// Reads a model. The model must have no notes.
fn clean(text: &str) -> Model {
    let model = obj(text).expect(text);
    assert!(model.notes.is_empty(), "{text}: {:?}", notes(&model));
    model
}

/// Reads a model. The model must have exactly one note, and the note must contain `says`.
#[track_caller]
fn noted(text: &str, says: &str) -> Model {
    let model = obj(text).expect(text);
    let notes = notes(&model);
    assert!(notes.len() == 1 && notes[0].contains(says), "{notes:?}");
    model
}

/// Reads a square with the material `a` of this MTL text.
#[track_caller]
fn with_mtl(mtl: &str) -> Model {
    let uvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    let text = format!("mtllib a.mtl\n{SQUARE}{uvs}usemtl a\nf 1/1 2/2 3/3 4/4\n");
    read(&[("a.obj", text.as_str()), ("a.mtl", mtl)]).expect(mtl)
}

/// The material of this MTL text. The text must cause no notes.
#[track_caller]
fn material(mtl: &str) -> Material {
    let model = with_mtl(mtl);
    assert!(model.notes.is_empty(), "{mtl}: {:?}", notes(&model));
    model.materials[0].clone()
}

/// The only note that this MTL text causes. The square must still be drawn.
#[track_caller]
fn note(mtl: &str) -> String {
    let model = with_mtl(mtl);
    assert_eq!(model.triangles.len(), 2);
    let notes = notes(&model);
    assert_eq!(notes.len(), 1, "{mtl}: {notes:?}");
    notes[0].clone()
}

/// The texture coordinates of the square's corners, in the order of the file.
fn uvs(model: &Model) -> [[f64; 2]; 4] {
    let [first, second] = [0, 1].map(|at| model.triangles[at].corners);
    [first[0], first[1], first[2], second[2]].map(|corner| {
        let uv = corner.uv.expect("a texture coordinate");
        model.uvs[uv as usize]
    })
}

#[test]
fn every_line_end_and_a_byte_order_mark_are_read() {
    // The text ends with a single line end of another system, which must not matter.
    for end in ["\n", "\r\n", "\r"] {
        let text =
            format!("\u{feff}# made by hand\n{SQUARE}\nf 1 2 3 4\n").replace('\n', end) + "\n# \r";
        let model = clean(&text);
        assert_eq!(model.triangles.len(), 2, "{end:?}");
        let problem = obj(&text.replace("v 1 1 0", "v 1 1")).unwrap_err();
        let wanted = "line 4: 'v 1 1' is not a position: it needs 3 numbers";
        assert_eq!(problem, wanted);
    }
}

#[test]
fn a_backslash_joins_lines() {
    let model = clean(&format!("{SQUARE}f 1 2 \\\n3 \\ \t\r\n 4\n"));
    assert_eq!(model.triangles.len(), 2);
    assert_eq!(clean(&format!("{SQUARE}f 1 2\\\n3\\")).triangles.len(), 1);
}

#[test]
fn numbers_have_comments_signs_and_weights() {
    let text =
        "v +0 0 0 # first\nv 1 0 0 1\nv 0 1e0 0 1 1 #x\nvt 0 1 #\nvn 0 0 1 # up\nf +1 2 -1 # 4\n";
    let model = clean(text);
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(model.positions, positions);
    assert!(model.colors.is_empty());
    let corners = model.triangles[0].corners.map(|corner| corner.position);
    assert_eq!(corners, [0, 1, 2]);
}

#[test]
fn lines_stay_edges() {
    let model = clean(&format!("{SQUARE}f 1 2 3\nl 3 4/1 1 #5\n"));
    assert!(model.has_lines && !clean(&format!("{SQUARE}f 1 2 3\n")).has_lines);
    let edges = [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]];
    assert_eq!(model.edges, edges);
    let text = format!("{SQUARE}v nan 0 0\nf 1 2 3\nl 4 9\nl 4 5\nl 4 x\nl 4 0\n");
    let model = noted(&text, "a line is left out: an end is missing (4 times)");
    assert_eq!(model.edges.len(), 3);
}

#[test]
fn decimal_commas_are_points() {
    let model = noted("v 0,5 0 0\nv 1 0 0\nv 0 1,25 0\nf 1 2 3", "comma");
    assert_eq!(model.positions[0], [0.5, 0.0, 0.0]);
    assert_eq!(model.positions[2], [0.0, 1.25, 0.0]);
}

#[test]
fn what_is_no_number_is_left_out() {
    // A vertex that no face uses causes no note.
    clean(&format!("{SQUARE}v nan inf -1.#IND\nf 1 2 3 4\n"));
    let text = format!("{SQUARE}v nan 0 0\nf 1 2 3 4\nf 1 2 5\n");
    let model = noted(&text, "a face is left out: a coordinate");
    assert_eq!(model.triangles.len(), 2);
    for normal in ["nan nan nan", "1 0", "inf 0 0", "0 0 0", "-nan(ind) 0 0"] {
        let model = noted(
            &format!("{SQUARE}vn {normal}\nf 1//1 2//1 3//1\n"),
            "a normal",
        );
        let normal = model.triangles[0].corners[0].normal.unwrap();
        assert_eq!(model.normals[normal as usize], [0.0, 0.0, 1.0]);
    }
    let text = format!("{SQUARE}vt nan 0\nvt 0 0\nf 1/1 2/2 3/2\n");
    let model = noted(&text, "texture coordinates are left out");
    assert_eq!(model.triangles[0].corners[1].uv, None);
    let problem = obj("v 1 2 x\n").unwrap_err();
    assert!(
        problem.contains("line 1: 'v 1 2 x' is not a position"),
        "{problem}"
    );
}

#[test]
fn missing_indices_are_replaced_or_left_out() {
    let lists = "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 2\n";
    for index in ["0", "2", "-2", "x", "1.5", "99999999999999999999"] {
        let text = format!("{SQUARE}{lists}f 1//{index} 2//{index} 3//{index}\nf 1//1 3//1 4//2\n");
        let model = obj(&text).unwrap();
        // Index 2 is missing, too, although the repairs of the first corners add normals to the list.
        let note = &notes(&model)[0];
        assert!(
            note.contains("a normal is replaced") && note.contains("(4 times)"),
            "{note}"
        );
        for triangle in &model.triangles {
            for corner in triangle.corners {
                let [x, y, z] = model.normals[corner.normal.unwrap() as usize];
                assert!(x == 0.0 && y == 0.0 && z > 0.0, "{index}");
            }
        }
    }
    for index in ["0", "4", "-4", "x"] {
        let text = format!("{SQUARE}{lists}f 1/1 2/2 3/{index}\n");
        let model = noted(&text, "not every corner");
        assert_eq!(
            model.triangles[0].corners.map(|corner| corner.uv),
            [None; 3]
        );
    }
    noted(&format!("{SQUARE}{lists}f 1/1 2/2 3\n"), "not every corner");
    let text = format!("{SQUARE}{lists}vt 0 5000\nf 1/4 2/4 3/4\nf 1/5 2/6 3/7\n");
    let uvs = obj(&text).unwrap().triangles[1]
        .corners
        .map(|corner| corner.uv);
    assert_eq!(uvs, [None; 3]);
    for face in [
        "1 2 0",
        "1 2 5",
        "1 2 -5",
        "1 2 x",
        "1 2 /1/1",
        "1 2 3/1/1/1",
    ] {
        let text = format!("{SQUARE}{lists}f 1 2 3 4\nf {face}\n");
        let model = noted(&text, "it names a vertex that does not exist");
        assert_eq!(model.triangles.len(), 2, "{face}");
    }
    for face in ["1", "1 2", ""] {
        noted(
            &format!("{SQUARE}f 1 2 3 4\nf {face}\n"),
            "fewer than 3 corners",
        );
    }
    // Vertices can follow the faces that name them.
    assert_eq!(clean(&format!("f 1 2 3 4\n{SQUARE}")).triangles.len(), 2);
}

/// Lines that cannot be read are counted, so the values of later lines keep their indices.
#[test]
fn what_cannot_be_read_is_counted() {
    let text = format!("{SQUARE}vt\nvt 0.5 0\nvn up\nvn 0 0 4\nf 1/2/2 2/2/2 3/2/2\n");
    let model = noted(&text, "a word of a line is skipped");
    let corner = model.triangles[0].corners[0];
    assert_eq!(model.uvs[corner.uv.unwrap() as usize], [0.5, 1.0]);
    assert_eq!(
        model.normals[corner.normal.unwrap() as usize],
        [0.0, 0.0, 4.0]
    );
    let model = obj(&text.replace("/2", "/1")).unwrap();
    let corner = model.triangles[0].corners[0];
    assert_eq!(corner.uv, None);
    assert_eq!(
        model.normals[corner.normal.unwrap() as usize],
        [0.0, 0.0, 1.0]
    );
}

/// Positions a millionth apart, at the origin and far from it.
#[test]
fn a_note_tells_how_to_keep_positions_apart() {
    let text = |from: f64| {
        // The points are on a parabola, so that faces have an area.
        let corner = |at: u32| {
            let x = f64::from(at) * 1e-6;
            format!("v {} {} 0\n", from + x, x * x)
        };
        let corners: String = (0..300).map(corner).collect();
        let face = |at: u32| format!("f {} {} {}\n", at + 1, at + 2, at + 3);
        corners + &(0..298).map(face).collect::<String>()
    };
    for (from, wanted) in [(0.0, ": scale = "), (10_000.0, ": center, scale = ")] {
        let model = obj(&text(from)).unwrap();
        let note = model.merging(1.0).unwrap();
        let (_, options) = note.split_once(wanted).unwrap();
        let scale = options.split_once(' ').unwrap().0.parse().unwrap();
        let center = wanted.contains("center");
        assert_eq!(model.merging(scale), None);
        let options = Options {
            center,
            scale,
            ..Options::default()
        };
        let positions = model.lists(&options).unwrap().positions;
        let distinct: HashSet<_> = positions.iter().collect();
        assert!(distinct.len() > 290, "{}", distinct.len());
        let [low, high] = [positions.iter().min(), positions.iter().max()].map(Option::unwrap);
        assert_eq!(center, (low[0] + high[0]).abs() <= 1, "{low:?} {high:?}");
    }
}

#[test]
fn colors_are_fractions_or_bytes() {
    let colored = |first: &str, second: &str| {
        let model = clean(&format!(
            "v 0 0 0 {first}\nv 1 0 0\nv 1 1 0 {second}\nv 0 1 0\nf 1 2 3 4\n"
        ));
        let corners = model.triangles.iter().flat_map(|triangle| triangle.corners);
        let colors: Vec<_> = corners
            .map(|corner| model.colors[corner.color.unwrap() as usize])
            .collect();
        // The fourth vertex has no color, and becomes white.
        assert_eq!(colors[5], [255; 3]);
        [colors[0], colors[1], colors[2]]
    };
    let white = [255; 3];
    assert_eq!(
        colored("1 0 0.5", "0 1 0"),
        [[255, 0, 128], white, [0, 255, 0]]
    );
    assert_eq!(
        colored("255 0 128", "0 1 0"),
        [[255, 0, 128], white, [0, 1, 0]]
    );
    assert_eq!(
        colored("1.0001 0 0.5 1", "nan -1 0"),
        [[255, 0, 128], white, [0; 3]]
    );
}

#[test]
fn smoothing_groups_are_read() {
    let groups = |text: &str| {
        let model = obj(&format!("{SQUARE}{text}")).unwrap();
        let groups = model.triangles.iter().map(|triangle| triangle.smoothing);
        (groups.collect::<Vec<_>>(), notes(&model))
    };
    assert_eq!(groups("f 1 2 3\n").0, [Smoothing::Angle]);
    let (found, notes) = groups("s 1\nf 1 2 3\ns off\nf 1 2 3\ns 7 # x\nf 1 2 3\ns 0\nf 1 2 3\n");
    let group = Smoothing::Group;
    assert_eq!(
        found,
        [group(1), Smoothing::Flat, group(7), Smoothing::Flat]
    );
    assert!(notes.is_empty());
    let (found, notes) = groups("s 2\ns all\nf 1 2 3\n");
    assert_eq!(found, [group(2)]);
    assert!(
        notes.len() == 1 && notes[0].contains("smoothing"),
        "{notes:?}"
    );
}

#[test]
fn what_is_not_drawn_is_named_once() {
    let text =
        format!("{SQUARE}g a\no b\nf 1 2 3\nvp 1 2\np 1\np 2\ncurv 0 1 1 2\nlod 1\nfoo\nfoo\n");
    let model = noted(&text, "not drawn: 'vp', points, 'curv', 'lod', 'foo'");
    assert_eq!(model.triangles.len(), 1);
    // A file of garbage causes only a note of limited length.
    let words: Vec<String> = (0..100_000).map(|at| format!("w{at} x\n")).collect();
    let words = words.concat();
    let model = noted(&format!("{SQUARE}f 1 2 3\n{words}"), "'w0', 'w1', ");
    assert!(notes(&model)[0].len() < 1000);
}

#[test]
fn what_is_no_model_is_refused() {
    let binary = b"v \0\x01\x02\nf\n".repeat(9);
    for bytes in [b"L\x01\0\0\x10".to_vec(), binary] {
        let problem = read(&[("a.obj", bytes)]).unwrap_err();
        assert_eq!(problem, "it is not text: an OBJ file must be text");
    }
    let face = format!("{SQUARE}f{}", " 1".repeat(1_000_001));
    let problem = obj(&face).unwrap_err();
    assert!(
        problem.contains("line 5: a face has more than 1000000 corners"),
        "{problem}"
    );
    // A zero byte in a comment does not matter.
    clean(&format!("{SQUARE}f 1 2 3\n# \0\n"));
}

#[test]
fn names_may_contain_anything() {
    let text = format!(
        "{SQUARE}vt 0 0\nf 1 2 3\nmtllib my #1 lib.mtl\nusemtl wood #1\nf 1/1 2/1 3/1\nusemtl wood #2\nf 1 2 3\n"
    );
    let mtl = "newmtl wood #1\nKd 1 0 0 # red\nmap_Kd a #b.png\nnewmtl wood #2\nKd 0 0 1\n";
    let files = [
        ("x/a.obj", text.as_str()),
        ("x/my #1 lib.mtl", mtl),
        ("x/lib.mtl", ""),
    ];
    let model = read(&files).unwrap();
    assert!(model.notes.is_empty(), "{:?}", notes(&model));
    let names: Vec<&str> = model.materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["wood #1", "wood #2"]);
    let materials: Vec<_> = model
        .triangles
        .iter()
        .map(|triangle| triangle.material)
        .collect();
    assert_eq!(materials, [None, Some(0), Some(1)]);
    assert_eq!(model.materials[0].color, [255, 0, 0]);
    let files: Vec<_> = model
        .files
        .iter()
        .map(|file| file.to_str().unwrap())
        .collect();
    assert_eq!(files, ["x/my #1 lib.mtl", "x/a #b.png"]);
}

#[test]
fn libraries_may_be_several_or_missing() {
    let faces = "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n";
    let libraries = [
        ("a.mtl", "newmtl a\nKd 1 0 0\n"),
        ("b.mtl", "newmtl b\nKd 0 1 0\n"),
    ];
    for lines in [
        "mtllib a.mtl\nmtllib b.mtl\n",
        "mtllib a.mtl b.mtl\n",
        "mtllib b.mtl\nmtllib a.mtl\nmtllib b.mtl\n",
    ] {
        // The lines of `mtllib` can also follow the faces.
        for text in [
            format!("{lines}{SQUARE}{faces}"),
            format!("{SQUARE}{faces}{lines}"),
        ] {
            let model = read(&[("a.obj", text.as_str()), libraries[0], libraries[1]]).unwrap();
            assert!(model.notes.is_empty(), "{text}: {:?}", notes(&model));
            let color =
                |at: usize| model.materials[model.triangles[at].material.unwrap() as usize].color;
            assert_eq!([color(0), color(1)], [[255, 0, 0], [0, 255, 0]]);
        }
    }
    let text = format!("mtllib my lib.mtl\n{SQUARE}{faces}usemtl\nf 1 2 4\n");
    let model = obj(&text).unwrap();
    let notes = notes(&model);
    assert_eq!(notes.len(), 2, "{notes:?}");
    assert!(
        notes[0].contains("cannot read materials my lib.mtl: "),
        "{notes:?}"
    );
    assert_eq!(
        notes[1],
        "undefined materials are white: 2, the first is 'a'"
    );
    let white = ["a", "b"].map(|name| Material::new(name.into()));
    assert_eq!(model.materials, white);
    let materials: Vec<_> = model
        .triangles
        .iter()
        .map(|triangle| triangle.material)
        .collect();
    assert_eq!(materials, [Some(0), Some(1), None]);
    let parts = [
        ("a.obj", format!("mtllib a.mtl none.mtl\n{SQUARE}{faces}")),
        ("a.mtl", libraries[0].1.into()),
    ];
    let notes = common::notes(&read(&parts).unwrap());
    assert!(
        notes[0].contains("none.mtl")
            && notes[1] == "undefined materials are white: 1, the first is 'b'",
        "{notes:?}"
    );
}

#[test]
fn materials_have_colors_opacity_and_emission() {
    let red =
        material("newmtl a\nKa 1 1 1\nKd 1 0.5 0\nKs 1 1 1\nNs 9\nNi 1\nillum 2\nKe 0 0 0.2\n");
    assert_eq!((red.color, red.emission), ([255, 128, 0], [0, 0, 51]));
    assert_eq!(material("newmtl a\nKd 0.2\n").color, [51; 3]);
    let opacity = |lines: &str| material(&format!("newmtl a\n{lines}\n")).opacity;
    let cases = [
        ("", 1.0),
        ("d 0.25", 0.25),
        ("d -halo 0.25", 0.25),
        ("Tr 0.25", 0.75),
        ("d 1\nTr 1", 1.0),
        ("Tr 1\nd 1", 1.0),
        ("d 7", 1.0),
    ];
    for (lines, wanted) in cases {
        assert!((opacity(lines) - wanted).abs() < 1e-9, "{lines}");
    }
}

#[test]
fn mistakes_in_materials_are_noted() {
    let color = |mtl: &str, says: &str| {
        let note = note(mtl);
        assert!(note.contains(says), "{mtl}: {note}");
        with_mtl(mtl).materials[0].color
    };
    assert_eq!(
        color("newmtl a\nKd 0,8 0,4 0\n", "a decimal comma"),
        [204, 102, 0]
    );
    assert_eq!(
        color("Kd 1 0 0\nnewmtl a\n", "before the first newmtl"),
        [255; 3]
    );
    let twice = "newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 0 1\nd 0\n";
    assert_eq!(
        color(
            twice,
            "a second material of the same name is skipped (2 times)"
        ),
        [255, 0, 0]
    );
    for value in ["", "red", "xyz 0.4 0.3 0.2", "spectral a.rfl", "1 0"] {
        let model = with_mtl(&format!("newmtl a\nKd {value}\nKe 1 0 0\n"));
        let notes = notes(&model);
        assert!(
            notes
                .iter()
                .any(|note| note.contains("'Kd' of a material cannot be read")),
            "{value}: {notes:?}"
        );
        assert_eq!(
            (model.materials[0].color, model.materials[0].emission),
            ([255; 3], [255, 0, 0])
        );
    }
    for line in ["map_Kd", "map_Kd -clamp on", "d nan", "d"] {
        let keyword = line.split(' ').next().unwrap();
        let note = note(&format!("newmtl a\n{line}\n"));
        assert!(
            note.contains(&format!("'{keyword}' of a material cannot be read")),
            "{note}"
        );
    }
    let left_out =
        note("newmtl a\nmap_Ks a.png\nmap_Bump b.png\nnorm c.png\nPr 1\nfoo\nmap_Ks a.png\n");
    assert_eq!(
        left_out,
        "not drawn: 'map_Ks', 'map_Bump', 'norm', 'Pr', 'foo'"
    );
}

#[test]
fn textures_have_options() {
    let file = |line: &str| {
        let model = with_mtl(&format!("newmtl a\n{line}\n"));
        assert!(model.notes.is_empty(), "{line}: {:?}", notes(&model));
        let file = model.files.last().unwrap().to_str().unwrap().to_string();
        (file, model.materials[0].clamp)
    };
    let repeats = [
        "map_Kd my picture.png",
        "map_Kd -s 2 my picture.png",
        "map_Kd -s 2 2 2 -o 1 my picture.png",
        "map_Kd -blendu on -bm 1 -imfchan r -texres 64 -type sphere -clamp off my picture.png",
        "map_Kd -what 1 2 3 4 5 my picture.png",
        "map_Kd -cc on -boost 1.5 C:\\elsewhere\\my picture.png",
    ];
    for line in repeats {
        assert_eq!(file(line), ("my picture.png".into(), [false; 2]), "{line}");
    }
    assert_eq!(
        file("map_Kd -clamp on -s 1 1 1 a.png"),
        ("a.png".into(), [true; 2])
    );
    assert_eq!(file("map_Kd 7 up.png").0, "7 up.png");
    assert_eq!(note("newmtl a\nmap_Kd -mm 0 1 a.png\n"), "not drawn: '-mm'");
}

#[test]
fn textures_with_alpha_have_holes() {
    assert_eq!(material("newmtl a\nKd 1 0 0\n").alpha, Alpha::Ignored);
    for mtl in [
        "map_Kd a.png",
        "map_Kd a.png\nmap_d a.png",
        "map_d -imfchan m a.png\nmap_Kd a.png",
    ] {
        assert_eq!(
            material(&format!("newmtl a\n{mtl}\n")).alpha,
            Alpha::Cut(128),
            "{mtl}"
        );
    }
    for mtl in ["map_Kd a.png\nmap_d b.png", "map_d a.png"] {
        assert_eq!(note(&format!("newmtl a\n{mtl}\n")), "not drawn: 'map_d'");
    }
}

#[test]
fn texture_coordinates_are_scaled_and_moved() {
    let square = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let moved = |options: &str| uvs(&with_mtl(&format!("newmtl a\nmap_Kd {options} a.png\n")));
    assert_eq!(moved(""), square);
    assert_eq!(moved("-s 1 1 1"), square);
    // In the file, v points up. The point with the file's v = 0 stays where it is.
    assert_eq!(
        moved("-s 2 3 1"),
        [[0.0, 1.0], [2.0, 1.0], [2.0, -2.0], [0.0, -2.0]]
    );
    assert_eq!(
        moved("-o 0.5 0.25"),
        square.map(|[u, v]| [u + 0.5, v - 0.25])
    );
    assert_eq!(
        moved("-s 2 -o 1 0"),
        square.map(|[u, v]| [2.0 * u + 1.0, v])
    );
    // Faces of other materials use the same coordinates, and are not transformed.
    let text = format!(
        "mtllib a.mtl\n{SQUARE}vt 1 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 3/1 4/1\nf 1 2 4\n"
    );
    let mtl = "newmtl a\nmap_Kd -s 2 2 a.png\nnewmtl b\nmap_Kd a.png\n";
    let model = read(&[("a.obj", text.as_str()), ("a.mtl", mtl)]).unwrap();
    let uv = |at: usize| {
        model.triangles[at].corners[2]
            .uv
            .map(|at| model.uvs[at as usize])
    };
    assert_eq!(
        [uv(0), uv(1), uv(2)],
        [Some([2.0, 1.0]), Some([1.0, 1.0]), None]
    );
    assert_eq!(model.uvs.len(), 2);
    // Coordinates that are far from 0 after the transform are moved near 0.
    let far = with_mtl("newmtl a\nmap_Kd -o 5000 0 a.png\n");
    assert_eq!(uvs(&far), square);
    assert!(notes(&far)[0].contains("beyond 1024"));
}

/// Two squares with materials `a` and `b`, and the materials' opacities after reading.
fn opacities(mtl: &str) -> (Vec<f64>, Vec<String>) {
    let text = format!("mtllib m.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\nusemtl b\nf 4 3 2 1\n");
    let model = read(&[("a.obj", text.as_str()), ("m.mtl", mtl)]).unwrap();
    let opacities = model.materials.iter().map(|it| it.opacity).collect();
    (opacities, notes(&model))
}

#[test]
fn no_model_is_invisible() {
    let opaque = "all faces have the opacity 0: they are drawn opaque";
    let meant = "Tr 1 without d is read as opaque";
    let hidden = "a material has the opacity 0: its faces are invisible";
    let cases: [(&str, &[f64], &[&str]); 8] = [
        ("newmtl a\nTr 1\nnewmtl b\nTr 1.0\n", &[1.0; 2], &[meant]),
        (
            "newmtl a\nTr 1\nnewmtl b\nTr 0.25\n",
            &[1.0, 0.75],
            &[meant],
        ),
        ("newmtl a\nTr 1\nd 1\nnewmtl b\n", &[1.0; 2], &[]),
        ("newmtl a\nd 1\nTr 1\nnewmtl b\n", &[1.0; 2], &[]),
        ("newmtl a\nTr 1\nd 0.5\nnewmtl b\n", &[0.5, 1.0], &[]),
        ("newmtl a\nd 0\nnewmtl b\nd 0\n", &[1.0; 2], &[opaque]),
        ("newmtl a\nd 0\nnewmtl b\n", &[0.0, 1.0], &[hidden]),
        // No face has the third material.
        (
            "newmtl a\nd 0\nnewmtl b\nd 0\nnewmtl c\n",
            &[1.0; 3],
            &[opaque],
        ),
    ];
    for (mtl, wanted, says) in cases {
        assert_eq!(
            opacities(mtl),
            (
                wanted.to_vec(),
                says.iter().map(ToString::to_string).collect()
            ),
            "{mtl}"
        );
    }
}

/// Opaque texels of a picture of one row, as a PNG.
fn png(colors: &[[u8; 3]]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let width = u32::try_from(colors.len()).unwrap();
    let picture = image::RgbImage::from_raw(width, 1, colors.concat()).unwrap();
    let mut to = std::io::Cursor::new(&mut bytes);
    picture.write_to(&mut to, image::ImageFormat::Png).unwrap();
    bytes
}

#[test]
fn textures_of_light_are_added_to_the_surface() {
    let obj = format!("mtllib m.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n");
    let shown = |mtl: &str| {
        let surface = png(&[[10, 20, 30], [40, 50, 250]]);
        let light = png(&[[100, 0, 0]]);
        let files = [
            ("a.obj", obj.as_bytes()),
            ("m.mtl", mtl.as_bytes()),
            ("s.png", &surface),
            ("l.png", &light),
        ];
        let memory = common::memory(&files);
        let mut model = fixel_assets::read(std::path::Path::new("a.obj"), &memory).unwrap();
        let material = model.materials[0].clone();
        let picture = model
            .texture(&material, &memory)
            .map(|picture| picture.pixels);
        (picture, material.emission, notes(&model))
    };
    let both = vec![[110, 20, 30, 255], [140, 50, 250, 255]];
    let textures = "newmtl a\nKd 1 1 1\nmap_Kd s.png\nmap_Ke l.png\n";
    for factor in ["", "Ke 1 1 1\n", "Ke 0 0 0\n"] {
        let found = shown(&format!("{textures}{factor}"));
        assert_eq!(found, (Some(both.clone()), [0; 3], vec![]), "{factor}");
    }
    // The last texture of light counts, however many there are.
    let many = "map_Ke s.png\n".repeat(100_000);
    let found = shown(&format!("newmtl a\nmap_Kd s.png\n{many}map_Ke l.png\n"));
    assert_eq!(found, (Some(both.clone()), [0; 3], vec![]));
    // Half of the light: 50.2, rounded.
    let half = shown(&format!("Ke 9 9 9\n{textures}Ke 0.5 0 0\n"))
        .0
        .unwrap();
    assert_eq!(half[0], [60, 20, 30, 255]);
    // A surface of one color: 0.2 of 255 is 51.
    let plain = "newmtl a\nKd 0.2 0.2 0.2\nmap_Ke l.png\n";
    assert_eq!(shown(plain).0.unwrap(), [[151, 51, 51, 255]]);
    // The light lies otherwise on the faces than the surface does. Then it is not drawn, nor is its factor.
    for options in ["-s 2 2 2", "-o 0.5", "-clamp on"] {
        let apart = format!("newmtl a\nmap_Kd s.png\nKe 1 1 1\nmap_Ke {options} l.png\n");
        let (picture, emission, notes) = shown(&apart);
        assert_eq!((picture.unwrap()[0], emission), ([10, 20, 30, 255], [0; 3]));
        assert_eq!(
            notes,
            ["not drawn: emission with other texture coordinates than the surface"]
        );
        let alike = apart.replace("map_Kd", &format!("map_Kd {options}"));
        assert_eq!(shown(&alike), (Some(both.clone()), [0; 3], vec![]));
    }
    // A missing picture of light leaves the surface, and a missing picture of the surface leaves its color.
    let (picture, _, notes) = shown("newmtl a\nmap_Kd s.png\nmap_Ke none.png\n");
    assert_eq!(picture.unwrap()[0], [10, 20, 30, 255]);
    assert!(
        notes[0].starts_with("cannot read texture none.png: "),
        "{notes:?}"
    );
    assert!(notes[0].ends_with("; its faces do not glow"), "{notes:?}");
    let (picture, _, notes) = shown("newmtl a\nmap_Kd none.png\nmap_Ke l.png\n");
    assert!(
        picture.is_none() && notes[0].ends_with("; its faces have one color"),
        "{notes:?}"
    );
}

/// A picture of the width of one and the height of the other could fill the memory.
#[test]
fn light_and_surface_get_the_size_of_the_one_with_more_texels() {
    let obj = format!("mtllib m.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n");
    let (short, long) = (png(&[[9; 3]; 2]), png(&[[5; 3]; 3]));
    let mut column = std::io::Cursor::new(Vec::new());
    let picture = image::RgbImage::from_pixel(1, 4, image::Rgb([7; 3]));
    picture
        .write_to(&mut column, image::ImageFormat::Png)
        .unwrap();
    let mtl = b"newmtl a\nmap_Kd s.png\nmap_Ke l.png\n".as_slice();
    let column = column.into_inner();
    for (surface, light, size, sum) in [
        (&short, &column, (1, 4), 16),
        (&column, &short, (1, 4), 16),
        (&short, &long, (3, 1), 14),
    ] {
        let files = [
            ("a.obj", obj.as_bytes()),
            ("m.mtl", mtl),
            ("s.png", surface),
            ("l.png", light),
        ];
        let memory = common::memory(&files);
        let mut model = fixel_assets::read(std::path::Path::new("a.obj"), &memory).unwrap();
        let material = model.materials[0].clone();
        let picture = model.texture(&material, &memory).unwrap();
        assert_eq!((picture.width, picture.height), size);
        assert!(picture.pixels.iter().all(|it| *it == [sum, sum, sum, 255]));
    }
}

#[test]
fn a_texture_of_ambient_light_serves_if_there_is_no_other() {
    let file = |mtl: &str| {
        let model = with_mtl(mtl);
        assert!(model.notes.is_empty(), "{mtl}: {:?}", notes(&model));
        let texture = model.materials[0].texture.unwrap() as usize;
        model.images[texture]
            .file()
            .unwrap()
            .to_str()
            .unwrap()
            .to_string()
    };
    assert_eq!(file("newmtl a\nmap_Ka -clamp on a.png\n"), "a.png");
    assert_eq!(file("newmtl a\nmap_Ka a.png\nmap_Kd d.png\n"), "d.png");
    assert_eq!(file("newmtl a\nmap_Kd d.png\nmap_Ka a.png\n"), "d.png");
    assert_eq!(file("newmtl a\nmap_Ka a.png\nmap_Ka b.png\n"), "b.png");
}

#[test]
fn a_material_can_lack_a_name() {
    let colors = |text: &str| {
        let text = format!("mtllib m.mtl\n{SQUARE}{text}f 1 2 3 4\n");
        let model = read(&[("a.obj", text.as_str()), ("m.mtl", "newmtl\nKd 1 0 0\n")]).unwrap();
        assert!(model.notes.is_empty(), "{:?}", notes(&model));
        let material = model.triangles[0].material;
        material.map(|at| model.materials[at as usize].color)
    };
    assert_eq!(colors("usemtl\n"), Some([255, 0, 0]));
    assert_eq!(colors("usemtl  \n"), Some([255, 0, 0]));
    assert_eq!(colors(""), None);
    // Without such a material, faces have none.
    let model = clean(&format!("{SQUARE}usemtl\nf 1 2 3 4\n"));
    assert_eq!(model.triangles[0].material, None);
}

#[test]
fn textures_are_beside_the_file_that_names_them() {
    let obj = format!("mtllib materials/m.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n");
    let found = |name: &str, present: &[&str]| {
        let mtl = format!("newmtl a\nmap_Kd {name}\n");
        let mut files = vec![("x/a.obj", obj.as_str()), ("x/materials/m.mtl", &mtl)];
        files.extend(present.iter().map(|name| (*name, "")));
        let model = read(&files).unwrap();
        model.images[0]
            .file()
            .unwrap()
            .to_str()
            .unwrap()
            .to_string()
    };
    let (inner, outer) = ("x/materials/t/q.png", "x/t/q.png");
    for name in ["t/q.png", "t\\q.png"] {
        assert_eq!(found(name, &[inner, outer]), inner);
        assert_eq!(found(name, &[outer]), outer);
        // From another computer.
        assert_eq!(
            found(
                &format!("C:\\work\\{name}"),
                &["x/q.png", "x/materials/q.png"]
            ),
            "x/materials/q.png"
        );
        assert_eq!(found(name, &["x/q.png"]), "x/q.png");
    }
    // The exact name in a later place counts more than another case in an earlier one.
    assert_eq!(found("t/Q.PNG", &[outer, "x/Q.PNG"]), "x/Q.PNG");
    assert_eq!(found("t/Q.PNG", &[outer]), outer);
    assert_eq!(found("T/q.png", &[inner, outer]), inner);
    assert_eq!(found("t/q.png", &[]), "x/q.png");
}
