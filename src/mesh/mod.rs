//! Meshes: vertices, faces and edges, and the sources they come from.

mod attribute;
mod buffers;
#[doc(hidden)]
pub mod flash;
mod indexed;
pub mod obj;
mod positions;
mod primitive;
mod shapes;

pub use buffers::{Buffers, Counts};
pub(crate) use indexed::Element;
pub use indexed::{Index, Mesh};
pub(crate) use positions::Place;
pub use positions::Positions;
pub(crate) use primitive::Placement;
pub use primitive::{Corner, Missing, Primitive};
pub use shapes::Shape;
