//! The crate compared with textbook formulas of projection, cameras, interpolation and time.
//!
//! Expected numbers were worked out by hand, or are computed here in f64 with the formula itself. Each test is named
//! after its formula. Axes are right-handed: the camera is at the origin and looks along −z, with y up. n and f are the
//! distances of the near and far planes.

mod camera;
mod helpers;
mod pictures;
mod projection;
mod segment;
mod time;
mod triangle;
