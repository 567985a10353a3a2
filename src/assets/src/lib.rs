//! Reads models and pictures in any common format, for the crate `fixel`.
//!
//! [`read`] reads OBJ with its MTL materials, STL, PLY, and glTF, text or binary; [`Picture::decode`] reads PNG, JPEG,
//! BMP, TGA, GIF and WebP. Both functions accept files with small mistakes. For a model, [`Model::notes`] says what was
//! replaced or left out. If nothing is left to draw, [`read`] returns an error that says why. The crate runs on the
//! host, where `fixel`'s macros use it to put models and pictures into flash.
//!
//! ```
//! use std::io;
//! use std::path::{Path, PathBuf};
//!
//! use fixel_assets::{Files, Options};
//!
//! /// A file in memory. (`Disk` reads the files on the disk.)
//! struct Memory(&'static str);
//!
//! impl Files for Memory {
//!     fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
//!         Ok(self.0.into())
//!     }
//!     fn find(&self, path: &Path) -> Option<PathBuf> {
//!         Some(path.into())
//!     }
//! }
//!
//! let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2\n";
//! let model = fixel_assets::read(Path::new("square.obj"), &Memory(text))?;
//! assert_eq!((model.positions.len(), model.triangles.len()), (4, 2));
//! assert!(model.notes.iter().eq(["a face of fewer than 3 corners is left out"]));
//! // The third corner of the square, in the fixed-point format of a mesh.
//! assert_eq!(model.lists(&Options::default())?.positions[2], [1 << 16, 1 << 16, 0]);
//! # Ok::<(), String>(())
//! ```

mod complete;
mod files;
mod gltf;
mod lists;
mod material;
mod mtl;
mod notes;
mod obj;
mod order;
mod outline;
pub mod picture;
mod ply;
mod polygon;
mod sight;
mod sniff;
mod stl;
mod text;
pub mod vector;
mod winding;

use std::cell::Cell;
use std::collections::{HashMap, HashSet};
use std::hash::Hash;
use std::path::{Path, PathBuf};

pub use files::{Disk, Files};
use files::{Folder, SEARCHES};
pub use lists::{Lists, Options, Run};
pub use material::{Alpha, INVISIBLE, Image, Material, times};
pub use notes::Notes;
pub use outline::outline;
pub use picture::Picture;
use polygon::Ears;
pub use sniff::Format;

/// Any file may have this many triangles and this many vertices; a file of more than a megabyte, one for 4 of its bytes.
/// Vertices that are not repeated take more. Without a limit, a short file could claim all memory.
const MOST: usize = 1 << 18;

/// A model as the file describes it, in f64, before any rounding.
#[derive(Debug, Default)]
pub struct Model {
    /// Positions of all vertices, in the file's units and axes.
    pub positions: Vec<[f64; 3]>,
    /// Texture coordinates, from the top left corner: u runs to the right, v runs down, and 1 is one repeat.
    pub uvs: Vec<[f64; 2]>,
    /// Normals, of any length except 0.
    pub normals: Vec<[f64; 3]>,
    /// Colors: red, green and blue.
    pub colors: Vec<[u8; 3]>,
    /// The triangles of all polygons, in the file's order.
    pub triangles: Vec<Triangle>,
    /// The edges of the file's polygons, each once: the indices of the positions of its ends.
    pub edges: Vec<[u32; 2]>,
    /// Whether the file has lines. They are among the edges.
    pub has_lines: bool,
    /// The names of the file's objects: its meshes or groups.
    pub objects: Vec<String>,
    /// The materials; empty if the file has none.
    pub materials: Vec<Material>,
    /// The pictures for textures; [`Material::texture`] is an index into this list.
    pub images: Vec<Image>,
    /// Whether every face had texture coordinates before [`complete`](Self::complete) added the missing ones.
    pub had_uvs: bool,
    /// The files that belong to the model: materials, buffers and pictures.
    pub files: Vec<PathBuf>,
    /// What was replaced or left out.
    pub notes: Notes,
    /// A sentence about faces so far away that the others cannot be seen beside them, if there are any.
    pub far: Option<String>,
    ears: Ears,
    object: Option<u32>,
    places: HashMap<String, u32>,
    /// The size of the files that the model is read from, in bytes.
    bytes: usize,
    /// The pictures that were read, the number of their pixels, and how many pixels may be read.
    decoded: HashSet<u32>,
    pixels: [usize; 2],
}

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// The corners, counter-clockwise as seen from the front.
    pub corners: [Corner; 3],
    /// The index of the material; `None` if the triangle has no material.
    pub material: Option<u32>,
    /// The index of the object; `None` if the triangle belongs to no object.
    pub object: Option<u32>,
    /// Which faces are shaded as one surface with this triangle, where the file has no normals.
    pub smoothing: Smoothing,
}

