//! PLY files as real programs write them are read, and notes say what was replaced or left out.

#![allow(clippy::float_cmp)] // the files state these values exactly

mod common;

use common::{notes, read};
use fixel_assets::{Image, Model};

const VERTICES: &str = "property float x\nproperty float y\nproperty float z\n";
const FACES: &str = "property list uchar int vertex_indices\n";
const SQUARE: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// The text of a file. `vertex` and `face` are more properties of vertices and faces. `vertices` and `faces` are the
/// lines of values.
fn text(vertex: &str, vertices: &str, face: &str, faces: &str) -> String {
    let counts = [vertices.lines().count(), faces.lines().count()];
    format!(
        "ply\nformat ascii 1.0\nelement vertex {}\n{VERTICES}{vertex}element face {}\n{FACES}{face}end_header\n{vertices}{faces}",
        counts[0], counts[1]
    )
}

fn ply(bytes: impl AsRef<[u8]>) -> Model {
    read(&[("a.ply", bytes)]).expect("a model")
}

fn refused(bytes: impl AsRef<[u8]>) -> String {
    read(&[("a.ply", bytes)]).expect_err("no model")
}

/// The positions of all triangles.
fn triangles(model: &Model) -> Vec<[[f64; 3]; 3]> {
    let corners = model.triangles.iter().map(|triangle| triangle.corners);
    corners
        .map(|corners| corners.map(|corner| model.positions[corner.position as usize]))
        .collect()
}

