//! The extremes of every number format: pictures with extreme numbers, and their errors, measured with the f64 model.
//!
//! Inputs are numbers of the crate's formats, so that the measured error is only the crate's own. Each file derives the
//! bounds of its cases. The measured errors go into a table: see [`table`].

mod canvases;
mod coordinates;
mod depth;
mod determinism;
mod judge;
mod limits;
mod meshes;
mod outlines;
mod parallel;
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
