//! Storages that keep several pixels in a byte.

use core::cell::Cell;
use core::mem;
use core::ops::Range;

use embedded_graphics::pixelcolor::raw::{RawData, RawU1, RawU2, RawU4};
use embedded_graphics::pixelcolor::{BinaryColor, PixelColor};

use super::depth::first;
use super::storage::{RowSpan, Storage};
use crate::sealed::sealed;

/// A [`Storage`] with 8, 4 or 2 pixels in a byte, side by side: [`BinaryColor`], `Gray2`, `Gray4`, or a color of your
/// own whose `Raw` is `RawU1`, `RawU2` or `RawU4`, such as an index into a palette of 16 colors.
///
/// The leftmost pixel has the most significant bits, and each row begins with a new byte, as in embedded-graphics'
/// `Framebuffer`: a 128x64 frame of [`BinaryColor`] is 1 KiB. [`clear`](super::Canvas::clear) also fills the bits that
/// are left at the end of a row. [`Canvas::packed`](super::Canvas::packed) makes a canvas.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray4, prelude::*};
/// use fixel::prelude::*;
/// let mut bytes = [0; 4];
/// let mut canvas: Canvas<Gray4, _> = Canvas::packed(&mut bytes, 3, 2)?;
/// let (a, b) = (Gray4::new(0xa), Gray4::new(0xb));
/// canvas.draw_iter([Pixel(Point::new(0, 0), a), Pixel(Point::new(2, 1), b)])?;
/// assert_eq!(bytes, [0xa0, 0x00, 0x00, 0xb0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Packed {}

/// A [`Storage`] with 8 pixels in a byte, one below the other, as SSD1306 and similar displays want them.
///
/// A *page* is 8 rows: a byte for each column from the left, whose least significant bit is the topmost pixel.
/// Pages follow each other from the top, and a canvas's first row is the first row of a page. If the height is not a
/// multiple of 8, only the low bits of the last page are shown. [`Canvas::pages`](super::Canvas::pages) makes a canvas.
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
/// use fixel::prelude::*;
/// let mut bytes = [0; 4];
/// let mut canvas = Canvas::pages(&mut bytes, 2, 16)?;
/// let on = [Point::new(1, 0), Point::new(0, 15)];
/// canvas.draw_iter(on.map(|point| Pixel(point, BinaryColor::On)))?;
/// assert_eq!(bytes, [0x00, 0x01, 0x80, 0x00]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pages {}

sealed!(Packed, Pages);

/// The raw data of a color that is smaller than a byte.
#[diagnostic::on_unimplemented(
    message = "a packed canvas cannot store colors of raw type `{Self}`",
    label = "its pixels have 1, 2 or 4 bits",
    note = "the canvas takes the color of the shaders that are drawn to it: write `&shader.converted()`, and give the \
            canvas the type `Canvas<BinaryColor, _>` or that of `Gray2` or `Gray4`"
)]
trait Bits: RawData<Storage = u8> {}

impl Bits for RawU1 {}
impl Bits for RawU2 {}
impl Bits for RawU4 {}

/// Bits of a pixel.
const fn bits<R: Bits>() -> u32 {
    R::BITS_PER_PIXEL as u32
}

/// Pixels in a byte.
const fn per_byte<R: Bits>() -> u32 {
    8 / bits::<R>()
}

/// A byte in which all bits of its last pixel are set.
const fn mask<R: Bits>() -> u8 {
    (1 << bits::<R>()) - 1
}

#[inline]
fn unpacked<C: PixelColor<Raw: Bits> + From<C::Raw>>(byte: u8, shift: u32) -> C {
    // It drops the bits of other pixels.
    C::Raw::from_u32(u32::from(byte) >> shift).into()
}

#[inline]
fn packed<C: PixelColor<Raw: Bits + From<C>>>(byte: u8, shift: u32, color: C) -> u8 {
    let raw = C::Raw::from(color).into_inner();
    byte & !(mask::<C::Raw>() << shift) | raw << shift
}

/// Pixels of a row that share bytes.
#[derive(Clone, Copy, Debug)]
pub struct PackedCursor<'a> {
    bytes: &'a [Cell<u8>],
    /// The next pixel and the end, counted from the first pixel of the first byte.
    next: usize,
    end: usize,
}

