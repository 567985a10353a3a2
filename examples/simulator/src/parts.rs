//! Rounds a model to the library's formats, and splits it into meshes of at most 65,535 points each.

use std::collections::HashMap;
use std::hash::Hash;
use std::ops::Range;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::{Mesh, Vec2, Vec3};

use super::Result;
use super::skin::times;
use fixel_assets::vector::unit;
use fixel_assets::{Model, Triangle};

/// The largest number of values: indices have 16 bits, and the last one stands for no value.
const MOST: usize = 65_535;

/// The lists that one [`Mesh`] borrows, and the material of its faces.
#[derive(Debug, Default)]
pub struct Part {
    /// Index of the model's material.
    pub material: Option<u32>,
    pub positions: Vec<Vec3>,
    pub uvs: Vec<Vec2>,
    pub normals: Vec<Vec3>,
    /// Empty if the vertices have no colors.
    pub colors: Vec<Rgb888>,
    pub faces: Vec<[u16; 3]>,
    pub uv_faces: Vec<[u16; 3]>,
    pub normal_faces: Vec<[u16; 3]>,
    pub color_faces: Vec<[u16; 3]>,
    pub edges: Vec<[u16; 2]>,
}

impl Part {
    /// Returns the mesh over this part's lists.
    ///
    /// # Errors
    ///
    /// None for the parts that [`split`] makes, although the library checks them.
    pub fn mesh(&self) -> Result<Mesh<'_>> {
        let mut mesh = Mesh::new(&self.positions, &self.faces)?.with_edges(&self.edges)?;
        if !self.faces.is_empty() {
            mesh = mesh
                .with_uvs(&self.uvs, Some(&self.uv_faces))?
                .with_normals(&self.normals, Some(&self.normal_faces))?;
        }
        if !self.colors.is_empty() {
            mesh = mesh.with_colors(&self.colors, Some(&self.color_faces))?;
        }
        Ok(mesh)
    }
}

/// A list that is being filled, and the index in it of each of the model's entries.
struct List<K, T> {
    values: Vec<T>,
    places: HashMap<K, u16>,
}

impl<K: Eq + Hash, T> List<K, T> {
    fn new() -> Self {
        Self {
            values: Vec::new(),
            places: HashMap::new(),
        }
    }

    fn has_room(&self, more: usize) -> bool {
        self.values.len() + more <= MOST
    }

    fn place(&mut self, key: K, value: impl FnOnce() -> Result<T>) -> Result<u16> {
        if let Some(&place) = self.places.get(&key) {
            return Ok(place);
        }
        let place = u16::try_from(self.values.len())?;
        self.values.push(value()?);
        self.places.insert(key, place);
        Ok(place)
    }
}

/// The properties that all faces of a part share: their material, and whether their vertices have colors.
fn kind(triangle: &Triangle) -> (Option<u32>, bool) {
    let is_colored = triangle.corners.iter().all(|corner| corner.color.is_some());
    (triangle.material, is_colored)
}

