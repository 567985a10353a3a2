//! Textures with their reductions to half, quarter and so on.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};

use super::array::number;
use super::sampler::{exponents, log2, size_log2};
use super::{Addressing, Bilinear, Blend, Filter, Nearest, Sampler};
use crate::Error;
use crate::error::{check_length, ok};
use crate::message;
use crate::sealed::{Sealed, sealed};

/// A texture with its mipmap levels: the texture itself, and reductions of it for triangles that are far away.
///
/// Level 0 is the texture. Each further level has half the width and half the height of the level before; the last one
/// is reached when a side has one texel. A texel is the mean of the four that it replaces, each channel rounded to
/// nearest, halves up ([`Blend::mean`]). So at level n, a channel differs by at most n/2 steps from the mean of all
/// texels that it replaces.
///
/// A mipmap borrows the texels of all levels, in one slice: level 0 first, each level row by row from the top. Together
/// they take a third more memory than the texture; [`len`](Self::len) returns their number. There are three ways to
/// create a mipmap: [`MipmapArray`] computes the levels at compile time, and [`as_mipmap`](MipmapArray::as_mipmap)
/// borrows them; [`build`](Self::build) computes them at run time, in your memory; [`new`](Self::new) takes a slice
/// that already has them.
///
/// [`Mipmapped`](crate::shade::Mipmapped) draws it. Used as a [`Sampler`], it behaves like the texture at level 0.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::texture::Mipmap;
/// let mut texels = [Gray8::BLACK; Mipmap::<Gray8>::len(4, 2)];
/// texels[..8].copy_from_slice(&[10, 20, 0, 0, 30, 41, 0, 1].map(Gray8::new));
/// let mipmap = Mipmap::build(&mut texels, 4, 2)?;
/// assert_eq!(mipmap.levels(), 2);
/// assert_eq!(mipmap.texels()[8..], [25, 0].map(Gray8::new)); // 25.25 and 0.25
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Mipmap<'a, C> {
    texels: &'a [C],
    /// The color for an empty slice, which cannot occur.
    first: C,
    size_log2: [u8; 2],
}

/// The number of texels of all levels, from the exponents of the size. It has one bit for each level; the bits are two
/// apart, because a level has a quarter of the texels of the level before.
const fn len_of([width_log2, height_log2]: [u32; 2]) -> usize {
    let (low, high) = if width_log2 < height_log2 {
        (width_log2, height_log2)
    } else {
        (height_log2, width_log2)
    };
    // The last level has 2^(high − low) texels, the first one 2^(high + low).
    let bits = (0x5555_5555_u64 << (high - low)) & ((2 << (high + low)) - 1);
    bits as usize
}

impl<'a, C: Copy> Mipmap<'a, C> {
    /// How many texels all levels of a texture have together.
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
    /// If the width or the height is not a power of two or is above [`MAX_TEXTURE_SIZE`](super::MAX_TEXTURE_SIZE). Use
    /// it only in constants, where this stops compilation.
    #[must_use]
    pub const fn len(width: usize, height: usize) -> usize {
        len_of([log2("width", width), log2("height", height)])
    }

    /// A mipmap of texels that have all levels already.
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large; [`Error::Length`] unless
    /// there are exactly as many texels as all levels need.
    pub const fn new(texels: &'a [C], width: u32, height: u32) -> Result<Self, Error> {
        let size = ok!(exponents(width, height));
        ok!(check_length(texels.len(), len_of(size)));
        Ok(Self {
            texels,
            first: texels[0],
            size_log2: [size[0] as u8, size[1] as u8],
        })
    }

