//! Textures of a size that is known at run time.

use core::hint::select_unpredictable;
use core::slice;

use super::Sampler;
use super::sampler::{self, exponents, size_log2};
use crate::error::Error;
use crate::error::{check_length, ok};

/// A texture that borrows its texels; its size is known at run time.
///
/// Width and height are powers of two, at most [`MAX_SIZE`](Self::MAX_SIZE). The texels are stored row by row, the top
/// row first. [`include_texture!`](crate::include_texture) converts a picture file at compile time,
/// [`from_rows`](Self::from_rows) borrows rows of texels, and [`new`](Self::new) takes a slice. Textures of different
/// sizes fit in one list:
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// static BRICK: Texture<Rgb565> = include_texture!("samples/brick.bmp");
/// static STRIPES: [[Rgb565; 2]; 1] = [[Rgb565::RED, Rgb565::BLUE]];
/// static SKINS: [Texture<Rgb565>; 2] = [BRICK, Texture::from_rows(&STRIPES)];
/// assert_eq!(SKINS.map(|skin| (skin.width(), skin.height())), [(8, 4), (2, 1)]);
/// let shader = Textured::new(SKINS[1]);
/// # let _ = shader;
/// ```
///
/// # Cost
///
/// Reading a texel takes one instruction more than reading it from rows, `&[[C; W]; H]`. A `Texture` also needs up to
/// two registers more than rows do, for its width and its number of texels. If the loop over pixels has no registers
/// left for these two numbers, it loads them from the stack at each pixel. The table lists millions of instructions per
/// frame for the benchmark's floor: 47,610 pixels with a 64x64 texture and a depth buffer. To avoid this cost where the
/// size is known at compile time, let [`include_texture!`](crate::include_texture) make rows.
///
/// <!-- figures: textures of run-time size -->
/// | | rows | `Texture` |
/// |---|---:|---:|
/// | Cortex-M4, `Newton` | 1.14 | 1.25 |
/// | the same at opt-level "s" | 1.29 | 1.40 |
/// | Cortex-M4, `Fast` | 1.35 | 1.51 |
/// | Cortex-M0+, `Newton` | 2.40 | 2.37 |
/// | Cortex-M0+, `Fast` | 2.35 | 2.52 |
/// <!-- end -->
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Texture<'a, C> {
    /// As many texels as the size needs, which is at least one.
    texels: &'a [C],
    /// The texel that takes the place of an empty slice; an empty slice cannot occur.
    first: &'a C,
    size_log2: [u8; 2],
    /// Minus the width. In every column's number, the set bits of this number are 0.
    minus_width: i32,
}

impl<'a, C: Copy> Texture<'a, C> {
    /// Largest width and height of any texture, in texels.
    pub const MAX_SIZE: usize = sampler::MAX_SIZE;

    /// A texture of `texels`, row by row from the top.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::prelude::*;
    /// let texels = [Gray8::new(0); 64];
    /// let skin = Texture::new(&texels, 16, 4)?;
    /// assert_eq!((skin.width(), skin.height()), (16, 4));
    /// let error = Texture::new(&texels, 16, 8).unwrap_err();
    /// assert_eq!(error.to_string(), "number of texels is 64: it must be exactly 128");
    /// let error = Texture::new(&texels, 64, 0).unwrap_err();
    /// assert_eq!(error.to_string(), "height is 0: it must be a power of two, at most 32768, such as 1");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large; [`Error::Count`] if the
    /// number of texels is not width times height.
    pub const fn new(texels: &'a [C], width: u32, height: u32) -> Result<Self, Error> {
        let [width, height] = ok!(exponents(width, height));
        ok!(check_length("texels", texels.len(), 1 << (width + height)));
        Ok(Self::of(texels, [width, height]))
    }

    /// A texture of rows, the top row first. Rows do not compile if their number or length is not a power of two.
    #[must_use]
    pub const fn from_rows<const W: usize, const H: usize>(rows: &'a [[C; W]; H]) -> Self {
        Self::of(rows.as_flattened(), const { size_log2(W, H) })
    }

    const fn of(texels: &'a [C], [width, height]: [u32; 2]) -> Self {
        Self {
            texels,
            first: &texels[0],
            size_log2: [width as u8, height as u8],
            minus_width: -(1 << width),
        }
    }

    /// The texels, row by row from the top.
    #[must_use]
    pub const fn texels(&self) -> &'a [C] {
        self.texels
    }

    /// Number of columns.
    #[must_use]
    pub const fn width(&self) -> u32 {
        1 << self.size_log2[0]
    }

    /// Number of rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        1 << self.size_log2[1]
    }
}

