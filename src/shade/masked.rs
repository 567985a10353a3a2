//! Textures whose opacities are in another texture.

use embedded_graphics::pixelcolor::{GrayColor, PixelColor};

use super::Translucent;
use crate::Error;
use crate::texture::Sampler;

/// A texture whose opacities are in another texture, the mask; see [`Textured::masked`](crate::Textured::masked).
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Masked<S, M> {
    texture: S,
    mask: M,
}

impl<S: Sampler<Color: PixelColor>, M: Sampler<Color: GrayColor>> Masked<S, M> {
    /// Errors: [`Error::MaskSize`] if the sizes differ.
    pub(super) fn new(texture: S, mask: M) -> Result<Self, Error> {
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
        self.texel_at(0, u, v)
    }

    #[inline]
    fn texel_at(&self, level: u32, u: i32, v: i32) -> Self::Color {
        // White is 1, 3, 15 or 255.
        let scale = 255 / M::Color::WHITE.luma().max(1);
        let mask = self.mask.texel_at(level, u, v);
        Translucent {
            color: self.texture.texel_at(level, u, v),
            opacity: mask.luma().wrapping_mul(scale),
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
}
