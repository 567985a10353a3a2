//! Tests that need no reference model: two results must be equal bit for bit, or the test states the expected value.

#[path = "../../examples/common/mod.rs"]
mod examples;

use embedded_graphics::pixelcolor::PixelColor;
use fixel::DrawList;
use fixel::canvas::DepthBuffer;
use fixel::prelude::*;

mod assets;
mod bands;
mod canvas;
mod colors;
mod counts;
mod depths;
mod golden;
mod kept_corners;
mod labels;
mod mirrors;
mod objects;
mod order;
mod picking;
mod quantized;
mod quantized_positions;
mod raster;
mod readme;
mod rotations;
mod shaders;
mod shades;

mod sprites;
mod things;
mod threads;
mod traits;
mod wireframe;

/// A canvas with depths.
type Screen<'c, C, D = LinearDepth> = Canvas<'c, C, Native, D>;

/// A picture, drawn in bands of `rows` rows, and its depths. The last band has the remaining rows. All pixels have this
/// color and depth before they are drawn.
fn picture<C: PixelColor, D: DepthBuffer>(
    (width, height): (u32, u32),
    rows: u32,
    (color, depth): (C, u16),
    draw: &mut dyn FnMut(&mut Screen<'_, C, D>),
) -> (Vec<C>, Vec<u16>) {
    let mut colors = vec![color; (width * height) as usize];
    let mut depths = vec![depth; colors.len()];
    let band = (width * rows) as usize;
    let bands = colors.chunks_mut(band).zip(depths.chunks_mut(band));
    for (first, (colors, depths)) in (0..).step_by(rows as usize).zip(bands) {
        let band = Canvas::band(colors, width, height, first).unwrap();
        draw(&mut band.with_depth_format(depths).unwrap());
    }
    (colors, depths)
}

/// A list with enough room for all tests, because each size is compiled.
type List = DrawList<900, 1200>;
