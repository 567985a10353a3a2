//! Draws a frame in bands, as a microcontroller with little memory does.

use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Drawn;

use super::Result;
use crate::draw::add;
use crate::scene::{Band, Done};

/// Draws a frame in bands of `rows` rows. Returns the pixels of all bands.
///
/// # Errors
///
/// `draw` fails.
pub fn bands(
    size: (u32, u32),
    rows: u32,
    draw: impl Fn(Band<'_>) -> Result<Done>,
) -> Result<(Vec<Rgb888>, Done)> {
    let width = size.0 as usize;
    let rows = rows.min(size.1) as usize;
    let mut pixels = vec![Rgb888::default(); width * size.1 as usize];
    let mut depth = vec![0; width * rows];
    let mut sum = (Drawn::default(), Duration::ZERO);
    let mut first_row = 0;
    for band in pixels.chunks_mut(width * rows) {
        let len = band.len();
        let (drawn, time) = draw(Band {
            pixels: band,
            depth: &mut depth[..len],
            size,
            first_row,
        })?;
        sum = (add(sum.0, drawn), sum.1 + time);
        // The number of rows in this band.
        first_row += (len / width) as u32;
    }
    Ok((pixels, sum))
}
