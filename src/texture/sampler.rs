//! The interface between a texture and its shader: texels by column and row.

use crate::Error;
use crate::error::{check_length, ok};
use crate::message;

/// Texels by column and row; they repeat in both directions.
///
/// Width and height are powers of two.
///
/// It is implemented for [`Texture`](super::Texture), [`Palette`](super::Palette), [`PackedGray4`](super::PackedGray4),
/// [`Mipmap`](super::Mipmap) and [`Masked`](crate::shade::Masked), for references to them, and for references to
/// [`TextureArray`](super::TextureArray), [`PaletteArray`](super::PaletteArray) and plain rows of texels:
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb888;
/// use fixel::texture::Sampler;
/// let rows: Vec<[Rgb888; 256]> = (0..=255).map(|y| [Rgb888::new(y, 0, 0); 256]).collect();
/// let image: &[[Rgb888; 256]; 256] = rows.as_slice().try_into().unwrap();
/// assert_eq!(image.texel(0, 3), Rgb888::new(3, 0, 0));
/// assert_eq!(image.texel(-1, -1), Rgb888::new(255, 0, 0));
/// assert_eq!(image.size_log2(), [8, 8]);
/// ```
///
/// Other sizes do not compile; the error names a size that does:
///
/// ```compile_fail
/// use fixel::texture::Sampler;
/// use embedded_graphics::pixelcolor::Gray8;
/// let image = [[Gray8::new(0); 100]; 64];
/// let _ = (&image).texel(0, 0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a texture",
    label = "not a texture",
    note = "textures are `Texture`, `Palette`, `Mipmap`, `&TextureArray` and `&PaletteArray`; for a slice of texels, \
            write `Texture::new(&texels, width, height)?`"
)]
pub trait Sampler: Copy {
    /// A texel: a color, or one with an opacity (see [`Texel`](crate::shade::Texel)).
    type Color: Copy;

    /// Width and height are 2 to these powers; at most 15.
    fn size_log2(&self) -> [u32; 2];

    /// The texel in column `u` and row `v`, both modulo the size; (0, 0) is the top left texel.
    fn texel(&self, u: i32, v: i32) -> Self::Color;
}

/// Largest width and height of a texture, in texels.
pub const MAX_TEXTURE_SIZE: usize = 1 << 15;

/// The largest size, in the type that [`Error`] uses.
const MAX: u32 = MAX_TEXTURE_SIZE as u32;

/// The exponent of a width or height, checked at compile time; `of` names the size in the error.
pub(super) const fn log2(of: &'static str, size: usize) -> u32 {
    // A size that does not fit into 32 bits is too large anyway.
    let given = if size > u32::MAX as usize {
        u32::MAX
    } else {
        size as u32
    };
    message::checked(exponent(of, given), "texture")
}

/// The exponents of a width and a height in a type.
pub(super) const fn size_log2<const W: usize, const H: usize>() -> [u32; 2] {
    [log2("width", W), log2("height", H)]
}

/// The exponent of a width or height; `of` names the size in the error.
const fn exponent(of: &'static str, given: u32) -> Result<u32, Error> {
    if given.is_power_of_two() && given <= MAX {
        Ok(given.ilog2())
    } else {
        let max = MAX;
        Err(Error::PowerOfTwo { of, given, max })
    }
}

/// The exponents of a width and a height.
pub(super) const fn exponents(width: u32, height: u32) -> Result<[u32; 2], Error> {
    let width_log2 = ok!(exponent("width", width));
    Ok([width_log2, ok!(exponent("height", height))])
}

/// The entry at column `u` and row `v`, both modulo the size. The mask shows the compiler that the indices are in
/// range.
#[inline]
pub(super) fn wrapped<T: Copy, const W: usize, const H: usize>(
    rows: &[[T; W]; H],
    u: i32,
    v: i32,
) -> T {
    const { size_log2::<W, H>() };
    let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
    rows[v & (H - 1)][u & (W - 1)]
}

impl<S: Sampler> Sampler for &S {
    type Color = S::Color;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        (**self).size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> S::Color {
        (**self).texel(u, v)
    }
}

/// Implements a sampler whose size is in its type: `$texel` is the color at column `$u` and row `$v` of a `$Type`.
macro_rules! sampler_of_rows {
    ($Type:ty, |$texels:ident, $u:ident, $v:ident| $texel:expr) => {
        impl<C: Copy, const W: usize, const H: usize> Sampler for &$Type {
            type Color = C;

            #[inline]
            fn size_log2(&self) -> [u32; 2] {
                const { size_log2::<W, H>() }
            }

            #[inline]
            fn texel(&self, $u: i32, $v: i32) -> C {
                let $texels = *self;
                $texel
            }
        }
    };
}
pub(super) use sampler_of_rows;

