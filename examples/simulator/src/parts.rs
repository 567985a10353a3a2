//! A model rounded to the library's formats, in meshes of at most 65,535 points each.

use std::collections::HashMap;

use fixel::{Mesh, Vec2, Vec3};

use super::Result;
use super::load::Model;

/// Indices have 16 bits, and the last one stands for no value.
const MOST: usize = 65_535;

/// The lists that one [`Mesh`] borrows.
#[derive(Debug, Default)]
pub struct Part {
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    uv_faces: Vec<[u16; 3]>,
    normal_faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
}

impl Part {
    /// Returns the mesh over this part's lists.
    ///
    /// # Errors
    ///
    /// None for the parts that [`split`] makes; the library checks them all the same.
    pub fn mesh(&self) -> Result<Mesh<'_>> {
        let mut mesh = Mesh::new(&self.positions, &self.faces)?.with_edges(&self.edges)?;
        if !self.faces.is_empty() {
            mesh = mesh
                .with_uvs(&self.uvs, Some(&self.uv_faces))?
                .with_normals(&self.normals, Some(&self.normal_faces))?;
        }
        Ok(mesh)
    }
}

/// A list being filled, and the indices in it of the model's entries.
struct List<T> {
    values: Vec<T>,
    places: HashMap<usize, u16>,
}

impl<T> List<T> {
    fn new() -> Self {
        Self {
            values: Vec::new(),
            places: HashMap::new(),
        }
    }

    fn has_room(&self, more: usize) -> bool {
        self.values.len() + more <= MOST
    }

    fn place(&mut self, index: usize, value: impl FnOnce() -> Result<T>) -> Result<u16> {
        if let Some(&place) = self.places.get(&index) {
            return Ok(place);
        }
        let place = u16::try_from(self.values.len())?;
        self.values.push(value()?);
        self.places.insert(index, place);
        Ok(place)
    }
}

/// Cuts `model` into parts that a mesh can hold.
///
/// # Errors
///
/// The format cannot hold one of the numbers.
pub fn split(model: &Model) -> Result<Vec<Part>> {
    let position = |index: usize| -> Result<Vec3> { Ok(Vec3::try_from(model.positions[index])?) };
    let mut parts = Vec::new();
    let mut triangles = model.triangles.iter().peekable();
    while triangles.peek().is_some() {
        let (mut positions, mut uvs, mut normals) = (List::new(), List::new(), List::new());
        let mut part = Part::default();
        while positions.has_room(3) && uvs.has_room(3) && normals.has_room(3) {
            let Some(corners) = triangles.next() else {
                break;
            };
            let [mut face, mut uv_face, mut normal_face] = [[0; 3]; 3];
            for (at, corner) in corners.iter().enumerate() {
                face[at] = positions.place(corner.position, || position(corner.position))?;
                let (uv, normal) = (corner.uv.unwrap_or(0), corner.normal.unwrap_or(0));
                uv_face[at] = uvs.place(uv, || Ok(Vec2::try_from(model.uvs[uv])?))?;
                normal_face[at] =
                    normals.place(normal, || Ok(Vec3::try_from(unit(model.normals[normal]))?))?;
            }
            part.faces.push(face);
            part.uv_faces.push(uv_face);
            part.normal_faces.push(normal_face);
        }
        part.positions = positions.values;
        part.uvs = uvs.values;
        part.normals = normals.values;
        parts.push(part);
    }
    // Edges are cut separately: an edge may join points that went to different parts.
    let mut edges = model.edges.iter().peekable();
    while edges.peek().is_some() {
        let mut positions = List::new();
        let mut part = Part::default();
        while positions.has_room(2) {
            let Some(&[from, to]) = edges.next() else {
                break;
            };
            part.edges.push([
                positions.place(from, || position(from))?,
                positions.place(to, || position(to))?,
            ]);
        }
        part.positions = positions.values;
        parts.push(part);
    }
    Ok(parts)
}

/// Returns the normal at unit length, so that it is not too small for the format; zero stays zero.
fn unit(normal: [f64; 3]) -> [f64; 3] {
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 {
        normal.map(|x| x / length)
    } else {
        normal
    }
}
