//! The number formats, one name per quantity.
//!
//! | quantity | format | range | resolution |
//! |---|---|---|---|
//! | coordinates, distances | [`Scalar`] (`I16F16`) | ±32768 | 1.5e-5 |
//! | texture coordinates | [`TexCoord`] (`I12F20` repeats) | ±2048 | 9.5e-7 |
//! | sine, cosine, unit vectors | [`Unit`] (`I2F30`) | ±2 | 9.3e-10 |
//! | angle | `u32` fraction of a turn ([`Angle`](crate::Angle)) | one turn, wraps | 8.4e-8 degrees |
//! | speed of rotation | `i64` thousandths of a turn a minute ([`Rate`](crate::Rate)) | ±2.1 million turns a minute, 60 times that in hertz | 1/1000 |
//! | time | `u64` milliseconds | 584 million years | 1 ms |
//! | transform, projection | 30 bits and a sign, with a shared exponent ([`Transform`](crate::Transform)) | ±2^62 | 2^-30 of the largest |
//! | clip space | `i64` with a binary point per draw call | what the transform makes of any [`Scalar`] | 2^-16 of a model's unit or finer |
//! | screen | [`Subpixel`] (`I24F8` pixels) | 2048 about the viewport's centre, beyond which triangles are clipped | 1/256 pixel |
//! | 1/w, or depth under a parallel projection | `u32`, the nearest corner of a primitive filling 31 bits | 2^23 to 1 in a primitive | 2^-31 of the largest |
//! | attribute/w | `i32`, likewise | half of 1/w | 2^-30 of the attribute's largest value |
//! | reciprocal of 1/w | 31 bits ([`reciprocal`](crate::num::reciprocal)) | | exact, rounded down |
//! | depth as stored | `u16`, floor(65535 · near / w) | 65535 at the near plane, 0 infinitely far | 1/65535 of near/w |
//! | the same in [floating point](crate::target::Float) | `u16`: 4 bits of exponent, 12 of mantissa | 65535 at the near plane, 0 from 65,536 times as far | 2^-12 of the distance |
//! | the same over a [wider range](crate::target::WideFloat) | `u16`: 5 bits of exponent, 11 of mantissa | 65535 at the near plane, 0 from 2^32 times as far | 2^-11 of the distance |
//! | [short](crate::Mesh::short) positions | `[i16; 3]`, 0 to 16 fraction bits | ±2^15 units | 2^-fraction |
//! | varyings of a shader | `i32`, whatever the shader makes of it | ±2^31 | rounded down to its unit |
//! | … texels | 16 fraction bits ([`Textured`](crate::Textured)) | ±32768 texels | 1/65536 texel |
//! | … colour levels | 16 fraction bits of a step ([`Levels`](crate::Levels)) | 0 to 255 steps | 1/65536 step |
//! | brightness, colour fractions | `i32` ([`Light::brightness`](crate::Light::brightness)) | 0 to 65,536, which is 1 | 1/65536 |
//!
//! Products are accumulated in 64 bits and rounded once, to nearest; where something rounds in another
//! way, its documentation says so. What exceeds a range saturates; only angles, and turns of a
//! repeating texture, wrap.

mod angle;
pub(crate) mod block;
mod reciprocal;
pub(crate) mod rsqrt;
mod time;
pub(crate) mod wide;

pub use angle::Angle;
pub use reciprocal::reciprocal;
pub(crate) use reciprocal::short_reciprocal;
pub use time::{Rate, Spin};

use crate::Error;
use crate::error::Given;

/// Coordinates and distances: signed, 16 integer and 16 fraction bits.
///
/// Range −32768 to 32768 − 2⁻¹⁶, resolution 2⁻¹⁶ ≈ 1.5e-5.
/// [`fx!`](crate::fx) writes a literal, [`scalar`] converts a float at run time.
///
/// ```
/// use fixel::{Scalar, fx};
/// assert_eq!(fx!(1.5).to_bits(), 3 << 15);
/// assert_eq!(Scalar::from_num(2) * fx!(0.25), fx!(0.5));
/// ```
pub type Scalar = fixed::types::I16F16;

/// Texture coordinates in repeats of the texture: signed, 12 integer and 20 fraction bits.
///
/// Range −2048 to 2048 − 2⁻²⁰, resolution 2⁻²⁰ ≈ 9.5e-7. Rounding to it moves a texture of 256 texels
/// by 1.2e-4 texel at most, where a [`Scalar`] would by 2e-3.
/// [`vec2!`](crate::vec2) writes a pair of literals, [`tex_coord`] converts a float at run time.
pub type TexCoord = fixed::types::I12F20;

