//! From a place between texels to a colour.

use embedded_graphics::pixelcolor::PixelColor;

use super::Sampler;
use super::blend::Blend;
use crate::shade::Addressing;

/// What colour a texture has between the centres of its texels: [`Nearest`] or [`Bilinear`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// use fixel::{shade::Repeat, texture::Filter};
///
/// /// Takes a texture of a size, however it is filtered.
/// fn skin<F: Filter<Rgb565>>(textured: Textured<&TextureArray<Rgb565, 64, 64>, Repeat, F>) {
///     let _ = textured;
/// }
/// ```
pub trait Filter<C: PixelColor>: Copy + sealed::Sealed {
    /// The colour at a column and a row, in texels with 16 fraction bits from the first texel's corner.
    #[doc(hidden)]
    fn color<S: Sampler<Color = C>, A: Addressing>(sampler: &S, at: [i32; 2]) -> C;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Nearest {}
    impl Sealed for super::Bilinear {}
}

/// The texel whose centre is nearest: sharp, and squares where a texture is magnified.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Repeat, texture::Nearest};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Repeat, Nearest> = Textured::new(&SKIN);
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In quarters of a texel.
/// let texels = [0, 1, 2, 3, 4].map(|column| skin.shade(&pixel, [column << 14, 0]));
/// assert_eq!(texels, [10, 10, 10, 10, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nearest;

/// Blended of the four texels around, by how near their centres are: smooth where a texture is magnified.
/// Asked for by [`Textured::bilinear`](crate::Textured::bilinear).
///
/// Centres are at halves: a texture's first texel is itself half a texel from its corner. Beyond the
/// centres at the edge a repeating texture is blended with the other edge, a
/// [`clamped`](crate::Textured::clamped) one goes on with the texels of the edge. Where a texture is
/// made smaller, it flickers as with [`Nearest`]: there are no mipmaps.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Clamp, texture::Bilinear};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Clamp, Bilinear> = Textured::new(&SKIN).clamped().bilinear();
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In quarters of a texel.
/// let colors = [0, 1, 2, 3, 4, 5, 6].map(|column| skin.shade(&pixel, [column << 14, 0]));
/// assert_eq!(colors, [10, 10, 10, 13, 15, 18, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
///
/// # Rounding
///
/// The place between the centres is rounded to the nearest 32nd of a texel for colours of 16 bits
/// ([`Rgb565`](embedded_graphics::pixelcolor::Rgb565) and its like), whose channels are blended all at once in
/// one word, and to the nearest 256th for the others ([`Blend::WEIGHT_BITS`]). Rows are blended
/// first and rounded to a whole step, then what is between them. So a channel is off by at
/// most one step, and a 32nd (a 256th) of the difference between the four texels: two steps of red and
/// three of green from black to white in Rgb565, two of 255 in Rgb888. At the centres of texels it is exact.
///
/// # Cost
///
/// What a pixel takes beyond the nearest texel, in instructions, with `opt-level = 3` (of the measured floor with
/// a texture of 64x64 in flash, exact and affine; in the default mode Rgb565 takes 48 and 75); and bytes of code with `opt-level = "s"`:
///
/// | | Cortex-M4 | Cortex-M0+ | code, M4 | code, M0+ |
/// |---|---:|---:|---:|---:|
/// | Rgb565 | 43 to 48 | 63 to 68 | 112 | 140 |
/// | Rgb565, clamped | 55 to 57 | 81 to 86 | | |
/// | Rgb565 of a [`Palette`](super::PaletteArray) | 49 to 51 | 71 to 98 | | |
/// | Rgb888 | 60 to 65 | 97 to 111 | 164 | 200 |
/// | Gray8 | 32 to 33 | 41 to 47 | 76 | 88 |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bilinear;

impl<C: PixelColor> Filter<C> for Nearest {
    #[inline]
    fn color<S: Sampler<Color = C>, A: Addressing>(sampler: &S, [u, v]: [i32; 2]) -> C {
        sampler.texel(
            A::index(u >> 16, sampler.width_log2()),
            A::index(v >> 16, sampler.height_log2()),
        )
    }
}

impl<C: Blend> Filter<C> for Bilinear {
    #[inline]
    fn color<S: Sampler<Color = C>, A: Addressing>(sampler: &S, [u, v]: [i32; 2]) -> C {
        const {
            assert!(
                C::WEIGHT_BITS >= 1 && C::WEIGHT_BITS <= 15,
                "weights must have 1 to 15 bits"
            );
        }
        let ([left, right], x) = between::<A>(u, sampler.width_log2(), C::WEIGHT_BITS);
        let ([upper, lower], y) = between::<A>(v, sampler.height_log2(), C::WEIGHT_BITS);
        let row = |v| [sampler.texel(left, v), sampler.texel(right, v)];
        C::blend([row(upper), row(lower)], [x, y])
    }
}

/// The columns or rows whose centres `at` lies between, and how far it is beyond the first.
#[inline]
fn between<A: Addressing>(at: i32, log2: u32, weight_bits: u32) -> ([i32; 2], u32) {
    // Centres are at halves. Half a unit of the weight less is taken off, so that what is cut is rounded.
    let at = A::back(at, (1 << 15) - (1 << (15 - weight_bits)));
    let first = at >> 16;
    let weight = (at.cast_unsigned() & 0xffff) >> (16 - weight_bits);
    // Of 16 bits, so there is a next one.
    let both = [A::index(first, log2), A::index(first + 1, log2)];
    (both, weight)
}
