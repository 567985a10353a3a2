//! Measures the length of the pieces that mode `Fast` draws.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use fixel::Primitive;
use fixel::mode::Fast;
use fixel::prelude::*;

use super::wall::Bench;

/// A shader with a color that is the lower 16 bits of the pixel's column in the texture, in units of 2^-16 texel.
#[derive(Clone, Copy)]
struct Column;

impl Shader for Column {
    type Color = Rgb565;
    type Varyings = [i32; 1];

    fn varyings(&self, primitive: &Primitive<'_>) -> [[i32; 1]; 3] {
        // A repeat of the texture is 2^20 units of u. The factor 4 makes it 2^22 units: 2^6 texels of 2^16 units each.
        primitive.corners(|corner| [corner.uv().x.to_bits() << 2])
    }

    fn shade(&self, _: &Fragment, [column]: [i32; 1]) -> Option<Rgb565> {
        Some(RawU16::new(column as u16).into())
    }
}

/// Within a piece, the column increases by the same amount at every pixel. At the last pixel, the column also increases
/// by the remainder up to the start of the next piece: at most one unit per pixel of the piece. This constant is the
/// limit for the remainder. From one piece of the wall to the next, the increase changes by more than this limit.
const ROUNDING: u16 = 64;

/// The number of pixels of a row's first span, without the span's last pixel. The last piece ends at this last pixel.
const RUN: usize = 63;

/// The length of the pieces in a row of the wall, in pixels. A bend is where the increase from pixel to pixel changes
/// by more than [`ROUNDING`]. `None` if there is no bend, or if the bends are not at equal distances from the row's
/// start on.
pub fn length(bench: &mut Bench, mode: Fast) -> Result<Option<usize>, Error> {
    let row = bench.row(mode, &Column)?;
    let columns = row
        .iter()
        .take(RUN)
        .map(|&color| RawU16::from(color).into_inner());
    let gains = columns.clone().zip(columns.skip(1));
    let gains = gains.map(|(from, to)| to.wrapping_sub(from));
    let changes = gains.clone().zip(gains.skip(1));
    let changes = changes.map(|(before, after)| after.wrapping_sub(before).cast_signed());
    // The first difference belongs to pixel 1.
    let bends = (1..)
        .zip(changes)
        .filter(|(_, change)| change.unsigned_abs() > ROUNDING);
    let mut bends = bends.map(|(pixel, _)| pixel);
    let Some(length) = bends.next() else {
        return Ok(None);
    };
    let mut expected = (2..).map(|piece| piece * length);
    Ok(bends
        .all(|bend| expected.next() == Some(bend))
        .then_some(length))
}
