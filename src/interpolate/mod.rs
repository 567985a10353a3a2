//! Interpolation in perspective: what is linear in space is not linear on the screen.

mod segment;

pub use segment::{Segment, speed};
