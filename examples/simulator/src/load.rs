//! Reads OBJ models and adds what they lack.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use fixel::mesh::{Buffers, obj};
use fixel::num::{scalar, tex_coord};
use fixel::{Vec2, Vec3};

use super::Result;

/// Largest number of elements of a kind that the library's reader accepts; larger models are cut into parts here.
const MOST: usize = 65_535;

/// A model as read, in f64, before any rounding.
#[derive(Debug, Default)]
pub struct Model {
    pub positions: Vec<[f64; 3]>,
    pub uvs: Vec<[f64; 2]>,
    pub normals: Vec<[f64; 3]>,
    pub triangles: Vec<[Corner; 3]>,
    /// The outlines of the file's polygons, each edge once.
    pub edges: Vec<[usize; 2]>,
    /// Whether the file itself had texture coordinates on every face.
    pub had_uvs: bool,
}

/// Indices into a model's lists.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    pub position: usize,
    pub uv: Option<usize>,
    pub normal: Option<usize>,
}

/// Reads the OBJ file at `path` and fills in missing normals and texture coordinates.
///
/// # Errors
///
/// The file cannot be read, a line is malformed, an index or a number is out of range, or there is nothing to draw.
/// The message names the file and, if possible, the line.
pub fn model(path: &Path) -> Result<Model> {
    let name = path.display();
    let bytes = fs::read(path).map_err(|error| format!("cannot read model {name}: {error}"))?;
    // Comments in old encodings do no harm. A number in one of them is malformed, and is found below.
    let text = String::from_utf8_lossy(&bytes);
    parse(&text).map_err(|problem| format!("model {name}: {problem}").into())
}

/// Reads OBJ text. See [`model`].
pub fn parse(text: &str) -> Result<Model, String> {
    let statements = statements(text);
    for (line, statement) in &statements {
        check(statement).map_err(|problem| format!("line {line}: {problem}"))?;
    }
    let options = tobj::LoadOptions::default();
    let few = |kind| {
        statements
            .iter()
            .filter(|(_, s)| s.split(' ').next() == Some(kind))
            .count()
            < MOST
    };
    let fits = |statement: &str| {
        let mut words = statement.split_whitespace();
        words.next() != Some("v")
            || words
                .take(3)
                .all(|word| word.parse().is_ok_and(|x: f64| scalar(x).is_ok()))
    };
    if few("v") && few("vt") && few("vn") && statements.iter().all(|(_, s)| fits(s)) {
        check_all(text)?;
    }
    let (objects, _) = tobj::load_obj_buf(&mut sorted(&statements).as_bytes(), &options, |_| {
        Ok((Vec::new(), HashMap::new()))
    })
    .map_err(|error| error.to_string())?;
    let mut model = Model {
        had_uvs: true,
        ..Model::default()
    };
    for object in &objects {
        append(&mut model, &object.mesh, &object.name);
    }
    if model.triangles.is_empty() {
        return Err("it has no faces: there is nothing to draw".into());
    }
    model.outline(&objects);
    model.make_normals();
    model.make_uvs();
    Ok(model)
}

/// The statements of OBJ text without comments, joined where a backslash ends the line, each with
/// the number of its first line.
fn statements(text: &str) -> Vec<(usize, String)> {
    let text = text.trim_start_matches('\u{feff}');
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let mut statements: Vec<(usize, String)> = Vec::new();
    let mut joined = false;
    for (at, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or("").trim_end();
        let (line, goes_on) = match line.strip_suffix('\\') {
            Some(line) => (line, true),
            None => (line, false),
        };
        match statements.last_mut() {
            Some((_, statement)) if joined => {
                statement.push(' ');
                statement.push_str(line);
            }
            _ => statements.push((at + 1, line.into())),
        }
        joined = goes_on;
    }
    statements
}

/// Refuses what tobj accepts: numbers that the library's format cannot hold, and faces without area.
fn check(statement: &str) -> Result<(), String> {
    let mut words = statement.split_whitespace();
    let numbers = match words.next() {
        Some("v" | "vn") => 3,
        Some("vt") => 2,
        Some("f") if words.count() < 3 => {
            return Err("a face needs at least 3 corners".into());
        }
        _ => return Ok(()),
    };
    for (at, word) in words.take(numbers).enumerate() {
        let value: f64 = word
            .parse()
            .map_err(|_| format!("'{word}' is not a number"))?;
        // Print the number as it was written: an error's own number is rounded, and 1 - v is stored, not v.
        let (fits, range) = match (numbers, at) {
            (2, 0) => (tex_coord(value).is_ok(), "-2048 and 2047.99999"),
            (2, _) => (
                tex_coord(value).is_ok() && tex_coord(1.0 - value).is_ok(),
                "-2046.99999 and 2047.99999",
            ),
            // Of any size: positions are scaled, and of a normal only the direction counts.
            _ => (value.abs() < 1e100, "-1e100 and 1e100"),
        };
        if !fits {
            return Err(format!(
                "coordinate {word} cannot be represented: it must lie between {range}"
            ));
        }
    }
    Ok(())
}

