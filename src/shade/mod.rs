//! From interpolated values to a color: the shader trait and the shaders that come with the crate.
//!
//! | surface | a pixel is | varyings |
//! |---|---|---|
//! | [`Flat`] | one color for all | none |
//! | [`FaceColors`] | one color per triangle | none |
//! | [`Gouraud`] | the mesh's vertex colors | 3, or 1 for gray |
//! | [`Textured`] | a texel or bilinear between four, repeated or clamped | 2 |
//! | [`DepthView`] | gray by depth | none |
//! | [`NormalView`] | the normal's direction as a color | 3, or 1 for gray |
//!
//! Each can be wrapped, in any order and number:
//!
//! | adapter | a pixel is | varyings |
//! |---|---|---|
//! | [`.lit(light)`](Shader::lit) | the surface × light at the vertices | 1 more |
//! | [`.lit_faces(light)`](Shader::lit_faces) | the surface × light at the triangle | none more |
//! | [`.tinted()`](Shader::tinted) | the surface × the mesh's vertex colors | 3 more, or 1 for gray |
//! | [`.map(effect)`](Shader::map) | a function of the surface's color | none more |
//! | [`.converted()`](Shader::converted) | the surface in another color format, dithered where it is coarse | none more |

mod converted;
mod dither;
mod flat;
mod gouraud;
mod lanes;
mod levels;
mod light;
mod lit;
mod map;
mod shader;
mod textured;
mod tinted;
mod varyings;
mod views;

#[cfg(test)]
mod fixture;

pub use converted::Converted;
pub use flat::{FaceColors, Flat};
pub use gouraud::Gouraud;
pub use lanes::Lanes;
pub(crate) use lanes::MOST as MOST_VARYINGS;
pub use levels::{Channels, Levels};
pub use light::Light;
pub use lit::{FaceLit, Lit};
pub use map::Map;
pub use shader::{Fragment, Shader, ShaderFor};
pub use textured::Textured;
pub use tinted::Tinted;
pub use varyings::{PerFace, Texels, Tolerance, Varyings, Within};
pub use views::{DepthView, NormalView};
