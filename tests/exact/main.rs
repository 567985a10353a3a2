//! Tests that need no model: results must be the same to the last bit, or the expected value stands beside them.

#[path = "../common/mod.rs"]
mod common;
#[path = "../../examples/common/mod.rs"]
mod examples;

mod bands;
mod canvas;
mod golden;
mod images;
mod import;
mod objects;
mod picking;
mod quantized;
mod raster;
mod readme;
mod shaders;
mod short_positions;
mod sprites;
mod threads;
mod traits;
mod wireframe;
