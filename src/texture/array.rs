//! Textures that own their texels.

use embedded_graphics::iterator::raw::RawDataSlice;
use embedded_graphics::pixelcolor::raw::RawData;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565,
    Rgb666, Rgb888,
};

use super::sampler::{Grid, sampler_of_rows, size_log2, wrapped};
use super::{Argb1555, Argb4444, Sampler, Texture};
use crate::Error;
use crate::error::check_length;
use crate::message;

/// A texture that owns its texels; its size is part of the type.
///
/// There are `H` rows of `W` texels, the top row first.
///
/// Width and height are powers of two, at most [`MAX_TEXTURE_SIZE`](super::MAX_TEXTURE_SIZE). The compiler knows the
/// size, so a shader reads a texel in fewer instructions than from a [`Texture`]. [`as_texture`](Self::as_texture)
/// borrows it as a [`Texture`].
///
/// A `static` texture array is stored in flash. A texel takes two bytes in `Rgb565`, four in `Rgb888` and one in
/// gray.
///
/// There are three ways to create one:
///
/// - [`include_texture!`](crate::include_texture) converts a picture file at compile time.
/// - Constructors named after colors convert raw bytes. [`rgb565`](Self::rgb565) expects the high byte of a texel
///   first, like displays and embedded-graphics' `ImageRaw`; [`rgb565_le`](Self::rgb565_le) expects the low byte
///   first; and so on. [`argb4444`](Self::argb4444) and [`argb1555`](Self::argb1555) have an
///   opacity. Texels smaller than a byte are packed: the first lies in the high bits, and rows follow each
///   other without a gap.
/// - [`try_from_raw`](Self::try_from_raw) converts raw bytes of any color at run time.
///
/// (The compiler stops the evaluation of a constant after two million steps unless `long_running_const_eval` is
/// allowed. Up to 512x512 texels stay below this limit.)
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::{Gray4, Rgb565};
/// use fixel::prelude::*;
/// // Usually, the bytes come from include_bytes!("skin.rgb565").
/// static SKIN: TextureArray<Rgb565, 2, 1> = TextureArray::rgb565(&[0xf8, 0x00, 0x00, 0x1f]);
/// static SAME: TextureArray<Rgb565, 2, 1> = TextureArray::rgb565_le(&[0x00, 0xf8, 0x1f, 0x00]);
/// assert_eq!(SKIN.texels(), &[[Rgb565::new(31, 0, 0), Rgb565::new(0, 0, 31)]]);
/// assert_eq!(SKIN, SAME);
/// static GRAY: TextureArray<Gray4, 2, 2> = TextureArray::gray4(&[0x12, 0x34]);
/// assert_eq!(GRAY.texels(), &[[Gray4::new(1), Gray4::new(2)], [Gray4::new(3), Gray4::new(4)]]);
/// ```
///
/// Too few or too many bytes do not compile, nor does a size that is not a power of two. The compiler's error names the
/// numbers and what to write instead:
///
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static SKIN: TextureArray<Rgb565, 2, 1> = TextureArray::rgb565(&[0; 5]);
/// ```
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static SKIN: TextureArray<Rgb565, 3, 1> = TextureArray::rgb565(&[0; 6]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct TextureArray<C, const W: usize, const H: usize> {
    texels: [[C; W]; H],
}

impl<C: Copy, const W: usize, const H: usize> TextureArray<C, W, H> {
    /// A texture with these rows, the top one first.
    #[must_use]
    pub const fn from_texels(texels: [[C; W]; H]) -> Self {
        const { size_log2::<W, H>() };
        Self { texels }
    }

    /// The rows, the top one first.
    #[must_use]
    pub const fn texels(&self) -> &[[C; W]; H] {
        &self.texels
    }

    /// Borrows the texture as a [`Texture`], whose size is not part of the type.
    #[must_use]
    pub const fn as_texture(&self) -> Texture<'_, C> {
        Texture::of(Grid::of(&self.texels))
    }
}

impl<C: PixelColor + From<C::Raw>, const W: usize, const H: usize> TextureArray<C, W, H> {
    /// A texture from raw bytes at run time. `O` is their byte order: embedded-graphics' `BigEndian` or
    /// `LittleEndian`. The texture is returned by value, so it passes through the stack.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{raw::LittleEndian, Rgb565};
    /// use fixel::prelude::*;
    /// type Skin = TextureArray<Rgb565, 2, 1>;
    /// let skin = Skin::try_from_raw::<LittleEndian>(&[0x00, 0xf8, 0x1f, 0x00])?;
    /// assert_eq!(skin.texels()[0][0], Rgb565::new(31, 0, 0));
    /// let error = Skin::try_from_raw::<LittleEndian>(&[0; 3]).unwrap_err();
    /// assert_eq!(error.to_string(), "slice has 3 elements: exactly 4 are needed");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are exactly as many bytes as the texels need.
    pub fn try_from_raw<'a, O>(bytes: &'a [u8]) -> Result<Self, Error>
    where
        RawDataSlice<'a, C::Raw, O>: IntoIterator<Item = C::Raw>,
    {
        let needed = bytes_for::<W, H>(C::Raw::BITS_PER_PIXEL);
        check_length(bytes.len(), needed)?;
        let mut raw = RawDataSlice::new(bytes).into_iter().map(C::from);
        let first = raw.next().ok_or(Error::Length { given: 0, needed })?;
        let mut texels = [[first; W]; H];
        let others = texels.as_flattened_mut().iter_mut().skip(1);
        for (texel, color) in others.zip(raw) {
            *texel = color;
        }
        Ok(Self::from_texels(texels))
    }
}

