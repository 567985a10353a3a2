//! The crate's pixels against the f64 model: coverage, attributes, distance and depth.
//!
//! `cargo test --test accuracy -- --nocapture` prints the figures.

// As in the model: textbook names, and f64 holds every integer used here.
#![allow(clippy::many_single_char_names, clippy::cast_precision_loss)]

#[path = "../reference/mod.rs"]
mod reference;

mod bounds;
mod bumpy;
mod chains;
mod clipped;
mod comparison;
mod drawing;
mod moves;
mod pictures;
mod spread;
mod varyings;
