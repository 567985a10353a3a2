//! From values at vertices to values at pixels.
//!
//! On the screen 1/w and attribute/w are linear, the attribute itself is not: each pixel divides the
//! one by the other. Plane equations give the two at the start of a run of pixels, from exact
//! numerators; an [`Interpolate`] steps along the run and divides, which is where speed is traded
//! for accuracy. [`Segment`] answers single questions about the same relation.

mod affine;
mod fast;
mod mode;
mod newton;
mod plane;
mod reciprocal;
mod run;
mod segment;

pub use affine::{Affine, Linear};
pub use fast::Fast;
pub use mode::{Exact, Interpolate};
pub use newton::Newton;
pub(crate) use plane::{Plane, Slope};
pub use reciprocal::reciprocal;
pub use run::{Cells, Pixels, Run, Scale, Steps};
pub(crate) use run::{FAR, weigh};
pub use segment::{Segment, speed};
