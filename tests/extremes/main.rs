//! The extremes of every number format: what is drawn there, and how far from the f64 model.
//!
//! Inputs are numbers that the crate has, so that only its own error counts. Each case states its bound and why it is
//! that, and what was measured goes into a table: see [`table`].

// f64 holds every integer used here, and no pixel is left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

#[path = "../accuracy/bounds.rs"]
mod bounds;
#[path = "../common/mod.rs"]
mod common;
#[path = "../accuracy/drawing.rs"]
mod drawing;
#[path = "../accuracy/mode.rs"]
// `accuracy` has uses for more of these.
#[allow(dead_code)]
mod mode;
#[path = "../accuracy/moves.rs"]
#[allow(dead_code)]
mod moves;
#[path = "../reference/mod.rs"]
mod reference;

mod coordinates;
mod judge;
mod planes;
mod scene;
mod table;
mod total;
