//! From the world to the picture: camera, projection, viewport, and the chain they form.

mod aspect;
mod camera;
mod chain;
mod projection;
mod viewport;

pub use aspect::Aspect;
pub use camera::Camera;
pub use chain::Chain;
pub use projection::{Kind, Parallel, Perspective, Projection};
pub use viewport::Viewport;

pub(crate) use projection::Row;
