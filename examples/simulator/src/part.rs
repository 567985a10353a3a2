//! Splits a model into meshes with one material and at most 65,535 values of a kind each.

use std::collections::HashMap;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::mesh::Outline;
use fixel::{Cull, Index, Mesh, Vec2, Vec3};
use fixel_assets::{Alpha, Lists, Model, Options, Triangle, outline, times};

use super::Result;

/// The largest number of values in a list. Indices have 16 bits, and the last index stands for no value.
const MOST: usize = 65_535;

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
    /// Whether the surface is drawn without light.
    pub is_unlit: bool,
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
            is_unlit: false,
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
    /// A mesh of one of the project's own scenes. Its back faces are culled.
    pub const fn own(mesh: Mesh<'a>, outline: Option<Outline<'a>>) -> Self {
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
    /// The indices. The other lists have the values in the library's types.
    lists: Lists,
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    colors: Vec<Rgb888>,
    outline: Vec<[Index; 4]>,
    creases: usize,
}

impl Part {
    fn new(material: Option<u32>, lists: Lists) -> Self {
        Self {
            material,
            positions: vectors(&lists.positions),
            uvs: lists.uvs.iter().copied().map(Vec2::from_bits).collect(),
            normals: vectors(&lists.normals),
            colors: lists.colors.iter().copied().map(rgb).collect(),
            lists,
            ..Self::default()
        }
    }

    /// The faces of a model that fits into one mesh, as `fixel::include_mesh!` makes them, and their silhouettes, as
    /// `fixel::include_outline!` makes them.
    ///
    /// # Errors
    ///
    /// The model does not fit.
    pub fn whole(model: &Model) -> Result<Self> {
        let lists = model.lists(&Options::default())?;
        let (outline, creases) = lists.outline(180.0);
        Ok(Self {
            outline,
            creases,
            ..Self::new(None, lists)
        })
    }

    /// Returns the mesh that borrows this part's lists.
    ///
    /// # Errors
    ///
    /// None for the parts that [`split`] makes, although the library checks them.
    pub fn mesh(&self) -> Result<Mesh<'_>> {
        /// The indices of an attribute; `None` if it has the same indices as the positions.
        fn own(faces: &[[Index; 3]]) -> Option<&[[Index; 3]]> {
            (!faces.is_empty()).then_some(faces)
        }
        let lists = &self.lists;
        let mut mesh = Mesh::new(&self.positions, &lists.faces)?.with_edges(&lists.edges)?;
        if !self.uvs.is_empty() {
            mesh = mesh.with_uvs(&self.uvs, own(&lists.uv_faces))?;
        }
        if !self.normals.is_empty() {
            mesh = mesh.with_normals(&self.normals, own(&lists.normal_faces))?;
        }
        if !self.colors.is_empty() {
            mesh = mesh.with_colors(&self.colors, own(&lists.color_faces))?;
        }
        Ok(mesh)
    }

    /// Returns the creases and silhouettes of this part.
    ///
    /// # Errors
    ///
    /// As for [`mesh`](Self::mesh).
    pub fn outline(&self) -> Result<Outline<'_>> {
        Ok(Outline::new(&self.mesh()?, &self.outline, self.creases)?)
    }

    /// Returns the piece of this part with its `finish`.
    ///
    /// # Errors
    ///
    /// As for [`mesh`](Self::mesh).
    pub fn piece(&self, finish: Finish) -> Result<Piece<'_>> {
        Ok(Piece {
            mesh: self.mesh()?,
            finish,
            outline: Some(self.outline()?),
            part: Some(self),
        })
    }

    /// Returns a copy with its faces in another order.
    pub fn in_order(&self, order: &[usize]) -> Self {
        let mut part = self.clone();
        let lists = &mut part.lists;
        for faces in [
            &mut lists.faces,
            &mut lists.uv_faces,
            &mut lists.normal_faces,
            &mut lists.color_faces,
        ] {
            // An empty list stays empty.
            *faces = order
                .iter()
                .filter_map(|&at| faces.get(at).copied())
                .collect();
        }
        part
    }
}

