//! From the world to the picture: camera, projection and viewport.
//!
#![cfg_attr(doc, doc = include_str!("../guide/diagrams/eye.svg"))]

mod aspect;
mod camera;
mod mvp;
mod projection;
mod viewport;
mod window;

pub use aspect::Aspect;
pub use camera::Camera;
pub use mvp::{AsMvp, Mvp};
pub use projection::{Parallel, Perspective, Projection, ProjectionKind};
pub use viewport::Viewport;
pub use window::Window;

pub(crate) use projection::ProjectionRow;
