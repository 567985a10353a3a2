//! The extremes of every number format: what is drawn there, and how far from the f64 model.
//!
//! Inputs are numbers that the crate has, so that only its own error counts. Each case states its bound and why it is
//! that, and what was measured goes into a table: see [`table`].

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
