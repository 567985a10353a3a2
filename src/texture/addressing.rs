//! What a texture shows beyond its edges.

use crate::TexCoord;
use crate::sealed::{Sealed, sealed};

/// What a texture shows beyond its edges: [`Repeat`] or [`Clamp`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// use fixel::texture::Addressing;
///
/// /// Takes any texture of this size, with either addressing.
/// fn skin<A: Addressing>(textured: Textured<&TextureArray<Rgb565, 64, 64>, A>) {
///     let _ = textured;
/// }
/// ```
pub trait Addressing: Copy + Sealed {
    /// The texture coordinate from which a triangle's are counted, in bits: a whole number of repeats.
    #[doc(hidden)]
    fn origin(bits: [i32; 3]) -> i32;

    /// The column or row for a whole number of texels, which may lie beyond the edges.
    #[doc(hidden)]
    fn index(texel: i32, log2: u32) -> i32;

    /// `texels` minus `little`, both with 16 fraction bits. A difference below `i32::MIN` wraps if texels repeat, and
    /// saturates if they are clamped.
    #[doc(hidden)]
    fn back(texels: i32, little: i32) -> i32;
}

sealed!(Repeat, Clamp);

/// Beyond its edge, a texture begins again.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Texels, texture::Repeat};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Repeat> = Textured::new(&SKIN);
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// let texels = [-1, 0, 1, 2, 3].map(|column| skin.shade(&pixel, Texels([column << 16, 0])));
/// assert_eq!(texels, [20, 10, 20, 10, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Repeat;

/// Beyond its edge, a texture continues with the texels of the edge.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Texels, texture::Clamp};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Clamp> = Textured::new(&SKIN).clamped();
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// let texels = [-1, 0, 1, 2, 3].map(|column| skin.shade(&pixel, Texels([column << 16, 0])));
/// assert_eq!(texels, [10, 10, 20, 20, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Clamp;

/// How many more fraction bits a texture coordinate has than texels.
const FINER: u32 = TexCoord::FRAC_BITS - 16;

/// Converts texture coordinates, in units of 2⁻²⁰ repeat and counted from `origin`, to texels with 16 fraction bits:
/// rounded to nearest, saturated.
///
/// A whole repeat is a whole number of texels, so coordinates that differ by whole repeats round alike.
// Out of line, because all textured shaders share this code.
#[inline(never)]
pub(crate) fn texels(bits: [i32; 3], origin: i32, log2: u32) -> [i32; 3] {
    bits.map(|bits| {
        // At most 33 bits, shifted by at most 15.
        let bits = i64::from(bits) - i64::from(origin);
        let texels = ((bits << log2) + (1 << (FINER - 1))) >> FINER;
        texels.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    })
}

impl Addressing for Repeat {
    #[inline]
    fn origin([a, b, c]: [i32; 3]) -> i32 {
        // The whole repeats that all three corners have in common; without them, the least corner lies in the first
        // repeat.
        a.min(b).min(c) >> TexCoord::FRAC_BITS << TexCoord::FRAC_BITS
    }

    #[inline]
    fn index(texel: i32, _: u32) -> i32 {
        // A sampler repeats by itself.
        texel
    }

    #[inline]
    fn back(texels: i32, little: i32) -> i32 {
        // A wrap changes the position by a whole number of repeats.
        texels.wrapping_sub(little)
    }
}

impl Addressing for Clamp {
    #[inline]
    fn origin(_: [i32; 3]) -> i32 {
        0
    }

    #[inline]
    fn index(texel: i32, log2: u32) -> i32 {
        texel.clamp(0, (1 << log2) - 1)
    }

    #[inline]
    fn back(texels: i32, little: i32) -> i32 {
        texels.saturating_sub(little)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Textures of few texels round, textures of many texels saturate.
    #[test]
    fn coordinates_round_or_saturate_for_any_size_of_texture() {
        let bits = [[-25, -24, -23], [-8, -7, 7], [8, 23, 24]];
        assert_eq!(
            bits.map(|bits| texels(bits, 0, 0)),
            [[-2, -1, -1], [0, 0, 0], [1, 1, 2]]
        );
        assert_eq!(bits.map(|bits| texels(bits, 0, 4)), bits);
        let (low, high) = (i32::MIN, i32::MAX);
        assert_eq!(texels([low, high, 0], 0, 4), [low, high, 0]);
        // 4096 columns: eight repeats in each direction, and not one unit more.
        let ends = [(-8 << 20) - 1, -8 << 20, (8 << 20) - 1];
        assert_eq!(texels(ends, 0, 12), [low, low, high - 255]);
        assert_eq!(texels([8 << 20, 0, 0], 0, 12), [high, 0, 0]);
        assert_eq!(texels([low, 0, high], high, 15), [low, low, 0]);
        assert_eq!(texels([low, 0, high], low, 15), [0, high, high]);
        // A triangle with corners as far apart as possible.
        let repeated = |bits, log2| texels(bits, Repeat::origin(bits), log2);
        assert_eq!(repeated([low, high, 0], 0), [0, 1 << 28, 1 << 27]);
        assert_eq!(
            repeated([-1, (1 << 20) - 1, 1 << 20], 2),
            [1 << 18, 2 << 18, 2 << 18]
        );
    }
}
