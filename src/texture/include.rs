//! Textures that [`include_texture!`](crate::include_texture) makes of files.

pub use super::color::*;
use super::sampler::{self, Grid};
use super::{Mipmap, MipmapArray, Palette, PaletteArray, Texture, TextureArray};
use crate::message;

/// A picture that the macro has read.
///
/// A trait's functions cannot run at compile time, but its constants can depend on types. So the macro declares a
/// type for the picture, the compiler infers the color's type from the place of the macro, and a constant of the two
/// holds the converted pixels. The macro implements [`Convert`] for each color; only the one that is used is computed.
pub trait File {
    /// The file's name, for errors.
    const PATH: &'static str;
    /// Columns and rows, which a texture may have.
    const SIZE: [u32; 2];
    /// The pixels, row by row, as indices of colors; of a mipmap, those of all levels.
    const PIXELS: Pixels;
}

/// Indices of colors.
#[derive(Clone, Copy, Debug)]
pub enum Pixels {
    /// A byte each.
    Bytes(&'static [u8]),
    /// Three bytes each, the low one first.
    Words(&'static [u8]),
}

/// A color, and the `N` pixels of picture `F` in it.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a texture of `{Self}`",
    label = "`{Self}` is not a color of embedded-graphics",
    note = "write a color of embedded-graphics, such as `Texture<Rgb565>` or `Texture<Gray8>`, or `Argb1555` or `Argb4444`"
)]
pub trait Convert<F: File, const N: usize>: Copy + 'static {
    /// The pixels, row by row.
    const TEXELS: &'static [Self; N];
    /// The colors that occur, and their last one for all further indices.
    const COLORS: &'static [Self; 256];
}

/// A texture that can be created from picture `F` with `N` pixels.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a `{Self}`",
    label = "expected a texture in a color of embedded-graphics",
    note = "write the type as `Texture<Rgb565>`, `TextureArray<Rgb565, WIDTH, HEIGHT>`, `Palette<Rgb565>`, `PaletteArray<Rgb565, WIDTH, HEIGHT>` or `Mipmap<Rgb565>`"
)]
pub trait FromFile<F: File, const N: usize>: Sized {
    /// The texture.
    const VALUE: Self;
}

/// Entries, row by row, as a grid of the picture's size.
const fn grid<F: File, T: Copy>(entries: &[T]) -> Grid<'_, T> {
    let [width, height] = F::SIZE;
    message::checked(Grid::new(entries, width, height), F::PATH)
}

/// Entries, row by row, as an array of rows; the picture must have the size `W` x `H`.
const fn rows<F: File, T: Copy, const W: usize, const H: usize>(entries: &[T]) -> [[T; W]; H] {
    let [width, height] = F::SIZE;
    if width as usize != W || height as usize != H {
        message::wrong_size(F::PATH, F::SIZE, [W, H]);
    }
    sampler::rows(entries)
}

/// The pixels as indices of a byte.
const fn indices<F: File>() -> &'static [u8] {
    match F::PIXELS {
        Pixels::Bytes(indices) => indices,
        Pixels::Words(_) => {
            panic!("the picture has more than 256 colors: a palette has at most 256")
        }
    }
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for &'static [C] {
    const VALUE: Self = C::TEXELS;
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Texture<'static, C> {
    const VALUE: Self = Texture::of(grid::<F, C>(C::TEXELS));
}

impl<F: File, C: Convert<F, N>, const N: usize, const W: usize, const H: usize> FromFile<F, N>
    for TextureArray<C, W, H>
{
    const VALUE: Self = TextureArray::from_texels(rows::<F, C, W, H>(C::TEXELS));
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Palette<'static, C> {
    const VALUE: Self = Palette::of(grid::<F, u8>(indices::<F>()), C::COLORS);
}

impl<F: File, C: Convert<F, N>, const N: usize, const W: usize, const H: usize> FromFile<F, N>
    for PaletteArray<C, W, H>
{
    const VALUE: Self = PaletteArray::from_rows(rows::<F, u8, W, H>(indices::<F>()), *C::COLORS);
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Mipmap<'static, C> {
    const VALUE: Self = {
        let [width, height] = F::SIZE;
        message::checked(Mipmap::new(C::TEXELS, width, height), F::PATH)
    };
}

impl<F: File, C: Convert<F, N>, const N: usize, const W: usize, const H: usize> FromFile<F, N>
    for MipmapArray<C, W, H, N>
{
    const VALUE: Self = {
        let [width, height] = F::SIZE;
        if width as usize != W || height as usize != H {
            message::wrong_size(F::PATH, F::SIZE, [W, H]);
        }
        MipmapArray::from_texels(*C::TEXELS)
    };
}
