//! Vectors, matrices and transforms.

mod rsqrt;
mod transform;
mod vector;

pub(crate) use rsqrt::unit;
pub use transform::Transform;
pub use vector::{Vec2, Vec3};
