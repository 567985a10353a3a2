//! Texels as sources, and masks.

use embedded_graphics::pixelcolor::{Gray8, GrayColor, PixelColor};

use super::{Output, PixelFormat, Translucent};
use crate::Error;
use crate::texture::{Argb1555, Argb4444, Blend, Sampler};

/// A texel that [`Textured`](crate::Textured) can draw: any color of embedded-graphics, a [`Translucent`] one,
/// [`Argb4444`] or [`Argb1555`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::shade::{Texel, Translucent};
/// use fixel::texture::{Argb1555, Argb4444};
/// let color = Rgb565::new(31, 0, 0);
/// assert_eq!(color.source(), Some(color));
/// assert_eq!(Argb1555::new(31, 0, 0).source(), Some(color));
/// assert_eq!(Argb4444::new(15, 15, 0, 0).source(), Some(Translucent { color, opacity: 255 }));
/// assert_eq!(Argb4444::new(0, 15, 0, 0).source(), None);
/// ```
pub trait Texel: Copy {
    /// The output for a pixel that shows this texel.
    type Source: Output;

    /// The texel as the source of a pixel; `None` for a hole.
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

/// The color and the opacity are blended separately.
impl<C: Blend> Blend for Translucent<C> {
    const WEIGHT_BITS: u32 = C::WEIGHT_BITS;

    #[inline]
    fn blend([[a, b], [c, d]]: [[Self; 2]; 2], [x, y]: [u32; 2]) -> Self {
        let gray = |texel: Self| Gray8::new(texel.opacity);
        // Weights of 1 to 15 bits, as those of Gray8.
        let weight = |weight: u32| weight << 8 >> C::WEIGHT_BITS;
        let opacities = [[gray(a), gray(b)], [gray(c), gray(d)]];
        Self {
            color: C::blend([[a.color, b.color], [c.color, d.color]], [x, y]),
            opacity: Gray8::blend(opacities, [weight(x), weight(y)]).luma(),
        }
    }
}

/// A texture whose opacities are in another texture, the mask; see [`Textured::masked`](crate::Textured::masked).
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565};
/// use fixel::{prelude::*, shade::{Masked, Translucent}, texture::Sampler};
/// static SKIN: TextureArray<Rgb565, 1, 1> = TextureArray::rgb565(&[0xf8, 0x00]);
/// static MASK: TextureArray<Gray8, 1, 1> = TextureArray::gray8(&[99]);
/// let masked = Masked::new(&SKIN, &MASK)?;
/// let texel = Translucent { color: Rgb565::new(31, 0, 0), opacity: 99 };
/// assert_eq!(masked.texel(0, 0), texel);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Masked<S, M> {
    texture: S,
    mask: M,
}

impl<S: Sampler, M: Sampler<Color: GrayColor>> Masked<S, M> {
    /// A texture with a mask of the same size: where the mask is white, the texture is opaque, and where it is black,
    /// there is a hole.
    ///
    /// # Errors
    ///
    /// [`Error::MaskSize`] if the sizes differ.
    pub fn new(texture: S, mask: M) -> Result<Self, Error> {
        let size = texture.size_log2();
        let given = mask.size_log2();
        if size != given {
            // At most 2^15.
            let pixels = |[width, height]: [u32; 2]| [1 << (width & 15), 1 << (height & 15)];
            return Err(Error::MaskSize {
                given: pixels(given),
                texture: pixels(size),
            });
        }
        Ok(Self { texture, mask })
    }
}

impl<S: Sampler<Color: PixelColor>, M: Sampler<Color: GrayColor>> Sampler for Masked<S, M> {
    type Color = Translucent<S::Color>;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.texture.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> Self::Color {
        // White is 1, 3, 15 or 255.
        let scale = 255 / M::Color::WHITE.luma().max(1);
        Translucent {
            color: self.texture.texel(u, v),
            opacity: self.mask.texel(u, v).luma().wrapping_mul(scale),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::{Gray4, Rgb565};

    #[test]
    fn a_mask_of_another_size_is_refused() {
        let (skin, mask) = ([[Rgb565::new(1, 2, 3); 4]; 2], [[Gray4::new(15); 2]; 4]);
        let error = Masked::new(&skin, &mask).unwrap_err();
        assert_eq!(
            std::format!("{error}"),
            "mask has 2x4 texels: it must have 4x2, like its texture"
        );
    }

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
