//! Meshes: positions, faces, attributes and edges, and where they come from.
//!
//! | source | at compile time, in flash | at run time, in the caller's memory |
//! |---|---|---|
//! | a file | [`include_mesh!`](crate::include_mesh) | |
//! | a generated shape | [`shape!`](crate::shape) | [`Shape::build`] |
//! | your own slices | [`Mesh::new`] in a `static`, unwrapped by [`Mesh::checked`] | [`Mesh::new`] |
//!
//! [`Sprites`] are rectangles that face the viewer, one at each position of a slice.
//!
//! [`Keyframes`] blends two poses of a mesh. [`Outline`] holds a mesh's edges with the faces beside them.
//!
//! [`Quantized`] is a mesh whose attributes take about a third of the flash.
//!
//! A shader reads a mesh as a [`Primitive`] and its [`Corner`]s.

mod attribute;
mod bounds;
mod buffers;
#[doc(hidden)]
pub mod flash;
mod keyframes;
#[allow(clippy::module_inception)] // one type, one file
mod mesh;
mod normals;
mod outline;
mod part;
mod placement;
mod positions;
mod primitive;
mod quantized;
mod shapes;
mod sprites;

pub use bounds::Bounds;
pub use buffers::{Buffers, Counts};
pub use keyframes::Keyframes;
pub use mesh::{Index, Mesh};
pub use outline::Outline;
pub use part::{Material, Part, TextureAlpha};
pub use placement::Missing;
pub(crate) use placement::Placement;
pub use positions::Positions;
pub(crate) use positions::StoredPosition;
pub(crate) use primitive::Indices;
pub use primitive::{Corner, Primitive};
pub use quantized::Quantized;
pub use shapes::Shape;
pub use sprites::Sprites;
