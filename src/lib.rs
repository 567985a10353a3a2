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
pub use shade::{Fragment, Sample};

/// Everything a drawing program needs.
pub mod prelude {
    pub use crate::{Angle, Error, Face, Fragment, Mesh, Sample, Scalar, Vec2, Vec3, Vertex};
    pub use crate::{fx, include_obj, shape, vec2, vec3};
}