/// Cuts `model` into parts that a mesh can hold, each of one material.
///
/// # Errors
///
/// The format cannot hold one of the numbers.
pub fn split(model: &Model) -> Result<Vec<Part>> {
    let position = |index: u32| position(model, index);
    let mut parts = Vec::new();
    let mut order: Vec<&Triangle> = model.triangles.iter().collect();
    order.sort_by_key(|triangle| kind(triangle));
    for triangles in order.chunk_by(|a, b| kind(a) == kind(b)) {
        let (material, is_colored) = kind(triangles[0]);
        let mut rest = triangles;
        while !rest.is_empty() {
            let mut lists = Lists::new();
            rest = lists.fill(model, rest, is_colored, model.uvs.len())?;
            if let Some(shade) = material.and_then(|at| model.materials.get(at as usize)) {
                for color in &mut lists.colors.values {
                    let [r, g, b] = times([color.r(), color.g(), color.b()], shade.color);
                    *color = Rgb888::new(r, g, b);
                }
            }
            parts.push(Part {
                material,
                ..lists.part()
            });
        }
    }
    // Edges are split separately, because an edge may join points in different parts.
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

/// Rounds `model` to one part, with its edges and the colors of its vertices, in the order of its materials. Also
/// returns which faces have which material.
///
/// # Errors
///
/// It does not fit into one mesh, or the format cannot hold one of the numbers.
pub fn whole(model: &Model) -> Result<(Part, Vec<Run>)> {
    let mut order: Vec<&Triangle> = model.triangles.iter().collect();
    order.sort_by_key(|triangle| triangle.material);
    let mut lists = Lists::new();
    let rest = lists.fill(model, &order, !model.colors.is_empty(), model.own_uvs)?;
    let mut edges = Vec::new();
    for &[from, to] in model.edges.iter().filter(|_| rest.is_empty()) {
        let mut end = |index| lists.positions.place(index, || position(model, index));
        edges.push([end(from)?, end(to)?]);
    }
    if !rest.is_empty() {
        return Err(format!(
            "a mesh holds at most {MOST} positions, texture coordinates or normals, and the model has {}, {} and {}",
            model.positions.len(),
            model.uvs.len(),
            model.normals.len()
        )
        .into());
    }
    let mut runs: Vec<Run> = Vec::new();
    for (at, triangle) in order.iter().enumerate() {
        match runs.last_mut() {
            Some((material, faces)) if *material == triangle.material => faces.end = at + 1,
            _ => runs.push((triangle.material, at..at + 1)),
        }
    }
    let part = Part {
        edges,
        ..lists.part()
    };
    Ok((part, runs))
}

/// A material, and the faces that have it.
pub type Run = (Option<u32>, Range<usize>);

fn position(model: &Model, index: u32) -> Result<Vec3> {
    Ok(Vec3::try_from(model.positions[index as usize])?)
}

/// The lists of a part, being filled. No value of an attribute has the index [`Mesh::NO_VALUE`].
struct Lists {
    positions: List<u32, Vec3>,
    uvs: List<usize, Vec2>,
    normals: List<usize, Vec3>,
    colors: List<[u8; 3], Rgb888>,
    part: Part,
}

impl Lists {
    fn new() -> Self {
        Self {
            positions: List::new(),
            uvs: List::new(),
            normals: List::new(),
            colors: List::new(),
            part: Part::default(),
        }
    }

    /// Adds triangles while there is room, and returns the others. If they are colored, corners without a color are
    /// white. They use the first `uvs` of the model's texture coordinates.
    fn fill<'a, 'b>(
        &mut self,
        model: &Model,
        triangles: &'a [&'b Triangle],
        is_colored: bool,
        uvs: usize,
    ) -> Result<&'a [&'b Triangle]> {
        for (at, triangle) in triangles.iter().enumerate() {
            let has_room = self.positions.has_room(3)
                && self.uvs.has_room(3)
                && self.normals.has_room(3)
                && self.colors.has_room(3);
            if !has_room {
                return Ok(&triangles[at..]);
            }
            let [mut face, mut uv_face, mut normal_face, mut color_face] = [[0; 3]; 4];
            for (at, corner) in triangle.corners.iter().enumerate() {
                let index = corner.position;
                face[at] = self.positions.place(index, || position(model, index))?;
                uv_face[at] = match corner.uv.map(|uv| uv as usize).filter(|&uv| uv < uvs) {
                    Some(uv) => self.uvs.place(uv, || Ok(Vec2::try_from(model.uvs[uv])?))?,
                    None => Mesh::NO_VALUE,
                };
                let normal = corner.normal.map_or(0, |normal| normal as usize);
                normal_face[at] = self.normals.place(normal, || {
                    // At unit length, the normal is not too small for the format. A zero normal stays zero.
                    let direction = unit(model.normals[normal]).unwrap_or_default();
                    Ok(Vec3::try_from(direction)?)
                })?;
                if is_colored {
                    let color = corner
                        .color
                        .map_or([255; 3], |color| model.colors[color as usize]);
                    let [r, g, b] = color;
                    color_face[at] = self.colors.place(color, || Ok(Rgb888::new(r, g, b)))?;
                }
            }
            self.part.faces.push(face);
            self.part.uv_faces.push(uv_face);
            self.part.normal_faces.push(normal_face);
            if is_colored {
                self.part.color_faces.push(color_face);
            }
        }
        Ok(&[])
    }

    fn part(self) -> Part {
        Part {
            positions: self.positions.values,
            uvs: self.uvs.values,
            normals: self.normals.values,
            colors: self.colors.values,
            ..self.part
        }
    }
}
