//! Textures whose size is known at run time.

use super::Sampler;
use super::sampler::Grid;
use crate::Error;
use crate::error::ok;

/// A texture that borrows its texels; its size is known at run time.
///
/// Width and height are powers of two, at most [`MAX_TEXTURE_SIZE`](super::MAX_TEXTURE_SIZE). The texels lie row by
/// row, the top row first. There are three ways to create one: [`include_texture!`](crate::include_texture)
/// converts a picture file at compile time; [`TextureArray::as_texture`](super::TextureArray::as_texture) borrows an array as a texture; [`new`](Self::new)
/// takes a slice. Textures of different sizes fit in one list:
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static BRICK: Texture<Rgb565> = include_texture!("samples/brick.bmp");
/// static STRIPES: TextureArray<Rgb565, 2, 1> = TextureArray::rgb565(&[0xf8, 0x00, 0x00, 0x1f]);
/// static SKINS: [Texture<Rgb565>; 2] = [BRICK, STRIPES.as_texture()];
/// assert_eq!(SKINS.map(|skin| (skin.width(), skin.height())), [(8, 4), (2, 1)]);
/// let shader = Textured::new(&SKINS[1]);
/// # let _ = shader;
/// ```
///
/// # Cost
///
/// Reading a texel takes a shift and two masks more than with a [`TextureArray`](super::TextureArray), and more
/// registers. The table lists instructions per frame for the benchmark's floor: 47,610 pixels with a 64x64 texture. A
/// shader holds either the texture itself, `Textured::new(SKIN)`, or a reference to it; with a reference, the size is
/// read again at each pixel:
///
/// | | `TextureArray` | `Texture` | `&Texture` |
/// |---|---:|---:|---:|
/// | Cortex-M4, `Newton` | 1,386,960 | 1,538,720 | 2,387,200 |
/// | Cortex-M4, `Affine` | 1,202,040 | 1,406,040 | 2,060,960 |
/// | Cortex-M0+, `Newton` | 2,787,600 | 3,007,200 | 3,514,680 |
/// | Cortex-M0+, `Affine` | 2,180,000 | 2,247,480 | 2,992,280 |
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Texture<'a, C> {
    grid: Grid<'a, C>,
    /// The color for an empty slice, which cannot occur.
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
    /// assert_eq!(error.to_string(), "height is 0: it must be a power of two, at most 32768, such as 1");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large;
    /// [`Error::Length`] if the number of texels is not their product.
    pub const fn new(texels: &'a [C], width: u32, height: u32) -> Result<Self, Error> {
        let grid = ok!(Grid::new(texels, width, height));
        Ok(Self::of(grid))
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
        1 << self.grid.size_log2()[0]
    }

    /// Number of rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        1 << self.grid.size_log2()[1]
    }
}

impl<C: Copy> Sampler for Texture<'_, C> {
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.grid.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        self.grid.get(u, v).unwrap_or(self.first)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Clamp, Repeat};
    use super::*;
    use crate::texture::{Bilinear, Filter, Nearest, PaletteArray, TextureArray};
    use embedded_graphics::pixelcolor::Rgb565;

    /// Points in sixteenths of a texel, in several repeats and far beyond.
    fn points() -> impl Iterator<Item = [i32; 2]> {
        let ends = [i32::MIN, i32::MIN + 1, i32::MAX];
        let along = move || (-40..200).step_by(3).map(|at| at << 12).chain(ends);
        along().flat_map(move |v| along().map(move |u| [u, v]))
    }

    fn same<S: Sampler<Color = Rgb565>, T: Sampler<Color = Rgb565>>(one: &S, other: &T) {
        assert_eq!(one.size_log2(), other.size_log2());
        for at in points() {
            let near = Nearest.color::<_, Clamp>(one, at);
            assert_eq!(near, Nearest.color::<_, Clamp>(other, at), "{at:?}");
            let near = Nearest.color::<_, Repeat>(one, at);
            assert_eq!(near, Nearest.color::<_, Repeat>(other, at), "{at:?}");
            let blended = Bilinear.color::<_, Clamp>(one, at);
            assert_eq!(blended, Bilinear.color::<_, Clamp>(other, at), "{at:?}");
        }
    }

    #[test]
    fn every_color_equals_that_of_an_array() {
        fn compare<const W: usize, const H: usize>() {
            let (mut texels, mut indices) = ([[Rgb565::new(0, 0, 0); W]; H], [[0; W]; H]);
            let mut colors = [Rgb565::new(0, 0, 0); 256];
            for (at, texel) in texels.as_flattened_mut().iter_mut().enumerate() {
                *texel = Rgb565::new(at as u8, (at * 7) as u8, (at * 5) as u8);
            }
            for (at, index) in indices.as_flattened_mut().iter_mut().enumerate() {
                *index = (at * 37) as u8;
            }
            for (at, color) in (0..=255).zip(&mut colors) {
                *color = Rgb565::new(at, at >> 2, 31 - (at >> 3));
            }
            let array = TextureArray::from_texels(texels);
            same(&&array, &array.as_texture());
            same(&&array, &&array.as_texture());
            let array = PaletteArray::from_rows(indices, colors);
            same(&&array, &array.as_palette());
            same(&&array, &&array.as_palette());
        }
        compare::<8, 2>();
        compare::<1, 4>();
        compare::<1, 1>();
    }
}
