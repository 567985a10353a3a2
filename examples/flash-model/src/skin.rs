//! A texture in flash.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::RawU16;
use fixel::Texture;
use fixel::texture::Sampler;

use crate::header::TextureRecord;

/// A texture that stores each texel as the 16 bits of an `Rgb565`. (Without `unsafe`, words cannot be borrowed as a
/// slice of `Rgb565`.)
#[derive(Clone, Copy, Debug)]
pub struct Skin<'a>(Texture<'a, u16>);

impl<'a> Skin<'a> {
    /// Returns the texture that a record describes. Returns `None` if the texture would reach beyond the texels, or if
    /// its width or height is not valid.
    pub(crate) fn new(&[width, height, first]: &TextureRecord, texels: &'a [u16]) -> Option<Self> {
        let count = width.checked_mul(height)? as usize;
        let texels = texels.get(first as usize..)?.get(..count)?;
        Texture::new(texels, width, height).ok().map(Self)
    }
}

impl Sampler for Skin<'_> {
    type Color = Rgb565;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.0.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> Rgb565 {
        RawU16::new(self.0.texel(u, v)).into()
    }
}
