//! How a canvas stores colors in memory, and how a span gets the pixels that it draws: consecutive pixels of one row,
//! each a stored color with its depth.

use core::marker::PhantomData;
use core::mem;
use core::ops::Range;

use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData, ToBytes};
use embedded_graphics::pixelcolor::{IntoStorage, PixelColor};

use super::depth::DepthBuffer;
use crate::sealed::Sealed;

/// How a canvas stores colors of type `C`. Sealed: four types implement it.
///
/// [`Native`] keeps the color itself. [`Words`] keeps the color's raw bits as an integer, for a bus that sends words of
/// 16 bits. embedded-graphics' [`BigEndian`](BigEndian) and [`LittleEndian`](LittleEndian) keep the color's raw bytes,
/// in the order that their names say, for a bus that sends bytes.
///
/// Use this trait as a bound in code that draws on canvases of any storage, or that sends the bytes of canvases of any
/// color:
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
/// use fixel::prelude::*;
/// use fixel::canvas::Storage;
///
/// fn send<C, O, const N: usize>(canvas: &Canvas<'_, C, O>, bus: &mut Vec<u8>)
/// where
///     O: Storage<C, Cell = [u8; N]>,
/// {
///     bus.extend_from_slice(canvas.as_bytes());
/// }
///
/// let (mut pixels, mut bus) = ([[0; 2]; 2], Vec::new());
/// let mut canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut pixels, 2, 1)?;
/// canvas.clear(Rgb565::RED);
/// send(&canvas, &mut bus);
/// assert_eq!(bus, [0xf8, 0x00, 0xf8, 0x00]);
/// # Ok::<(), Error>(())
/// ```
pub trait Storage<C>: Sealed + Sized {
    /// A pixel in memory.
    type Cell: Copy + Cell<C, Self>;

    /// Converts a color to its stored form.
    fn store(color: C) -> Self::Cell;

    /// Converts a stored pixel back to its color.
    fn load(cell: Self::Cell) -> C;
}

/// A [`Storage`] that keeps each color as it is, in its own type.
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

/// A [`Storage`] that keeps a color's raw bits as an integer, such as a `u16` for `Rgb565`.
///
/// Use it if the bus and its DMA send words of 16 bits with the most significant bit first. A display of 16-bit colors
/// expects this order. The processor then stores a pixel in one step, whereas it stores [`BigEndian`](BigEndian) bytes
/// one by one. Many buses also pause after each word, so one word of 16 bits is sent faster than two words of 8 bits.
///
/// A color of up to 8 bits is stored in a `u8`, a color of up to 16 bits in a `u16`, and a color of more bits in a
/// `u32`. Unused upper bits are 0.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::canvas::{Canvas, Words};
/// let mut words = [0_u16; 4];
/// let mut canvas: Canvas<Rgb565, Words> = Canvas::new(&mut words, 2, 2)?;
/// canvas.clear(Rgb565::RED);
/// assert_eq!(words, [0xf800; 4]);
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Words {}

impl Sealed for Native {}
impl Sealed for Words {}
impl Sealed for BigEndian {}
impl Sealed for LittleEndian {}

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

impl<C, W> Storage<C> for Words
where
    C: PixelColor + IntoStorage<Storage = W> + From<C::Raw>,
    C::Raw: RawData<Storage = W>,
    W: Copy + Cell<C, Self>,
{
    type Cell = W;

    #[inline]
    fn store(color: C) -> W {
        color.into_storage()
    }

    #[inline]
    fn load(cell: W) -> C {
        C::Raw::from(cell).into()
    }
}

impl<C> Cell<C, Words> for u8 {}
impl<C> Cell<C, Words> for u16 {}
impl<C> Cell<C, Words> for u32 {}

impl<C, const N: usize> Storage<C> for BigEndian
where
    C: PixelColor + ToBytes<Bytes = [u8; N]> + From<C::Raw>,
{
    type Cell = [u8; N];

    #[inline]
    fn store(color: C) -> [u8; N] {
        color.to_be_bytes()
    }

    #[inline]
    fn load(cell: [u8; N]) -> C {
        C::Raw::from_u32(number(cell.iter())).into()
    }
}

impl<C, const N: usize> Storage<C> for LittleEndian
where
    C: PixelColor + ToBytes<Bytes = [u8; N]> + From<C::Raw>,
{
    type Cell = [u8; N];

    #[inline]
    fn store(color: C) -> [u8; N] {
        color.to_le_bytes()
    }

    #[inline]
    fn load(cell: [u8; N]) -> C {
        C::Raw::from_u32(number(cell.iter().rev())).into()
    }
}

impl<C: ToBytes<Bytes = [u8; N]>, const N: usize> Cell<C, BigEndian> for [u8; N] {}
impl<C: ToBytes<Bytes = [u8; N]>, const N: usize> Cell<C, LittleEndian> for [u8; N] {}

/// The number with these bytes, the most significant byte first.
#[inline]
fn number<'b>(bytes: impl Iterator<Item = &'b u8>) -> u32 {
    bytes.fold(0, |all, &byte| all << 8 | u32::from(byte))
}

