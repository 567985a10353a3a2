//! Mipmaps that own their texels, made at compile time.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};

use super::Mipmap;
use super::array::number;
use super::sampler::size_log2;
use crate::message;

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
    /// A mipmap of the texels of all levels.
    pub(super) const fn from_texels(texels: [C; LENGTH]) -> Self {
        const { check::<W, H, LENGTH>() };
        Self { texels }
    }

    /// Borrows it as a [`Mipmap`], whose size is not part of the type.
    #[must_use]
    pub const fn as_mipmap(&self) -> Mipmap<'_, C> {
        const { check::<W, H, LENGTH>() };
        Mipmap::of(&self.texels, const { size_log2::<W, H>() })
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
