//! Textures that [`include_texture!`](crate::include_texture) makes of files.

use super::{Indexed, Mipmap, Texture};
use crate::message;

/// A picture that [`include_texture!`](crate::include_texture) has read.
///
/// A trait's functions cannot run at compile time, but its constants can depend on types. So the macro declares a type
/// for the picture, the compiler infers the color's type from the place of the macro, and a constant that depends on
/// both types holds the converted pixels.
pub trait File {
    /// The file's name, for errors.
    const PATH: &'static str;
    /// The numbers of columns and rows. A texture may have this size.
    const SIZE: [u32; 2];
    /// The colors that occur in the picture, at least one. The bytes of a color are: red, green and blue with 5 bits
    /// each, then with 6 bits each, then with 8 bits each; luma with 1, 2, 4 and 8 bits; and the bits of `Argb1555` and
    /// of `Argb4444`, the high byte first.
    const COLORS: &'static [[u8; 17]];
    /// The pixels, row by row, as indices of colors; for a mipmap, the pixels of all levels. An index has one byte or,
    /// if there are more than 256 colors, three bytes, the low byte first.
    const PIXELS: &'static [u8];
}

/// A type of texel that picture `F`, which has `N` pixels, converts to: a color, or `u8` for the index of a pixel's
/// color.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a texture of `{Self}`",
    label = "`{Self}` is not a color of embedded-graphics",
    note = "write a color of embedded-graphics, such as `Texture<Rgb565>` or `Texture<Gray8>`, or `Argb1555` or `Argb4444`"
)]
pub trait Convert<F: File, const N: usize, const K: usize>: Copy + 'static {
    /// The texels of the picture's colors. The table may be longer.
    const TABLE: &'static [Self; K];
    /// The texels of the pixels, row by row.
    const TEXELS: &'static [Self; N];
}

/// A texture that can be created from picture `F` with `N` pixels in `K` colors.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a `{Self}`",
    label = "expected a texture in a color of embedded-graphics",
    note = "write the type as `Texture<Rgb565>`, `[[Rgb565; WIDTH]; HEIGHT]`, `Indexed<Texture<u8>, Rgb565>` or `Mipmap<Rgb565>`"
)]
pub trait FromFile<F: File, const N: usize, const K: usize>: Sized {
    /// The texture.
    const VALUE: Self;
}

/// The texels of pixels, from a table and the pixels' indices.
pub(super) const fn texels<C: Copy, const N: usize>(table: &[C], pixels: &[u8]) -> [C; N] {
    let (mut texels, mut at) = ([table[0]; N], 0);
    // The loop contains no call, because the compiler refuses constants that take two million calls and repetitions.
    let (has_bytes, (triples, _)) = (pixels.len() == N, pixels.as_chunks());
    while at < N {
        texels[at] = if has_bytes {
            table[pixels[at] as usize]
        } else {
            let [a, b, c] = triples[at];
            table[a as usize | (b as usize) << 8 | (c as usize) << 16]
        };
        at += 1;
    }
    texels
}

impl<F: File, C: Convert<F, N, K>, const N: usize, const K: usize> FromFile<F, N, K>
    for &'static [C]
{
    const VALUE: Self = C::TEXELS;
}

impl<F: File, C: Convert<F, N, K>, const N: usize, const K: usize, const W: usize, const H: usize>
    FromFile<F, N, K> for &'static [[C; W]; H]
{
    const VALUE: Self = match C::TEXELS.as_chunks().0.first_chunk() {
        Some(rows) if F::SIZE[0] as usize == W && F::SIZE[1] as usize == H => rows,
        _ => message::wrong_size(F::PATH, F::SIZE, [W, H]),
    };
}

impl<F: File, C: Convert<F, N, K>, const N: usize, const K: usize, const W: usize, const H: usize>
    FromFile<F, N, K> for [[C; W]; H]
{
    const VALUE: Self = *<&[[C; W]; H] as FromFile<F, N, K>>::VALUE;
}

impl<F: File, C: Convert<F, N, K>, const N: usize, const K: usize> FromFile<F, N, K>
    for Texture<'static, C>
{
    const VALUE: Self = {
        let [width, height] = F::SIZE;
        message::checked(Texture::new(C::TEXELS, width, height), F::PATH)
    };
}

impl<F: File, C: Convert<F, N, K>, const N: usize, const K: usize> FromFile<F, N, K>
    for Mipmap<'static, C>
{
    const VALUE: Self = {
        let [width, height] = F::SIZE;
        message::checked(Mipmap::new(C::TEXELS, width, height), F::PATH)
    };
}

impl<
    F: File,
    S: FromFile<F, N, K>,
    C: Convert<F, N, M>,
    const N: usize,
    const K: usize,
    const M: usize,
> FromFile<F, N, K> for Indexed<'static, S, C, M>
{
    const VALUE: Self = Self {
        indices: S::VALUE,
        colors: C::TABLE,
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_of_three_bytes_begins_with_the_least() {
        let table: std::vec::Vec<u32> = (0..=0x1_0000).collect();
        let pixels = [2, 1, 0, 0, 0, 1];
        assert_eq!(texels::<u32, 2>(&table, &pixels), [0x102, 0x1_0000]);
    }
}
