//! Textures of raw bytes.

use core::marker::PhantomData;

use embedded_graphics::iterator::raw::RawDataSlice;
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::pixelcolor::raw::{BigEndian, RawData, RawU16};

use super::sampler::exponents;
use super::{Argb1555, Argb4444, Sampler};
use crate::error::{Error, check_count, check_length, ok};
use crate::message;

/// A texture of raw bytes, usually from `include_bytes!`, in the format of embedded-graphics' `ImageRaw`.
///
/// `C` is the type of a texel: any color of embedded-graphics, [`Argb4444`] or [`Argb1555`]. `O` is the order of the
/// bytes of a texel: `BigEndian`, the default, has the high byte first; `LittleEndian` has the low byte first. Texels
/// smaller than a byte are packed, with the first texel in the high bits. For example, a mask of
/// [`Gray4`](embedded_graphics::pixelcolor::Gray4) takes half a byte per texel. Rows follow each other without a gap,
/// the top row first. Width and height are powers of two, at most [`Texture::MAX_SIZE`](crate::Texture::MAX_SIZE), and
/// a row fills whole bytes.
///
/// The bytes of a texel are converted at each pixel that is drawn. A [`Texture`](super::Texture) or rows, which hold
/// colors in memory, are faster.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray4, Rgb565, RgbColor, raw::LittleEndian};
/// use fixel::{prelude::*, texture::{Raw, Sampler}};
/// // Usually, the bytes come from include_bytes!("skin.rgb565").
/// let skin = Raw::<Rgb565>::new(&[0xf8, 0x00, 0x00, 0x1f], 2, 1)?;
/// assert_eq!([skin.texel(0, 0), skin.texel(1, 0)], [Rgb565::RED, Rgb565::BLUE]);
/// let same = Raw::<Rgb565, LittleEndian>::new(&[0x00, 0xf8, 0x1f, 0x00], 2, 1)?;
/// assert_eq!(same.texel(2, 0), Rgb565::RED); // the texture repeats
///
/// static DROP: Raw<Gray4> = Raw::checked(Raw::new(&[0x0f, 0xa5], 2, 2));
/// assert_eq!(DROP.texel(0, 1), Gray4::new(10));
///
/// let error = Raw::<Gray4>::new(&[0; 3], 4, 2).unwrap_err();
/// assert_eq!(error.to_string(), "number of bytes is 3: it must be exactly 4");
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Raw<'a, C, O = BigEndian> {
    bytes: &'a [u8],
    size_log2: [u8; 2],
    format: PhantomData<(C, O)>,
}

/// A color that can be read from raw bytes.
pub trait FromRaw: Copy {
    type Raw: RawData;

    fn from_raw(raw: Self::Raw) -> Self;
}

impl<C: PixelColor + From<C::Raw>> FromRaw for C {
    type Raw = C::Raw;

    #[inline]
    fn from_raw(raw: C::Raw) -> C {
        raw.into()
    }
}

impl FromRaw for Argb1555 {
    type Raw = RawU16;

    #[inline]
    fn from_raw(raw: RawU16) -> Self {
        Self::from_bits(raw.into_inner())
    }
}

impl FromRaw for Argb4444 {
    type Raw = RawU16;

    #[inline]
    fn from_raw(raw: RawU16) -> Self {
        Self::from_bits(raw.into_inner())
    }
}

impl<'a, C: FromRaw, O: Copy> Raw<'a, C, O>
where
    RawDataSlice<'a, C::Raw, O>: IntoIterator<Item = C::Raw>,
{
    /// A texture of `width` x `height` texels.
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] if the width or the height is not a power of two or is too large; [`Error::Count`] if a
    /// row does not fill whole bytes, or if the number of bytes is not exactly what the texels need.
    pub const fn new(bytes: &'a [u8], width: u32, height: u32) -> Result<Self, Error> {
        let size = ok!(exponents(width, height));
        let bits = C::Raw::BITS_PER_PIXEL as u32;
        ok!(check_count(
            "columns",
            width as usize,
            [8_u32.div_ceil(bits) as usize, 1 << 15]
        ));
        let row = (width * bits / 8) as usize;
        ok!(check_length(
            "bytes",
            bytes.len(),
            row.saturating_mul(height as usize)
        ));
        Ok(Self {
            bytes,
            size_log2: [size[0] as u8, size[1] as u8],
            format: PhantomData,
        })
    }

    /// Unwraps a texture in a `const` or `static`, where an error stops compilation.
    ///
    /// # Panics
    ///
    /// If `result` is an error. Call `checked` only at compile time.
    #[must_use]
    pub const fn checked(result: Result<Self, Error>) -> Self {
        message::checked(result, "texture")
    }
}

