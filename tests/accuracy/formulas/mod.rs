//! The crate compared with textbook formulas, in the order of the guide's pages on mathematics.
//!
//! Expected numbers were worked out by hand, or are computed here in f64 with the formula itself. Each test is named
//! after its formula. Axes are right-handed: the camera is at the origin and looks along −z, with y up. n and f are the
//! distances of the near and far planes.

mod camera;
mod clipping;
mod coverage;
mod helpers;
mod light;
mod pictures;
mod pixel;
mod plane;
mod projection;
mod rotation;
mod segment;
mod time;
mod triangle;
