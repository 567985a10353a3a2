//! All tests that need the f64 model. The tests compare pixels, values, depths and positions of the crate with the
//! model.
//!
//! `cargo test --test accuracy -- --nocapture` prints the measured errors.

// f64 holds every integer used here exactly, and no pixel lies left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

mod bands;
mod blending;
mod bumpy;
mod clipped_values;
mod clipping;
mod closed;
mod coverage;
mod diffusion;
mod extremes;
mod filter;
mod float_depth;
mod fog;
mod formulas;
mod in_view;
mod lights;
mod lines;
mod mipmap;
mod mvps;
mod normals;
mod outline;
mod painter;
mod picking;
mod promises;
mod quantized;
mod rectangle;
mod scenes;
mod sine;
mod sized_points;
mod sky;
mod smooth_edges;
mod sprites;
mod stacks;
mod triangle;
mod varyings;
mod wide;
