//! What is drawn: meshes, and how they get to the screen.

mod attribute;
mod buffers;
mod mesh;
pub mod obj;
mod positions;
mod shapes;
mod vertex;

#[doc(hidden)]
pub use buffers::Arrays;
pub use buffers::{Buffers, Counts};
pub(crate) use mesh::Element;
pub use mesh::{Index, Mesh};
pub(crate) use positions::Place;
pub use positions::Positions;
pub use shapes::Shape;
pub use vertex::{Corner, Face};
