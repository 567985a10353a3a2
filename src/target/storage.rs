//! How colors are stored in memory.

use core::ops::Range;

use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData, ToBytes};

use super::depth::first;

/// How a canvas stores colors of type `C`. Sealed: three types implement it.
///
/// [`Native`] keeps the color itself. embedded-graphics' [`BigEndian`] and [`LittleEndian`] keep its raw bytes in
/// that order, ready for a display's bus.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
/// use fixel::target::Storage;
/// let cell = <BigEndian as Storage<Rgb565>>::store(Rgb565::RED);
/// assert_eq!(cell, [0xf8, 0x00]);
/// assert_eq!(<BigEndian as Storage<Rgb565>>::load(cell), Rgb565::RED);
/// ```
pub trait Storage<C>: Sealed {
    /// One pixel in memory.
    type Cell: Copy;

    /// Converts a color to its stored form.
    fn store(color: C) -> Self::Cell;

    /// Converts a stored pixel back to its color.
    fn load(cell: Self::Cell) -> C;

    /// Where in its cells a run begins; nothing if each cell is a pixel.
    #[doc(hidden)]
    type Start: Copy;

    /// A pixel in memory.
    #[doc(hidden)]
    type Place<'a>
    where
        Self::Cell: 'a;

    /// The cells of a run, and where in them it begins.
    ///
    /// It gets no reference to the cells: the compiler would know more of a reference that passes through a function
    /// than of one that does not, and other code would follow for all programs.
    #[doc(hidden)]
    fn locate(run: Run) -> (Range<usize>, Self::Start);

    /// The number of pixels of a run.
    #[doc(hidden)]
    fn len(cells: usize, start: Self::Start) -> usize;

    /// Splits off the first `count` pixels of a run, or all that are left.
    #[doc(hidden)]
    fn first<'a>(
        cells: &mut &'a mut [Self::Cell],
        start: &mut Self::Start,
        count: usize,
    ) -> impl Iterator<Item = Self::Place<'a>> + use<'a, C, Self>;

    /// The color of a pixel.
    #[doc(hidden)]
    fn get(place: &Self::Place<'_>) -> C;

    /// Changes the color of a pixel.
    #[doc(hidden)]
    fn set(place: Self::Place<'_>, color: C);
}

/// Pixels side by side in a canvas; public in name only.
#[derive(Debug)]
pub struct Run {
    /// Their numbers, if the pixels of the canvas are counted row by row.
    pub(super) pixels: Range<usize>,
}

/// The layout of a storage in which each cell is a pixel.
macro_rules! cells_are_pixels {
    ($cell:ty) => {
        type Start = ();
        type Place<'a>
            = &'a mut $cell
        where
            $cell: 'a;

        #[inline(always)]
        fn locate(run: Run) -> (Range<usize>, ()) {
            (run.pixels, ())
        }

        #[inline(always)]
        fn len(cells: usize, (): ()) -> usize {
            cells
        }

        #[inline(always)]
        #[allow(clippy::mut_mut)] // the slice is replaced by its rest
        fn first<'a>(
            cells: &mut &'a mut [$cell],
            (): &mut (),
            count: usize,
        ) -> impl Iterator<Item = &'a mut $cell> + use<'a, C> {
            first(cells, count).iter_mut()
        }

        #[inline(always)]
        fn get(place: &&mut $cell) -> C {
            <Self as Storage<C>>::load(**place)
        }

        #[inline(always)]
        fn set(place: &mut $cell, color: C) {
            *place = <Self as Storage<C>>::store(color);
        }
    };
}

/// A [`Storage`] that keeps each color unconverted, in its own type.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::target::{Canvas, Native};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Native {}

/// A pixel stored as bytes: an array `[u8; N]`. Sealed.
///
/// Use it as the bound of code that sends canvases of any color in either byte order.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// use fixel::target::{Bytes, Storage};
///
/// fn send<C, O: Storage<C, Cell: Bytes>>(canvas: &Canvas<'_, C, O>, bus: &mut Vec<u8>) {
///     bus.extend_from_slice(canvas.as_bytes());
/// }
///
/// let (mut pixels, mut bus) = ([[0; 2]; 2], Vec::new());
/// let mut canvas: Canvas<Rgb565, _> = Canvas::big_endian(&mut pixels, 2, 1)?;
/// canvas.clear(Rgb565::RED);
/// send(&canvas, &mut bus);
/// assert_eq!(bus, [0xf8, 0x00, 0xf8, 0x00]);
/// # Ok::<(), Error>(())
/// ```
pub trait Bytes: ByteArray {}

impl<const N: usize> Bytes for [u8; N] {}

/// Public in name only: it keeps other crates from implementing [`Storage`].
pub trait Sealed {}

impl Sealed for Native {}
impl Sealed for BigEndian {}
impl Sealed for LittleEndian {}

/// The working part of [`Bytes`], public in name only.
pub trait ByteArray: Copy {
    /// Reads the number whose most significant byte comes first.
    fn be_number(self) -> u32;

    /// Reads the number whose least significant byte comes first.
    fn le_number(self) -> u32;

    /// Views a slice of pixels as its bytes, without a copy.
    fn flatten(cells: &[Self]) -> &[u8];
}

impl<const N: usize> ByteArray for [u8; N] {
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

    cells_are_pixels!(C);
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

    cells_are_pixels!(C::Bytes);
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

    cells_are_pixels!(C::Bytes);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_byte_is_the_highest_or_the_lowest() {
        let bytes = [0x12, 0x34, 0x56];
        assert_eq!(bytes.be_number(), 0x12_3456);
        assert_eq!(bytes.le_number(), 0x56_3412);
    }
}
