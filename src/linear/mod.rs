//! Vectors, matrices and transforms.

pub(crate) mod block;
mod matrix;
mod transform;
pub(crate) mod unit;
mod vector;

pub use matrix::Matrix4;
pub use transform::Transform;
pub(crate) use transform::{Line, compose, dot};
pub use vector::{Vec2, Vec3};