fn vectors(list: &[[i32; 3]]) -> Vec<Vec3> {
    list.iter().copied().map(Vec3::from_bits).collect()
}

/// A color of the importer.
pub fn rgb([r, g, b]: [u8; 3]) -> Rgb888 {
    Rgb888::new(r, g, b)
}

/// The properties that all faces of a part share: their material, and whether their vertices have colors.
fn kind(triangle: &Triangle) -> (Option<u32>, bool) {
    let is_colored = triangle.corners.iter().any(|corner| corner.color.is_some());
    (triangle.material, is_colored)
}

/// Multiplies the colors of vertices by the colors of their materials. If any corner of a triangle has a color, its
/// corners without a color become white first.
fn tint(model: &mut Model) -> Result<()> {
    let old = std::mem::take(&mut model.colors);
    let mut places = HashMap::new();
    for triangle in &mut model.triangles {
        let (material, is_colored) = kind(triangle);
        if !is_colored {
            continue;
        }
        let tint = material.map_or([255; 3], |at| model.materials[at as usize].color);
        for corner in &mut triangle.corners {
            let color = times(corner.color.map_or([255; 3], |at| old[at as usize]), tint);
            let new = u32::try_from(model.colors.len())?;
            let place = *places.entry(color).or_insert(new);
            if place == new {
                model.colors.push(color);
            }
            corner.color = Some(place);
        }
    }
    Ok(())
}

/// Cuts `model` into parts that a mesh can hold: first faces, with one material per part, then the edges of its
/// polygons, and then its outline if `crease` is given. If two faces meet at an angle of more than `crease` degrees,
/// the outline has a line between them.
///
/// # Errors
///
/// One of the numbers does not fit the format.
pub fn split(mut model: Model, crease: Option<f64>) -> Result<Vec<Part>> {
    tint(&mut model)?;
    let mut triangles = std::mem::take(&mut model.triangles);
    let edges = std::mem::take(&mut model.edges);
    // Only positions that no face uses can be out of range.
    let fixed = |&position| Vec3::try_from(position).unwrap_or_default();
    let positions: Vec<Vec3> = model.positions.iter().map(fixed).collect();
    let (outline, creases) = crease.map_or_else(Default::default, |crease| {
        let faces = triangles
            .iter()
            .map(|triangle| triangle.corners.map(|corner| corner.position));
        let positions: Vec<_> = positions
            .iter()
            .map(|position| position.to_bits())
            .collect();
        outline(&positions, &faces.collect::<Vec<_>>(), crease)
    });
    triangles.sort_by_key(kind);
    let mut parts = Vec::new();
    let same = triangles.chunk_by(|a, b| kind(a) == kind(b));
    // A triangle has at most three values of a kind.
    for triangles in same.flat_map(|same| same.chunks(MOST / 3)) {
        model.triangles = triangles.to_vec();
        let lists = model.lists(&Options::default())?;
        parts.push(Part::new(triangles[0].material, lists));
    }
    // Lines are split separately, because a line can join points of different parts. Each line has points of its own.
    let own = |corners: &[u32]| corners.iter().map(|&at| positions[at as usize]).collect();
    for edges in edges.chunks(MOST / 2) {
        let mut part = Part {
            positions: own(edges.as_flattened()),
            ..Part::default()
        };
        part.lists.edges = (0..)
            .step_by(2)
            .map(|at| [at, at + 1])
            .take(edges.len())
            .collect();
        parts.push(part);
    }
    let mut creases = creases;
    for edges in outline.chunks(MOST / 4) {
        let renumbered = (0..).step_by(4).zip(edges).map(|(at, &[a, .., d])| {
            // A border has only one face.
            [at, at + 1, at + 2, if a == d { at } else { at + 3 }]
        });
        parts.push(Part {
            positions: own(edges.as_flattened()),
            outline: renumbered.collect(),
            creases: creases.min(edges.len()),
            ..Part::default()
        });
        creases = creases.saturating_sub(edges.len());
    }
    Ok(parts)
}
