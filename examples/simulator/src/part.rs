//! Rounds a model to the library's formats, and splits it into meshes with one material and at most 65,535 points each.

use std::collections::HashMap;
use std::hash::Hash;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::mesh::Outline;
use fixel::{Cull, Mesh, Vec2, Vec3};
use fixel_assets::vector::{cross, dot, length, sub, unit};
use fixel_assets::{Alpha, Model, Triangle};

use super::Result;
use super::skin::times;

/// The largest number of values. Indices have 16 bits, and the last index stands for no value.
const MOST: usize = 65_535;

/// The cosine of 40 degrees. If two faces meet at a larger angle, an outline has a line between them.
const CREASE: f64 = 0.766;

/// The color of surfaces without a color.
pub const CLAY: Rgb888 = Rgb888::new(236, 214, 190);

/// How the faces of a material are drawn.
#[derive(Clone, Copy, Debug)]
pub struct Finish {
    /// The index of the texture.
    pub texture: Option<usize>,
    /// The color that is used if there is no texture and the vertices have no colors.
    pub color: Rgb888,
    /// The light that the surface emits, which is added to the color.
    pub glow: Rgb888,
    pub opacity: u8,
    /// What the texture's alpha means.
    pub alpha: Alpha,
    /// Whether the texture does not repeat.
    pub is_clamped: bool,
    pub cull: Cull,
}

impl Finish {
    /// One color, opaque, seen from both sides.
    pub const fn plain(color: Rgb888) -> Self {
        Self {
            texture: None,
            color,
            glow: Rgb888::BLACK,
            opacity: 255,
            alpha: Alpha::Ignored,
            is_clamped: false,
            cull: Cull::Nothing,
        }
    }

    /// A texture. Where textures are not drawn, the surface is clay.
    pub const fn textured(texture: usize) -> Self {
        Self {
            texture: Some(texture),
            ..Self::plain(CLAY)
        }
    }
}

/// A mesh and its material.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'a> {
    pub mesh: Mesh<'a>,
    pub finish: Finish,
    /// The creases and silhouettes of the mesh.
    pub outline: Option<Outline<'a>>,
    /// The lists of the mesh; `None` if the mesh is compiled in.
    pub part: Option<&'a Part>,
}

impl<'a> Piece<'a> {
    /// A mesh that is compiled in. Back faces of the mesh are culled.
    pub const fn compiled(mesh: Mesh<'a>, outline: Option<Outline<'a>>) -> Self {
        Self {
            mesh,
            finish: Finish {
                cull: Cull::Back,
                ..Finish::plain(CLAY)
            },
            outline,
            part: None,
        }
    }
}

/// The lists that a [`Mesh`] borrows, and the material of its faces.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// The index of the material in the model.
    pub material: Option<u32>,
    pub positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    /// Empty if the vertices have no colors.
    colors: Vec<Rgb888>,
    pub faces: Vec<[u16; 3]>,
    uv_faces: Vec<[u16; 3]>,
    normal_faces: Vec<[u16; 3]>,
    color_faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
    outline: Vec<[u16; 4]>,
    creases: usize,
}

impl Part {
    /// Returns the mesh that borrows this part's lists.
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

    /// Returns the piece of this part with its `finish`.
    ///
    /// # Errors
    ///
    /// As for [`mesh`](Self::mesh).
    pub fn piece(&self, finish: Finish) -> Result<Piece<'_>> {
        let mesh = self.mesh()?;
        Ok(Piece {
            mesh,
            finish,
            outline: Some(Outline::new(&mesh, &self.outline, self.creases)?),
            part: Some(self),
        })
    }

    /// Returns a copy with its faces in another order.
    pub fn in_order(&self, order: &[usize]) -> Self {
        let sorted = |faces: &[[u16; 3]]| {
            let faces = order.iter().filter_map(|&at| faces.get(at));
            faces.copied().collect::<Vec<_>>()
        };
        Self {
            faces: sorted(&self.faces),
            uv_faces: sorted(&self.uv_faces),
            normal_faces: sorted(&self.normal_faces),
            color_faces: sorted(&self.color_faces),
            ..self.clone()
        }
    }
}

/// The keys of the values that a list already has. Each key has the value's index in the list.
struct Places<K>(HashMap<K, u16>);

impl<K: Eq + Hash> Places<K> {
    fn add<T>(
        &mut self,
        list: &mut Vec<T>,
        key: K,
        value: impl FnOnce() -> Result<T>,
    ) -> Result<u16> {
        if let Some(&place) = self.0.get(&key) {
            return Ok(place);
        }
        let place = u16::try_from(list.len())?;
        list.push(value()?);
        self.0.insert(key, place);
        Ok(place)
    }
}

/// A part that is being filled. A corner without a value of an attribute gets the index [`Mesh::NO_VALUE`].
struct Filling<'a> {
    model: &'a Model,
    part: Part,
    positions: Places<u32>,
    uvs: Places<u32>,
    normals: Places<u32>,
    colors: Places<[u8; 3]>,
}

impl<'a> Filling<'a> {
    fn new(model: &'a Model, material: Option<u32>) -> Self {
        Self {
            model,
            part: Part {
                material,
                ..Part::default()
            },
            positions: Places(HashMap::new()),
            uvs: Places(HashMap::new()),
            normals: Places(HashMap::new()),
            colors: Places(HashMap::new()),
        }
    }

    /// Whether there is room for another polygon of up to four corners.
    fn has_room(&self) -> bool {
        let Part {
            positions,
            uvs,
            normals,
            colors,
            ..
        } = &self.part;
        let most = positions.len().max(uvs.len()).max(normals.len());
        most.max(colors.len()) + 4 <= MOST
    }

