//! Textures of indices into a table of colors.

use embedded_graphics::pixelcolor::{Gray2, Gray4, Gray8, GrayColor};

use super::Sampler;

/// A texture with texels that are indices into a table of colors: one byte per texel instead of two or three.
///
/// `indices` is any sampler of bytes, such as a reference to rows or a [`Texture<u8>`](super::Texture). For indices of
/// four or two bits, use [`Raw<Gray4>`](super::Raw) or `Raw<Gray2>`. `colors` has 1 to 256 colors. An index beyond the
/// last color shows the last color. With 256 colors, the default, no index is beyond the last color, so the program
/// does not check. To draw the same texture darker or in other colors, replace `colors`.
///
/// [`include_texture!`](crate::include_texture) makes an `Indexed` texture from a picture with few colors.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::{Window, prelude::*, texture::Indexed};
/// static TILES: [[u8; 2]; 2] = [[0, 1], [1, 2]];
/// static COLORS: [Rgb565; 3] = [Rgb565::BLACK, Rgb565::RED, Rgb565::WHITE];
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::GREEN; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// canvas.draw(&SQUARE, &mvp, &Textured::new(Indexed { indices: &TILES, colors: &COLORS }));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["KKRR", "KKRR", "RRWW", "RRWW"]);
/// # Ok::<(), Error>(())
/// ```
///
/// An empty table of colors does not compile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Indexed<'a, S, C, const COLORS: usize = 256> {
    /// The texels.
    pub indices: S,
    /// The color for each index.
    pub colors: &'a [C; COLORS],
}

/// A type of texel that can be an index into a table of colors: a number of at most eight bits.
pub trait PaletteIndex: Copy {
    fn index(self) -> u8;
}

impl PaletteIndex for u8 {
    #[inline]
    fn index(self) -> u8 {
        self
    }
}

impl PaletteIndex for Gray2 {
    #[inline]
    fn index(self) -> u8 {
        self.luma()
    }
}

impl PaletteIndex for Gray4 {
    #[inline]
    fn index(self) -> u8 {
        self.luma()
    }
}

impl PaletteIndex for Gray8 {
    #[inline]
    fn index(self) -> u8 {
        self.luma()
    }
}

impl<S: Sampler<Color: PaletteIndex>, C: Copy, const COLORS: usize> Sampler
    for Indexed<'_, S, C, COLORS>
{
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.indices.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        self.texel_at(0, u, v)
    }

    #[inline]
    fn texel_at(&self, level: u32, u: i32, v: i32) -> C {
        const { assert!(COLORS > 0, "a table has at least one color") };
        let index = self.indices.texel_at(level, u, v).index();
        self.colors[usize::from(index).min(COLORS - 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Raw, Texture};
    use super::*;

    #[test]
    fn indices_beyond_the_colors_show_the_last() {
        let texture = Indexed {
            indices: &[[1, 255]],
            colors: &[5, 6],
        };
        assert_eq!([0, 1, -1].map(|u| texture.texel(u, 7)), [6; 3]);
        let colors = core::array::from_fn(|at| at);
        let texture: Indexed<_, _> = Indexed {
            colors: &colors,
            indices: texture.indices,
        };
        assert_eq!([0, 1].map(|u| texture.texel(u, 0)), [1, 255]);
    }

    #[test]
    fn indices_may_have_two_four_or_eight_bits() {
        let colors = &core::array::from_fn::<_, 16, _>(|at| 10 * at);
        let bytes = [0x1b, 0xe4];
        let two = Raw::<Gray2>::new(&bytes, 4, 2).unwrap();
        let two = Indexed {
            indices: two,
            colors,
        };
        assert_eq!([0, 1, 2, 3].map(|u| two.texel(u, 0)), [0, 10, 20, 30]);
        let four = Raw::<Gray4>::new(&bytes, 2, 2).unwrap();
        let four = Indexed {
            indices: four,
            colors,
        };
        assert_eq!([0, 1].map(|u| four.texel(u, 1)), [140, 40]);
        let eight = Texture::new(&[3, 9], 2, 1).unwrap();
        let eight = Indexed {
            indices: eight,
            colors,
        };
        assert_eq!([0, 1].map(|u| eight.texel(u, 0)), [30, 90]);
    }
}
