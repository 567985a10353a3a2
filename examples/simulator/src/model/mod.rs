//! Reads models in all formats.

mod complete;
#[cfg(feature = "gltf")]
mod gltf;
mod material;
mod mtl;
mod obj;
#[cfg(feature = "ply")]
mod ply;
mod polygon;
mod reading;
mod sniff;
mod stl;
mod text;
mod winding;

use std::fs;
use std::path::{Path, PathBuf};

use fixel::num::tex_coord;

use super::Result;
pub use material::{Image, Material};
use polygon::Ears;
use reading::Reading;
pub use sniff::Format;

/// A model as read, in f64, before any rounding.
#[derive(Debug, Default)]
pub struct Model {
    pub positions: Vec<[f64; 3]>,
    pub uvs: Vec<[f64; 2]>,
    pub normals: Vec<[f64; 3]>,
    pub colors: Vec<[u8; 3]>,
    pub triangles: Vec<Triangle>,
    /// The outlines of the file's polygons, each edge once.
    pub edges: Vec<[u32; 2]>,
    /// The materials; empty if the file has none.
    pub materials: Vec<Material>,
    pub images: Vec<Image>,
    /// How many texture coordinates come from the file; the others were computed.
    pub own_uvs: usize,
    /// Whether every face has its own texture coordinates.
    pub had_uvs: bool,
    /// The files that belong to the model: materials, buffers and pictures.
    pub files: Vec<PathBuf>,
    /// Sentences for the user about parts that could not be read and are left out.
    pub notes: Vec<String>,
}

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    pub corners: [Corner; 3],
    /// Index of its material.
    pub material: Option<u32>,
}

/// Indices into a model's lists.
#[derive(Clone, Copy, Debug, Default)]
pub struct Corner {
    pub position: u32,
    pub uv: Option<u32>,
    pub normal: Option<u32>,
    pub color: Option<u32>,
}

/// Reads the model file at `path` and fills in missing normals and texture coordinates.
///
/// # Errors
///
/// The file cannot be read, is malformed, names an element that it does not have, or has nothing to draw. The message
/// is one line, which names the file, the line or the byte, the value and what was expected.
pub fn read(path: &Path, quiet: bool) -> Result<Model> {
    let name = path.display();
    let bytes = fs::read(path).map_err(|error| format!("cannot read model {name}: {error}"))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let reading = Reading::new(bytes.len(), quiet);
    let read = || -> Result<Model, String> {
        let mut model = match sniff::format(path, &bytes)? {
            Format::Obj => obj::read(&bytes, folder, &reading)?,
            Format::Stl => stl::read(&bytes, &reading)?,
            Format::Ply => read_ply(&bytes, &reading)?,
            Format::Gltf => read_gltf(&bytes, folder, quiet)?,
        };
        model.check()?;
        model.complete();
        model
            .files
            .extend(model.images.iter().filter_map(Image::file));
        Ok(model)
    };
    read().map_err(|problem| format!("model {name}: {}", text::one_line(&problem)).into())
}

#[cfg(feature = "ply")]
use ply::read as read_ply;

/// Refuses a PLY file, because the code that reads it is not compiled in.
#[cfg(not(feature = "ply"))]
fn read_ply(_: &[u8], _: &Reading) -> Result<Model, String> {
    Err(
        "it is a PLY file, and this program was built without PLY: build it with --features ply"
            .into(),
    )
}

#[cfg(feature = "gltf")]
use gltf::read as read_gltf;

/// Refuses a glTF file, because the code that reads it is not compiled in.
#[cfg(not(feature = "gltf"))]
fn read_gltf(_: &[u8], _: &Path, _: bool) -> Result<Model, String> {
    Err(
        "it is a glTF file, and this program was built without glTF: build it with --features gltf"
            .into(),
    )
}

/// The index of the next element of a list.
fn next<T>(list: &[T]) -> Result<u32, String> {
    u32::try_from(list.len())
        .map_err(|_| "it has more than 4,294,967,295 elements of a kind".into())
}

impl Model {
    /// Adds a polygon as triangles, and its outline.
    fn polygon(&mut self, ears: &mut Ears, corners: &[Corner], material: Option<u32>) {
        let triangles = ears.triangles(&self.positions, corners);
        self.triangles
            .extend(triangles.iter().map(|triangle| Triangle {
                corners: triangle.map(|at| corners[at]),
                material,
            }));
        for (at, corner) in corners.iter().enumerate() {
            self.edge(corner.position, corners[(at + 1) % corners.len()].position);
        }
    }

    /// Adds an edge.
    fn edge(&mut self, from: u32, to: u32) {
        if from != to {
            self.edges.push([from.min(to), from.max(to)]);
        }
    }

    /// Refuses a model with nothing to draw, and numbers that no scale can bring into range.
    fn check(&self) -> Result<(), String> {
        if self.triangles.is_empty() {
            return Err("it has no faces: there is nothing to draw".into());
        }
        for (at, position) in self.positions.iter().enumerate() {
            if let Some(x) = position.iter().find(|x| !is_usable(**x)) {
                return Err(format!("position {at}: {}", unusable(x)));
            }
        }
        for (at, uv) in self.uvs.iter().enumerate() {
            if let Some(x) = uv.iter().find(|&&x| tex_coord(x).is_err()) {
                return Err(format!(
                    "texture coordinate {at}: {x} cannot be represented: it must lie between -2048 and 2047.99999"
                ));
            }
        }
        Ok(())
    }

    /// Whether faces have colors of their own.
    pub fn is_colored(&self) -> bool {
        !self.colors.is_empty() || !self.materials.is_empty()
    }
}

/// Whether a number can be scaled to the library's range, and its square can be computed.
fn is_usable(x: f64) -> bool {
    x.abs() <= 1e30
}

/// Says that a number is not usable.
fn unusable(x: impl std::fmt::Display) -> String {
    format!("coordinate {x} cannot be represented: it must lie between -1e30 and 1e30")
}