    fn position(&mut self, index: u32) -> Result<u16> {
        let value = || Ok(Vec3::try_from(self.model.positions[index as usize])?);
        self.positions.add(&mut self.part.positions, index, value)
    }

    /// Adds a triangle. With `is_colored`, corners without a color become white.
    fn triangle(&mut self, triangle: &Triangle, is_colored: bool) -> Result<()> {
        let model = self.model;
        let material = triangle.material.map(|at| &model.materials[at as usize]);
        let [mut face, mut uv_face, mut normal_face, mut color_face] = [[Mesh::NO_VALUE; 3]; 4];
        for (at, corner) in triangle.corners.iter().enumerate() {
            face[at] = self.position(corner.position)?;
            if let Some(uv) = corner.uv {
                let value = || Ok(Vec2::try_from(model.uvs[uv as usize])?);
                uv_face[at] = self.uvs.add(&mut self.part.uvs, uv, value)?;
            }
            if let Some(normal) = corner.normal {
                // A normal in a file can be too small for the format, so normals are scaled to unit length. A zero
                // normal stays zero.
                let value = || {
                    Ok(Vec3::try_from(
                        unit(model.normals[normal as usize]).unwrap_or_default(),
                    )?)
                };
                normal_face[at] = self.normals.add(&mut self.part.normals, normal, value)?;
            }
            if is_colored {
                let color = corner
                    .color
                    .map_or([255; 3], |color| model.colors[color as usize]);
                let value = || {
                    let [r, g, b] = material.map_or(color, |material| times(color, material.color));
                    Ok(Rgb888::new(r, g, b))
                };
                color_face[at] = self.colors.add(&mut self.part.colors, color, value)?;
            }
        }
        self.part.faces.push(face);
        self.part.uv_faces.push(uv_face);
        self.part.normal_faces.push(normal_face);
        if is_colored {
            self.part.color_faces.push(color_face);
        }
        Ok(())
    }
}

/// The edges that belong to an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outlined {
    Nothing,
    Silhouettes,
    /// Silhouettes and creases.
    Creases,
}

/// The properties that all faces of a part share: their material, and whether their vertices have colors.
fn kind(triangle: &Triangle) -> (Option<u32>, bool) {
    let is_colored = triangle.corners.iter().any(|corner| corner.color.is_some());
    (triangle.material, is_colored)
}

/// Cuts `model` into parts that a mesh can hold: first faces, with one material per part, then edges and outlines if
/// wanted.
///
/// # Errors
///
/// One of the numbers does not fit the format.
pub fn split(model: &Model, outlined: Outlined) -> Result<Vec<Part>> {
    let mut parts = Vec::new();
    let mut order: Vec<&Triangle> = model.triangles.iter().collect();
    order.sort_by_key(|triangle| kind(triangle));
    for triangles in order.chunk_by(|a, b| kind(a) == kind(b)) {
        let (material, is_colored) = kind(triangles[0]);
        let mut filling = Filling::new(model, material);
        for triangle in triangles {
            if !filling.has_room() {
                parts.push(filling.part);
                filling = Filling::new(model, material);
            }
            filling.triangle(triangle, is_colored)?;
        }
        parts.push(filling.part);
    }
    // Edges are split separately, because an edge can join points of different parts.
    let mut filling = Filling::new(model, None);
    for &[from, to] in &model.edges {
        if !filling.has_room() {
            parts.push(filling.part);
            filling = Filling::new(model, None);
        }
        let edge = [filling.position(from)?, filling.position(to)?];
        filling.part.edges.push(edge);
    }
    let outline = match outlined {
        Outlined::Nothing => Vec::new(),
        _ => outline(model),
    };
    for (is_crease, corners) in outline {
        if !filling.has_room() {
            parts.push(filling.part);
            filling = Filling::new(model, None);
        }
        let mut edge = [0; 4];
        for (to, corner) in edge.iter_mut().zip(corners) {
            *to = filling.position(corner)?;
        }
        filling.part.outline.push(edge);
        filling.part.creases += usize::from(is_crease && outlined == Outlined::Creases);
    }
    parts.push(filling.part);
    Ok(parts)
}

/// Returns the edges that can be part of an outline, in the form that [`Outline::new`] takes, and whether each of them
/// is a crease. Creases come first. Two edges count as the same edge if their ends have the same positions, even if the
/// indices differ.
fn outline(model: &Model) -> Vec<(bool, [u32; 4])> {
    let mut first: HashMap<[u64; 3], u32> = HashMap::new();
    let mut place = |index: u32| {
        let bits = model.positions[index as usize].map(|x| (x + 0.0).to_bits());
        *first.entry(bits).or_insert(index)
    };
    let mut open: HashMap<[u32; 2], (u32, [f64; 3])> = HashMap::new();
    let mut edges = Vec::new();
    for triangle in &model.triangles {
        let corners = triangle.corners.map(|corner| place(corner.position));
        let [p, q, r] = corners.map(|at| model.positions[at as usize]);
        let normal = cross(sub(q, p), sub(r, p));
        for at in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|next| corners[(at + next) % 3]);
            if let Some((d, other)) = open.remove(&[b, a]) {
                let least = CREASE * length(normal) * length(other);
                edges.push((dot(normal, other) < least, [a, b, c, d]));
            } else if let Some((d, _)) = open.insert([a, b], (c, normal)) {
                edges.push((false, [a, b, d, a]));
            }
        }
    }
    edges.extend(
        open.into_iter()
            .map(|([a, b], (c, _))| (false, [a, b, c, a])),
    );
    // Creases come first. Within creases and other edges, the corners decide, because a hash map has no fixed order.
    edges.sort_unstable_by_key(|&(is_crease, corners)| (!is_crease, corners));
    edges
}