sampler_of_rows!([[C; W]; H], |rows, u, v| wrapped(rows, u, v));

/// Entries, row by row, as an array of rows.
pub(super) const fn rows<T: Copy, const W: usize, const H: usize>(entries: &[T]) -> [[T; W]; H] {
    let mut rows = [[entries[0]; W]; H];
    let mut at = 0;
    while at < W * H {
        rows[at / W][at % W] = entries[at];
        at += 1;
    }
    rows
}

/// Entries, row by row, of a size that is known at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Grid<'a, T> {
    /// As many as the size needs, so at least one.
    entries: &'a [T],
    size_log2: [u8; 2],
}

impl<'a, T: Copy> Grid<'a, T> {
    /// Errors: [`Error::PowerOfTwo`] for the size, [`Error::Length`] for the number of entries.
    pub(super) const fn new(entries: &'a [T], width: u32, height: u32) -> Result<Self, Error> {
        let [width, height] = ok!(exponents(width, height));
        ok!(check_length(entries.len(), 1 << (width + height)));
        let size_log2 = [width as u8, height as u8];
        Ok(Self { entries, size_log2 })
    }

    /// The entries of rows whose size is checked already.
    pub(super) const fn of<const W: usize, const H: usize>(rows: &'a [[T; W]; H]) -> Self {
        let [width, height] = const { size_log2::<W, H>() };
        Self {
            entries: rows.as_flattened(),
            size_log2: [width as u8, height as u8],
        }
    }

    pub(super) const fn entries(&self) -> &'a [T] {
        self.entries
    }

    #[inline]
    pub(super) const fn size_log2(&self) -> [u32; 2] {
        let [width, height] = self.size_log2;
        [width as u32, height as u32]
    }

    /// The entry at column `u` and row `v`, both modulo the size; never `None`.
    ///
    /// The number of entries is a power of two. The mask with one less limits the row to the height. It also shows
    /// the compiler that only an empty slice lacks the entry, so it tests for that once, before the loop over pixels.
    #[inline]
    pub(super) fn get(&self, u: i32, v: i32) -> Option<T> {
        let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
        let [width, _] = self.size_log2();
        let row = v.wrapping_shl(width);
        let column = u & (1_usize.wrapping_shl(width) - 1);
        let index = (row | column) & self.entries.len().wrapping_sub(1);
        self.entries.get(index).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_powers_of_two_and_lengths_fit() {
        let entries = [7; 200];
        let grid = |count, width, height| Grid::new(&entries[..count], width, height).map(|_| ());
        for (width, height) in [(1, 1), (64, 2), (2, 64), (1, 128)] {
            assert_eq!(grid((width * height) as usize, width, height), Ok(()));
            let given = (width * height) as usize + 1;
            let needed = given - 1;
            assert_eq!(
                grid(given, width, height),
                Err(Error::Length { given, needed })
            );
        }
        let error = grid(200, 100, 2).unwrap_err();
        assert_eq!(
            std::format!("{error}"),
            "width is 100: it must be a power of two, at most 32768, such as 128"
        );
        let max = 32768;
        for given in [0, 3, 65536, u32::MAX] {
            let (of, other) = ("width", "height");
            assert_eq!(grid(1, given, 1), Err(Error::PowerOfTwo { of, given, max }));
            let of = other;
            assert_eq!(grid(1, 1, given), Err(Error::PowerOfTwo { of, given, max }));
        }
        let (given, needed) = (1, 1 << 30);
        assert_eq!(grid(1, max, max), Err(Error::Length { given, needed }));
    }

    /// Compares every entry with rows whose size is in their type, even far beyond the edges.
    #[test]
    fn a_grid_repeats_like_rows() {
        fn compare<const W: usize, const H: usize>() {
            let mut rows = [[0; W]; H];
            for (at, entry) in rows.as_flattened_mut().iter_mut().enumerate() {
                *entry = at;
            }
            let (width, height) = (W as u32, H as u32);
            let grid = Grid::new(rows.as_flattened(), width, height).unwrap();
            assert_eq!(grid, Grid::of(&rows));
            let far = [i32::MIN, i32::MIN + 1, -40_000, 40_000, i32::MAX];
            for v in (-9..9).chain(far) {
                for u in (-9..9).chain(far) {
                    assert_eq!(
                        grid.get(u, v),
                        Some(wrapped(&rows, u, v)),
                        "{W}x{H} {u} {v}"
                    );
                }
            }
        }
        compare::<1, 1>();
        compare::<8, 1>();
        compare::<1, 8>();
        compare::<4, 2>();
        compare::<2, 4>();
    }
}