/// Lets the library's own reader check the text. It knows the line of an error, which tobj does not report, and finds
/// indices out of range that tobj does not notice.
fn check_all(text: &str) -> Result<(), String> {
    let read = || -> Result<(), fixel::Error> {
        let counts = obj::count(text.as_bytes())?;
        let mut positions = vec![Vec3::ZERO; counts.positions];
        let mut faces = vec![[0; 3]; counts.faces];
        let mut uvs = vec![Vec2::default(); counts.uvs];
        let mut uv_faces = vec![[0; 3]; counts.uv_faces];
        let mut normals = vec![Vec3::ZERO; counts.normals];
        let mut normal_faces = vec![[0; 3]; counts.normal_faces];
        let mut buffers = Buffers::new(&mut positions, &mut faces);
        buffers.uvs = &mut uvs;
        buffers.uv_faces = &mut uv_faces;
        buffers.normals = &mut normals;
        buffers.normal_faces = &mut normal_faces;
        obj::parse(text.as_bytes(), buffers).map(|_| ())
    };
    read().map_err(|error| error.to_string())
}

/// Returns the text for tobj: only the parts that are drawn, with faces of different forms in objects of their own.
///
/// tobj gives a face without texture coordinates those of the face before it, if other faces of its object have some.
/// So an object's name says what its faces have. Materials and groups do not matter.
fn sorted(statements: &[(usize, String)]) -> String {
    let mut out = String::new();
    let mut form = "";
    for (_, statement) in statements {
        let mut words = statement.split_whitespace();
        let Some(kind @ ("v" | "vt" | "vn" | "f")) = words.next() else {
            continue;
        };
        let mut words: Vec<&str> = words.collect();
        match kind {
            // tobj would divide by a fourth number, and colors are not drawn.
            "v" => words.truncate(3),
            "vt" if words.len() == 1 => words.push("0"),
            "f" => {
                let mut parts = words[0].split('/').skip(1).map(|part| !part.is_empty());
                let this = match (parts.next() == Some(true), parts.next() == Some(true)) {
                    (false, false) => "o plain\n",
                    (true, false) => "o uv\n",
                    (false, true) => "o normal\n",
                    (true, true) => "o uv normal\n",
                };
                if this != form {
                    form = this;
                    out.push_str(form);
                }
            }
            _ => {}
        }
        out.push_str(kind);
        for word in words {
            out.push(' ');
            out.push_str(word);
        }
        out.push('\n');
    }
    out
}

/// Returns the polygons of a tobj mesh, as ranges of its index lists.
fn polygons(mesh: &tobj::Mesh) -> Vec<std::ops::Range<usize>> {
    let triangles = vec![3; mesh.indices.len() / 3];
    let sizes = if mesh.face_arities.is_empty() {
        &triangles
    } else {
        &mesh.face_arities
    };
    let mut start = 0;
    sizes
        .iter()
        .map(|&size| {
            let range = start..start + size as usize;
            start = range.end;
            range
        })
        .collect()
}

/// Adds the polygons of one object as fans of triangles.
fn append(model: &mut Model, mesh: &tobj::Mesh, name: &str) {
    let (first, first_uv, first_normal) =
        (model.positions.len(), model.uvs.len(), model.normals.len());
    let triple = |v: &[f32]| [f64::from(v[0]), f64::from(v[1]), f64::from(v[2])];
    model
        .positions
        .extend(mesh.positions.chunks_exact(3).map(triple));
    let has_uv = name.contains("uv") && mesh.texcoord_indices.len() == mesh.indices.len();
    let has_normal = name.contains("normal") && mesh.normal_indices.len() == mesh.indices.len();
    if has_uv {
        // In OBJ files v runs up. Here it runs down, in the order of an image's rows.
        let flip = |v: &[f32]| [f64::from(v[0]), 1.0 - f64::from(v[1])];
        model.uvs.extend(mesh.texcoords.chunks_exact(2).map(flip));
    } else {
        model.had_uvs = false;
    }
    if has_normal {
        model
            .normals
            .extend(mesh.normals.chunks_exact(3).map(triple));
    }
    let corner = |at: usize| Corner {
        position: first + mesh.indices[at] as usize,
        uv: has_uv.then(|| first_uv + mesh.texcoord_indices[at] as usize),
        normal: has_normal.then(|| first_normal + mesh.normal_indices[at] as usize),
    };
    for polygon in polygons(mesh) {
        for second in polygon.start + 1..polygon.end.max(2) - 1 {
            model
                .triangles
                .push([polygon.start, second, second + 1].map(corner));
        }
    }
}

impl Model {
    /// Collects each polygon's outline, so that a wireframe shows quads as quads.
    fn outline(&mut self, objects: &[tobj::Model]) {
        let mut seen = std::collections::HashSet::new();
        let mut first = 0;
        for object in objects {
            for polygon in polygons(&object.mesh) {
                let indices = &object.mesh.indices[polygon];
                for (at, &from) in indices.iter().enumerate() {
                    let to = indices[(at + 1) % indices.len()];
                    let (from, to) = (first + from as usize, first + to as usize);
                    if from != to && seen.insert((from.min(to), from.max(to))) {
                        self.edges.push([from, to]);
                    }
                }
            }
            first += object.mesh.positions.len() / 3;
        }
    }
}
