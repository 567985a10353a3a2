//! Meshes: positions, faces, attributes and edges, and where they come from.

mod attribute;
mod buffers;
mod indexed;
pub mod obj;
mod positions;
mod primitive;
mod shapes;

#[doc(hidden)]
pub use buffers::Arrays;
pub use buffers::{Buffers, Counts};
pub(crate) use indexed::Element;
pub use indexed::{Index, Mesh};
pub(crate) use positions::Place;
pub use positions::Positions;
pub(crate) use primitive::Placement;
pub use primitive::{Corner, Missing, Primitive};
pub use shapes::Shape;
