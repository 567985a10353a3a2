//! Textures: texels in memory, and how a shader reads them.
//!
//! | texture | size | texel |
//! |---|---|---|
//! | rows, `&[[C; W]; H]` | in the type | a color; the fastest texture |
//! | [`Texture`] | known at run time | a color |
//! | [`Indexed`] | the size of its indices | an index into a table of colors, in a byte or less |
//! | [`Raw`] | known at run time | bytes of a file, in either order, or packed grays |
//! | [`Mipmap`] | known at run time | a color; has smaller copies of the texture for triangles far away |
//!
//! [`include_texture!`](crate::include_texture) turns a picture file into any of these textures at compile time. The
//! shader [`Textured`](crate::Textured) draws all of these, and your own [`Sampler`]s. For textures that are partly
//! transparent, use texels of [`Argb4444`], which have an opacity, or of [`Argb1555`], which may be holes.
#![cfg_attr(doc, doc = include_str!("../guide/tables.html"))]

mod addressing;
mod argb;
mod blend;
mod color;
mod cut_out;
mod filter;
#[doc(hidden)]
pub mod include;
mod indexed;
mod mipmap;
mod raw;
mod sampler;
#[allow(clippy::module_inception)] // one type, one file
mod texture;

pub(crate) use addressing::texels;
pub use argb::{Argb1555, Argb4444};
pub use blend::Blend;
pub use cut_out::{CutOut, OrHole};
pub use filter::{Bilinear, Filter, Nearest, Trilinear};
pub use indexed::Indexed;
pub use mipmap::Mipmap;
pub use raw::Raw;
pub use sampler::Sampler;
pub use texture::Texture;
