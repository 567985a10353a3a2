//! The number formats, one name per quantity.
//!
//! | quantity | format | range | resolution |
//! |---|---|---|---|
//! | coordinates, distances | [`Scalar`] (`I16F16`) | ±32768 | 1.5e-5 |
//! | texture coordinates | [`TexCoord`] (`I12F20` repeats) | ±2048 | 9.5e-7 |
//! | sine, cosine, unit vectors | [`Unit`] (`I2F30`) | ±2 | 9.3e-10 |
//! | angle | `u32` fraction of a turn ([`Angle`]) | one turn, wraps | 8.4e-8 degrees |
//! | speed of rotation | `i64` thousandths of a turn per minute ([`Rate`]) | ±2.1 billion turns per minute or per second; ±2.1 million from thousandths | 1/1000 turn per minute |
//! | time | `u64` milliseconds | 584 million years | 1 ms |
//! | transform, projection | 30 bits and a sign, with a shared exponent ([`Transform`](crate::Transform)) | ±2^62 | 2^-30 of the largest |
//! | clip space | `i64` with a binary point per draw call | every [`Scalar`] under every transform | 2^-16 of a model's unit or finer |
//! | screen | [`Subpixel`] (`I24F8` pixels) | 2048 around the viewport's center; triangles are clipped beyond | 1/256 pixel |
//! | 1/w, or depth under a parallel projection | `u32`, 31 bits at the nearest corner of a primitive | 2^19 to 1 in a primitive | 2^-31 of the largest |
//! | attribute/w | `i32`, scaled in the same way | at most half of 1/w | 2^-30 of the attribute's largest value |
//! | reciprocal of 1/w | 31 bits ([`reciprocal`]) | | exact, rounded down |
//! | stored depth | `u16`, floor(65535 · near / w) | 65535 at the near plane, 0 infinitely far | 1/65535 of near/w |
//! | stored depth in [floating point](crate::canvas::FloatDepth) | `u16`: 4 bits of exponent, 12 of mantissa | 65535 at the near plane, 0 from 65,536 times as far | 2^-12 of the distance |
//! | stored depth over a [wider range](crate::canvas::WideFloatDepth) | `u16`: 5 bits of exponent, 11 of mantissa | 65535 at the near plane, 0 from 2^32 times as far | 2^-11 of the distance |
//! | [short](crate::Mesh::short) positions | `[i16; 3]`, 0 to 16 fraction bits | ±2^15 units | 2^-fraction |
//! | varyings of a shader, in general | `i32` in a unit of the shader's choice | ±2^31 | rounded down to that unit |
//! | varyings: texels | 16 fraction bits ([`Textured`](crate::Textured)) | ±32768 texels | 1/65536 texel |
//! | varyings: color levels | 16 fraction bits of a step ([`PixelFormat`](crate::PixelFormat)) | 0 to 255 steps | 1/65536 step |
//! | brightness, color fractions | `i32` ([`Light::brightness`](crate::Light::brightness)) | 0 to 65,536, which stands for 1 | 1/65536 |
//!
//! # Overflow and rounding
//!
//! This crate's own operations saturate at the ends of their range and never panic. Only angles and the repeats of a
//! texture wrap. Products accumulate in 64 bits and round once, to nearest; a function that rounds differently says so.
//!
//! **The operators of single numbers belong to another crate.** [`Scalar`], [`TexCoord`], [`Subpixel`] and [`Unit`] are
//! types of the crate [`fixed`]. When a result of their `+`, `-`, `*` or `/` is out of range, a debug build panics and
//! a release build wraps; `/` by zero panics in both. `*` rounds down and `/` rounds toward zero. Where a result may
//! leave the range, call a method whose name says what happens: `saturating_add`, `saturating_mul`, `checked_div` and
//! so on.
//!
//! ```
//! use fixel::{Scalar, fx, vec3};
//! // In range: the operator will do.
//! assert_eq!(fx!(2) * fx!(0.25), fx!(0.5));
//! // 40,000 is beyond the range. `fx!(200) * fx!(200)` would panic, or be -25,536 in a
//! // release build.
//! assert_eq!(fx!(200).saturating_mul(fx!(200)), Scalar::MAX);
//! // The operators of vectors belong to this crate, and saturate.
//! assert_eq!((vec3!(200, 0, 0) * fx!(200)).x, Scalar::MAX);
//! ```

mod angle;
pub(crate) mod block;
mod convert;
mod literal;
mod log2;
mod reciprocal;
pub(crate) mod rsqrt;
mod time;
pub(crate) mod wide;

pub use angle::Angle;
pub use convert::{IntoScalar, scalar, tex_coord};
pub use literal::{literal, literal_degrees, literal_tex_coord};
#[doc(hidden)]
pub(crate) use log2::log2;
pub use reciprocal::reciprocal;
pub(crate) use reciprocal::short_reciprocal;
pub use time::{Rate, Spin};

/// Coordinates and distances: signed, 16 integer and 16 fraction bits.
///
/// Range −32768 to 32768 − 2⁻¹⁶, resolution 2⁻¹⁶ ≈ 1.5e-5. [`fx!`](crate::fx) writes a literal and
/// [`scalar`] converts a float at run time. Its operators do not saturate: see [`num`](self).
///
/// ```
/// use fixel::{Scalar, fx};
/// assert_eq!(fx!(1.5).to_bits(), 3 << 15);
/// assert_eq!(fx!(30000).saturating_add(fx!(30000)), Scalar::MAX);
/// ```
pub type Scalar = fixed::types::I16F16;

/// Texture coordinates in repeats of the texture: signed, 12 integer and 20 fraction bits.
///
/// Range −2048 to 2048 − 2⁻²⁰, resolution 2⁻²⁰ ≈ 9.5e-7. Its rounding moves a texture of 256 texels
/// by at most 1.2e-4 texel; a [`Scalar`] would move it by 2e-3. [`vec2!`](crate::vec2) writes
/// a pair of literals and [`tex_coord`] converts a float at run time.
pub type TexCoord = fixed::types::I12F20;

/// Screen coordinates: signed, 24 integer and 8 fraction bits of a pixel.
///
/// x runs to the right and y down from the top left corner of the frame. The center of a pixel has
/// the fraction 1/2.
///
/// ```
/// use fixel::num::Subpixel;
/// // The center of the second column.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The module's documentation states these roundings.
    #[test]
    fn operators_of_the_package_fixed_round_down_and_toward_zero() {
        let (least, half) = (Scalar::from_bits(-1), Scalar::from_bits(1 << 15));
        assert_eq!((least * half).to_bits(), -1);
        assert_eq!((least / Scalar::from_bits(2 << 16)).to_bits(), 0);
        let hundreds = Scalar::from_bits(200 << 16);
        assert_eq!(hundreds.wrapping_mul(hundreds).to_bits(), -25_536 << 16);
    }
}