    /// Computes all levels from level 0, with which `texels` begins; the rest of `texels` is overwritten.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new).
    pub fn build(texels: &'a mut [C], width: u32, height: u32) -> Result<Self, Error>
    where
        C: Blend,
    {
        let [width_log2, height_log2] = Mipmap::new(&*texels, width, height)?.size_log2;
        for level in 1..=width_log2.min(height_log2) {
            // Two rows of the level before, and one of this level.
            let wide = 2_usize << (width_log2 - level);
            let size = wide << (height_log2 - level + 1);
            let Some((before, after)) =
                texels.split_at_mut_checked(start(texels.len(), size) + size)
            else {
                continue;
            };
            let before = before.get(before.len() - size..).unwrap_or_default();
            for (pair, row) in before
                .chunks_exact(2 * wide)
                .zip(after.chunks_exact_mut(wide / 2))
            {
                let (upper, lower) = pair.split_at(wide);
                let squares = upper.chunks_exact(2).zip(lower.chunks_exact(2));
                for (texel, square) in row.iter_mut().zip(squares) {
                    if let (&[a, b], &[c, d]) = square {
                        *texel = C::mean([[a, b], [c, d]]);
                    }
                }
            }
        }
        Mipmap::new(texels, width, height)
    }

    /// All levels' texels, level 0 first, each row by row.
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

    /// The number of levels: 1 to 16.
    #[must_use]
    pub const fn levels(&self) -> u32 {
        self.last() + 1
    }

    /// The last level.
    #[inline]
    pub(crate) const fn last(&self) -> u32 {
        let [width, height] = self.size_log2;
        (if width < height { width } else { height }) as u32
    }

    /// One level as a texture; `level` must not be beyond the last one.
    #[inline]
    pub(crate) const fn level(&self, level: u32) -> Level<'a, C> {
        Level {
            mipmap: *self,
            level,
        }
    }
}

/// Where the level with `size` texels, a power of two, begins: after the larger levels, which are the higher bits of
/// `len`.
#[inline]
const fn start(len: usize, size: usize) -> usize {
    len & !(size | (size - 1))
}

/// A level of a mipmap.
#[derive(Clone, Copy)]
pub(crate) struct Level<'a, C> {
    mipmap: Mipmap<'a, C>,
    level: u32,
}

impl<C: Copy> Sampler for Level<'_, C> {
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        let [width, height] = Sampler::size_log2(&self.mipmap);
        [
            width.wrapping_sub(self.level),
            height.wrapping_sub(self.level),
        ]
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        let Mipmap { texels, first, .. } = self.mipmap;
        let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
        let [width, height] = self.size_log2();
        let column = u & (1_usize.wrapping_shl(width) - 1);
        let size = 1_usize.wrapping_shl(width + height);
        let index = (v.wrapping_shl(width) | column) & (size - 1) | start(texels.len(), size);
        match texels.get(index) {
            Some(&texel) => texel,
            None => first,
        }
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
        self.level(0).texel(u, v)
    }
}

/// A [`Mipmap`] that owns its texels, made at compile time: in a `static`, it is stored in flash.
///
/// `W` and `H` are the size of the texture, powers of two, and `LENGTH` is the number of texels of all levels:
/// [`Mipmap::len`]. A wrong `LENGTH` does not compile, and the compiler's error names the right one.
///
/// Constructors named after colors take the texture as raw bytes, like those of [`TextureArray`](super::TextureArray).
///
/// (The compiler stops the evaluation of a constant after two million steps unless `long_running_const_eval` is
/// allowed. Up to 256x256 texels stay below this limit.)
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::texture::{Mipmap, MipmapArray};
/// // Usually, the bytes come from include_bytes!("skin.rgb565"). Red, blue; blue, blue.
/// static SKIN: MipmapArray<Rgb565, 2, 2, { Mipmap::<Rgb565>::len(2, 2) }> =
///     MipmapArray::rgb565(&[0xf8, 0x00, 0x00, 0x1f, 0x00, 0x1f, 0x00, 0x1f]);
/// assert_eq!(SKIN.as_mipmap().levels(), 2);
/// assert_eq!(SKIN.as_mipmap().texels()[4], Rgb565::new(8, 0, 23)); // 7.75, 0, 23.25
/// ```
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::texture::MipmapArray;
/// // error: a texture of 2x2 texels needs 5 texels in all levels: 4 are given
/// static SKIN: MipmapArray<Gray8, 2, 2, 4> = MipmapArray::gray8(&[1, 2, 3, 4]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MipmapArray<C, const W: usize, const H: usize, const LENGTH: usize> {
    texels: [C; LENGTH],
}