impl<C: Copy> Sampler for Texture<'_, C> {
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        let [width, height] = self.size_log2;
        [width.into(), height.into()]
    }

    /// A loop over pixels has no registers to spare, so this function needs only three numbers beside the coordinates:
    /// the address of the texels, their number, and minus the width.
    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        let (all, one) = (self.texels, slice::from_ref(self.first));
        // The compiler sees that there is at least one texel. The choice must not be a branch: in a build for size, the
        // compiler would leave the branch in the loop over pixels.
        let texels = select_unpredictable(all.is_empty(), one, all);
        // The complement is −1 − (v · width + u modulo width). The number −width is used twice, because −1 − (u modulo
        // width) is !u | −width.
        let complement = v
            .wrapping_mul(self.minus_width)
            .wrapping_add(!u | self.minus_width);
        // The number of texels is a power of two. The mask limits the row to the height, and shows that no index is out
        // of range.
        let index = !complement.cast_unsigned() as usize & (texels.len() - 1);
        texels.get(index).copied().unwrap_or(*self.first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_powers_of_two_and_lengths_fit() {
        let texels = [7; 200];
        let length = |given, needed| Error::Count {
            of: "texels",
            given,
            min: needed,
            max: needed,
        };
        let new = |count, width, height| Texture::new(&texels[..count], width, height).map(|_| ());
        for (width, height) in [(1, 1), (64, 2), (2, 64), (1, 128)] {
            assert_eq!(new((width * height) as usize, width, height), Ok(()));
            let given = (width * height) as usize + 1;
            let needed = given - 1;
            let error = length(given, needed);
            assert_eq!(new(given, width, height), Err(error));
        }
        let error = new(200, 100, 2).unwrap_err();
        assert_eq!(
            std::format!("{error}"),
            "width is 100: it must be a power of two, at most 32768, such as 128"
        );
        let max = 32768;
        for given in [0, 3, 65536, u32::MAX] {
            let (of, other) = ("width", "height");
            assert_eq!(new(1, given, 1), Err(Error::PowerOfTwo { of, given, max }));
            let of = other;
            assert_eq!(new(1, 1, given), Err(Error::PowerOfTwo { of, given, max }));
        }
        assert_eq!(new(1, max, max), Err(length(1, 1 << 30)));
    }

    /// Compares each texel of the texture with the same texel of the rows, even far beyond the edges.
    #[test]
    fn a_texture_repeats_like_its_rows() {
        fn compare<const W: usize, const H: usize>() {
            let mut rows = [[0; W]; H];
            for (at, texel) in rows.as_flattened_mut().iter_mut().enumerate() {
                *texel = at;
            }
            let (width, height) = (W as u32, H as u32);
            let texture = Texture::new(rows.as_flattened(), width, height).unwrap();
            assert_eq!(texture, Texture::from_rows(&rows));
            let rows = &rows;
            assert_eq!(texture.size_log2(), rows.size_log2());
            let far = [i32::MIN, i32::MIN + 1, -40_000, 40_000, i32::MAX];
            for v in (-9..9).chain(far) {
                for u in (-9..9).chain(far) {
                    assert_eq!(texture.texel(u, v), rows.texel(u, v), "{W}x{H} {u} {v}");
                }
            }
        }
        compare::<1, 1>();
        compare::<8, 1>();
        compare::<1, 8>();
        compare::<4, 2>();
        compare::<2, 4>();
    }

    #[test]
    fn rows_repeat_in_both_directions() {
        let rows = &[[0, 1, 2, 3], [4, 5, 6, 7]];
        let texel = |u, v| rows.texel(u, v);
        assert_eq!([texel(0, 0), texel(3, 1), texel(4, 2)], [0, 7, 0]);
        assert_eq!([texel(-1, -1), texel(i32::MIN, i32::MAX)], [7, 4]);
    }
    /// A sampler without levels shows, for a texel of a level, the first of the texels that it replaces.
    #[test]
    fn levels_of_a_texture_are_its_own_texels() {
        let rows: [[u32; 16]; 4] =
            core::array::from_fn(|v| core::array::from_fn(|u| (v * 16 + u) as u32));
        let (rows, texture) = (&rows, Texture::from_rows(&rows));
        for (v, u) in (0..4).flat_map(|v| (0..16).map(move |u| (v, u))) {
            for level in 0..=2 {
                let first = (v << level) % 4 * 16 + (u << level) % 16;
                let found = [rows.texel_at(level, u, v), texture.texel_at(level, u, v)];
                assert_eq!(found.map(u32::cast_signed), [first; 2]);
            }
        }
    }
}
