//! The textbook's formulas of projection, cameras, interpolation and time, as checks of the crate.
//!
//! Expected numbers were worked out by hand, or are computed here in f64 from the formula itself; each test is named
//! after its formula. Right-handed axes, camera at the origin looking down −z, y up; n and f are distances.

mod camera;
mod given;
mod pictures;
mod projection;
mod segment;
mod time;
mod triangle;
