//! Textures of several sizes with eight by eight squares. Texels are read at run time.

use embedded_graphics::pixelcolor::{Rgb565, WebColors};
use fixel::prelude::*;

/// The texels of a texture, row by row.
pub type Rows<const SIDE: usize> = [[Rgb565; SIDE]; SIDE];

/// Makes a texture, and calls `draw` with it.
pub fn checkered<const SIDE: usize, T>(draw: impl FnOnce(Textured<&Rows<SIDE>>) -> T) -> T {
    let square = SIDE / 8;
    let rows: Vec<[Rgb565; SIDE]> = (0..SIDE)
        .map(|row| {
            std::array::from_fn(|column| match (row / square + column / square) % 2 {
                0 => Rgb565::CSS_IVORY,
                _ => Rgb565::CSS_STEEL_BLUE,
            })
        })
        .collect();
    let rows: &Rows<SIDE> = rows.as_slice().try_into().expect("as many rows as columns");
    draw(Textured::new(rows))
}
