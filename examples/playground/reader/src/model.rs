//! The model as the lists of a mesh.

use std::fmt::Write;
use std::path::Path;

use fixel_assets::vector::{along, largest, length, sub};
use fixel_assets::{Files, Format, Material, Model, Options, Run};

use crate::quoted;

/// The most triangles that the page draws.
const FACES: usize = 65_536;

/// Reads a model, and returns what the page's module needs of it, and the model.
///
/// # Errors
///
/// Those of the importer, or the model is too large for the page.
pub fn read(
    name: &str,
    files: &dyn Files,
    notes: &mut Vec<String>,
) -> Result<(Vec<u8>, Model), String> {
    let path = Path::new(name);
    let mut model = fixel_assets::read(path, files)?;
    notes.extend(model.notes.iter());
    let has_normals = model.triangles.iter().all(|triangle| {
        triangle
            .corners
            .iter()
            .all(|corner| corner.normal.is_some())
    });
    model.complete();
    let mut call = quoted(name);
    if !has_normals {
        call.push_str(", normals");
    }
    let options = Options {
        scale: fitted(&mut model, &mut call, notes),
        z_up: Format::of(path) == Some(Format::Stl),
        ..Options::default()
    };
    let too_large = |problem: String| format!("model {name}: {problem}");
    let lists = model.lists(&options).map_err(too_large)?;
    if lists.faces.len() > FACES {
        return Err(too_large(format!(
            "it has {} triangles: the page draws at most {FACES}",
            lists.faces.len()
        )));
    }
    let (faces, uv_faces, normal_faces) = (&lists.faces, &lists.uv_faces, &lists.normal_faces);
    let (positions, uvs, normals) = (&lists.positions, &lists.uvs, &lists.normals);
    let parts = parts(&model);
    let counts = [
        positions.len(),
        faces.len(),
        uvs.len(),
        uv_faces.len(),
        normals.len(),
        normal_faces.len(),
        parts.len(),
    ];
    let mut mesh = Vec::new();
    #[allow(clippy::cast_possible_truncation)] // 65,536 at most
    mesh.extend(
        counts
            .iter()
            .flat_map(|&count| (count as u32).to_le_bytes()),
    );
    let words = |faces: &[[u16; 3]]| {
        faces
            .iter()
            .flatten()
            .flat_map(|word| word.to_le_bytes())
            .collect::<Vec<_>>()
    };
    mesh.extend(
        positions
            .iter()
            .flatten()
            .flat_map(|bits| bits.to_le_bytes()),
    );
    mesh.extend(words(faces));
    mesh.extend(uvs.iter().flatten().flat_map(|bits| bits.to_le_bytes()));
    mesh.extend(words(uv_faces));
    mesh.extend(normals.iter().flatten().flat_map(|bits| bits.to_le_bytes()));
    mesh.extend(words(normal_faces));
    mesh.extend(
        parts
            .as_flattened()
            .iter()
            .flat_map(|word| word.to_le_bytes()),
    );
    mesh.extend(call.into_bytes());
    Ok((mesh, model))
}

/// The runs of faces with one material: the first face, the one after the last, and the material's color. None if no
/// material has a color.
fn parts(model: &Model) -> Vec<[u32; 3]> {
    if !model.materials.iter().any(is_colored) {
        return Vec::new();
    }
    let part = |run: Run| {
        let material = run.material.and_then(|at| model.materials.get(at as usize));
        let [red, green, blue] = material.map_or([255; 3], |material| material.color);
        #[allow(clippy::cast_possible_truncation)] // 65,536 at most
        let [start, end] = run.faces.map(|face| face as u32);
        [start, end, u32::from_be_bytes([0, red, green, blue])]
    };
    model.runs().into_iter().map(part).collect()
}

fn is_colored(material: &Material) -> bool {
    material.color != [255; 3]
}

/// Returns the scale at which the model fits the mesh's format, whose steps are 2^-16: 1 if it fits as it is, otherwise
/// the one that makes its radius about 1. If the model is then still far from the origin, moves it there.
fn fitted(model: &mut Model, call: &mut String, notes: &mut Vec<String>) -> f64 {
    // The positions that faces use.
    let corners = model.triangles.iter().flat_map(|triangle| triangle.corners);
    let used = corners.map(|corner| model.positions[corner.position as usize]);
    let bound = |axis: usize, pick: fn(f64, f64) -> f64| {
        let all = used.clone().map(|at| at[axis]);
        all.reduce(pick).unwrap_or(0.0)
    };
    let low = [0, 1, 2].map(|axis| bound(axis, f64::min));
    let high = [0, 1, 2].map(|axis| bound(axis, f64::max));
    let center = along(low, sub(high, low), 0.5);
    let radius = length(sub(high, center));
    let most = largest(low).max(largest(high)).max(radius);
    if radius == 0.0 || (radius >= 1.0 / 16.0 && most < 16_384.0) {
        return 1.0;
    }
    let scale = 1.0 / radius;
    let _ = write!(call, ", scale = {scale:e}");
    if largest(center) * scale > 1024.0 {
        let [x, y, z] = center;
        notes.push(format!(
            "it is far from the origin: the page moved it there, by ({}, {}, {})",
            -x, -y, -z
        ));
        let _ = write!(call, " /* of a model without its place: ({x}, {y}, {z}) */");
        for position in &mut model.positions {
            *position = sub(*position, center);
        }
    }
    scale
}
