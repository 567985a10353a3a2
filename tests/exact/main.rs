//! What needs no model: it is the same to the last bit, or the expected value stands beside it.

#[path = "../common/mod.rs"]
mod common;
#[path = "../../examples/common/mod.rs"]
mod examples;

mod bands;
mod canvas;
mod golden;
mod import;
mod raster;
mod shaders;
mod short_positions;
mod threads;
mod traits;
mod wireframe;
