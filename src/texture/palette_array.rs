//! Textures of 8-bit indices that own them.

use super::sampler::{Grid, rows, sampler_of_rows, size_log2, wrapped};
use super::{Palette, Sampler, palette_colors};
use crate::message;

/// A texture with one byte per texel, an index into its own 256 colors; its size is part of the type.
///
/// There are `H` rows of `W` indices.
///
/// The rules for sizes are the same as for [`TextureArray`](super::TextureArray). [`as_palette`](Self::as_palette)
/// borrows it as a [`Palette`].
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::prelude::*;
/// static TILES: PaletteArray<Rgb565, 2, 2> =
///     PaletteArray::new(&[0, 1, 1, 2], &[Rgb565::BLACK, Rgb565::RED, Rgb565::WHITE]);
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::GREEN; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// canvas.draw(&SQUARE, &mvp, &Textured::new(&TILES));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["KKRR", "KKRR", "RRWW", "RRWW"]);
/// # Ok::<(), Error>(())
/// ```
///
/// Too few or too many indices do not compile, nor do zero colors or more than 256:
///
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static TILES: PaletteArray<Rgb565, 2, 2> = PaletteArray::new(&[0, 1, 1], &[Rgb565::new(0, 0, 0)]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct PaletteArray<C, const W: usize, const H: usize> {
    indices: [[u8; W]; H],
    colors: [C; 256],
}

impl<C: Copy, const W: usize, const H: usize> PaletteArray<C, W, H> {
    /// A texture of indices, row by row from the top, with 1 to 256 colors. Indices beyond the last color show the
    /// last color.
    #[must_use]
    pub const fn new<const LENGTH: usize, const COLORS: usize>(
        indices: &[u8; LENGTH],
        colors: &[C; COLORS],
    ) -> Self {
        const {
            if LENGTH != W * H {
                message::wrong_length([W, H], "indices", LENGTH, W * H);
            }
        }
        Self::from_rows(rows(indices), palette_colors(colors))
    }

    pub(super) const fn from_rows(indices: [[u8; W]; H], colors: [C; 256]) -> Self {
        const { size_log2::<W, H>() };
        Self { indices, colors }
    }

    /// Borrows the texture as a [`Palette`], whose size is not part of the type.
    #[must_use]
    pub const fn as_palette(&self) -> Palette<'_, C> {
        Palette::of(Grid::of(&self.indices), &self.colors)
    }

    /// The colors, one for each index.
    #[must_use]
    pub const fn colors(&self) -> &[C; 256] {
        &self.colors
    }

    /// The same texture with other colors, for example darker ones.
    #[must_use]
    pub const fn with_colors(self, colors: [C; 256]) -> Self {
        Self { colors, ..self }
    }
}

sampler_of_rows!(PaletteArray<C, W, H>, |array, u, v| {
    array.colors[usize::from(wrapped(&array.indices, u, v))]
});

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::Gray8;

    #[test]
    fn indices_beyond_the_colors_show_the_last() {
        let palette: PaletteArray<_, 2, 1> =
            PaletteArray::new(&[1, 255], &[Gray8::new(5), Gray8::new(6)]);
        assert_eq!((&palette).texel(0, 7), Gray8::new(6));
        assert_eq!((&palette).texel(-1, 0), Gray8::new(6));
        let palette = palette.with_colors([Gray8::new(9); 256]);
        assert_eq!((&palette).texel(1, 0), Gray8::new(9));
    }
}
