//! Vectors, matrices and transforms.

pub(crate) mod block;
mod matrix;
mod product;
mod transform;
pub(crate) mod unit;
mod vector;

pub use matrix::Matrix4;
pub(crate) use product::{IS_NARROW, dot, product, short_dot, times_short, upper};
pub use transform::Transform;
pub(crate) use transform::{Line, compose};
pub use vector::{Vec2, Vec3};
