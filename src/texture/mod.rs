//! Textures: texels in memory, and how a shader reads them.

mod array;
mod blend;
mod filter;
mod palette_array;
mod sampler;

pub use array::TextureArray;
pub use blend::Blend;
pub use filter::{Bilinear, Filter, Nearest};
pub use palette_array::PaletteArray;
pub use sampler::{MAX_TEXTURE_SIZE, Sampler};