/// Which of the faces around a point are shaded as one surface, where the file has no normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Smoothing {
    /// Faces with normals at most 60 degrees apart.
    #[default]
    Angle,
    /// No other faces: each face is flat.
    Flat,
    /// Faces of the same group.
    Group(u32),
}

/// A corner of a triangle, as indices into the model's lists.
#[derive(Clone, Copy, Debug, Default)]
pub struct Corner {
    /// Index of the corner's position.
    pub position: u32,
    /// Index of the corner's texture coordinate.
    pub uv: Option<u32>,
    /// Index of the corner's normal.
    pub normal: Option<u32>,
    /// Index of the corner's color.
    pub color: Option<u32>,
}

/// Reads the model at `path`.
///
/// # Errors
///
/// The file cannot be read, is not a model, ends too early, or has nothing to draw. The message is one line. It does
/// not name the model's file, but the line or the byte, the value, and what was expected.
pub fn read(path: &Path, files: &dyn Files) -> Result<Model, String> {
    let read = || -> Result<Model, String> {
        let bytes = files.read(path);
        let bytes = bytes.map_err(|error| format!("it cannot be read: {error}"))?;
        let searches = Cell::new(SEARCHES);
        let folder = Folder {
            searches: &searches,
            files,
            path: path.parent().unwrap_or(Path::new("")),
            own: None,
            all: bytes.len(),
        };
        let mut model = match sniff::format(path, &bytes)? {
            Format::Obj => obj::read(&bytes, folder)?,
            Format::Stl => stl::read(&bytes, folder)?,
            Format::Ply => ply::read(&bytes, folder)?,
            Format::Gltf => gltf::read(&bytes, folder)?,
        };
        if model.triangles.is_empty() {
            let notes: Vec<String> = model.notes.iter().collect();
            let why = match (model.notes.is_quiet(), model.positions.as_slice()) {
                (false, _) => "there is nothing to draw",
                (_, []) => "it has no faces: there is nothing to draw",
                _ => "it has points or lines, but no faces: only faces are drawn",
            };
            return Err([&[why.into()], &notes[..]].concat().join("; "));
        }
        model.show();
        model.far = model.check_sight()?;
        model.edges.sort_unstable();
        model.edges.dedup();
        model
            .files
            .extend(model.images.iter().filter_map(Image::file));
        Ok(model)
    };
    read().map_err(|problem| text::one_line(&problem))
}

/// The index of the next element of a list.
fn next<T>(list: &[T]) -> Result<u32, String> {
    u32::try_from(list.len())
        .map_err(|_| "it has more than 4,294,967,295 elements of a kind".into())
}

/// The index of a value in a list. If `places` lacks the key, the value is added to the list.
fn merge<K: Eq + Hash, T>(
    list: &mut Vec<T>,
    places: &mut HashMap<K, u32>,
    key: K,
    value: T,
) -> Result<u32, String> {
    let new = next(list)?;
    let place = *places.entry(key).or_insert(new);
    if place == new {
        list.push(value);
    }
    Ok(place)
}

impl Model {
    /// Makes the next polygons belong to the object of this name.
    fn begin_object(&mut self, name: &str) {
        self.object = merge(
            &mut self.objects,
            &mut self.places,
            name.into(),
            name.into(),
        )
        .ok();
    }

    /// Fails if there are too many elements of a kind for the size of the file.
    fn check(&self, count: usize, kind: &str) -> Result<(), String> {
        let most = MOST.max(self.bytes / 4);
        if count <= most {
            return Ok(());
        }
        Err(format!("it has over {most} {kind}: too many for its size"))
    }

    /// Adds an edge.
    fn edge(&mut self, from: u32, to: u32) {
        if from != to {
            self.edges.push([from.min(to), from.max(to)]);
        }
    }

    /// Whether the model has vertex colors, or a material that differs from [`Material::new`].
    #[must_use]
    pub fn is_colored(&self) -> bool {
        let is_plain = |it: &Material| *it == Material::new(it.name.clone());
        !self.colors.is_empty() || !self.materials.iter().all(is_plain)
    }
}
