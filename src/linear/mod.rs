//! Vectors, matrices and transforms.

mod transform;
mod vector;

pub use transform::Transform;
pub use vector::{Vec2, Vec3};