#[test]
fn numbers_of_every_type_and_order() {
    let expected = triangles(&ply(text("", SQUARE, "", "4 0 1 2 3\n")));
    assert_eq!(expected.len(), 2);
    for (names, size, float, signed) in [
        (["char", "int8"], 1, false, true),
        (["uchar", "uint8"], 1, false, false),
        (["short", "int16"], 2, false, true),
        (["ushort", "uint16"], 2, false, false),
        (["int", "int32"], 4, false, true),
        (["uint", "uint32"], 4, false, false),
        (["float", "float32"], 4, true, true),
        (["double", "float64"], 8, true, true),
    ] {
        for (name, little) in names.into_iter().zip([true, false]) {
            let number = |x: f64| {
                let mut bytes = match (float, size) {
                    (true, 4) => (x as f32).to_le_bytes().to_vec(),
                    (true, _) => x.to_le_bytes().to_vec(),
                    _ => (x as i64).to_le_bytes()[..size].to_vec(),
                };
                if !little {
                    bytes.reverse();
                }
                bytes
            };
            let format = if little { "little" } else { "big" };
            let mut file = format!(
                "ply\r\nformat binary_{format}_endian 1.0\r\nelement vertex 4\r\nproperty {name} x\r\nproperty {name} y\r\n\
                 property {name} z\r\nelement face 1\r\nproperty list {name} {name} vertex_index\r\nend_header\r\n"
            )
            .into_bytes();
            let x = if signed { -1.0 } else { 0.0 };
            for p in [
                [x, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [1.0, 1.0, 0.0],
                [x, 1.0, 0.0],
            ] {
                file.extend(p.iter().flat_map(|&x| number(x)));
            }
            file.extend([4.0, 0.0, 1.0, 2.0, 3.0].iter().flat_map(|&x| number(x)));
            let model = ply(file);
            assert_eq!(model.positions[0], [x, 0.0, 0.0], "{name}");
            assert_eq!(model.triangles.len(), 2, "{name}");
            assert!(notes(&model).is_empty(), "{name}: {:?}", notes(&model));
        }
    }
}

#[test]
fn attributes_of_vertices() {
    let vertex = "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n\
                  property uchar blue\nproperty float s\nproperty float t\n";
    let vertices =
        "0 0 0 0 0 1 255 0 10 0 0\n1 0 0 0 0 1 0 255 20 1 0\n1 1 0 0 0 1 0 0 255 1 0.75\n";
    let model = ply(text(vertex, vertices, "", "3 0 1 2\n"));
    let corner = model.triangles[0].corners[2];
    assert_eq!(
        model.normals[corner.normal.unwrap() as usize],
        [0.0, 0.0, 1.0]
    );
    assert_eq!(model.colors[corner.color.unwrap() as usize], [0, 0, 255]);
    // In the file, v points up.
    assert_eq!(model.uvs[corner.uv.unwrap() as usize], [1.0, 0.25]);
    // Colors can be fractions. The properties of colors can have other names.
    let vertex =
        "property float diffuse_red\nproperty float diffuse_green\nproperty float diffuse_blue\n";
    let model = ply(text(
        vertex,
        "0 0 0 1 0.5 0\n1 0 0 1 1 1\n1 1 0 0 0 0\n",
        "",
        "3 0 1 2\n",
    ));
    assert_eq!(model.colors[0], [255, 128, 0]);
}

#[test]
fn attributes_of_faces() {
    let face = "property list uchar float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
    let faces = "3 0 1 2 6 0 0 1 0 1 1 255 0 0\n3 0 2 3 6 0 0 1 1 0 1 0 0 255\n3 0 1 2 0 255 0 0\n";
    let model = ply(text("", SQUARE, face, faces));
    let corners: Vec<_> = model
        .triangles
        .iter()
        .map(|triangle| triangle.corners[1])
        .collect();
    let colors: Vec<_> = corners
        .iter()
        .map(|corner| model.colors[corner.color.unwrap() as usize])
        .collect();
    assert_eq!(colors, [[255, 0, 0], [0, 0, 255], [255, 0, 0]]);
    assert_eq!(model.colors.len(), 2);
    assert_eq!(model.uvs[corners[1].uv.unwrap() as usize], [1.0, 0.0]);
    assert_eq!(corners[2].uv, None);
}

#[test]
fn a_comment_names_the_texture() {
    let plain = text("", SQUARE, "", "3 0 1 2\n");
    let model = ply(plain.replace(
        "element face",
        "comment TextureFile wood chip.png\nelement face",
    ));
    assert_eq!(model.images, [Image::File("wood chip.png".into())]);
    assert_eq!(model.triangles[0].material, Some(0));
    assert_eq!(model.materials[0].texture, Some(0));
}

#[test]
fn strips_alternate_and_restart() {
    let strips =
        text("", SQUARE, "", "8 0 1 3 2 -1 0 1 2\n").replace("element face", "element tristrips");
    let model = ply(strips);
    let corners = model
        .triangles
        .iter()
        .map(|triangle| triangle.corners.map(|corner| corner.position));
    assert!(corners.eq([[0, 1, 3], [3, 1, 2], [0, 1, 2]]));
}

#[test]
fn faces_may_come_first() {
    let file = format!(
        "ply\nformat ascii 1.0\nelement face 1\n{FACES}element vertex 3\n{VERTICES}property float u\nproperty float v\nend_header\n\
         3 0 1 2\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n"
    );
    let model = ply(file);
    assert_eq!(
        triangles(&model),
        [[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]]
    );
    assert_eq!(model.triangles[0].corners[1].uv, Some(1));
}

#[test]
fn what_cannot_be_used_is_noted() {
    let faces = "3 0 1 2\n2 0 1\n3 0 1 9\n3 0 1 -2\n";
    let odd = text("", SQUARE, "", faces).replace("element face", "made by hand\nelement face");
    let model = ply(format!("\u{feff}{odd}"));
    assert_eq!(model.triangles.len(), 1);
    assert_eq!(
        notes(&model),
        [
            "a line of the header that is not of PLY is left out",
            "a face of fewer than 3 corners is left out",
            "a face is left out: it names a vertex that does not exist (2 times)",
        ]
    );
    // If the file ends too early, the faces before its end are drawn.
    let short = text("", SQUARE, "", "3 0 1 2\n3 0 2 3\n").replace("face 2", "face 5");
    let model = ply(short);
    assert_eq!(model.triangles.len(), 2);
    assert_eq!(
        notes(&model),
        ["the rest of the file is left out: line 15: the file ends here"]
    );
}

#[test]
fn refusals_say_what_the_file_is() {
    let cloud = format!("ply\nformat ascii 1.0\nelement vertex 1\n{VERTICES}end_header\n0 0 0\n");
    let edges = cloud.replace(
        "end_header\n0 0 0",
        "element edge 1\nproperty int vertex1\nend_header\n0 0 0\n0",
    );
    for (file, expected) in [
        (cloud.clone(), "it has points or lines"),
        (edges, "it has points or lines"),
        (
            cloud.replace("ascii", "utf8"),
            "line 2: there is no format 'utf8'",
        ),
        (
            cloud.replace("float y", "number y"),
            "line 5: 'number' is not a type",
        ),
        (
            cloud.replace("float y\n", "float w\n"),
            "its vertices have no properties x, y and z",
        ),
        (
            cloud.replace("end_header", ""),
            "its header has no line 'end_header'",
        ),
        (
            text("", "0 0 0\n1 O 0\n", "", "3 0 1 2\n"),
            "line 11: 'y': 'O' is not a number",
        ),
        (
            text("", SQUARE, "", "3 0 1\n"),
            "line 14: 'vertex_indices': a number is missing",
        ),
        (
            text("", SQUARE, "", "3 0 1 2\n").replace("_indices", "es"),
            "its faces have no property vertex_indices",
        ),
    ] {
        let said = refused(&file);
        assert!(said.contains(expected), "no '{expected}' in: {said}");
    }
}

/// A list that claims more elements than the file has bytes must not fill the memory.
#[test]
fn a_short_file_does_not_fill_the_memory() {
    let head = text("", SQUARE, "", "").replace("ascii", "binary_little_endian");
    let mut binary = head
        .replace("face 0", "face 1")
        .replace("uchar int", "uint int")
        .into_bytes();
    binary.extend([0xff; 12]);
    refused(&binary);
}
