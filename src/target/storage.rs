//! How a colour lies in memory.

use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData, ToBytes};

/// How a canvas stores colours of type `C`.
///
/// [`Native`] keeps the colour itself; embedded-graphics' [`BigEndian`] and [`LittleEndian`] keep
/// its raw bytes in that order, ready for a display's bus.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
/// use fixel::target::Storage;
/// let cell = <BigEndian as Storage<Rgb565>>::store(Rgb565::RED);
/// assert_eq!(cell, [0xf8, 0x00]);
/// ```
pub trait Storage<C> {
    /// One pixel in memory.
    type Cell: Copy;

    /// A colour as it is stored.
    fn store(color: C) -> Self::Cell;

    /// A stored colour.
    fn load(cell: Self::Cell) -> C;
}

/// A [`Storage`] that keeps each colour as the type that it is.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::target::{Canvas, Native};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Native {}

impl<C: PixelColor> Storage<C> for Native {
    type Cell = C;

    #[inline]
    fn store(color: C) -> C {
        color
    }

    #[inline]
    fn load(cell: C) -> C {
        cell
    }
}

/// The bytes of a pixel: `[u8; N]`, as a number and as part of a slice.
///
/// ```
/// use fixel::target::Bytes;
/// assert_eq!([0x12, 0x34].be_number(), 0x1234);
/// assert_eq!(Bytes::flatten(&[[1, 2], [3, 4]]), [1, 2, 3, 4]);
/// ```
pub trait Bytes: Copy {
    /// The number that these bytes are, the first being the most significant.
    fn be_number(self) -> u32;

    /// The number that these bytes are, the first being the least significant.
    fn le_number(self) -> u32;

    /// The bytes of a slice of pixels, without a copy.
    fn flatten(cells: &[Self]) -> &[u8];
}

impl<const N: usize> Bytes for [u8; N] {
    #[inline]
    fn be_number(self) -> u32 {
        self.iter().fold(0, |all, &byte| all << 8 | u32::from(byte))
    }

    #[inline]
    fn le_number(self) -> u32 {
        self.iter()
            .rev()
            .fold(0, |all, &byte| all << 8 | u32::from(byte))
    }

    #[inline]
    fn flatten(cells: &[Self]) -> &[u8] {
        cells.as_flattened()
    }
}

impl<C> Storage<C> for BigEndian
where
    C: PixelColor + ToBytes<Bytes: Bytes> + From<C::Raw>,
{
    type Cell = C::Bytes;

    #[inline]
    fn store(color: C) -> C::Bytes {
        color.to_be_bytes()
    }

    #[inline]
    fn load(cell: C::Bytes) -> C {
        C::Raw::from_u32(cell.be_number()).into()
    }
}

impl<C> Storage<C> for LittleEndian
where
    C: PixelColor + ToBytes<Bytes: Bytes> + From<C::Raw>,
{
    type Cell = C::Bytes;

    #[inline]
    fn store(color: C) -> C::Bytes {
        color.to_le_bytes()
    }

    #[inline]
    fn load(cell: C::Bytes) -> C {
        C::Raw::from_u32(cell.le_number()).into()
    }
}
