//! What is drawn: meshes, and how their triangles are cut and culled.

mod buffers;
mod mesh;
pub mod obj;
mod panic;
mod shapes;
mod vertex;

#[doc(hidden)]
pub use buffers::Arrays;
pub use buffers::{Buffers, Counts};
#[allow(unused_imports)]
pub(crate) use mesh::Element;
pub use mesh::{Index, Mesh};
pub use shapes::Shape;
pub use vertex::{Face, Vertex};