impl<C: Copy, const W: usize, const H: usize, const LENGTH: usize> MipmapArray<C, W, H, LENGTH> {
    /// Borrows it as a [`Mipmap`], whose size is not part of the type.
    #[must_use]
    pub const fn as_mipmap(&self) -> Mipmap<'_, C> {
        const { check::<W, H, LENGTH>() };
        let [width, height] = const { size_log2::<W, H>() };
        Mipmap {
            texels: &self.texels,
            first: self.texels[0],
            size_log2: [width as u8, height as u8],
        }
    }
}

/// Stops compilation unless `LENGTH` is the number of texels of all levels.
const fn check<const W: usize, const H: usize, const LENGTH: usize>() {
    let needed = Mipmap::<u8>::len(W, H);
    if LENGTH != needed {
        message::wrong_length([W, H], "texels in all levels", LENGTH, needed);
    }
}

/// A channel of the mean of four texels: its lowest bit and its width, in bits.
macro_rules! mean {
    ($four:ident, $shift:literal, $bits:expr) => {{
        let [a, b, c, d] = $four;
        let mask: u32 = (1 << $bits) - 1;
        let sum = (a >> $shift & mask)
            + (b >> $shift & mask)
            + (c >> $shift & mask)
            + (d >> $shift & mask);
        ((sum + 2) >> 2) << $shift
    }};
}

/// A constructor from the raw bytes of level 0. `$texel` reads a texel as a word, `$mean` is the word of the mean of
/// four, and `$color` makes a color of a word.
macro_rules! constructor {
    ($name:ident $order:literal $bytes:literal, |$slice:ident| $texel:expr, |$four:ident| $mean:expr,
        |$word:ident| $color:expr) => {
        #[doc = concat!("The mipmap of a texture from raw bytes", $order, ".")]
        ///
        /// Too few or too many bytes do not compile.
        #[must_use]
        pub const fn $name<const BYTES: usize>(bytes: &[u8; BYTES]) -> Self {
            const {
                check::<W, H, LENGTH>();
                let needed = W * H * $bytes;
                if BYTES != needed {
                    message::wrong_length([W, H], "bytes", BYTES, needed);
                }
            }
            let mut $slice = bytes.as_slice();
            let mut words = [0_u32; LENGTH];
            let mut at = 0;
            while at < W * H {
                words[at] = $texel;
                at += 1;
            }
            // `from` runs over the level before, which is `width` wide, and `to` over this one.
            let (mut from, mut begin, mut to, mut width) = (0, W * H, W * H, W);
            while to < LENGTH {
                let mut column = 0;
                while column < width {
                    let $four = [
                        words[from + column],
                        words[from + column + 1],
                        words[from + width + column],
                        words[from + width + column + 1],
                    ];
                    words[to] = $mean;
                    column += 2;
                    to += 1;
                }
                from += 2 * width;
                // The level before ends where this one began.
                if from == begin {
                    begin = to;
                    width /= 2;
                }
            }
            let $word = words[0];
            let mut texels = [$color; LENGTH];
            let mut at = 1;
            while at < LENGTH {
                let $word = words[at];
                texels[at] = $color;
                at += 1;
            }
            Self { texels }
        }
    };
}

/// Colors: bytes per texel, and the lowest bits and widths of the channels.
macro_rules! rgb {
    ($($color:ident $be:ident $le:ident $bytes:tt $r:literal $g:literal $b:literal $outer:literal $middle:literal;)+) => {$(
        impl<const W: usize, const H: usize, const LENGTH: usize> MipmapArray<$color, W, H, LENGTH> {
            constructor!($be ", the high byte of a texel first" $bytes,
                |bytes| number!(bytes $bytes big),
                |four| mean!(four, $r, $outer) | mean!(four, $g, $middle) | mean!(four, $b, $outer),
                |word| $color::new((word >> $r) as u8, (word >> $g) as u8, (word >> $b) as u8));
            constructor!($le ", the low byte of a texel first" $bytes,
                |bytes| number!(bytes $bytes little),
                |four| mean!(four, $r, $outer) | mean!(four, $g, $middle) | mean!(four, $b, $outer),
                |word| $color::new((word >> $r) as u8, (word >> $g) as u8, (word >> $b) as u8));
        }
    )+};
}