/// Screen coordinates: signed, 24 integer and 8 fraction bits of a pixel.
///
/// x to the right and y down from the top left corner of the frame; a pixel's centre is at halves.
///
/// ```
/// use fixel::num::Subpixel;
/// // The centre of the second column.
/// assert_eq!(Subpixel::from_bits(384).to_string(), "1.5");
/// ```
pub type Subpixel = fixed::types::I24F8;

/// Sines, cosines and components of unit vectors: signed, 2 integer and 30 fraction bits.
///
/// ```
/// use fixel::{Angle, Unit};
/// let half: Unit = Angle::from_degrees(30).sin();
/// assert!((half - Unit::lit("0.5")).abs() < Unit::lit("0.00000001"));
/// ```
pub type Unit = fixed::types::I2F30;

/// Converts a float to the nearest [`Scalar`].
///
/// # Errors
///
/// [`Error::NotRepresentable`] if `value` is not a number or its magnitude is beyond ±32768.
///
/// ```
/// use fixel::{number::scalar, Scalar};
/// assert_eq!(scalar(1.5), Ok(Scalar::lit("1.5")));
/// assert!(scalar(40_000.0).is_err());
/// ```
pub const fn scalar(value: f64) -> Result<Scalar, Error> {
    match nearest(value, Scalar::FRAC_NBITS) {
        Ok(bits) => Ok(Scalar::from_bits(bits)),
        Err(error) => Err(error),
    }
}

/// Converts a float to the nearest [`TexCoord`].
///
/// # Errors
///
/// [`Error::NotRepresentable`] if `value` is not a number or its magnitude is beyond ±2048.
///
/// ```
/// use fixel::num::{tex_coord, TexCoord};
/// assert_eq!(tex_coord(1.5), Ok(TexCoord::lit("1.5")));
/// let error = tex_coord(3000.0).unwrap_err();
/// assert_eq!(error.to_string(), "3000 cannot be represented: it must lie between -2048 and 2047.99999");
/// ```
pub const fn tex_coord(value: f64) -> Result<TexCoord, Error> {
    match nearest(value, TexCoord::FRAC_NBITS) {
        Ok(bits) => Ok(TexCoord::from_bits(bits)),
        Err(error) => Err(error),
    }
}

/// The bits of the nearest number with so many fraction bits.
const fn nearest(value: f64, fraction: u32) -> Result<i32, Error> {
    // Round half away from zero; the cast of a finite value in range is exact after that.
    let scaled = value * (1_u32 << fraction) as f64;
    let rounded = if scaled < 0.0 {
        scaled - 0.5
    } else {
        scaled + 0.5
    };
    if rounded > -2_147_483_649.0 && rounded < 2_147_483_648.0 {
        Ok(rounded as i32)
    } else {
        Err(Error::NotRepresentable {
            value: Given::new(value),
            limit: Some(1 << (31 - fraction)),
        })
    }
}

/// Rounds a literal to a [`Scalar`] while compiling; used by [`fx!`](crate::fx) and [`vec3!`](crate::vec3).
///
/// # Panics
///
/// While compiling, if the literal is beyond ±32768.
#[doc(hidden)]
#[must_use]
pub const fn literal(value: f64) -> Scalar {
    match scalar(value) {
        Ok(number) => number,
        Err(_) => panic!("literal is not a number between -32768 and 32768"),
    }
}

/// Rounds a literal to a [`TexCoord`] while compiling; used by [`vec2!`](crate::vec2).
///
/// # Panics
///
/// While compiling, if the literal is beyond ±2048.
#[doc(hidden)]
#[must_use]
pub const fn literal_tex_coord(value: f64) -> TexCoord {
    match tex_coord(value) {
        Ok(number) => number,
        Err(_) => panic!("literal is not a number between -2048 and 2048"),
    }
}

/// A [`Scalar`] from a literal, rounded to the nearest while compiling.
///
/// A literal out of range does not compile.
///
/// ```
/// use fixel::fx;
/// assert_eq!(fx!(0.25) + fx!(2), fx!(2.25));
/// ```
/// ```compile_fail
/// let _ = fixel::fx!(40000);
/// ```
#[macro_export]
macro_rules! fx {
    ($value:expr) => {
        const {
            #[allow(clippy::cast_lossless, clippy::unnecessary_cast)]
            $crate::num::literal($value as f64)
        }
    };
}
