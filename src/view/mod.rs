//! From the world to the picture: camera, projection, viewport, and the mvp they form.

mod aspect;
mod camera;
mod mvp;
mod projection;
mod segment;
mod viewport;

pub use aspect::Aspect;
pub use camera::Camera;
pub use mvp::Mvp;
pub use projection::{Parallel, Perspective, Projection, ProjectionKind};
pub use segment::{Segment, speed};
pub use viewport::Viewport;

pub(crate) use projection::Row;
