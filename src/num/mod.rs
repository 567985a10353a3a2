//! The number formats, one name per quantity.
//!
//! | quantity | format | range | resolution |
//! |---|---|---|---|
//! | coordinates, distances | [`Scalar`] (`I16F16`) | ±32768 | 1.5e-5 |
//! | texture coordinates | [`TexCoord`] (`I12F20` repeats) | ±2048 | 9.5e-7 |
//! | sine, cosine, unit vectors, parts of a whole | [`Fraction`] (`I2F30`) | ±2 | 9.3e-10 |
//! | angle | `u32` fraction of a turn ([`Angle`]) | one turn, wraps | 8.4e-8 degrees |
//! | speed of rotation | `i64` thousandths of a turn per minute ([`Rate`]) | ±2.1 billion turns per minute or per second; ±2.1 million turns per second if made from thousandths | 1 turn per minute, or 1/1000 turn per second |
//! | time | `u64` milliseconds | 584 million years | 1 ms |
//! | transform, projection | 30 bits and a sign, with a shared exponent ([`Transform`](crate::Transform)) | ±2^62 | 2^-30 of the largest |
//! | clip space | `i64` with a binary point per draw call | every [`Scalar`] under every transform | 2^-16 of a model's unit or finer |
//! | screen | [`Subpixel`] (`I24F8` pixels) | 2048 around the viewport's center; triangles are clipped beyond | 1/256 pixel |
//! | 1/w, or depth under a parallel projection | `u32`, 31 bits at the nearest corner of a primitive | 2^19 to 1 in a primitive | at most 2^-30 of the largest |
//! | attribute/w | `i32`, scaled in the same way | at most half of 1/w | at most 4¼ · 2^-30 of the attribute's largest value |
//! | reciprocal of 1/w | 31 bits | | exact, rounded down |
//! | stored depth | `u16`, floor(65535 · near / w) | 65535 at the near plane, 0 infinitely far | 1/65535 of near/w |
//! | stored depth in [floating point](crate::canvas::FloatDepth) | `u16`: 4 bits of exponent, 12 of mantissa | 65535 at the near plane, 0 from 65,536 times as far | 2^-12 of the distance |
//! | stored depth over a [wider range](crate::canvas::WideFloatDepth) | `u16`: 5 bits of exponent, 11 of mantissa | 65535 at the near plane, 0 from 2^32 times as far | 2^-11 of the distance |
//! | [quantized](crate::Mesh::quantized) positions | `[i16; 3]`, 0 to 16 fraction bits | ±2^15 units | 2^-fraction |
//! | varyings of a shader, in general | `i32` in a unit of the shader's choice | ±2^31 | rounded down to that unit |
//! | varyings: texels | 16 fraction bits ([`Textured`](crate::Textured)) | ±32768 texels | 1/65536 texel |
//! | varyings: color levels | 16 fraction bits of a step ([`PixelFormat`](crate::PixelFormat)) | 0 to 255 steps | 1/65536 step |
//! | brightness, color fractions | `i32` ([`Light::brightness`](crate::Light::brightness)) | 0 to 65,536, which stands for 1 | 1/65536 |
//!
//! # Overflow and rounding
//!
//! Every operation saturates at the ends of its range, in debug and in release builds alike, and none panics. Two kinds
//! of values wrap instead: angles, and the texture coordinates of a texture that repeats. Numbers and vectors follow
//! one rule:
//!
//! | operation | rounding |
//! |---|---|
//! | `a + b`, `a - b`, `-a`, `a * n` with an `i32` | exact |
//! | `a * b` | to nearest, halves up |
//! | `a / b`, `a / n` with an `i32` | to nearest, halves away from zero |
//! | conversion from a float | to nearest, halves away from zero |
//! | conversion to an `f32` | to nearest, halves to even |
//!
//! Division by zero saturates by the sign of the dividend; 0/0 is 0. Sums of products accumulate in 64 bits and are
//! rounded once, to nearest; a function that rounds differently says so.
//!
//! If you multiply a value of the first column by a factor, or divide it by a divisor, the result has the value's type.
//! The factor can be on the left or on the right.
//!
//! | value | factors | divisors |
//! |---|---|---|
//! | [`Scalar`] | `i32`, `Scalar`, [`Fraction`] | `i32`, `Scalar` |
//! | [`TexCoord`] | `i32`, `TexCoord`, `Scalar` | the same |
//! | [`Fraction`], [`Subpixel`] | `i32`, a number of the same type | the same |
//! | [`Vec3`](crate::Vec3), [`Vec2`](crate::Vec2) | `i32`, `Scalar` | the same |
//! | [`Angle`] | `i32`, `Scalar`, `Fraction` | – |
//!
//! ```
//! use fixel::{Scalar, fx, vec3};
//! assert_eq!(fx!(2) * fx!(0.25), fx!(0.5));
//! // 40,000 is beyond the range, for a number as for a component.
//! assert_eq!(fx!(200) * fx!(200), Scalar::MAX);
//! assert_eq!((vec3!(200, 0, 0) * fx!(200)).x, Scalar::MAX);
//! assert_eq!(fx!(-1) / fx!(0), Scalar::MIN);
//! ```
#![cfg_attr(doc, doc = include_str!("../guide/tables.html"))]

mod angle;
pub(crate) mod block;
mod convert;
pub(crate) mod float;
mod literal;
mod log2;
pub(crate) mod number;
mod reciprocal;
pub(crate) mod rsqrt;
mod time;
pub(crate) mod wide;

#[doc(hidden)]
pub use crate::message::checked;
pub use angle::Angle;
pub(crate) use log2::log2;
pub use number::{Fraction, Scalar, Subpixel, TexCoord};
pub(crate) use reciprocal::{reciprocal, short_reciprocal};
pub use time::Rate;

#[cfg(test)]
mod tests;
