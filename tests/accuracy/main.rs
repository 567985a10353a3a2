//! The crate's pixels against the f64 model: coverage, attributes, distance and depth.
//!
//! `cargo test --test accuracy -- --nocapture` prints the figures.

// f64 holds every integer used here, and no pixel is left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

#[path = "../common/recorder.rs"]
mod recorder;
#[path = "../reference/mod.rs"]
mod reference;

mod bounds;
mod bumpy;
mod clipped;
mod comparison;
mod drawing;
mod float_depth;
mod mode;
mod moves;
mod mvps;
mod pictures;
mod promises;
mod sine;
mod spread;
mod triangle;
mod varyings;
