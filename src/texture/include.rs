//! Textures that [`include_texture!`](crate::include_texture) makes of files.

use super::{Indexed, Mipmap, Texture};
use crate::message;

/// A picture that the macro has read.
///
/// A trait's functions cannot run at compile time, but its constants can depend on types. So the macro declares a
/// type for the picture, the compiler infers the color's type from the place of the macro, and a constant of the two
/// holds the converted pixels.
pub trait File {
    /// The file's name, for errors.
    const PATH: &'static str;
    /// Columns and rows, which a texture may have.
    const SIZE: [u32; 2];
    /// The colors that occur: red, green, blue and alpha of each.
    const COLORS: &'static [u8];
    /// The pixels, row by row, as indices of colors; of a mipmap, those of all levels. An index has a byte or, if there
    /// are more than 256 colors, three bytes, the low one first.
    const PIXELS: &'static [u8];
}

/// A color, and the `N` pixels of picture `F` in it.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a texture of `{Self}`",
    label = "`{Self}` is not a color of embedded-graphics",
    note = "write a color of embedded-graphics, such as `Texture<Rgb565>` or `Texture<Gray8>`, or `Argb1555` or `Argb4444`"
)]
pub trait Convert<F: File, const N: usize>: Copy + 'static {
    /// The first colors, as many as there is room for, and the last one for all further indices.
    const TABLE: &'static [Self; N];
    /// The pixels, row by row.
    const TEXELS: &'static [Self; N];
}

/// A texture that can be created from picture `F` with `N` pixels.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a `{Self}`",
    label = "expected a texture in a color of embedded-graphics",
    note = "write the type as `Texture<Rgb565>`, `[[Rgb565; WIDTH]; HEIGHT]`, `Indexed<Texture<u8>, Rgb565>` or `Mipmap<Rgb565>`"
)]
pub trait FromFile<F: File, const N: usize>: Sized {
    /// The texture.
    const VALUE: Self;
}

/// The colors of pixels: in `few` if indices have a byte, in `many` otherwise.
pub(super) const fn texels<C: Copy, const N: usize>(
    mut pixels: &[u8],
    few: &[C],
    many: &[C; N],
) -> [C; N] {
    let (mut texels, has_few) = (*many, pixels.len() == N);
    let mut at = 0;
    // Patterns, because in the compiler, an index takes as long as several of them.
    while at < N {
        texels[at] = match *pixels {
            [index, ref rest @ ..] if has_few => {
                pixels = rest;
                few[index as usize]
            }
            [a, b, c, ref rest @ ..] => {
                pixels = rest;
                many[a as usize | (b as usize) << 8 | (c as usize) << 16]
            }
            _ => break,
        };
        at += 1;
    }
    texels
}

/// A texture of all pixels, row by row.
const fn texture<F: File, T: Copy>(pixels: &[T]) -> Texture<'_, T> {
    let [width, height] = F::SIZE;
    message::checked(Texture::new(pixels, width, height), F::PATH)
}

/// All pixels as rows; the picture must have the size `W` x `H`.
const fn rows<F: File, T: Copy, const W: usize, const H: usize>(pixels: &[T]) -> &[[T; W]; H] {
    let [width, height] = F::SIZE;
    match pixels.as_chunks().0.first_chunk() {
        Some(rows) if width as usize == W && height as usize == H => rows,
        _ => message::wrong_size(F::PATH, F::SIZE, [W, H]),
    }
}

/// The pixels as indices of at most `K` colors.
const fn indices<F: File, const N: usize, const K: usize>() -> &'static [u8] {
    let colors = F::COLORS.len() / 4;
    if colors > K || F::PIXELS.len() != N {
        message::too_many_colors(F::PATH, colors, K);
    }
    F::PIXELS
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for &'static [C] {
    const VALUE: Self = C::TEXELS;
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Texture<'static, C> {
    const VALUE: Self = texture::<F, C>(C::TEXELS);
}

impl<F: File, C: Convert<F, N>, const N: usize, const W: usize, const H: usize> FromFile<F, N>
    for [[C; W]; H]
{
    const VALUE: Self = *rows::<F, C, W, H>(C::TEXELS);
}

impl<F: File, C: Convert<F, K>, const N: usize, const K: usize> FromFile<F, N>
    for Indexed<'static, Texture<'static, u8>, C, K>
{
    const VALUE: Self = Self {
        indices: texture::<F, u8>(indices::<F, N, K>()),
        colors: C::TABLE,
    };
}

impl<F: File, C: Convert<F, K>, const N: usize, const K: usize, const W: usize, const H: usize>
    FromFile<F, N> for Indexed<'static, &'static [[u8; W]; H], C, K>
{
    const VALUE: Self = Self {
        indices: rows::<F, u8, W, H>(indices::<F, N, K>()),
        colors: C::TABLE,
    };
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Mipmap<'static, C> {
    const VALUE: Self = {
        let [width, height] = F::SIZE;
        message::checked(Mipmap::new(C::TEXELS, width, height), F::PATH)
    };
}
