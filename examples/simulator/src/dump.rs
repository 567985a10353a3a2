//! Writes the interpolated values of each pixel as numbers.

use std::io::Write;

use embedded_graphics::pixelcolor::PixelColor;
use fixel::shade::Texels;
use fixel::{Fragment, Primitive, Shader, TexCoord};

use super::Result;

/// A "color" that holds the interpolated values of a pixel. So the depth test selects the visible ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Record {
    pub covered: bool,
    uv: [i32; 2],
    /// Fraction bits of `uv`.
    uv_bits: u32,
    /// In units of 2⁻¹⁶.
    distance: i32,
    depth: u16,
}

impl PixelColor for Record {
    type Raw = ();
}

/// A shader that records the interpolated values, with as many fraction bits as texture coordinates leave room for.
#[derive(Clone, Copy, Debug)]
pub struct Recorder {
    uv_bits: u32,
}

impl Recorder {
    /// Makes a shader for texture coordinates of magnitude up to `largest`: 24 fraction bits up to 127, else their
    /// own 20.
    pub fn new(largest: f64) -> Self {
        Self {
            uv_bits: if largest < 127.0 {
                24
            } else {
                TexCoord::FRAC_NBITS
            },
        }
    }
}

impl Shader for Recorder {
    type Color = Record;

    // All values are as exact as a texture coordinate.
    type Varyings = (Texels, Texels);

    fn varyings(&self, primitive: &Primitive<'_>) -> [(Texels, Texels); 3] {
        let up = self.uv_bits - TexCoord::FRAC_NBITS;
        primitive.corners(|corner| {
            let uv = corner.uv().to_bits().map(|bits| bits << up);
            (Texels(uv), Texels([corner.distance().to_bits(), 0]))
        })
    }

    fn shade(
        &self,
        at: &Fragment,
        (Texels(uv), Texels([distance, _])): (Texels, Texels),
    ) -> Option<Record> {
        Some(Record {
            covered: true,
            uv,
            uv_bits: self.uv_bits,
            distance,
            depth: at.depth,
        })
    }
}

/// Writes a header, and a row for each covered pixel, in row order.
///
/// # Errors
///
/// The output cannot be written.
pub fn write(records: &[Record], width: usize, out: &mut impl Write) -> Result<()> {
    writeln!(out, "x,y,u,v,w,depth")?;
    for (y, row) in records.chunks(width).enumerate() {
        for (x, record) in row.iter().enumerate().filter(|(_, record)| record.covered) {
            let [u, v] = record.uv.map(|bits| decimal(bits, record.uv_bits));
            let w = decimal(record.distance, 16);
            writeln!(out, "{x},{y},{u},{v},{w},{}", record.depth)?;
        }
    }
    Ok(())
}

/// Returns `bits` · 2^-`fraction` in decimal, with every digit.
fn decimal(bits: i32, fraction: u32) -> String {
    let magnitude = u64::from(bits.unsigned_abs());
    let mask = (1 << fraction) - 1;
    // 10^n / 2^n = 5^n: n fraction bits make n decimals.
    let digits = u128::from(magnitude & mask) * 5_u128.pow(fraction);
    let digits = format!("{digits:0width$}", width = fraction as usize);
    let digits = digits.trim_end_matches('0');
    let sign = if bits < 0 { "-" } else { "" };
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}{}{point}{digits}", magnitude >> fraction)
}
