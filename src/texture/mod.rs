//! Textures: texels in memory, and how a shader reads them.
//!
//! | type | size | texel |
//! |---|---|---|
//! | [`Texture`] | known at run time | a color |
//! | [`TextureArray`] | in the type | a color |
//! | [`Palette`] | known at run time | a byte, an index into 256 colors |
//! | [`PaletteArray`] | in the type | a byte, an index into 256 colors |
//! | [`PackedGray4`] | known at run time | half a byte, a gray |
//! | [`Mipmap`] | known at run time | a color, with reductions of the texture for triangles far away |
//! | [`MipmapArray`] | in the type | the same |
//!
//! [`include_texture!`](crate::include_texture) turns a picture file into any of the first four at compile time. A shader
//! takes a reference to any of them or to your own
//! [`Sampler`]; a [`MipmapArray`] is first borrowed by [`as_mipmap`](MipmapArray::as_mipmap). A [`Filter`] chooses the
//! color between the centers of texels. Texels of [`Argb4444`] have an opacity, and those of [`Argb1555`] may be holes.

// Files are read at compile time, where `From` is not const; offsets lie within a file.
#![allow(
    clippy::cast_lossless,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]

mod addressing;
mod argb;
mod array;
mod blend;
mod color;
mod filter;
#[doc(hidden)]
pub mod include;
mod mipmap;
mod mipmap_array;
mod mipmap_filter;
mod packed;
mod palette;
mod palette_array;
mod sampler;
#[allow(clippy::module_inception)] // one type, one file
mod texture;

pub(crate) use addressing::texels;
pub use addressing::{Addressing, Clamp, Repeat};
pub use argb::{Argb1555, Argb4444};
pub use array::TextureArray;
pub use blend::Blend;
pub use filter::{Bilinear, CutOut, Filter, Nearest};
pub use mipmap::Mipmap;
pub use mipmap_array::MipmapArray;
pub use mipmap_filter::{MipmapFilter, Trilinear};
pub use packed::PackedGray4;
pub use palette::{Palette, palette_colors};
pub use palette_array::PaletteArray;
pub use sampler::{MAX_TEXTURE_SIZE, Sampler};
pub use texture::Texture;
