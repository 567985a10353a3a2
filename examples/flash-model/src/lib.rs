//! A model in flash: a mesh, its parts with their colors and textures, and the module that shows it.
//!
//! The firmware `pico_model` of examples/boards borrows the whole model from flash. The playground and the tests write
//! models.
//!
//! The words are little-endian. After the [header](Header) come these lists, each padded to a whole word:
//!
//! | list | element |
//! |---|---|
//! | positions | three `i16`, in units of 2<sup>-fraction</sup>: the model fits into the ball of radius 1 around the origin |
//! | faces | three `u16`, indices of positions |
//! | normals | three `i8` |
//! | faces of normals | three `u16`, indices of normals: one element for each face, or no elements if each position has a normal |
//! | texture coordinates | two `u16`: u and v, in steps above the least of the model; a step is the range from the least to the greatest, divided by 65,535 and rounded up to a unit of 2<sup>-20</sup> |
//! | faces of texture coordinates | as for normals |
//! | colors | three `u8`: red, green and blue |
//! | faces of colors | as for normals |
//! | parts | a [`PartRecord`] |
//! | textures | a [`TextureRecord`] |
//! | texels | `u16`, the bits of an `Rgb565` |
#![cfg_attr(not(feature = "write"), no_std)]

mod colors;
mod header;
mod module;
mod problem;
mod skin;
#[cfg(feature = "write")]
mod uf2;
#[cfg(feature = "write")]
mod write;

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;
use fixel::mesh::flash::{Small, UvGrid};
use fixel::{Mesh, Vec2, Vec3};

pub use colors::Colors;
pub use header::{ADDRESS, Board, Header, PartRecord, TextureRecord};
pub use module::{Controller, Module, ModuleProblem, NO_PIN, Wires};
pub use problem::Problem;
pub use skin::Skin;
#[cfg(feature = "write")]
pub use uf2::{board, region, uf2};
#[cfg(feature = "write")]
pub use write::{with_module, write};

use header::Lists;

/// A model that borrows its lists from flash.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    module: Module,
    mesh: Mesh<'a>,
    normals: Small<'a, Vec3>,
    normal_faces: &'a [[u16; 3]],
    uvs: Small<'a, Vec2>,
    uv_faces: &'a [[u16; 3]],
    colors: Colors<'a>,
    parts: &'a [PartRecord],
    textures: &'a [TextureRecord],
    texels: &'a [u16],
}

/// A part of a model: faces with one color or texture.
#[derive(Clone, Debug)]
pub struct Part<'a> {
    /// The part's faces: a range of the mesh's faces.
    pub faces: Range<usize>,
    /// The color of a part without a texture.
    pub color: Rgb888,
    /// The texture, if the part has one.
    pub texture: Option<Skin<'a>>,
}

impl<'a> Model<'a> {
    /// Reads a model from the start of `words`, and checks everything that drawing relies on.
    ///
    /// # Errors
    ///
    /// The words are not a model, or the model has another version. The model is cut off or damaged. The model's lists
    /// do not fit each other.
    pub fn read(words: &'a [u32]) -> Result<Self, Problem> {
        let (header, words) = header::read(words)?;
        let mut lists = Lists(words);
        let positions = lists.triples(header.positions)?;
        let faces = lists.triples(header.faces)?;
        let normals = lists.triples(header.normals)?;
        let normal_faces = lists.triples(header.normal_faces)?;
        let uvs = lists.arrays::<u16, 2>(header.uvs)?;
        let uv_faces = lists.triples(header.uv_faces)?;
        let colors = Colors {
            values: lists.triples(header.colors)?,
            faces: lists.triples(header.color_faces)?,
        };
        let parts = lists.arrays(header.parts)?;
        let textures = lists.arrays(header.textures)?;
        let texels = lists.arrays::<u16, 1>(header.texels)?;
        lists.end()?;

        header.module.check().map_err(Problem::Module)?;
        let mesh =
            Mesh::quantized(positions, header.fraction, faces).map_err(|_| Problem::Lists)?;
        let counts = (positions.len(), faces.len());
        check(counts, normals.len(), normal_faces)?;
        check(counts, uvs.len(), uv_faces)?;
        check(counts, colors.values.len(), colors.faces)?;
        let corners = header.uv_corners.map(|[u, v]| Vec2::from_bits([u, v]));
        let model = Self {
            module: header.module,
            mesh,
            normals: Small::normals(normals),
            normal_faces,
            uvs: Small::uvs_of_16(uvs, UvGrid::around(&corners, u16::MAX)),
            uv_faces,
            colors,
            parts,
            textures,
            texels: texels.as_flattened(),
        };
        for part in parts {
            model.part(part)?;
        }
        Ok(model)
    }

    /// The module that shows the model.
    #[must_use]
    pub const fn module(&self) -> Module {
        self.module
    }

    /// The mesh of the whole model.
    #[must_use]
    pub const fn mesh(&self) -> Mesh<'_> {
        let normals = (&self.normals, self.normal_faces);
        self.mesh
            .with_quantized_attributes(normals, (&self.uvs, self.uv_faces))
    }

    /// The colors of vertices; `None` if the model has none.
    #[must_use]
    pub const fn colors(&self) -> Option<Colors<'a>> {
        if self.colors.values.is_empty() {
            return None;
        }
        Some(self.colors)
    }

    /// The parts that make up the mesh, each with its color or texture.
    pub fn parts(&self) -> impl Iterator<Item = Part<'a>> {
        // No part is left out, because `read` has checked each part.
        self.parts.iter().flat_map(|part| self.part(part))
    }

    fn part(&self, &[start, end, color, texture]: &PartRecord) -> Result<Part<'a>, Problem> {
        let faces = start as usize..end as usize;
        if self.mesh.faces().get(faces.clone()).is_none() {
            return Err(Problem::Lists);
        }
        let [_, red, green, blue] = color.to_be_bytes();
        let texture = if texture == header::NO_TEXTURE {
            None
        } else {
            let record = self.textures.get(texture as usize).ok_or(Problem::Lists)?;
            Some(Skin::new(record, self.texels).ok_or(Problem::Lists)?)
        };
        Ok(Part {
            faces,
            color: Rgb888::new(red, green, blue),
            texture,
        })
    }
}

/// Checks that an attribute (normals or texture coordinates) fits the mesh. If the attribute has faces of its own, they
/// must be as many as the mesh's faces, and each corner must name a value that exists, or `NO_VALUE`. Otherwise, the
/// attribute must have a value for each position, or no values.
fn check(
    (positions, faces): (usize, usize),
    values: usize,
    own_faces: &[[u16; 3]],
) -> Result<(), Problem> {
    let is_index = |&index: &u16| index == Mesh::NO_VALUE || usize::from(index) < values;
    let fits = if own_faces.is_empty() {
        values == 0 || values == positions
    } else {
        own_faces.len() == faces && own_faces.as_flattened().iter().all(is_index)
    };
    if fits { Ok(()) } else { Err(Problem::Lists) }
}
