//! How colors are stored in memory.

use core::ops::Range;

use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData, ToBytes};

use super::depth::first;
use crate::sealed::{Sealed, sealed};

/// How a canvas stores colors of type `C`. Sealed: five types implement it.
///
/// [`Native`] keeps the color itself. embedded-graphics' [`BigEndian`] and [`LittleEndian`] keep its raw bytes in that
/// order, ready for a display's bus. [`Packed`](super::Packed) and [`Pages`](super::Pages) keep several pixels in a
/// byte.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
/// use fixel::canvas::Storage;
/// let cell = <BigEndian as Storage<Rgb565>>::store(Rgb565::RED);
/// assert_eq!(cell, [0xf8, 0x00]);
/// assert_eq!(<BigEndian as Storage<Rgb565>>::load(cell), Rgb565::RED);
/// ```
pub trait Storage<C>: Sealed {
    /// An element of a canvas's memory: a pixel, or a byte of several.
    type Cell: Copy;

    /// Converts a color to its stored form: a cell in which all pixels have this color.
    fn store(color: C) -> Self::Cell;

    /// Converts a stored pixel, the first of a cell, back to its color.
    fn load(cell: Self::Cell) -> C;

    /// Pixels of a cell side by side.
    #[doc(hidden)]
    const COLUMNS: u32 = 1;

    /// Pixels of a cell one below the other.
    #[doc(hidden)]
    const ROWS: u32 = 1;

    /// The position in its cells at which a span begins; no data if each cell is a pixel.
    #[doc(hidden)]
    type Cursor<'a>: Copy;

    /// A pixel in memory.
    #[doc(hidden)]
    type PixelRef<'a>
    where
        Self::Cell: 'a;

    /// The cells of a span, and the position in them at which it begins.
    ///
    /// It takes no reference to the cells: a reference passed through a function would tell the compiler more
    /// (`noalias`), and change the code of every program.
    #[doc(hidden)]
    fn locate<'a>(span: RowSpan) -> (Range<usize>, Self::Cursor<'a>);

    /// The number of pixels of a span.
    #[doc(hidden)]
    fn len(cells: usize, cursor: Self::Cursor<'_>) -> usize;

    /// Splits off the first `count` pixels of a span, or all that are left.
    #[doc(hidden)]
    #[allow(clippy::mut_mut)] // the slice is replaced by its rest
    fn first<'a>(
        cells: &mut &'a mut [Self::Cell],
        cursor: &mut Self::Cursor<'a>,
        count: usize,
    ) -> impl Iterator<Item = Self::PixelRef<'a>> + use<'a, C, Self>;

    /// The color of a pixel.
    #[doc(hidden)]
    fn get(pixel: &Self::PixelRef<'_>) -> C;

    /// Changes the color of a pixel.
    #[doc(hidden)]
    fn set(pixel: Self::PixelRef<'_>, color: C);

    /// The colors of all pixels of `size` (columns and rows), row by row.
    #[doc(hidden)]
    fn pixels(cells: &[Self::Cell], size: [u32; 2]) -> impl ExactSizeIterator<Item = C>;
}

/// Pixels side by side in a canvas; public in name only.
#[derive(Debug)]
pub struct RowSpan {
    /// Their numbers, if the pixels of the canvas are counted row by row.
    pub(super) pixels: Range<usize>,
    /// Counted from the first row in memory.
    pub(super) row: u32,
    pub(super) columns: Range<u32>,
    /// Of the canvas.
    pub(super) width: u32,
}

impl RowSpan {
    /// It wraps: a triangle's row that is left of the frame ends before it starts, possibly below 0. The result is then
    /// a range outside of any memory.
    #[inline]
    pub(super) const fn new(row: u32, columns: Range<u32>, width: u32) -> Self {
        let start = row * width;
        let pixels =
            start.wrapping_add(columns.start) as usize..start.wrapping_add(columns.end) as usize;
        Self {
            pixels,
            row,
            columns,
            width,
        }
    }
}

/// The layout of a storage in which each cell is a pixel.
macro_rules! cells_are_pixels {
    ($cell:ty) => {
        type Cursor<'a> = ();
        type PixelRef<'a>
            = &'a mut $cell
        where
            $cell: 'a;

        #[inline(always)]
        fn locate<'a>(span: RowSpan) -> (Range<usize>, <Self as Storage<C>>::Cursor<'a>) {
            (span.pixels, ())
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
        fn get(pixel: &&mut $cell) -> C {
            <Self as Storage<C>>::load(**pixel)
        }

        #[inline(always)]
        fn set(pixel: &mut $cell, color: C) {
            *pixel = <Self as Storage<C>>::store(color);
        }

        #[inline(always)]
        fn pixels(cells: &[$cell], _: [u32; 2]) -> impl ExactSizeIterator<Item = C> {
            cells.iter().map(|&cell| <Self as Storage<C>>::load(cell))
        }
    };
}

/// A [`Storage`] that keeps each color unconverted, in its own type.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, Native};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Native {}

/// A pixel stored as bytes, `[u8; N]`, or a byte of several pixels, `u8`. Sealed.
///
/// Use it as the bound of code that sends canvases of any color, in either byte order or packed.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// use fixel::canvas::{Bytes, Storage};
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
pub trait Bytes: Copy + Sealed {
    /// Views a slice of pixels as its bytes, without a copy.
    #[doc(hidden)]
    fn flatten(cells: &[Self]) -> &[u8];
}

impl<const N: usize> Bytes for [u8; N] {
    #[inline]
    fn flatten(cells: &[Self]) -> &[u8] {
        cells.as_flattened()
    }
}

impl Bytes for u8 {
    #[inline]
    fn flatten(cells: &[Self]) -> &[u8] {
        cells
    }
}

sealed!(Native, BigEndian, LittleEndian, u8);
impl<const N: usize> Sealed for [u8; N] {}

/// The number whose most significant byte comes first.
#[inline]
fn number<'b>(bytes: impl Iterator<Item = &'b u8>) -> u32 {
    bytes.fold(0, |all, &byte| all << 8 | u32::from(byte))
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

impl<C: PixelColor + ToBytes<Bytes: Copy + AsRef<[u8]>> + From<C::Raw>> Storage<C> for BigEndian {
    type Cell = C::Bytes;

    #[inline]
    fn store(color: C) -> C::Bytes {
        color.to_be_bytes()
    }

    #[inline]
    fn load(cell: C::Bytes) -> C {
        C::Raw::from_u32(number(cell.as_ref().iter())).into()
    }

    cells_are_pixels!(C::Bytes);
}

impl<C: PixelColor + ToBytes<Bytes: Copy + AsRef<[u8]>> + From<C::Raw>> Storage<C>
    for LittleEndian
{
    type Cell = C::Bytes;

    #[inline]
    fn store(color: C) -> C::Bytes {
        color.to_le_bytes()
    }

    #[inline]
    fn load(cell: C::Bytes) -> C {
        C::Raw::from_u32(number(cell.as_ref().iter().rev())).into()
    }

    cells_are_pixels!(C::Bytes);
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn the_first_byte_is_the_highest_or_the_lowest() {
        let bytes = [0x12, 0x34, 0x56];
        assert_eq!(number(bytes.iter()), 0x12_3456);
        assert_eq!(number(bytes.iter().rev()), 0x56_3412);
    }
}
