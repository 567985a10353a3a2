//! Measures how long the pieces of mode `Fast` are.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use fixel::mode::Fast;
use fixel::prelude::*;

use super::wall::Bench;

/// A shader whose color is the pixel's column of the texture: the lower 16 bits, in units of a texel's fraction.
#[derive(Clone, Copy)]
struct Column;

impl Shader for Column {
    type Color = Rgb565;
    type Varyings = [i32; 1];

    fn varyings(&self, primitive: &Primitive<'_>) -> [[i32; 1]; 3] {
        // A repeat is 2^20, and also 2^6 texels of 2^16 each.
        primitive.corners(|corner| [corner.uv().x.to_bits() << 2])
    }

    fn shade(&self, _: &Fragment, [column]: [i32; 1]) -> Option<Rgb565> {
        Some(RawU16::new(column as u16).into())
    }
}

/// The column grows by the same amount at every pixel of a piece except the last, which takes the rest up to the next
/// piece's start: a difference of up to a unit for each pixel. From one piece of the wall to the next, the growth
/// changes by more.
const ROUNDING: u16 = 64;

/// Pixels of a row's first span, except the last one, at which its last piece ends.
const RUN: usize = 63;

/// Pixels of a row of the wall from one bend to the next, if all pieces have the same length.
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
    // The first gain is the one at pixel 1.
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
