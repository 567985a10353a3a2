//! Textures of 8-bit indices whose size is known at run time.

use super::Sampler;
use super::sampler::Grid;
use crate::Error;
use crate::error::ok;

/// A texture with one byte per texel, an index into 256 colors; its size is known at run time.
///
/// It borrows both the indices and the colors.
///
/// Sizes, the order of texels and the cost are the same as for [`Texture`](super::Texture). The same macros create
/// it, from a file with a color table; [`PaletteArray::as_palette`](super::PaletteArray::as_palette) borrows an array
/// as a palette.
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::{prelude::*, texture::Sampler};
/// static TILES: Palette<Rgb565> = include_texture!("samples/tiles.bmp");
/// assert_eq!((TILES.width(), TILES.height()), (4, 2));
/// assert_eq!(TILES.indices()[..4], [0, 1, 2, 3]);
/// assert_eq!((&TILES).texel(1, 0), Rgb565::new(31, 0, 0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Palette<'a, C> {
    indices: Grid<'a, u8>,
    colors: &'a [C; 256],
}

impl<'a, C: Copy> Palette<'a, C> {
    /// A texture of `indices` into `colors`, row by row from the top.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use fixel::{prelude::*, texture};
    /// static COLORS: [Rgb565; 256] = texture::palette_colors(&[Rgb565::BLACK, Rgb565::WHITE]);
    /// let tiles = Palette::new(&[0, 1, 1, 0], &COLORS, 2, 2)?;
    /// let error = Palette::new(&[0, 1, 1], &COLORS, 2, 2).unwrap_err();
    /// assert_eq!(error.to_string(), "slice has 3 elements: exactly 4 are needed");
    /// # let _ = tiles;
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large;
    /// [`Error::Length`] if the number of indices is not their product.
    pub const fn new(
        indices: &'a [u8],
        colors: &'a [C; 256],
        width: u32,
        height: u32,
    ) -> Result<Self, Error> {
        let indices = ok!(Grid::new(indices, width, height));
        Ok(Self::of(indices, colors))
    }

    pub(super) const fn of(indices: Grid<'a, u8>, colors: &'a [C; 256]) -> Self {
        Self { indices, colors }
    }

    /// The indices, row by row from the top.
    #[must_use]
    pub const fn indices(&self) -> &'a [u8] {
        self.indices.entries()
    }

    /// The colors, one for each index.
    #[must_use]
    pub const fn colors(&self) -> &'a [C; 256] {
        self.colors
    }

    /// The same texture with other colors, for example darker ones.
    #[must_use]
    pub const fn with_colors(self, colors: &'a [C; 256]) -> Self {
        Self { colors, ..self }
    }

    /// Number of columns.
    #[must_use]
    pub const fn width(&self) -> u32 {
        1 << self.indices.size_log2()[0]
    }

    /// Number of rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        1 << self.indices.size_log2()[1]
    }
}

/// A color for each of 256 indices: the given colors, and their last one for all further indices.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::texture::palette_colors;
/// let colors = palette_colors(&[Gray8::new(3), Gray8::new(5)]);
/// assert_eq!([0, 1, 2, 255].map(|index| colors[index]), [3, 5, 5, 5].map(Gray8::new));
/// ```
///
/// An empty list, or one of more than 256 colors, does not compile.
#[must_use]
pub const fn palette_colors<C: Copy, const COLORS: usize>(colors: &[C; COLORS]) -> [C; 256] {
    const {
        assert!(
            COLORS >= 1 && COLORS <= 256,
            "a palette must have 1 to 256 colors: write that many in the list of colors"
        );
    }
    let mut all = [colors[COLORS - 1]; 256];
    let mut i = 0;
    while i < COLORS {
        all[i] = colors[i];
        i += 1;
    }
    all
}

impl<C: Copy> Sampler for Palette<'_, C> {
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.indices.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        self.colors[usize::from(self.indices.get(u, v).unwrap_or(0))]
    }
}