sampler_of_rows!(TextureArray<C, W, H>, |array, u, v| wrapped(&array.texels, u, v));

/// The number in the first bytes of a slice, which loses them. A compiler interprets this macro in less time than a
/// function. There are enough bytes, so the 0 is never used.
macro_rules! number {
    ($bytes:ident 1 big) => {
        number!($bytes, [a], *a as u32)
    };
    ($bytes:ident 2 big) => {
        number!($bytes, [a, b], (*a as u32) << 8 | *b as u32)
    };
    ($bytes:ident 2 little) => {
        number!($bytes, [a, b], (*b as u32) << 8 | *a as u32)
    };
    ($bytes:ident 3 big) => {
        number!($bytes, [a, b, c], (*a as u32) << 16 | (*b as u32) << 8 | *c as u32)
    };
    ($bytes:ident 3 little) => {
        number!($bytes, [a, b, c], (*c as u32) << 16 | (*b as u32) << 8 | *a as u32)
    };
    ($bytes:ident, [$($byte:ident),+], $number:expr) => {
        if let [$($byte,)+ rest @ ..] = $bytes {
            $bytes = rest;
            $number
        } else {
            0
        }
    };
}
pub(super) use number;

/// How many bytes the texels take, with `bits` bits each.
const fn bytes_for<const W: usize, const H: usize>(bits: usize) -> usize {
    (W * H * bits).div_ceil(8)
}

/// A constructor from raw bytes: `$raw` is the number of the texel with an index, and `$color` is its color. The bytes
/// are a slice, from which `$raw` may cut.
macro_rules! constructor {
    ($name:ident $order:literal $bits:expr, |$bytes:pat_param, $index:ident| $raw:expr,
        |$number:ident| $color:expr) => {
        #[doc = concat!("A texture from raw bytes", $order, ".")]
        ///
        /// Too few or too many bytes do not compile.
        #[must_use]
        pub const fn $name<const LENGTH: usize>(bytes: &[u8; LENGTH]) -> Self {
            const {
                let needed = bytes_for::<W, H>($bits);
                if LENGTH != needed {
                    message::wrong_length([W, H], "bytes", LENGTH, needed);
                }
            }
            let $bytes = bytes.as_slice();
            let $number = 0;
            let mut texels = [[$color; W]; H];
            let mut $index = 0;
            while $index < W * H {
                let $number = $raw;
                texels[$index / W][$index % W] = $color;
                $index += 1;
            }
            Self::from_texels(texels)
        }
    };
}

/// Colors of two or three bytes.
macro_rules! words {
    ($($color:ident $be:ident $le:ident $bytes:tt |$raw:ident| $new:expr;)+) => {$(
        impl<const W: usize, const H: usize> TextureArray<$color, W, H> {
            constructor!($be ", the high byte of a texel first" 8 * $bytes,
                |mut bytes, index| number!(bytes $bytes big), |$raw| $new);
            constructor!($le ", the low byte of a texel first" 8 * $bytes,
                |mut bytes, index| number!(bytes $bytes little), |$raw| $new);
        }
    )+};
}

/// RGB colors: bytes per texel, and the lowest bits of the channels in embedded-graphics' format.
macro_rules! rgb {
    ($($color:ident $be:ident $le:ident $bytes:tt $r:literal $g:literal $b:literal;)+) => {
        words! {$(
            // `new` masks the bits above the channel.
            $color $be $le $bytes |raw| $color::new((raw >> $r) as u8, (raw >> $g) as u8, (raw >> $b) as u8);
        )+}
    };
}

rgb! {
    Rgb555 rgb555 rgb555_le 2 10 5 0;
    Bgr555 bgr555 bgr555_le 2 0 5 10;
    Rgb565 rgb565 rgb565_le 2 11 5 0;
    Bgr565 bgr565 bgr565_le 2 0 5 11;
    Rgb666 rgb666 rgb666_le 3 12 6 0;
    Bgr666 bgr666 bgr666_le 3 0 6 12;
    Rgb888 rgb888 rgb888_le 3 16 8 0;
    Bgr888 bgr888 bgr888_le 3 0 8 16;
}