/// A pixel of a canvas of color `C` and storage `O`. The compiler infers `C` and `O` from the pixel's type where it
/// can. The trait is public, but its module is private.
///
/// ```compile_fail,E0277
/// use fixel::prelude::*;
/// let mut bytes = [0_u8; 32]; // not `[[0_u8; 2]; 16]`
/// let canvas = Canvas::new(&mut bytes, 4, 4);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be a pixel of this canvas",
    label = "not a color, nor the integer or the array of bytes that the canvas's type asks for",
    note = "a slice of colors makes a canvas of colors; a slice of arrays makes one of bytes if its type says so: \
            `let canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut bytes, width, height)?`, where `bytes` is \
            `[[u8; 2]; N]`",
    note = "`slice.as_chunks_mut().0` views a slice of bytes as arrays"
)]
pub trait Cell<C, O> {}

impl<C: PixelColor> Cell<C, Native> for C {}

/// The colors and depths of a canvas. If a `Memory` is in registers, finding a row does not read the canvas again.
pub(crate) struct Memory<'a, C, O: Storage<C>, D> {
    pub(crate) colors: &'a mut [O::Cell],
    /// Empty if there is no depth buffer.
    pub(crate) depths: &'a mut [u16],
    pub(crate) width: u32,
    pub(crate) first_row: u32,
    pub(super) buffer: PhantomData<D>,
}

impl<'a, C, O: Storage<C>, D: DepthBuffer> Memory<'a, C, O, D> {
    #[inline]
    pub(crate) fn reborrow(&mut self) -> Memory<'_, C, O, D> {
        Memory {
            colors: self.colors,
            depths: self.depths,
            ..*self
        }
    }

    /// The pixels in some columns of a row, with their depths. The row and the columns must lie within the canvas's
    /// area; the rasterizer's rows and columns do. Returns `None` if the memory is too short for these pixels, or if
    /// `columns` ends before it starts. Never panics.
    #[inline]
    pub(crate) fn cells(self, row: u32, columns: Range<u32>) -> Option<Cells<'a, C, O, D>> {
        let first = self.begin(row);
        self.cells_from(first, columns)
    }

    /// The index of a row's first pixel in memory.
    #[inline]
    pub(crate) fn begin(&self, row: u32) -> u32 {
        row.wrapping_sub(self.first_row).wrapping_mul(self.width)
    }

    /// The [`cells`](Self::cells) of a row that begins at `first`.
    #[inline]
    pub(crate) fn cells_from(self, first: u32, columns: Range<u32>) -> Option<Cells<'a, C, O, D>> {
        // The sums wrap, because a triangle's row that is left of the frame ends before it starts, possibly below 0.
        // The range is then outside of any memory.
        let (start, end) = (
            first.wrapping_add(columns.start),
            first.wrapping_add(columns.end),
        );
        let range = start as usize..end as usize;
        Some(Cells {
            colors: self.colors.get_mut(range.clone())?,
            depths: if D::IS_KEPT {
                self.depths.get_mut(range)?
            } else {
                &mut []
            },
            buffer: PhantomData,
        })
    }
}

/// Pixels of a row in memory: colors and depths.
pub(crate) struct Cells<'a, C, O: Storage<C>, D> {
    colors: &'a mut [O::Cell],
    depths: &'a mut [u16],
    buffer: PhantomData<D>,
}

impl<'a, C, O: Storage<C>, D: DepthBuffer> Cells<'a, C, O, D> {
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.colors.len()
    }

    /// Splits off the colors of the first `N` pixels; `None` if fewer are left. The depths of these pixels are not
    /// split off, because they are not used.
    #[inline]
    pub(crate) fn colors<const N: usize>(&mut self) -> Option<&'a mut [O::Cell; N]> {
        // If too few colors are left, none may be split off.
        if self.colors.len() < N {
            return None;
        }
        first(&mut self.colors, N).first_chunk_mut()
    }

    /// The pixel at an index, with its depth.
    #[inline]
    pub(crate) fn at(&mut self, index: usize) -> Option<(&mut O::Cell, Option<&mut u16>)> {
        let depth = if D::IS_KEPT {
            self.depths.get_mut(index)
        } else {
            None
        };
        Some((self.colors.get_mut(index)?, depth))
    }

    /// The stored depths; none if they are not kept.
    #[inline]
    pub(crate) fn depths(&self) -> &[u16] {
        self.depths
    }

    /// Splits off the first `count` pixels, or all that are left.
    #[inline]
    pub(crate) fn first(
        &mut self,
        count: usize,
    ) -> impl Iterator<Item = (&'a mut O::Cell, Option<&'a mut u16>)> + use<'a, C, O, D> {
        let (colors, depths) = (
            first(&mut self.colors, count),
            first(&mut self.depths, count),
        );
        colors.iter_mut().zip(D::each(depths))
    }
}

/// Splits off the first `count` elements of a slice, or all that are left.
#[inline]
#[allow(clippy::mut_mut)] // the slice is replaced by its rest
fn first<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let all = mem::take(slice);
    let (first, rest) = all.split_at_mut(count.min(all.len()));
    *slice = rest;
    first
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
