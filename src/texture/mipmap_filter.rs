//! The color of a mipmap at a point and a level.

use super::mipmap::Level;
use super::{Addressing, Bilinear, Blend, Filter, Mipmap, Nearest};
use crate::sealed::{Sealed, sealed};

/// The color of a [`Mipmap`] at a point and a level: [`Nearest`], [`Bilinear`] or [`Trilinear`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::shade::Mipmapped;
/// use fixel::texture::{MipmapFilter, Repeat};
///
/// /// Takes a mipmap with any filter.
/// fn skin<F: MipmapFilter<Rgb565>>(surface: Mipmapped<'_, Rgb565, Repeat, F>) {
///     let _ = surface;
/// }
/// ```
pub trait MipmapFilter<C>: Copy + Sealed {
    /// The color at a column and a row of level 0, in texels with 16 fraction bits, and at a level with 8 fraction
    /// bits.
    #[doc(hidden)]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C>;
}

sealed!(Trilinear);

/// Blends the four texels around a point in each of the two levels between which a pixel lies, and then the two
/// results, so that no edge shows where a level ends.
///
/// [`Mipmapped::trilinear`](crate::shade::Mipmapped::trilinear) selects it. Each blend is rounded as
/// [`Bilinear`] describes it; the position between two levels is cut to the same units, 1/32 or 1/256 of a level.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::shade::Mipmapped;
/// use fixel::texture::{Repeat, Trilinear};
/// fn smooth(surface: Mipmapped<'_, Rgb565>) -> Mipmapped<'_, Rgb565, Repeat, Trilinear> {
///     surface.trilinear()
/// }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Trilinear;

impl<'a, C: Copy> Mipmap<'a, C> {
    /// The color in one level, which must not be beyond the last one.
    #[inline]
    fn color_in<A: Addressing, F: Filter<C>>(
        &self,
        filter: F,
        [u, v]: [i32; 2],
        level: u32,
    ) -> Option<C> {
        filter.color::<Level<'a, C>, A>(&self.level(level), [u >> level, v >> level])
    }

    /// The whole level nearest to a level with 8 fraction bits.
    #[inline]
    fn nearest_level(&self, level: i32) -> u32 {
        ((level + 128) >> 8)
            .clamp(0, self.last().cast_signed())
            .cast_unsigned()
    }
}

impl<C: Copy> MipmapFilter<C> for Nearest {
    #[inline]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C> {
        mipmap.color_in::<A, _>(Nearest, at, mipmap.nearest_level(level))
    }
}

impl<C: Blend> MipmapFilter<C> for Bilinear {
    #[inline]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C> {
        mipmap.color_in::<A, _>(Bilinear, at, mipmap.nearest_level(level))
    }
}

impl<C: Blend> MipmapFilter<C> for Trilinear {
    #[inline]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C> {
        let level = level
            .clamp(0, (mipmap.last() << 8).cast_signed())
            .cast_unsigned();
        let (whole, weight) = (level >> 8, (level & 0xff) << C::WEIGHT_BITS >> 8);
        let fine = mipmap.color_in::<A, _>(Bilinear, at, whole)?;
        if weight == 0 {
            return Some(fine);
        }
        let coarse = mipmap.color_in::<A, _>(Bilinear, at, whole + 1)?;
        Some(fine.mix(coarse, weight))
    }
}
