//! From values at vertices to values at pixels.
//!
//! On the screen 1/w and attribute/w are linear, the attribute itself is not: each pixel divides the
//! one by the other. Plane equations give the two at the start of a run of pixels; an [`Interpolate`] steps
//! along the run and divides, which is where speed is traded for accuracy:
//!
//! | mode | texels off, of 256x256 at 320x240 | at each pixel | for |
//! |---|---|---|---|
//! | [`Newton`], the default | 0.001 | a step towards the reciprocal | all but the smallest cores |
//! | [`Fast`] | a tolerance, and 1/32 | additions | Cortex-M0+, large triangles |
//! | [`Fast::NARROW`] | 1/16 | additions | Cortex-M0+, where that is to be seen |
//! | [`Exact`] | 0.001 | a reciprocal of 31 bits | a standard to compare with; 64-bit computers |
//! | [`Affine`] | without a bound | additions | what faces the eye, or is small |
//! | [`Linear`] | without a bound | additions | to the unit in parallel projections |
//!
//! All draw the same in bands as in frames, and the same on every target. (Beyond a depth ratio of 128 within a
//! triangle the first three have up to 0.01 texels in place of 0.001, and more beyond one of 10⁶: see the
//! [limits](crate::guide::limits).) [`Segment`] answers single questions about the same relation; the
//! [guide to modes](crate::guide::modes) says which mode to choose, and derives their bounds.

mod affine;
mod fast;
mod mode;
mod newton;
mod plane;
mod run;
mod tolerance;

pub use affine::{Affine, Linear};
pub use fast::Fast;
pub use mode::{Exact, Interpolate};
pub use newton::Newton;
pub(crate) use plane::{Plane, Slope};
pub use run::{Cells, Pixels, Run, Scale, Steps};
pub(crate) use run::{FAR, RUN, weigh};
pub use tolerance::Tolerance;
