//! The color at a point between texels.

use embedded_graphics::pixelcolor::PixelColor;

use super::Addressing;
use super::Sampler;
use super::blend::Blend;

/// The color of a texture between the centers of its texels: [`Nearest`] or [`Bilinear`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// use fixel::texture::{Filter, Repeat};
///
/// /// Takes a texture of one size, with either filter.
/// fn skin<F: Filter<Rgb565>>(textured: Textured<&TextureArray<Rgb565, 64, 64>, Repeat, F>) {
///     let _ = textured;
/// }
/// ```
pub trait Filter<C: PixelColor>: Copy + sealed::Sealed {
    /// The color at a column and a row: distances from the first texel's corner, in texels with 16 fraction bits.
    #[doc(hidden)]
    fn color<S: Sampler<Color = C>, A: Addressing>(sampler: &S, at: [i32; 2]) -> C;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Nearest {}
    impl Sealed for super::Bilinear {}
}

/// Takes the texel whose center is nearest.
///
/// A magnified texture shows its texels as sharp squares.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Texels, texture::{Nearest, Repeat}};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Repeat, Nearest> = Textured::new(&SKIN);
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In quarters of a texel.
/// let texels = [0, 1, 2, 3, 4].map(|column| skin.shade(&pixel, Texels([column << 14, 0])));
/// assert_eq!(texels, [10, 10, 10, 10, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nearest;

/// Blends the four texels around a point, by the distances of their centers.
///
/// A magnified texture is smooth. [`Textured::bilinear`](crate::Textured::bilinear) selects it.
///
/// The first texel's center lies half a texel from the texture's corner. Beyond the outermost centers, a
/// repeating texture blends with its other edge, and a [`clamped`](crate::Textured::clamped) one keeps the color
/// of its edge. A reduced texture flickers as with [`Nearest`], because there are no mipmaps.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Texels, texture::{Bilinear, Clamp}};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Clamp, Bilinear> = Textured::new(&SKIN).clamped().bilinear();
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In quarters of a texel.
/// let colors = [0, 1, 2, 3, 4, 5, 6].map(|column| skin.shade(&pixel, Texels([column << 14, 0])));
/// assert_eq!(colors, [10, 10, 10, 13, 15, 18, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
///
/// # Rounding
///
/// The position between the centers is rounded to the nearest 1/32 texel for colors of 16 bits (such as
/// [`Rgb565`](embedded_graphics::pixelcolor::Rgb565)), because one word holds all their channels during a blend. For
/// other colors it is rounded to the nearest 1/256 texel ([`Blend::WEIGHT_BITS`]).
///
/// Two blends along rows come first, each rounded to a whole step; then one blend between the rows. A channel's error
/// is at most one step, plus 1/32 (or 1/256) of the difference between the four texels. From black to white, this is
/// two steps of red and three of green in Rgb565, and two steps of 255 in Rgb888. At the centers of texels there is
/// no error.
///
/// # Cost
///
/// The table lists how many more instructions a pixel takes than with [`Nearest`], with `opt-level = 3`, for the
/// benchmark's floor with a 64x64 texture in flash. The range covers the modes `Exact` and `Affine`; in the default
/// mode, Rgb565 takes 48 more on the M4 and 75 more on the M0+. The last columns are bytes of code with
/// `opt-level = "s"`.
///
/// | | Cortex-M4 | Cortex-M0+ | code, M4 | code, M0+ |
/// |---|---:|---:|---:|---:|
/// | Rgb565 | 43 to 48 | 63 to 68 | 112 | 140 |
/// | Rgb565, clamped | 55 to 57 | 81 to 86 | | |
/// | Rgb565 of a [`Palette`](super::PaletteArray) | 49 to 51 | 71 to 98 | | |
/// | Rgb888 | 60 to 65 | 97 to 111 | 164 | 200 |
/// | Gray8 | 32 to 33 | 41 to 47 | 76 | 88 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

/// The two columns or rows whose centers enclose `at`, and the distance of `at` from the first center.
#[inline]
fn between<A: Addressing>(at: i32, log2: u32, weight_bits: u32) -> ([i32; 2], u32) {
    // Centers lie at halves. Half a unit of the weight stays, so that the cut below rounds to nearest.
    let at = A::back(at, (1 << 15) - (1 << (15 - weight_bits)));
    let first = at >> 16;
    let weight = (at.cast_unsigned() & 0xffff) >> (16 - weight_bits);
    // `first` has 16 bits, so adding 1 cannot overflow.
    let both = [A::index(first, log2), A::index(first + 1, log2)];
    (both, weight)
}
