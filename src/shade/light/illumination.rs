//! An amount of light, and which parts of it are interpolated.

use super::FULL;
use crate::sealed::{Sealed, sealed};
use crate::shade::format::{each, luma, zip};
use crate::shade::{Channels, PixelFormat, Varyings};

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
    /// The light by which the surface's color is multiplied: one number for white light, or red, green and blue. On a
    /// gray canvas, only red is used.
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

impl<D: Amount, S: Amount> Illumination<D, S> {
    /// The sum of two amounts of light, which saturates.
    #[must_use]
    #[inline]
    pub fn plus<E: Amount, T: Amount>(
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
        (self.diffuse.pack::<C>(), self.specular.pack::<C>())
    }

    /// The light, from varyings that [`pack`](Self::pack) made.
    #[inline]
    pub(in crate::shade) fn unpack<C: PixelFormat>((diffuse, specular): Packed<D, S, C>) -> Self {
        Self {
            diffuse: D::unpack::<C>(diffuse),
            specular: S::unpack::<C>(specular),
        }
    }
}

/// The varyings of a light: one brightness for all channels, or one for each channel; and one more number for
/// highlights.
pub(in crate::shade) type Packed<D, S, C> =
    (<D as Amount>::Channels<C>, <S as Amount>::Channels<C>);

#[inline]
fn sum<A: Amount, B: Amount, R: Amount>(a: A, b: B) -> R {
    R::of(zip(a.rgb(), b.rgb(), i32::saturating_add))
}

/// The light, limited to the range from darkness to full brightness.
#[inline]
fn limited(light: i32) -> i32 {
    light.clamp(0, FULL)
}

/// An amount of light: white, or red, green and blue, or `()` for none.
///
/// White light takes one varying; colored light takes one for each channel of the canvas.
#[doc(hidden)]
pub trait Amount: Copy + Default + Sealed {
    /// The type of the sum of this light and another light.
    type Or<E: Amount>: Amount;

    /// The type of the sum of this light and a white light.
    type OrWhite: Amount;

    /// The varyings on a canvas of color `C`.
    type Channels<C: PixelFormat>: Varyings + Default;

    const IS_NONE: bool = false;

    fn of(rgb: [i32; 3]) -> Self;
    fn rgb(self) -> [i32; 3];
    fn pack<C: PixelFormat>(self) -> Self::Channels<C>;
    fn unpack<C: PixelFormat>(channels: Self::Channels<C>) -> Self;
}

sealed!(i32, ()); // [i32; 3] is sealed as channels

impl Amount for () {
    type Or<E: Amount> = E;
    type OrWhite = i32;
    type Channels<C: PixelFormat> = ();

    const IS_NONE: bool = true;

    #[inline]
    fn of(_: [i32; 3]) -> Self {}

    #[inline]
    fn rgb(self) -> [i32; 3] {
        [0; 3]
    }

    #[inline]
    fn pack<C: PixelFormat>(self) {}

    #[inline]
    fn unpack<C: PixelFormat>((): ()) {}
}

impl Amount for i32 {
    type Or<E: Amount> = E::OrWhite;
    type OrWhite = Self;
    type Channels<C: PixelFormat> = [Self; 1];

    #[inline]
    fn of([light, ..]: [i32; 3]) -> Self {
        light
    }

    #[inline]
    fn rgb(self) -> [i32; 3] {
        [self; 3]
    }

    #[inline]
    fn pack<C: PixelFormat>(self) -> [Self; 1] {
        [limited(self)]
    }

    #[inline]
    fn unpack<C: PixelFormat>([light]: [Self; 1]) -> Self {
        light
    }
}

impl Amount for [i32; 3] {
    type Or<E: Amount> = Self;
    type OrWhite = Self;
    type Channels<C: PixelFormat> = C::Channels;

    #[inline]
    fn of(rgb: Self) -> Self {
        rgb
    }

    #[inline]
    fn rgb(self) -> Self {
        self
    }

    #[inline]
    fn pack<C: PixelFormat>(self) -> C::Channels {
        let limited = each(self, limited);
        C::Channels::first(if C::Channels::IS_GRAY {
            [luma(limited); 3]
        } else {
            limited
        })
    }

    #[inline]
    fn unpack<C: PixelFormat>(channels: C::Channels) -> Self {
        channels.all()
    }
}
