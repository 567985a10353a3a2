//! What is drawn: meshes, and how they get to the screen.

mod clip;
mod cull;
mod mesh;
mod project;
mod vertex;

pub(crate) use clip::{ClipVertex, line as clip_line, triangle as clip_triangle};
pub use cull::Cull;
pub(crate) use mesh::Element;
pub use mesh::{Index, Mesh};
pub(crate) use project::{Projected, Projector};
pub use vertex::{Face, Vertex};
