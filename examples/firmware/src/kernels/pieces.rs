//! Measures how long the pieces of mode `Fast` are.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use fixel::mode::Fast;
use fixel::prelude::*;

use super::wall::Bench;

/// A shader whose color is the lower 16 bits of the pixel's column in the texture, in units of 2^-16 texel.
#[derive(Clone, Copy)]
struct Column;

impl Shader for Column {
    type Color = Rgb565;
    type Varyings = [i32; 1];

    fn varyings(&self, primitive: &Primitive<'_>) -> [[i32; 1]; 3] {
        // A repeat is 2^20 units of u, and 2^22 units here: 2^6 texels of 2^16 units.
        primitive.corners(|corner| [corner.uv().x.to_bits() << 2])
    }

    fn shade(&self, _: &Fragment, [column]: [i32; 1]) -> Option<Rgb565> {
        Some(RawU16::new(column as u16).into())
    }
}

/// Within a piece, the column grows by the same amount at every pixel. The last pixel also takes the remainder up to
/// the next piece's start, at most a unit per pixel. From one piece of the wall to the next, the growth changes by more
/// than that.
const ROUNDING: u16 = 64;

/// Pixels of a row's first span without the last one, where the last piece ends.
const RUN: usize = 63;

/// The number of pixels from one bend to the next in a row of the wall, if all pieces have the same length.
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
    // The first gain belongs to pixel 1.
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
