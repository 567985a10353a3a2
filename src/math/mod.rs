//! Vectors, matrices and transforms.

mod direction;
mod matrix;
mod operators;
mod transform;
mod vec2;
mod vec3;

pub use direction::Direction;
pub(crate) use direction::NormalMatrix;
pub use matrix::Matrix4;
pub use transform::Transform;
pub(crate) use transform::{AffineRow, compose};
pub use vec2::Vec2;
pub use vec3::Vec3;
