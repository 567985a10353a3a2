//! Mipmaps: textures with copies of half their size, a quarter, and so on.

use super::filter::size_at;
use super::sampler::{exponents, size_log2};
use super::{Blend, Sampler};
use crate::error::Error;
use crate::error::{check_length, ok};

/// A texture and its smaller copies, for triangles that are far away. The texture and the copies are called *levels*.
///
/// Level 0 is the texture. Each further level has half the width and half the height of the level before; in the last
/// level, the shorter side has one texel. A texel of a further level is the mean of the four texels that it replaces.
/// Each channel is rounded to nearest, halves up ([`Blend::mean`]). So at level n, a channel differs by at most n/2
/// steps from the mean of all texels of level 0 that the texel replaces.
///
/// A mipmap borrows the texels of all levels, in one slice: level 0 first, each level row by row from the top. All
/// levels together take a third more memory than the texture alone; [`len`](Self::len) returns the number of texels.
/// [`include_texture!`](crate::include_texture) computes the levels of a picture at compile time.
/// [`build`](Self::build) computes the levels at run time, in your memory. [`new`](Self::new) accepts a slice that
/// already contains all levels.
///
/// At each pixel, [`Textured::mipmapped`](crate::Textured::mipmapped) uses the level that suits the distance of the
/// pixel. Without `mipmapped`, all pixels use level 0.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::texture::Mipmap;
/// let mut texels = [Gray8::BLACK; Mipmap::<Gray8>::len(4, 2)];
/// texels[..8].copy_from_slice(&[10, 20, 0, 0, 30, 41, 0, 1].map(Gray8::new));
/// let mipmap = Mipmap::build(&mut texels, 4, 2)?;
/// assert_eq!(mipmap.texels()[8..], [25, 0].map(Gray8::new)); // 25.25 and 0.25
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Mipmap<'a, C> {
    texels: &'a [C],
    /// The color of a texel beyond the end of the slice. Such a texel cannot occur.
    first: C,
    size_log2: [u8; 2],
}

/// The number of texels of all levels, from the base-2 logarithms of the size. In binary, the number has one set bit
/// for each level. The set bits are two places apart, because a level has a quarter of the texels of the level before.
const fn len_of([width_log2, height_log2]: [u32; 2]) -> usize {
    let (low, high) = if width_log2 < height_log2 {
        (width_log2, height_log2)
    } else {
        (height_log2, width_log2)
    };
    // The last level has 2^(high − low) texels, and the first level has 2^(high + low).
    let bits = (0x5555_5555_u64 << (high - low)) & ((2 << (high + low)) - 1);
    bits as usize
}

impl<'a, C: Copy> Mipmap<'a, C> {
    /// The number of texels that all levels of a texture have together.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Rgb565;
    /// use fixel::texture::Mipmap;
    /// assert_eq!(Mipmap::<Rgb565>::len(64, 64), 4096 + 1024 + 256 + 64 + 16 + 4 + 1);
    /// assert_eq!(Mipmap::<Rgb565>::len(8, 2), 16 + 4);
    /// ```
    ///
    /// # Panics
    ///
    /// If the width or the height is not a power of two or is above [`Texture::MAX_SIZE`](crate::Texture::MAX_SIZE).
    /// Call this function only in constants, where a panic stops compilation.
    #[must_use]
    pub const fn len(width: usize, height: usize) -> usize {
        len_of(size_log2(width, height))
    }

    /// A mipmap of texels that already contain all levels.
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large; [`Error::Count`] unless
    /// there are exactly as many texels as all levels need.
    pub const fn new(texels: &'a [C], width: u32, height: u32) -> Result<Self, Error> {
        let size = ok!(exponents(width, height));
        ok!(check_length("texels", texels.len(), len_of(size)));
        Ok(Self {
            texels,
            first: texels[0],
            size_log2: [size[0] as u8, size[1] as u8],
        })
    }