words! {
    Argb1555 argb1555 argb1555_le 2 |raw| Argb1555::from_bits(raw as u16);
    Argb4444 argb4444 argb4444_le 2 |raw| Argb4444::from_bits(raw as u16);
}

/// Colors of a byte or less: the first one lies in the high bits.
macro_rules! packed {
    ($($color:ident $name:ident $bits:literal |$raw:ident| $new:expr;)+) => {$(
        impl<const W: usize, const H: usize> TextureArray<$color, W, H> {
            constructor!($name "" $bits, |bytes, index| {
                let at = index * $bits;
                bytes[at / 8] >> (8 - $bits - at % 8) & (0xff >> (8 - $bits))
            }, |$raw| $new);
        }
    )+};
}

packed! {
    Gray8 gray8 8 |raw| Gray8::new(raw);
    Gray4 gray4 4 |raw| Gray4::new(raw);
    Gray2 gray2 2 |raw| Gray2::new(raw);
    BinaryColor binary 1 |raw| if raw == 0 { BinaryColor::Off } else { BinaryColor::On };
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::image::{GetPixel, ImageRaw};
    use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
    use embedded_graphics::prelude::*;

    #[test]
    fn texels_equal_those_of_embedded_graphics() {
        const BYTES: [u8; 96] = {
            let mut bytes = [0; 96];
            let mut i = 0_u8;
            while i < 96 {
                bytes[i as usize] = i.wrapping_mul(i).wrapping_mul(37) ^ i;
                i += 1;
            }
            bytes
        };
        macro_rules! same {
            ($($color:ident $bits:literal $from:ident $order:ident,)+) => {$({
                const N: usize = 32 * $bits / 8;
                const RAW: [u8; N] = {
                    let mut raw = [0; N];
                    raw.copy_from_slice(BYTES.split_at(N).0);
                    raw
                };
                const TEXTURE: TextureArray<$color, 8, 4> = TextureArray::$from(&RAW);
                let image = ImageRaw::<$color, $order>::new(&RAW, 8);
                for (at, v, u) in (0..32).map(|i| (Point::new(i % 8, i / 8), i / 8, i % 8)) {
                    assert_eq!(Some((&TEXTURE).texel(u, v)), image.pixel(at), "{at}");
                }
                assert_eq!(TextureArray::<$color, 8, 4>::try_from_raw::<$order>(&RAW), Ok(TEXTURE));
                let short = TextureArray::<$color, 8, 4>::try_from_raw::<$order>(&RAW[1..]);
                assert_eq!(short, Err(Error::Length { given: N - 1, needed: N }));
            })+};
        }
        same! {
            Rgb555 16 rgb555 BigEndian,
            Bgr555 16 bgr555 BigEndian,
            Rgb565 16 rgb565 BigEndian,
            Bgr565 16 bgr565 BigEndian,
            Rgb666 24 rgb666 BigEndian,
            Bgr666 24 bgr666 BigEndian,
            Rgb888 24 rgb888 BigEndian,
            Bgr888 24 bgr888 BigEndian,
            Rgb565 16 rgb565_le LittleEndian,
            Bgr565 16 bgr565_le LittleEndian,
            Rgb888 24 rgb888_le LittleEndian,
            Bgr666 24 bgr666_le LittleEndian,
            Gray8 8 gray8 BigEndian,
            Gray4 4 gray4 BigEndian,
            Gray2 2 gray2 BigEndian,
            BinaryColor 1 binary BigEndian,
        }
    }

    #[test]
    fn texels_with_opacity_have_the_bits_of_their_bytes() {
        const BYTES: [u8; 8] = [0x8f, 0x01, 0x7f, 0x02, 0xff, 0xff, 0x12, 0x34];
        const HIGH_FIRST: [u16; 4] = [0x8f01, 0x7f02, 0xffff, 0x1234];
        const LOW_FIRST: [u16; 4] = [0x018f, 0x027f, 0xffff, 0x3412];
        macro_rules! same {
            ($($color:ident $from:ident $bits:ident,)+) => {$({
                const TEXTURE: TextureArray<$color, 2, 2> = TextureArray::$from(&BYTES);
                assert_eq!(TEXTURE.texels().as_flattened(), $bits.map($color::from_bits));
            })+};
        }
        same! {
            Argb1555 argb1555 HIGH_FIRST,
            Argb1555 argb1555_le LOW_FIRST,
            Argb4444 argb4444 HIGH_FIRST,
            Argb4444 argb4444_le LOW_FIRST,
        }
    }

    #[test]
    fn texels_repeat_in_both_directions() {
        let texture =
            TextureArray::from_texels([[0, 1, 2, 3], [4, 5, 6, 7]].map(|row| row.map(Gray8::new)));
        let texel = |u, v| (&texture).texel(u, v).luma();
        assert_eq!([texel(0, 0), texel(3, 1), texel(4, 2)], [0, 7, 0]);
        assert_eq!([texel(-1, -1), texel(i32::MIN, i32::MAX)], [7, 4]);
    }
}
