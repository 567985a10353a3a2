//! Meshes: positions, faces, attributes and edges, and where they come from.
//!
//! | source | at compile time, in flash | at run time, in the caller's memory |
//! |---|---|---|
//! | a file | [`include_mesh!`](crate::include_mesh) | |
//! | a generated shape | [`shape!`](crate::shape) | [`Shape::build`] |
//! | your own slices | [`Mesh::new`] in a `static`, unwrapped by [`Mesh::checked`] | [`Mesh::new`] |
//!
//! [`Sprites`] are rectangles that face the viewer, one at each position of a slice.
//!
//! [`Keyframes`] blends two poses of a mesh. [`Outline`] holds a mesh's edges, each with its adjacent faces.
//!
//! A shader reads a mesh as a [`Primitive`] and its [`Corner`]s.
//!
//! # Less flash
//!
//! [`shape!`](crate::shape) and [`include_mesh!`](crate::include_mesh) can store a mesh in fewer bits. The argument
//! `quantized` reduces only the positions. The arguments `quantized_8` and `quantized_16` (only in `include_mesh!`) reduce
//! positions, normals and texture coordinates. The number in the name is the number of bits for u, and for v:
//!
//! | list | bytes per element | bytes in fewer bits | largest error |
//! |---|---|---|---|
//! | positions | 12 | 6 | see [`Mesh::quantized`] |
//! | normals | 12 | 3 | 0.32 degrees |
//! | texture coordinates, `quantized_16` | 8 | 4 | 1/131,070 of their range, plus 2⁻²¹ of the texture |
//! | texture coordinates, `quantized_8` | 8 | 2 | 1/510 of their range, plus 2⁻²¹ of the texture |
//!
#![cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#![cfg_attr(doc, doc = page_picture!("quantized", "The same ring with numbers of 32 bits, and quantized"))]
//! A normal's largest component becomes ±127, and the others are rounded to nearest, halves up. The rounding turns the
//! normal by at most asin(√½ / 127). The range from the least texture coordinate to the greatest is divided into equal
//! steps, separately for u and v. If coordinates range from 0 to 1, a texture with 64 texels in a row moves by up to
//! 1/2048 texel with `quantized_16`, and by up to 1/8 texel with `quantized_8`.
//!
//! The attributes of each triangle are unpacked when the triangle is drawn. For normals, this takes a few percent of
//! the instructions on Cortex-M4. A program without such meshes does not contain the code that unpacks attributes.
//!
//! ```
//! use fixel::prelude::*;
//! static BALL: Mesh = shape!(sphere(16, 12), quantized_8).without_uvs();
//! assert!(BALL.has_normals());
//! ```

mod attribute;
mod bounds;
mod buffers;
mod corner_cache;
mod counts;
#[doc(hidden)]
pub mod flash;
mod index;
mod keyframes;
#[allow(clippy::module_inception)] // one type, one file
mod mesh;
mod normals;
mod outline;
mod part;
mod placement;
mod positions;
mod primitive;
mod shapes;
mod sprites;

pub use bounds::Bounds;
pub use buffers::Buffers;
pub(crate) use corner_cache::CornerCache;
pub use counts::Counts;
pub use index::Index;
pub(crate) use index::Indices;
pub use keyframes::Keyframes;
pub use mesh::Mesh;
pub use outline::Outline;
pub use part::{Material, Part, TextureAlpha};
pub use placement::Missing;
pub(crate) use placement::Placement;
pub use positions::Positions;
pub(crate) use positions::{List, StoredPosition};
pub(crate) use primitive::Reads;
pub use primitive::{Corner, Primitive};
pub use shapes::Shape;
pub use sprites::Sprites;
