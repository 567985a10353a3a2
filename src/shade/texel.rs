//! Texels, and what a shader outputs for them.

use embedded_graphics::pixelcolor::{Gray8, GrayColor, PixelColor};

use super::{Output, PixelFormat, Translucent};
use crate::texture::{Argb1555, Argb4444, Blend, OrHole};

/// A texel that [`Textured`](crate::Textured) can draw: any color of embedded-graphics, a [`Translucent`] color,
/// [`Argb4444`] or [`Argb1555`].
#[doc(hidden)]
pub trait Texel: Copy {
    /// The type of the output for a pixel that shows this texel.
    type Source: Output;

    /// The output for a pixel that shows this texel; `None` for a hole.
    fn source(self) -> Option<Self::Source>;
}

impl<C: PixelColor> Texel for C {
    type Source = C;

    #[inline]
    fn source(self) -> Option<C> {
        Some(self)
    }
}

impl<C: PixelFormat> Texel for Translucent<C> {
    type Source = Self;

    #[inline]
    fn source(self) -> Option<Self> {
        (self.opacity > 0).then_some(self)
    }
}

impl Texel for Argb4444 {
    type Source = Translucent<embedded_graphics::pixelcolor::Rgb565>;

    #[inline]
    fn source(self) -> Option<Self::Source> {
        let (color, opacity) = (self.color(), self.opacity());
        Translucent { color, opacity }.source()
    }
}

impl Texel for Argb1555 {
    type Source = embedded_graphics::pixelcolor::Rgb565;

    #[inline]
    fn source(self) -> Option<Self::Source> {
        self.color()
    }
}

impl<T: Texel> Texel for OrHole<T> {
    type Source = T::Source;

    #[inline]
    fn source(self) -> Option<T::Source> {
        self.0?.source()
    }
}

/// The color and the opacity are blended separately.
impl<C: Blend> Blend for Translucent<C> {
    const WEIGHT_BITS: u32 = C::WEIGHT_BITS;

    #[inline]
    fn blend([[a, b], [c, d]]: [[Self; 2]; 2], [x, y]: [u32; 2]) -> Self {
        let gray = |texel: Self| Gray8::new(texel.opacity);
        // Converts a weight of 1 to 15 bits to the 8 bits of a weight of Gray8.
        let weight = |weight: u32| weight << 8 >> C::WEIGHT_BITS;
        let opacities = [[gray(a), gray(b)], [gray(c), gray(d)]];
        Self {
            color: C::blend([[a.color, b.color], [c.color, d.color]], [x, y]),
            opacity: Gray8::blend(opacities, [weight(x), weight(y)]).luma(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::Rgb565;

    #[test]
    fn colors_and_opacities_are_blended_each_for_itself() {
        let texel = |red, opacity| Translucent {
            color: Rgb565::new(red, 0, 0),
            opacity,
        };
        let [a, b] = [texel(0, 255), texel(31, 55)];
        // A quarter of the way.
        assert_eq!(a.mix(b, 8), texel(8, 205));
        assert_eq!([a.mix(b, 0), a.mix(b, 32)], [a, b]);
    }
}
