//! The extremes of every number format: what is drawn there, and how far from the f64 model.
//!
//! Inputs are numbers that the crate has, so that only its own error counts. Each case states its bound and why it is
//! that, and what was measured goes into a table: see [`table`].

// f64 holds every integer used here, and no pixel is left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

// `accuracy` uses all of these, this a part.
#[allow(dead_code)]
#[path = "../accuracy/bounds.rs"]
mod bounds;
#[path = "../common/mod.rs"]
mod common;
#[allow(dead_code)]
#[path = "../accuracy/drawing.rs"]
mod drawing;
#[allow(dead_code)]
#[path = "../accuracy/mode.rs"]
mod mode;
#[allow(dead_code)]
#[path = "../accuracy/moves.rs"]
mod moves;
#[path = "../reference/mod.rs"]
mod reference;

mod canvases;
mod coordinates;
mod depth;
mod determinism;
mod judge;
mod limits;
mod meshes;
mod outlines;
mod parts;
mod planes;
mod proofs;
mod rotations;
mod scene;
mod small;
mod table;
mod textures;
mod total;
mod verdict;

use common::recorder;