    /// Computes all levels from level 0. `texels` must begin with level 0; the rest of `texels` is overwritten.
    ///
    /// ```standalone_crate
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use fixel::prelude::*;
    /// use fixel::texture::Mipmap;
    /// static BRICK: Texture<Rgb565> = include_texture!("samples/brick.tga");
    /// let mut texels = [Rgb565::BLACK; Mipmap::<Rgb565>::len(8, 4)];
    /// texels[..8 * 4].copy_from_slice(BRICK.texels());
    /// let bricks = Mipmap::build(&mut texels, 8, 4)?;
    /// assert_eq!(bricks.texels()[..32], *BRICK.texels());
    /// # Ok::<(), fixel::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new).
    pub fn build(texels: &'a mut [C], width: u32, height: u32) -> Result<Self, Error>
    where
        C: Blend,
    {
        Mipmap::new(&*texels, width, height)?;
        let (mut wide, mut size) = (width as usize, (width * height) as usize);
        let mut rest = &mut *texels;
        while let Some((level, others)) = rest.split_at_mut_checked(size)
            && let Some((next, _)) = others.split_at_mut_checked(size / 4)
            && !next.is_empty()
        {
            // Two rows of this level become one row of the next level.
            let pairs = level.chunks_exact(2 * wide);
            for (pair, row) in pairs.zip(next.chunks_exact_mut(wide / 2)) {
                let (upper, lower) = pair.split_at(wide);
                let squares = upper.chunks_exact(2).zip(lower.chunks_exact(2));
                for (texel, square) in row.iter_mut().zip(squares) {
                    if let (&[a, b], &[c, d]) = square {
                        *texel = C::mean([[a, b], [c, d]]);
                    }
                }
            }
            (rest, wide, size) = (others, wide / 2, size / 4);
        }
        Mipmap::new(texels, width, height)
    }

    /// The texels of all levels, level 0 first, each level row by row.
    #[must_use]
    pub const fn texels(&self) -> &'a [C] {
        self.texels
    }

    /// Width of level 0, in texels.
    #[must_use]
    pub const fn width(&self) -> u32 {
        1 << self.size_log2[0]
    }

    /// Height of level 0, in texels.
    #[must_use]
    pub const fn height(&self) -> u32 {
        1 << self.size_log2[1]
    }
}

impl<C: Copy> Sampler for Mipmap<'_, C> {
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        let [width, height] = self.size_log2;
        [width.into(), height.into()]
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        self.texel_at(0, u, v)
    }

    #[inline]
    fn texel_at(&self, level: u32, u: i32, v: i32) -> C {
        let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
        let [width, height] = size_at(level, self.size_log2());
        let size = 1_usize.wrapping_shl(width.wrapping_add(height));
        // The level begins after all larger levels. In the binary number of all texels, the larger levels are the
        // higher bits.
        let start = self.texels.len() & !(size | (size - 1));
        let place = v.wrapping_shl(width) | u & (1_usize.wrapping_shl(width) - 1);
        let level = self.texels.get(start..).and_then(|rest| rest.get(..size));
        // The mask shows the compiler that a level has this texel.
        let texel = level.and_then(|level| level.get(place & (size - 1)));
        texel.copied().unwrap_or(self.first)
    }
}

#[cfg(test)]
mod tests {
    use super::super::cut_out::{CutOut, OrHole};
    use super::super::{Bilinear, Filter, Indexed, Nearest, Trilinear};
    use super::*;
    use embedded_graphics::pixelcolor::Gray8;
    use std::vec::Vec;

    /// Wide, high and square textures with levels of several rows and columns. Each has fewer than 255 texels in all
    /// levels, so each texel can have a gray of its own.
    const SIZES: [[u32; 2]; 5] = [[16, 4], [4, 16], [32, 2], [1, 8], [8, 8]];

