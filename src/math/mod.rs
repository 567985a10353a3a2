//! Vectors, matrices and transforms.

mod length;
mod matrix;
mod transform;
mod vector;

pub use matrix::Matrix4;
pub use transform::Transform;
pub(crate) use transform::{AffineRow, compose};
pub use vector::{Vec2, Vec3};
