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
//! | texels | `u16`, the bits of an `Rgb565`; in a texture with holes, 0xF81F is a hole |
#![cfg_attr(not(feature = "write"), no_std)]

#[cfg(feature = "write")]
mod cost;
#[cfg(feature = "write")]
mod count;
mod header;
#[cfg(feature = "write")]
#[path = "../../common/layers.rs"]
mod layers;
mod module;
mod painted;
mod problem;
#[cfg(feature = "write")]
mod sides;
mod skin;
#[cfg(feature = "write")]
mod uf2;
#[cfg(feature = "write")]
mod write;

use core::ops::Range;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::Window;
use fixel::mesh::flash::{Small, UvGrid};
use fixel::prelude::*;

#[cfg(feature = "write")]
pub use cost::{cost, rate};
pub use header::{ADDRESS, Board, HOLE, Header, PartRecord, TextureRecord};
pub use module::{Controller, Module, ModuleProblem, NO_PIN, Wires};
pub use painted::{Colors, Painted};
pub use problem::Problem;
pub use skin::Skin;
#[cfg(feature = "write")]
pub use uf2::{board, region, uf2};
#[cfg(feature = "write")]
pub use write::{with_module, write};

use header::Lists;

/// The view of a model, for a picture of this size.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn view(size: (u32, u32)) -> Result<Mvp, Error> {
    // The model lies in the ball of radius 1, which touches the nearer borders of the picture: 2.924 sin 20° = 1.
    let (near, far) = (fx!(1.9), fx!(3.95));
    let projection = if size.0 < size.1 {
        let width = fx!(1.38309); // 2 · 1.9 tan 20°
        let height = width.to_bits() * size.1.cast_signed() / size.0.cast_signed();
        let window = Window::centered(width, Scalar::from_bits(height));
        Projection::frustum(window, near, far)?
    } else {
        Projection::perspective(deg!(40), size, near, far)?
    };
    let camera = Camera::look_at(vec3!(0, 1, 2.748), Vec3::ZERO, Vec3::Y)?;
    Ok(projection * camera)
}

/// How far a model has turned at a time.
#[must_use]
pub fn turn(now_ms: u64) -> Transform {
    Transform::rotate_y(Rate::rpm(6).angle_at(now_ms))
}

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

/// A part of a model: faces with one finish.
#[derive(Clone, Debug)]
pub struct Part<'a> {
    /// The part's faces: a range of the mesh's faces.
    pub faces: Range<usize>,
    /// The color of a part without a texture.
    pub color: Rgb888,
    /// The texture, if the part has one.
    pub texture: Option<Skin<'a>>,
    /// Whether texels of the color [`HOLE`] are holes.
    pub has_holes: bool,
    /// The light that the surface sends out.
    pub emission: Rgb888,
    /// Whether the faces are seen from behind, too.
    pub is_two_sided: bool,
    /// Whether the surface has its own colors in every light.
    pub is_unlit: bool,
    /// The colors of the model's vertices, if it has any.
    pub colors: Colors<'a>,
}

impl<'a> Part<'a> {
    /// Whether the part only reflects light, and has neither holes nor colors of vertices. Then its surface under the
    /// light is all there is to draw.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let is_dark = self.emission == Rgb888::BLACK;
        is_dark && !self.is_unlit && !self.has_holes && self.colors.values.is_empty()
    }

    /// A surface in the colors of the part's vertices under a light, if light changes the part, with the light that the
    /// part sends out.
    pub fn painted<S, L>(&self, surface: S, light: L) -> Painted<'a, S, L> {
        Painted {
            surface,
            colors: self.colors,
            light: (!self.is_unlit).then_some(light),
            emission: self.emission,
        }
    }
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

    /// The parts that make up the mesh, each with its color or texture.
    pub fn parts(&self) -> impl Iterator<Item = Part<'a>> {
        // No part is left out, because `read` has checked each part.
        self.parts.iter().flat_map(|part| self.part(part))
    }

    fn part(&self, record: &PartRecord) -> Result<Part<'a>, Problem> {
        let &[start, end, color, texture, emission, finish] = record;
        let faces = start as usize..end as usize;
        if self.mesh.faces().get(faces.clone()).is_none() {
            return Err(Problem::Lists);
        }
        let texture = if texture == header::NO_TEXTURE {
            None
        } else {
            let record = self.textures.get(texture as usize).ok_or(Problem::Lists)?;
            Some(Skin::new(record, self.texels).ok_or(Problem::Lists)?)
        };
        let rgb = |color: u32| {
            let [_, red, green, blue] = color.to_be_bytes();
            Rgb888::new(red, green, blue)
        };
        Ok(Part {
            faces,
            color: rgb(color),
            texture,
            has_holes: finish & header::HOLES > 0,
            emission: rgb(emission),
            is_two_sided: finish & header::TWO_SIDED > 0,
            is_unlit: finish & header::UNLIT > 0,
            colors: self.colors,
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
