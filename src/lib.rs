//! 3D scenes in microcontroller framebuffers, in fixed point.
#![no_std]

#[cfg(test)]
extern crate std;

mod angle;
mod draw;
mod error;
pub mod geometry;
pub mod interpolate;
pub mod linear;
pub mod number;
mod raster;
pub mod shade;
pub mod target;
mod time;
pub mod view;

pub use angle::Angle;
pub use draw::{Drawn, Pass, Place};
pub use error::{Error, Given};
pub use geometry::{Cull, Face, Index, Mesh, Vertex};
pub use linear::{Matrix4, Transform, Vec2, Vec3};
pub use number::{Scalar, Unit};
pub use shade::{
    Converted, DepthView, FaceColors, Flat, Fragment, Gouraud, Levels, Light, Lit, LitFaces,
    LitTexture, Modulated, NormalView, Palette, Sample, Texture, Textured,
};
pub use target::Canvas;
pub use time::{Rate, Spin};
pub use view::{Aspect, Camera, Chain, Projection, Viewport};

/// Everything a drawing program needs.
pub mod prelude {
    pub use crate::{
        Angle, Camera, Canvas, Chain, Cull, Error, Face, Fragment, Mesh, Pass, Projection, Rate,
        Sample, Scalar, Spin, Transform, Vec2, Vec3, Vertex, Viewport,
    };
    pub use crate::{
        Converted, DepthView, FaceColors, Flat, Gouraud, Levels, Light, Lit, LitFaces, LitTexture,
        Modulated, NormalView, Palette, Texture, Textured,
    };
    pub use crate::{fx, include_obj, shape, vec2, vec3};
}
