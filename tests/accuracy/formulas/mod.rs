//! Checks of the crate by textbook formulas of projection, cameras, interpolation and time.
//!
//! Expected numbers were worked out by hand, or are computed here in f64 from the formula itself; each test is named
//! after its formula. Axes are right-handed; the camera is at the origin and looks down −z, y up; n and f are
//! distances.

mod camera;
mod helpers;
mod pictures;
mod projection;
mod segment;
mod time;
mod triangle;