impl<'a, C: FromRaw, O: Copy> Sampler for Raw<'a, C, O>
where
    RawDataSlice<'a, C::Raw, O>: IntoIterator<Item = C::Raw>,
{
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        let [width, height] = self.size_log2;
        [width.into(), height.into()]
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
        let [width, height] = self.size_log2();
        let mask = |log2| 1_usize.wrapping_shl(log2) - 1;
        let index = (v & mask(height)).wrapping_shl(width) | u & mask(width);
        let texel = RawDataSlice::new(self.bytes).into_iter().nth(index);
        // The index is in range, so there is always a texel.
        C::from_raw(texel.unwrap_or_else(|| C::Raw::from_u32(0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::image::{GetPixel, ImageRaw};
    use embedded_graphics::pixelcolor::raw::LittleEndian;
    use embedded_graphics::pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
        Rgb888,
    };
    use embedded_graphics::prelude::*;
    use std::string::ToString;

    fn length(given: usize, needed: usize) -> Error {
        Error::Count {
            of: "bytes",
            given,
            min: needed,
            max: needed,
        }
    }

    #[test]
    fn texels_equal_those_of_embedded_graphics() {
        let bytes: [u8; 96] =
            core::array::from_fn(|i| (i as u8).wrapping_mul(i as u8).wrapping_mul(37) ^ i as u8);
        macro_rules! same {
            ($($color:ident $bits:literal $order:ident,)+) => {$({
                let bytes = &bytes[..32 * $bits / 8];
                let texture = Raw::<$color, $order>::new(bytes, 8, 4).unwrap();
                assert_eq!(texture.size_log2(), [3, 2]);
                let image = ImageRaw::<$color, $order>::new(bytes, 8);
                for (v, u) in (-4..8).flat_map(|v| (-8..16).map(move |u| (v, u))) {
                    let at = Point::new(u & 7, v & 3);
                    assert_eq!(Some(texture.texel(u, v)), image.pixel(at), "{at}");
                }
                let (given, needed) = (bytes.len() - 1, bytes.len());
                let short = Raw::<$color, $order>::new(&bytes[1..], 8, 4);
                assert_eq!(short.err(), Some(length(given, needed)));
            })+};
        }
        same! {
            Rgb555 16 BigEndian,
            Bgr555 16 BigEndian,
            Rgb565 16 BigEndian,
            Bgr565 16 LittleEndian,
            Rgb565 16 LittleEndian,
            Rgb666 24 BigEndian,
            Bgr666 24 LittleEndian,
            Rgb888 24 BigEndian,
            Bgr888 24 LittleEndian,
            Gray8 8 BigEndian,
            Gray4 4 BigEndian,
            Gray4 4 LittleEndian,
            Gray2 2 BigEndian,
            BinaryColor 1 BigEndian,
        }
    }

    #[test]
    fn texels_with_opacity_have_the_bits_of_their_bytes() {
        let bytes = [0x8f, 0x01, 0x7f, 0x02];
        let high_first = Raw::<Argb1555>::new(&bytes, 2, 1).unwrap();
        assert_eq!(high_first.texel(0, 0), Argb1555::from_bits(0x8f01));
        let low_first = Raw::<Argb4444, LittleEndian>::new(&bytes, 2, 1).unwrap();
        assert_eq!(low_first.texel(1, 0), Argb4444::from_bits(0x027f));
    }

    #[test]
    fn sizes_that_do_not_fit_are_refused() {
        let new = |width, height| Raw::<Gray4>::new(&[0; 8], width, height).map(|_| ());
        assert_eq!(new(4, 4), Ok(()));
        assert_eq!(
            new(1, 16).unwrap_err().to_string(),
            "number of columns is 1: it must be at least 2 and at most 32768"
        );
        for (width, height) in [(3, 4), (0, 4), (4, 3), (1 << 16, 1)] {
            let error = new(width, height).unwrap_err();
            assert!(
                matches!(error, Error::PowerOfTwo { .. }),
                "{width}x{height}"
            );
        }
        let (given, needed) = (8, 4);
        assert_eq!(new(4, 2), Err(length(given, needed)));
        let needed = 1 << 32;
        let large = Raw::<Argb8888>::new(&[0; 8], 1 << 15, 1 << 15).map(|_| ());
        assert_eq!(large, Err(length(given, needed)));
    }

    /// A color of four bytes.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Argb8888;

    impl PixelColor for Argb8888 {
        type Raw = embedded_graphics::pixelcolor::raw::RawU32;
    }

    impl From<embedded_graphics::pixelcolor::raw::RawU32> for Argb8888 {
        fn from(_: embedded_graphics::pixelcolor::raw::RawU32) -> Self {
            Self
        }
    }
}
