//! The model as the lists of a mesh.

use std::fmt::Write;
use std::path::Path;

use fixel_assets::vector::{largest, length, sub};
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
    let of_model = |problem: String| format!("model {name}: {problem}");
    let mut model = fixel_assets::read(path, files).map_err(of_model)?;
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
    let (center, scale) = fitted(&model, &mut call, notes);
    let options = Options {
        center,
        scale,
        z_up: Format::of(path) == Some(Format::Stl),
        ..Options::default()
    };
    let lists = model.lists(&options).map_err(of_model)?;
    if lists.faces.len() > FACES {
        return Err(of_model(format!(
            "it has {} triangles: the page draws at most {FACES}",
            lists.faces.len()
        )));
    }
    let mut mesh = Vec::new();
    list(&mut mesh, &lists.positions, i32::to_le_bytes);
    list(&mut mesh, &lists.faces, u16::to_le_bytes);
    list(&mut mesh, &lists.uvs, i32::to_le_bytes);
    list(&mut mesh, &lists.uv_faces, u16::to_le_bytes);
    list(&mut mesh, &lists.normals, i32::to_le_bytes);
    list(&mut mesh, &lists.normal_faces, u16::to_le_bytes);
    list(&mut mesh, &lists.colors, u8::to_le_bytes);
    list(&mut mesh, &lists.color_faces, u16::to_le_bytes);
    list(&mut mesh, &parts(&model), u32::to_le_bytes);
    mesh.push(model.had_uvs.into());
    mesh.extend(call.into_bytes());
    Ok((mesh, model))
}

/// Appends how many elements a list has, and the elements.
fn list<T: Copy, const N: usize, const SIZE: usize>(
    to: &mut Vec<u8>,
    list: &[[T; N]],
    bytes: impl Fn(T) -> [u8; SIZE],
) {
    #[allow(clippy::cast_possible_truncation)] // 65,536 at most
    to.extend((list.len() as u32).to_le_bytes());
    to.extend(list.as_flattened().iter().flat_map(|&number| bytes(number)));
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

/// Returns how the model fits the mesh's format, whose steps are 2^-16: as it is, or at the scale that makes its radius
/// about 1. If the model is then still far from the origin, it is also moved there.
fn fitted(model: &Model, call: &mut String, notes: &mut Vec<String>) -> (bool, f64) {
    let [low, high] = model.bounds();
    let center = model.middle();
    let radius = length(sub(high, center));
    let most = largest(low).max(largest(high)).max(radius);
    if radius == 0.0 || (radius >= 1.0 / 16.0 && most < 16_384.0) {
        return (false, 1.0);
    }
    let scale = 1.0 / radius;
    let is_far = largest(center) * scale > 1024.0;
    if is_far {
        notes.push("it is far from the origin: the option center moves it there".into());
        call.push_str(", center");
    }
    let _ = write!(call, ", scale = {scale:e}");
    (is_far, scale)
}
