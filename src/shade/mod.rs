//! From interpolated values to a colour: the shader trait and the shaders that come with the crate.
//!
//! | shader | a pixel is | varyings |
//! |---|---|---|
//! | [`Flat`] | one colour for all | 0 |
//! | [`FaceColors`] | one colour per triangle | 0 |
//! | [`Gouraud`] | the mesh's vertex colours | 3, or 1 for grey |
//! | [`Lit`] | one surface colour × light at the vertices | 1 |
//! | [`LitFaces`] | one surface colour × light at the triangle | 0 |
//! | [`Textured`] | a texel or bilinear between four, repeated or clamped | 2 |
//! | [`LitTexture`] | a texel × light at the vertices | 3 |
//! | [`Modulated`] | a texel × the mesh's vertex colours | 5, or 3 for grey |
//! | [`DepthView`] | grey by depth | 0 |
//! | [`NormalView`] | the normal's direction as a colour | 3, or 1 for grey |
//!
//! Any of them is turned into another colour format, dithered where it is coarse, by [`Converted`].

mod converted;
mod dither;
mod flat;
mod gouraud;
mod levels;
mod light;
mod lit;
mod modulated;
mod pose;
mod shader;
mod textured;
mod views;

#[cfg(test)]
mod trial;

pub use converted::Converted;
pub use flat::{FaceColors, Flat};
pub use gouraud::Gouraud;
pub use levels::{Channels, Levels};
pub use light::Light;
pub use lit::{Lit, LitFaces, LitTexture};
pub use modulated::Modulated;
pub use shader::{Fragment, Shader};
pub use textured::{Addressing, Clamp, Repeat, Textured};
pub use views::{DepthView, NormalView};

use crate::texture::{Bilinear, Blend, Filter, Nearest, Sampler};
