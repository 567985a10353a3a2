//! Makes the same model in OBJ, STL and PLY. (The importer has tests of each format.)

use std::fmt::Write;

/// A house without a floor. The house has eight wall triangles and four roof triangles, all different, and
/// counter-clockwise seen from outside.
const POSITIONS: [[f32; 3]; 9] = [
    [-1.0, 0.0, 1.5],
    [1.0, 0.0, 1.5],
    [1.0, 0.0, -1.5],
    [-1.0, 0.0, -1.5],
    [-1.0, 1.0, 1.5],
    [1.0, 1.0, 1.5],
    [1.0, 1.0, -1.5],
    [-1.0, 1.0, -1.5],
    [0.25, 2.0, 0.0],
];
const FACES: [[u16; 3]; 12] = [
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 0, 4],
    [3, 4, 7],
    [4, 5, 8],
    [5, 6, 8],
    [6, 7, 8],
    [7, 4, 8],
];

/// A color for each position.
pub fn color(at: usize) -> [u8; 3] {
    let at = u8::try_from(at).unwrap();
    [at * 28, 255 - at * 20, at % 3 * 100]
}

pub fn obj(colored: bool) -> String {
    let mut text = String::new();
    for (at, [x, y, z]) in POSITIONS.into_iter().enumerate() {
        write!(text, "v {x} {y} {z}").unwrap();
        for component in color(at).into_iter().filter(|_| colored) {
            write!(text, " {}", f64::from(component) / 255.0).unwrap();
        }
        text.push('\n');
    }
    for face in FACES {
        let [a, b, c] = face.map(|index| index + 1);
        writeln!(text, "f {a} {b} {c}").unwrap();
    }
    text
}

pub fn stl_text() -> String {
    let mut text = String::from("solid\n");
    for face in FACES {
        text += "  FACET normal 0 0 0\n    outer loop\n";
        for [x, y, z] in face.map(|index| POSITIONS[usize::from(index)]) {
            writeln!(text, "      vertex {x:e} {y} {z}").unwrap();
        }
        text += "    endloop\n  endfacet\n";
    }
    text + "endsolid\n"
}

pub fn ply_text(colored: bool) -> String {
    let colors = if colored {
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    } else {
        ""
    };
    let mut text = format!(
        "ply\nformat ascii 1.0\ncomment a house\nelement vertex 9\nproperty float x\nproperty float y\n\
         property float z\n{colors}element face 12\nproperty list uchar int vertex_indices\nend_header\n"
    );
    for (at, [x, y, z]) in POSITIONS.into_iter().enumerate() {
        write!(text, "{x} {y} {z}").unwrap();
        for component in color(at).into_iter().filter(|_| colored) {
            write!(text, " {component}").unwrap();
        }
        text.push('\n');
    }
    for [a, b, c] in FACES {
        writeln!(text, "3 {a} {b} {c}").unwrap();
    }
    text
}
