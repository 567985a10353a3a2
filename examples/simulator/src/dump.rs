//! Writes the interpolated values of each pixel as a table.

use std::cell::Cell;
use std::io::Write;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::shade::{PerFace, Texels, Within};
use fixel::{Fragment, Primitive, Shader, TexCoord};

use super::Result;
use crate::args::Mode;

/// The interpolated values of a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Record {
    covered: bool,
    /// Whether the pixel shows the back of a face.
    is_back: bool,
    uv: [i32; 2],
    /// The number of fraction bits of `uv`.
    uv_bits: i32,
    distance: i32,
    /// The number of fraction bits of `distance`, in the model's own units.
    distance_bits: i32,
    depth: u16,
}

impl Record {
    /// Whether anything is drawn at the pixel.
    pub fn is_covered(&self) -> bool {
        self.covered
    }

    /// Whether the back of a face is drawn at the pixel.
    pub fn is_back(&self) -> bool {
        self.is_back
    }

    /// The distance from the eye along the direction of view, in the model's own units.
    pub fn distance(&self) -> f64 {
        f64::from(self.distance) * f64::from(-self.distance_bits).exp2()
    }

    /// Whether this pixel shows a surface that `other` does not show: `other` shows none, or one that is farther away
    /// by more than the rounding error.
    pub fn hides(&self, other: &Self) -> bool {
        let further = other.distance.saturating_sub(self.distance);
        self.covered && !(other.covered && further <= other.distance.abs() >> 10)
    }
}

/// The formats of recorded values. They have as many fraction bits as the size of the texture coordinates allows.
#[derive(Clone, Copy, Debug)]
pub struct Recorder {
    uv_bits: u32,
    distance_shift: i32,
    distance_bits: i32,
}

impl Recorder {
    /// Returns the formats for texture coordinates from −`largest` to `largest`. Distances are drawn at 2^`exponent` times
    /// their own size.
    ///
    /// Texture coordinates have 24 fraction bits, or fewer if they are large. Mode fast interpolates numbers of more
    /// than 28 bits by another method, which textures rarely need. In this mode, every recorded number therefore has at
    /// most 28 bits. Distances lose 11 bits, which is less than the mode's error of 2^-13.
    pub fn new(largest: f64, exponent: i32, mode: Mode) -> Self {
        let is_fast = mode == Mode::Fast;
        let whole = (largest + 1.0).log2().ceil();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 20 to 24
        let uv_bits = (if is_fast { 27.0 } else { 31.0 } - whole)
            .clamp(TexCoord::FRAC_BITS.into(), 24.0) as u32;
        let distance_shift = if is_fast { 11 } else { 0 };
        Self {
            uv_bits,
            distance_shift,
            distance_bits: 16 + exponent - distance_shift,
        }
    }

    /// Returns the size of one repeat of the texture in the recorded numbers. The result is in units of a mode's
    /// tolerance. (When a texture is drawn, this unit is a texel.)
    pub fn repeat(&self) -> f64 {
        f64::from(self.uv_bits - 16).exp2()
    }
}

/// A shader that records the values of the visible pixels.
#[derive(Clone, Copy)]
pub struct Recording<'a> {
    pub recorder: Recorder,
    /// The frame's pixels, in row order.
    pub records: &'a [Cell<Record>],
    pub width: u32,
}

impl Shader for Recording<'_> {
    type Color = Rgb888;
    type Varyings = ((Texels, Within<64, i32>), PerFace<i32>);

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let up = self.recorder.uv_bits - TexCoord::FRAC_BITS;
        primitive.corners(|corner| {
            let uv = corner.uv().to_bits().map(|bits| bits << up);
            let distance = corner.distance().to_bits() >> self.recorder.distance_shift;
            let is_back = i32::from(!primitive.is_front());
            ((Texels(uv), Within(distance)), PerFace(is_back))
        })
    }

    fn shade(
        &self,
        at: &Fragment,
        ((Texels(uv), Within(distance)), PerFace(is_back)): Self::Varyings,
    ) -> Option<Rgb888> {
        let [x, y] = [at.point.x, at.point.y].map(i32::cast_unsigned);
        // A nearer pixel that is drawn later replaces the record.
        self.records
            .get((y * self.width + x) as usize)?
            .set(Record {
                covered: true,
                is_back: is_back != 0,
                uv,
                uv_bits: self.recorder.uv_bits.cast_signed(),
                distance,
                distance_bits: self.recorder.distance_bits,
                depth: at.depth,
            });
        Some(Rgb888::WHITE)
    }
}

/// Writes a header, and a row for each covered pixel. Pixels are in row order.
///
/// # Errors
///
/// The output cannot be written.
pub fn write(records: &[Record], width: usize, out: &mut impl Write) -> Result<()> {
    writeln!(out, "x,y,u,v,w,depth")?;
    for (y, row) in records.chunks(width).enumerate() {
        for (x, record) in row.iter().enumerate().filter(|(_, record)| record.covered) {
            let [u, v] = record.uv.map(|bits| decimal(bits, record.uv_bits));
            let w = decimal(record.distance, record.distance_bits);
            writeln!(out, "{x},{y},{u},{v},{w},{}", record.depth)?;
        }
    }
    Ok(())
}

/// Returns `bits` · 2^-`fraction` as a decimal number with all of its digits.
fn decimal(bits: i32, fraction: i32) -> String {
    // The conversion to f64 is exact, because f64 holds 53 bits. A number with n fraction bits has n decimals.
    let value = f64::from(bits) * f64::from(-fraction).exp2();
    let Ok(decimals @ 1..) = usize::try_from(fraction) else {
        return value.to_string();
    };
    let text = format!("{value:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}
