//! Tests that need no reference model: two results must be equal bit for bit, or the test states the expected value.

#[path = "../../examples/common/mod.rs"]
mod examples;

use fixel::DrawList;

mod assets;
mod bands;
mod canvas;
mod colors;
mod depths;
mod golden;
mod mirrors;
mod objects;
mod picking;
mod quantized;
mod raster;
mod readme;
mod shaders;
mod shades;
mod short_positions;
mod sprites;
mod things;
mod threads;
mod traits;
mod wireframe;

/// A list with enough room for all tests, because each size is compiled.
type List = DrawList<900, 1200>;
