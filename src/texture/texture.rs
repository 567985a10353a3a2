//! Textures whose size is not in the type.

use embedded_graphics::pixelcolor::PixelColor;

use super::Sampler;
use super::sampler::Grid;
use crate::Error;

/// A texture: texels that are kept elsewhere, of a size that the program knows at run time.
///
/// Width and height are powers of two, at most [`MAX_TEXTURE_SIZE`](super::MAX_TEXTURE_SIZE). The texels lie row by row, the
/// top row first. [`include_bmp!`](crate::include_bmp) and [`include_tga!`](crate::include_tga) make a texture of
/// a file while compiling; a [`TextureArray`](super::TextureArray) becomes one by
/// [`as_texture`](super::TextureArray::as_texture); [`new`](Self::new) takes a slice. Textures of different sizes fit in
/// one list:
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static BRICK: Texture<Rgb565> = include_bmp!("samples/brick.bmp");
/// static STRIPES: TextureArray<Rgb565, 2, 1> = TextureArray::rgb565(&[0xf8, 0x00, 0x00, 0x1f]);
/// static SKINS: [Texture<Rgb565>; 2] = [BRICK, STRIPES.as_texture()];
/// assert_eq!(SKINS.map(|skin| (skin.width(), skin.height())), [(8, 4), (2, 1)]);
/// let shader = Textured::new(&SKINS[1]);
/// # let _ = shader;
/// ```
///
/// # Cost
///
/// COST
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texture<'a, C> {
    grid: Grid<'a, C>,
    /// What an empty slice would show; there is none.
    first: C,
}

impl<'a, C: Copy> Texture<'a, C> {
    /// A texture of `texels`, row by row from the top.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::prelude::*;
    /// let texels = [Gray8::new(0); 64];
    /// let skin = Texture::new(&texels, 16, 4)?;
    /// assert_eq!((skin.width(), skin.height()), (16, 4));
    /// let error = Texture::new(&texels, 16, 8).unwrap_err();
    /// assert_eq!(error.to_string(), "slice has 64 elements: exactly 128 are needed");
    /// let error = Texture::new(&texels, 64, 0).unwrap_err();
    /// assert_eq!(error.to_string(), "height is 0: it must be a power of two, at most 32768");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large;
    /// [`Error::Length`] if the number of texels is not their product.
    pub const fn new(texels: &'a [C], width: u32, height: u32) -> Result<Self, Error> {
        match Grid::new(texels, width, height) {
            Ok(grid) => Ok(Self::of(grid)),
            Err(error) => Err(error),
        }
    }

    pub(super) const fn of(grid: Grid<'a, C>) -> Self {
        let first = grid.entries()[0];
        Self { grid, first }
    }

    /// The texels, row by row from the top.
    #[must_use]
    pub const fn texels(&self) -> &'a [C] {
        self.grid.entries()
    }

    /// Number of columns.
    #[must_use]
    pub const fn width(&self) -> u32 {
        1 << self.grid.width_log2()
    }

    /// Number of rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        1 << self.grid.height_log2()
    }
}

impl<C: PixelColor> Sampler for Texture<'_, C> {
    type Color = C;

    #[inline]
    fn width_log2(&self) -> u32 {
        self.grid.width_log2()
    }

    #[inline]
    fn height_log2(&self) -> u32 {
        self.grid.height_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        self.grid.get(u, v).unwrap_or(self.first)
    }
}

impl<C: PixelColor> Sampler for &Texture<'_, C> {
    type Color = C;

    #[inline]
    fn width_log2(&self) -> u32 {
        self.grid.width_log2()
    }

    #[inline]
    fn height_log2(&self) -> u32 {
        self.grid.height_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        (**self).texel(u, v)
    }
}