impl<C: PixelColor<Raw: Bits + From<C>> + From<C::Raw>> Storage<C> for Packed {
    type Cell = u8;
    type Cursor<'a> = PackedCursor<'a>;
    type PixelRef<'a> = (&'a Cell<u8>, u32);

    const COLUMNS: u32 = per_byte::<C::Raw>();

    #[inline]
    fn store(color: C) -> u8 {
        C::Raw::from(color).into_inner() * (0xff / mask::<C::Raw>())
    }

    #[inline]
    fn load(cell: u8) -> C {
        unpacked(cell, 8 - bits::<C::Raw>())
    }

    #[inline]
    fn locate<'a>(span: RowSpan) -> (Range<usize>, PackedCursor<'a>) {
        let per_byte = per_byte::<C::Raw>();
        let row = span.row * span.width.div_ceil(per_byte);
        let Range { start, end } = span.columns;
        // An end below 0 is 2^31 or more, which no memory has.
        let cells = row + start / per_byte..row + end.div_ceil(per_byte);
        let next = (start % per_byte) as usize;
        let pixels = PackedCursor {
            bytes: &[],
            next,
            end: next + end.saturating_sub(start) as usize,
        };
        (cells.start as usize..cells.end as usize, pixels)
    }

    #[inline]
    fn len(_: usize, cursor: PackedCursor<'_>) -> usize {
        cursor.end - cursor.next
    }

    #[inline]
    #[allow(clippy::mut_mut)] // the slice is taken
    fn first<'a>(
        cells: &mut &'a mut [u8],
        cursor: &mut PackedCursor<'a>,
        count: usize,
    ) -> impl Iterator<Item = (&'a Cell<u8>, u32)> + use<'a, C> {
        if !cells.is_empty() {
            cursor.bytes = Cell::from_mut(mem::take(cells)).as_slice_of_cells();
        }
        let &mut PackedCursor { bytes, next, end } = cursor;
        cursor.next = next.saturating_add(count).min(end);
        let (last, per_byte) = (per_byte::<C::Raw>() - 1, per_byte::<C::Raw>() as usize);
        (next..cursor.next).map_while(move |at| {
            let shift = (last - (at % per_byte) as u32) * bits::<C::Raw>();
            Some((bytes.get(at / per_byte)?, shift))
        })
    }

    #[inline]
    fn get((byte, shift): &(&Cell<u8>, u32)) -> C {
        unpacked(byte.get(), *shift)
    }

    #[inline]
    fn set((byte, shift): (&Cell<u8>, u32), color: C) {
        byte.set(packed(byte.get(), shift, color));
    }

    #[inline]
    fn pixels(cells: &[u8], size: [u32; 2]) -> impl ExactSizeIterator<Item = C> {
        RowMajor::new(size, move |[x, y]: [u32; 2], [width, _]: [u32; 2]| {
            let per_byte = per_byte::<C::Raw>();
            let at = y * width.div_ceil(per_byte) + x / per_byte;
            let byte = cells.get(at as usize).copied().unwrap_or_default();
            unpacked(byte, (per_byte - 1 - x % per_byte) * bits::<C::Raw>())
        })
    }
}

impl Storage<BinaryColor> for Pages {
    type Cell = u8;
    /// The bit.
    type Cursor<'a> = u32;
    type PixelRef<'a> = (&'a mut u8, u32);

    const ROWS: u32 = 8;

    #[inline]
    fn store(color: BinaryColor) -> u8 {
        if color.is_on() { 0xff } else { 0 }
    }

    #[inline]
    fn load(cell: u8) -> BinaryColor {
        unpacked(cell, 0)
    }

    #[inline]
    fn locate<'a>(span: RowSpan) -> (Range<usize>, Self::Cursor<'a>) {
        let start = span.row / 8 * span.width;
        let Range { start: from, end } = span.columns;
        // They wrap as those of a canvas without pages do.
        let cells = start.wrapping_add(from) as usize..start.wrapping_add(end) as usize;
        (cells, span.row % 8)
    }

    #[inline]
    fn len(cells: usize, _: u32) -> usize {
        cells
    }

    #[inline]
    #[allow(clippy::mut_mut)] // the slice is replaced by its rest
    fn first<'a>(
        cells: &mut &'a mut [u8],
        bit: &mut u32,
        count: usize,
    ) -> impl Iterator<Item = (&'a mut u8, u32)> + use<'a> {
        let bit = *bit;
        first(cells, count).iter_mut().map(move |byte| (byte, bit))
    }

    #[inline]
    fn get((byte, bit): &(&mut u8, u32)) -> BinaryColor {
        unpacked(**byte, *bit)
    }

    #[inline]
    fn set((byte, bit): (&mut u8, u32), color: BinaryColor) {
        *byte = packed(*byte, bit, color);
    }

    #[inline]
    fn pixels(cells: &[u8], size: [u32; 2]) -> impl ExactSizeIterator<Item = BinaryColor> {
        RowMajor::new(size, move |[x, y]: [u32; 2], [width, _]: [u32; 2]| {
            let byte = cells.get((y / 8 * width + x) as usize);
            unpacked(byte.copied().unwrap_or_default(), y % 8)
        })
    }
}

/// The colors of a canvas, row by row; `color` gets a pixel's column and row, and the size.
struct RowMajor<F> {
    size: [u32; 2],
    at: [u32; 2],
    color: F,
}

impl<F> RowMajor<F> {
    const fn new(size: [u32; 2], color: F) -> Self {
        Self {
            size,
            at: [0; 2],
            color,
        }
    }
}

impl<C, F: Fn([u32; 2], [u32; 2]) -> C> Iterator for RowMajor<F> {
    type Item = C;

    #[inline]
    fn next(&mut self) -> Option<C> {
        let ([x, y], [width, height]) = (self.at, self.size);
        if y >= height {
            return None;
        }
        self.at = if x + 1 < width {
            [x + 1, y]
        } else {
            [0, y + 1]
        };
        Some((self.color)([x, y], self.size))
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let ([x, y], [width, height]) = (self.at, self.size);
        let left = ((height - y) * width - x) as usize;
        (left, Some(left))
    }
}

impl<C, F: Fn([u32; 2], [u32; 2]) -> C> ExactSizeIterator for RowMajor<F> {}
