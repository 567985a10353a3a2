//! What is drawn: meshes, and how their triangles are cut and culled.

mod mesh;
mod vertex;

#[allow(unused_imports)]
pub(crate) use mesh::Element;
pub use mesh::{Index, Mesh};
pub use vertex::{Face, Vertex};
