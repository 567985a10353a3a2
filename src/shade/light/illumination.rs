//! An amount of light, and which parts of it are interpolated.

use super::FULL;
use crate::sealed::{Sealed, sealed};
use crate::shade::{Channels, PixelFormat, Varyings};

/// The light at a point of a surface, in units of 2⁻¹⁶ of full brightness.
///
/// A light may exceed full brightness up to a thousand times, and be below 0, which takes away light of another one. A
/// surface limits the sum of its lights to the range from 0 to full brightness.
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
    /// The light by which the surface's color is multiplied: one number if it is white, or red, green and blue. On a
    /// gray canvas, only red is used.
    pub diffuse: D,
    /// The white of a highlight, which is added to the surface's color; `()` for no highlight.
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

impl<D: Diffuse, S: Specular> Illumination<D, S> {
    /// The sum of two amounts of light, which saturates.
    #[must_use]
    #[inline]
    pub fn plus<E: Diffuse, T: Specular>(
        self,
        other: Illumination<E, T>,
    ) -> Illumination<D::Or<E>, S::Or<T>> {
        Illumination {
            diffuse: self.diffuse.plus(other.diffuse),
            specular: self.specular.plus(other.specular),
        }
    }

    /// The same for lights of one type.
    #[inline]
    pub(super) fn join(self, other: Self) -> Self {
        Self {
            diffuse: self.diffuse.join(other.diffuse),
            specular: self.specular.join(other.specular),
        }
    }
}

/// The light, limited to the range from darkness to full brightness.
#[inline]
fn limited(light: i32) -> i32 {
    light.clamp(0, FULL)
}

/// Light that is multiplied by a surface's color: white, or red, green and blue.
///
/// White light takes one varying, colored light one for each channel of the canvas.
#[doc(hidden)]
pub trait Diffuse: Copy + Default + Sealed {
    /// This light and another one together.
    type Or<E: Diffuse>: Diffuse;

    /// The varyings on a canvas of color `C`.
    type Channels<C: PixelFormat>: Varyings + Default;

    fn white(brightness: i32) -> Self;
    fn rgb(self) -> [i32; 3];
    #[must_use]
    fn join(self, other: Self) -> Self;
    fn plus<E: Diffuse>(self, other: E) -> Self::Or<E>;
    fn pack<C: PixelFormat>(self) -> Self::Channels<C>;
    fn unpack<C: PixelFormat>(channels: Self::Channels<C>) -> Self;
}

sealed!(i32, ()); // [i32; 3] is sealed as channels

impl Diffuse for i32 {
    type Or<E: Diffuse> = E;
    type Channels<C: PixelFormat> = [Self; 1];

    #[inline]
    fn white(brightness: i32) -> Self {
        brightness
    }

    #[inline]
    fn rgb(self) -> [i32; 3] {
        [self; 3]
    }

    #[inline]
    fn join(self, other: Self) -> Self {
        self.saturating_add(other)
    }

    #[inline]
    fn plus<E: Diffuse>(self, other: E) -> E {
        other.join(E::white(self))
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

impl Diffuse for [i32; 3] {
    type Or<E: Diffuse> = Self;
    type Channels<C: PixelFormat> = C::Channels;

    #[inline]
    fn white(brightness: i32) -> Self {
        [brightness; 3]
    }

    #[inline]
    fn rgb(self) -> Self {
        self
    }

    #[inline]
    fn join(self, other: Self) -> Self {
        let ([r, g, b], [x, y, z]) = (self, other);
        [
            r.saturating_add(x),
            g.saturating_add(y),
            b.saturating_add(z),
        ]
    }

    #[inline]
    fn plus<E: Diffuse>(self, other: E) -> Self {
        self.join(other.rgb())
    }

    #[inline]
    fn pack<C: PixelFormat>(self) -> C::Channels {
        let [r, g, b] = self;
        C::Channels::of_rgb([limited(r), limited(g), limited(b)])
    }

    #[inline]
    fn unpack<C: PixelFormat>(channels: C::Channels) -> Self {
        channels.all()
    }
}

/// A highlight, which takes one varying, or none.
#[doc(hidden)]
pub trait Specular: Copy + Default + Sealed {
    /// This highlight and another one together.
    type Or<T: Specular>: Specular;

    type Channels: Varyings + Default;

    fn number(self) -> Option<i32>;
    #[must_use]
    fn join(self, other: Self) -> Self;
    fn plus<T: Specular>(self, other: T) -> Self::Or<T>;
    fn pack(self) -> Self::Channels;
    fn unpack(channels: Self::Channels) -> Self;
}

impl Specular for () {
    type Or<T: Specular> = T;
    type Channels = ();

    #[inline]
    fn number(self) -> Option<i32> {
        None
    }

    #[inline]
    fn join(self, (): ()) {}

    #[inline]
    fn plus<T: Specular>(self, other: T) -> T {
        other
    }

    #[inline]
    fn pack(self) {}

    #[inline]
    fn unpack((): ()) {}
}

impl Specular for i32 {
    type Or<T: Specular> = Self;
    type Channels = [Self; 1];

    #[inline]
    fn number(self) -> Option<i32> {
        Some(self)
    }

    #[inline]
    fn join(self, other: Self) -> Self {
        self.saturating_add(other)
    }

    #[inline]
    fn plus<T: Specular>(self, other: T) -> Self {
        self.saturating_add(other.number().unwrap_or_default())
    }

    #[inline]
    fn pack(self) -> [Self; 1] {
        [limited(self)]
    }

    #[inline]
    fn unpack([specular]: [Self; 1]) -> Self {
        specular
    }
}