rgb! {
    Rgb555 rgb555 rgb555_le 2 10 5 0 5 5;
    Bgr555 bgr555 bgr555_le 2 0 5 10 5 5;
    Rgb565 rgb565 rgb565_le 2 11 5 0 5 6;
    Bgr565 bgr565 bgr565_le 2 0 5 11 5 6;
    Rgb666 rgb666 rgb666_le 3 12 6 0 6 6;
    Bgr666 bgr666 bgr666_le 3 0 6 12 6 6;
    Rgb888 rgb888 rgb888_le 3 16 8 0 8 8;
    Bgr888 bgr888 bgr888_le 3 0 8 16 8 8;
}

impl<const W: usize, const H: usize, const LENGTH: usize> MipmapArray<Gray8, W, H, LENGTH> {
    constructor!(gray8 "" 1, |bytes| number!(bytes 1 big), |four| mean!(four, 0, 8), |word| {
        Gray8::new(word as u8)
    });
}

/// The color of a [`Mipmap`] at a point and a level: [`Nearest`], [`Bilinear`] or [`Trilinear`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::shade::Mipmapped;
/// use fixel::texture::{MipmapFilter, Repeat};
///
/// /// Takes a mipmap with any filter.
/// fn skin<F: MipmapFilter<Rgb565>>(surface: Mipmapped<'_, Rgb565, Repeat, F>) {
///     let _ = surface;
/// }
/// ```
pub trait MipmapFilter<C>: Copy + Sealed {
    /// The color at a column and a row of level 0, in texels with 16 fraction bits, and at a level with 8 fraction bits.
    #[doc(hidden)]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C>;
}

sealed!(Trilinear);

/// Blends the four texels around a point in each of the two levels between which a pixel lies, and then the two
/// results, so that no edge shows where a level ends.
///
/// [`Mipmapped::trilinear`](crate::shade::Mipmapped::trilinear) selects it. Each blend is rounded as
/// [`Bilinear`] describes it; the position between two levels is cut to the same units, 1/32 or 1/256 of a level.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::shade::Mipmapped;
/// use fixel::texture::{Repeat, Trilinear};
/// fn smooth(surface: Mipmapped<'_, Rgb565>) -> Mipmapped<'_, Rgb565, Repeat, Trilinear> {
///     surface.trilinear()
/// }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Trilinear;

impl<'a, C: Copy> Mipmap<'a, C> {
    /// The color in one level, which must not be beyond the last one.
    #[inline]
    fn color_in<A: Addressing, F: Filter<C>>(
        &self,
        filter: F,
        [u, v]: [i32; 2],
        level: u32,
    ) -> Option<C> {
        filter.color::<Level<'a, C>, A>(&self.level(level), [u >> level, v >> level])
    }

    /// The whole level nearest to a level with 8 fraction bits.
    #[inline]
    fn nearest_level(&self, level: i32) -> u32 {
        ((level + 128) >> 8)
            .clamp(0, self.last().cast_signed())
            .cast_unsigned()
    }
}

impl<C: Copy> MipmapFilter<C> for Nearest {
    #[inline]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C> {
        mipmap.color_in::<A, _>(Nearest, at, mipmap.nearest_level(level))
    }
}

impl<C: Blend> MipmapFilter<C> for Bilinear {
    #[inline]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C> {
        mipmap.color_in::<A, _>(Bilinear, at, mipmap.nearest_level(level))
    }
}

impl<C: Blend> MipmapFilter<C> for Trilinear {
    #[inline]
    fn color<A: Addressing>(mipmap: &Mipmap<'_, C>, at: [i32; 2], level: i32) -> Option<C> {
        let level = level
            .clamp(0, (mipmap.last() << 8).cast_signed())
            .cast_unsigned();
        let (whole, weight) = (level >> 8, (level & 0xff) << C::WEIGHT_BITS >> 8);
        let fine = mipmap.color_in::<A, _>(Bilinear, at, whole)?;
        if weight == 0 {
            return Some(fine);
        }
        let coarse = mipmap.color_in::<A, _>(Bilinear, at, whole + 1)?;
        Some(fine.mix(coarse, weight))
    }
}
