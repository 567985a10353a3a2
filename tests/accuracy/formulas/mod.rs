//! What the course notes on projection and interpolation say, row by row, as checks of the crate.
//!
//! Expected numbers are those of the notes, or computed here in f64 from the formula that a row
//! gives; each test is named by its row. Right-handed, camera at the origin looking down −z, y up;
//! n and f are distances.

mod camera;
mod given;
mod pictures;
mod projection;
mod segment;
mod time;
mod triangle;
