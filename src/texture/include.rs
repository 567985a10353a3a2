//! Textures that [`include_texture!`](crate::include_texture) makes of files.

use super::{Indexed, Mipmap, Texture};
use crate::message;

/// A picture that [`include_texture!`](crate::include_texture) has read.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    /// The file's name, for errors.
    pub path: &'static str,
    /// The numbers of columns and rows, which the macro has checked against the limits of textures.
    pub size: [u32; 2],
    /// The colors that occur in the picture, at least one. Each color is stored in all formats, in 17 bytes: red, green
    /// and blue with 5 bits each, then with 6 bits each, then with 8 bits each; luma with 1, 2, 4 and 8 bits; and the
    /// two bytes of `Argb1555` and of `Argb4444`, the high byte first.
    pub colors: &'static [[u8; 17]],
    /// The pixels, row by row, as indices of colors; for a mipmap, the pixels of all levels. An index has one byte or,
    /// if there are more than 256 colors, three bytes, the low byte first.
    pub pixels: &'static [u8],
}

/// A value that can be made of file `F`, which has `N` pixels in `K` colors: its [`Picture`], the texels of a type, or
/// a texture.
///
/// A trait's functions cannot run at compile time, but its constants can depend on types. So the macro declares a type
/// for the file, and implements this trait for [`Picture`]. The compiler infers the type of the texture from the place
/// of the macro.
#[diagnostic::on_unimplemented(
    message = "a picture cannot become a `{Self}`",
    label = "expected a texture in a color of embedded-graphics",
    note = "write the type as `Texture<Rgb565>`, `[[Rgb565; WIDTH]; HEIGHT]`, `Indexed<Texture<u8>, Rgb565>` or `Mipmap<Rgb565>`",
    note = "the color can be any color of embedded-graphics, `Argb1555` or `Argb4444`"
)]
pub trait FromFile<F, const N: usize, const K: usize>: Sized {
    /// The value.
    const VALUE: Self;
}

/// A table with the texel of each of a picture's colors. The table may have further entries.
#[derive(Clone, Copy, Debug)]
pub struct Table<C: 'static, const K: usize> {
    pub(super) texels: &'static [C; K],
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

impl<F, C, const N: usize, const K: usize> FromFile<F, N, K> for &'static [C]
where
    &'static [C; N]: FromFile<F, N, K>,
{
    const VALUE: Self = <&[C; N]>::VALUE;
}

impl<F, C, const N: usize, const K: usize, const W: usize, const H: usize> FromFile<F, N, K>
    for &'static [[C; W]; H]
where
    Picture: FromFile<F, N, K>,
    &'static [C; N]: FromFile<F, N, K>,
{
    const VALUE: Self = {
        let Picture { path, size, .. } = Picture::VALUE;
        match <&[C; N]>::VALUE.as_chunks().0.first_chunk() {
            Some(rows) if size[0] as usize == W && size[1] as usize == H => rows,
            _ => message::wrong_size(path, size, [W, H]),
        }
    };
}

impl<F, C, const N: usize, const K: usize, const W: usize, const H: usize> FromFile<F, N, K>
    for [[C; W]; H]
where
    C: Copy + 'static,
    &'static [[C; W]; H]: FromFile<F, N, K>,
{
    const VALUE: Self = *<&[[C; W]; H]>::VALUE;
}

impl<F, C, const N: usize, const K: usize> FromFile<F, N, K> for Texture<'static, C>
where
    C: Copy,
    Picture: FromFile<F, N, K>,
    &'static [C; N]: FromFile<F, N, K>,
{
    const VALUE: Self = {
        let Picture { path, size, .. } = Picture::VALUE;
        message::checked(Texture::new(<&[C; N]>::VALUE, size[0], size[1]), path)
    };
}

impl<F, C, const N: usize, const K: usize> FromFile<F, N, K> for Mipmap<'static, C>
where
    C: Copy,
    Picture: FromFile<F, N, K>,
    &'static [C; N]: FromFile<F, N, K>,
{
    const VALUE: Self = {
        let Picture { path, size, .. } = Picture::VALUE;
        message::checked(Mipmap::new(<&[C; N]>::VALUE, size[0], size[1]), path)
    };
}

impl<F, S, C, const N: usize, const K: usize, const M: usize> FromFile<F, N, K>
    for Indexed<'static, S, C, M>
where
    S: FromFile<F, N, K>,
    C: Copy,
    Table<C, M>: FromFile<F, N, M>,
{
    const VALUE: Self = Self {
        indices: S::VALUE,
        colors: Table::<C, M>::VALUE.texels,
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