    /// Each texel's gray is its index in the slice.
    fn grays([width, height]: [u32; 2]) -> Vec<Gray8> {
        let count = Mipmap::<Gray8>::len(width as usize, height as usize);
        (0..count).map(|at| Gray8::new(at as u8)).collect()
    }

    /// The color of each filter at a point.
    fn shown<const CLAMPED: bool>(
        mipmap: &Mipmap<'_, Gray8>,
        at: [i32; 2],
        level: i32,
    ) -> [Gray8; 3] {
        [
            Nearest::color::<CLAMPED>(mipmap, at, level),
            Bilinear::color::<CLAMPED>(mipmap, at, level),
            Trilinear::color::<CLAMPED>(mipmap, at, level),
        ]
    }

    /// The samplers that read a mipmap, and the filters at the center of a texel, show the texel that the slice has.
    #[test]
    fn every_level_has_rows_of_its_own_width() {
        let numbers: [u32; 256] = core::array::from_fn(|at| at as u32);
        for size in SIZES {
            let texels = grays(size);
            let mipmap = Mipmap::new(&texels, size[0], size[1]).unwrap();
            let indexed = Indexed {
                indices: mipmap,
                colors: &numbers,
            };
            let cut = CutOut {
                texture: mipmap,
                key: Gray8::new(255),
            };
            let mut all = texels.iter().zip(0..);
            for level in 0..=size[0].min(size[1]).ilog2() {
                let [width, height] = size.map(|side| (side >> level).cast_signed());
                for (v, u) in (0..height).flat_map(|v| (0..width).map(move |u| (v, u))) {
                    let (&gray, number) = all.next().unwrap();
                    let around = [(0, 0), (width, 0), (0, -height), (-width, 3 * height)];
                    for (x, y) in around.map(|(x, y)| (u + x, v + y)) {
                        let at = std::format!("{size:?}, level {level}, column {x}, row {y}");
                        assert_eq!(mipmap.texel_at(level, x, y), gray, "{at}");
                        assert_eq!(indexed.texel_at(level, x, y), number, "{at}");
                        assert_eq!(cut.texel_at(level, x, y), OrHole(Some(gray)), "{at}");
                        let center = [x, y].map(|at| (2 * at + 1) << 15 << level);
                        let of = (level << 8).cast_signed();
                        assert_eq!(shown::<false>(&mipmap, center, of), [gray; 3], "{at}");
                        let [column, row] =
                            [(x, width), (y, height)].map(|(at, size)| at.clamp(0, size - 1));
                        let edge = mipmap.texel_at(level, column, row);
                        assert_eq!(shown::<true>(&mipmap, center, of), [edge; 3], "{at}");
                    }
                }
            }
            assert_eq!(all.next(), None);
        }
    }

    /// Halfway between two levels, the color is halfway between the colors of a bilinear filter in these levels.
    #[test]
    fn both_levels_of_a_blend_have_rows_of_their_own_width() {
        for size in SIZES {
            let texels = grays(size);
            let mipmap = Mipmap::new(&texels, size[0], size[1]).unwrap();
            for level in 0..size[0].min(size[1]).ilog2().cast_signed() {
                for (v, u) in (0..16).flat_map(|v| (0..16).map(move |u| (v, u))) {
                    // Sixteen columns and rows across the texture, none of them at a center of a texel.
                    let at = [(u, size[0]), (v, size[1])]
                        .map(|(part, side)| (3 * part + 1) * (side.cast_signed() << 16) / 48);
                    let [fine, coarse] = [level, level + 1]
                        .map(|level| Bilinear::color::<false>(&mipmap, at, level << 8));
                    let half = 1 << Gray8::WEIGHT_BITS >> 1;
                    let shown = Trilinear::color::<false>(&mipmap, at, (level << 8) + 128);
                    assert_eq!(shown, fine.mix(coarse, half), "{size:?}, level {level}");
                }
            }
        }
    }
}
