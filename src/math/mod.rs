//! Vectors, matrices and transforms.

mod direction;
mod length;
mod matrix;
mod transform;
mod vector;

pub use direction::Direction;
pub(crate) use direction::NormalMatrix;
pub use matrix::Matrix4;
pub use transform::Transform;
pub(crate) use transform::{Line, compose};
pub use vector::{Vec2, Vec3};
