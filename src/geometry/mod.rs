//! What is drawn: meshes, and how they get to the screen.

mod attribute;
mod buffers;
mod clip;
mod cull;
mod mesh;
pub mod obj;
mod panic;
mod positions;
mod project;
mod projected;
mod shapes;
mod vertex;

#[doc(hidden)]
pub use buffers::Arrays;
pub use buffers::{Buffers, Counts};
pub(crate) use clip::{Corner, Outline, Weights, clip};
pub use cull::Cull;
pub(crate) use mesh::Element;
pub use mesh::{Index, Mesh};
pub use positions::Positions;
pub(crate) use project::Projector;
pub(crate) use projected::{DepthShift, Projected};
pub use shapes::Shape;
pub use vertex::{Face, Vertex};
