//! An amount of light, and which parts of it are interpolated.

use super::FULL;
use crate::shade::format::{each, luma, zip};
use crate::shade::{Channels, PixelFormat};

/// The light at a point of a surface, in units of 2⁻¹⁶ of full brightness.
///
/// A light may have up to a thousand times full brightness. A light may also be negative: then it takes light away from
/// other lights. A surface limits the sum of its lights to the range from 0 to full brightness.
///
/// ```
/// use fixel::shade::Illumination;
/// let half = Illumination::white(32_768);
/// let orange = Illumination { diffuse: [65_536, 32_768, 0], specular: () };
/// assert_eq!(half.plus(orange).diffuse, [98_304, 65_536, 32_768]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Illumination<D = i32, S = ()> {
    /// The light by which the surface's color is multiplied: one number for white light, or red, green and blue. A gray
    /// canvas uses only red, the first number.
    pub diffuse: D,
    /// The brightness of a white highlight, which is added to the surface's color; `()` for no highlight.
    pub specular: S,
}

impl Illumination {
    /// White light without a highlight.
    #[must_use]
    #[inline]
    pub const fn white(brightness: i32) -> Self {
        Self {
            diffuse: brightness,
            specular: (),
        }
    }
}

impl<D: Channels, S: Channels> Illumination<D, S> {
    /// The sum of two amounts of light, which saturates.
    #[must_use]
    #[inline]
    pub fn plus<E: Channels, T: Channels>(
        self,
        other: Illumination<E, T>,
    ) -> Illumination<D::Or<E>, S::Or<T>> {
        Illumination {
            diffuse: sum(self.diffuse, other.diffuse),
            specular: sum(self.specular, other.specular),
        }
    }

    /// Like [`plus`](Self::plus), but for two amounts of light of one type.
    #[inline]
    pub(super) fn join(self, other: Self) -> Self {
        Self {
            diffuse: sum(self.diffuse, other.diffuse),
            specular: sum(self.specular, other.specular),
        }
    }

    /// The varyings on a canvas of color `C`.
    #[inline]
    pub(in crate::shade) fn pack<C: PixelFormat>(self) -> Packed<D, S, C> {
        (packed::<D, C>(self.diffuse), packed::<S, C>(self.specular))
    }

    /// The light, from varyings that [`pack`](Self::pack) made.
    #[inline]
    pub(in crate::shade) fn unpack<C: PixelFormat>((diffuse, specular): Packed<D, S, C>) -> Self {
        Self {
            diffuse: D::of(diffuse.rgb()),
            specular: S::of(specular.rgb()),
        }
    }
}

/// The varyings of a light: one brightness for all channels, or one for each channel; and one more number for
/// highlights.
pub(in crate::shade) type Packed<D, S, C> = (<D as Channels>::On<C>, <S as Channels>::On<C>);

#[inline]
fn sum<A: Channels, B: Channels, R: Channels>(a: A, b: B) -> R {
    R::of(zip(a.rgb(), b.rgb(), i32::saturating_add))
}

/// The varyings of light on a canvas of color `C`, limited to the range from darkness to full brightness.
#[inline]
fn packed<A: Channels, C: PixelFormat>(light: A) -> A::On<C> {
    let light = each(light.rgb(), |light| light.clamp(0, FULL));
    A::On::<C>::of(if A::On::<C>::IS_GRAY && !A::IS_GRAY {
        [luma(light); 3]
    } else {
        light
    })
}
