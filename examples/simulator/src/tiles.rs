//! Draws a picture in parts: in tiles, for sizes that no canvas has, and in bands, as a microcontroller with little
//! memory does.

use std::time::Duration;

use embedded_graphics::pixelcolor::PixelColor;
use fixel::Drawn;
use fixel::Viewport;

use super::Result;
use crate::draw::add;
use crate::scene::{Band, Done};

/// How a picture is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Tiles {
    /// Width and height of the picture.
    pub size: (u32, u32),
    /// Largest width and height of a canvas.
    pub most: u32,
    /// Rows of a band.
    pub rows: u32,
}

impl Tiles {
    /// Draws the picture; returns its pixels, row by row.
    ///
    /// # Errors
    ///
    /// `draw_band` fails.
    pub fn draw<C: PixelColor + Default>(
        &self,
        draw_band: impl Fn(Band<'_, C>) -> Result<Done>,
    ) -> Result<(Vec<C>, Done)> {
        let (width, height) = self.size;
        let mut pixels = vec![C::default(); width as usize * height as usize];
        let done = self.each(draw_band, |(x, y), tile_width, drawn| {
            let rows = pixels.chunks_exact_mut(width as usize).skip(y as usize);
            for (to, from) in rows.zip(drawn.chunks_exact(tile_width as usize)) {
                to[x as usize..][..from.len()].copy_from_slice(from);
            }
        })?;
        Ok((pixels, done))
    }

    /// Draws the picture; gives `take` each tile: its top left corner, its width and its pixels.
    ///
    /// # Errors
    ///
    /// `draw_band` fails.
    pub fn each<C: PixelColor + Default>(
        &self,
        draw_band: impl Fn(Band<'_, C>) -> Result<Done>,
        mut take: impl FnMut((u32, u32), u32, &[C]),
    ) -> Result<Done> {
        let (width, height) = self.size;
        // Tiles begin at multiples of 8, so that the dithering pattern continues across them.
        let most = self.most / 8 * 8;
        let mut sum = (Drawn::default(), Duration::ZERO);
        let steps = |side: u32| (0..side).step_by(most as usize);
        for (x, y) in steps(height).flat_map(|y| steps(width).map(move |x| (x, y))) {
            let tile = (most.min(width - x), most.min(height - y));
            let viewport = if tile == self.size {
                None
            } else {
                let [left, top] = [x, y].map(|offset| -offset.cast_signed());
                Some(Viewport::new(left, top, width, height)?)
            };
            let (drawn, (counts, time)) = bands(tile, self.rows, viewport, &draw_band)?;
            take((x, y), tile.0, &drawn);
            sum = (add(sum.0, counts), sum.1 + time);
        }
        Ok(sum)
    }
}

/// Draws a frame in bands of `rows` rows; returns the pixels of all bands.
fn bands<C: PixelColor + Default>(
    size: (u32, u32),
    rows: u32,
    viewport: Option<Viewport>,
    draw_band: impl Fn(Band<'_, C>) -> Result<Done>,
) -> Result<(Vec<C>, Done)> {
    let width = size.0 as usize;
    let rows = rows.min(size.1) as usize;
    let mut pixels = vec![C::default(); width * size.1 as usize];
    let mut depth = vec![0; width * rows];
    let mut sum = (Drawn::default(), Duration::ZERO);
    let mut first_row = 0;
    for band in pixels.chunks_mut(width * rows) {
        let len = band.len();
        let (drawn, time) = draw_band(Band {
            pixels: band,
            depth: &mut depth[..len],
            size,
            first_row,
            viewport,
        })?;
        sum = (add(sum.0, drawn), sum.1 + time);
        // Rows of the frame.
        first_row += (len / width) as u32;
    }
    Ok((pixels, sum))
}
