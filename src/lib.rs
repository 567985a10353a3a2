//! 3D scenes in microcontroller framebuffers, in fixed point.
#![no_std]

#[cfg(test)]
extern crate std;

mod angle;
mod error;
pub mod geometry;
pub mod linear;
pub mod number;
pub mod shade;

pub use angle::Angle;
pub use error::Error;
pub use geometry::{Face, Index, Mesh, Vertex};
pub use linear::{Vec2, Vec3};
pub use number::{Scalar, Unit};
pub use shade::{
    Converted, DepthView, FaceColors, Flat, Fragment, Gouraud, Levels, Light, Lit, LitFaces,
    LitTexture, Modulated, NormalView, Palette, Sample, Texture, Textured,
};

/// Everything a drawing program needs.
pub mod prelude {
    pub use crate::{Angle, Error, Face, Fragment, Mesh, Sample, Scalar, Vec2, Vec3, Vertex};
    pub use crate::{
        Converted, DepthView, FaceColors, Flat, Gouraud, Levels, Light, Lit, LitFaces, LitTexture,
        Modulated, NormalView, Palette, Texture, Textured,
    };
    pub use crate::{fx, vec2, vec3};
}
