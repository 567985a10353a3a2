//! How colors are stored in memory.

use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData, ToBytes};

use crate::sealed::{Sealed, sealed};

/// How a canvas stores colors of type `C`. Sealed: three types implement it.
///
/// [`Native`] keeps the color itself. embedded-graphics' [`BigEndian`] and [`LittleEndian`] keep its raw bytes in that
/// order, ready for a display's bus.
///
/// Use it as the bound of code that draws on a canvas however it stores its colors, or sends the bytes of canvases of
/// any color:
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

sealed!(Native, BigEndian, LittleEndian);

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

/// The number whose most significant byte comes first.
#[inline]
fn number<'b>(bytes: impl Iterator<Item = &'b u8>) -> u32 {
    bytes.fold(0, |all, &byte| all << 8 | u32::from(byte))
}

/// A pixel of a canvas whose color is `C` and whose storage is `O`. The compiler infers these from the pixel where it
/// can. Public in name only.
///
/// ```compile_fail,E0277
/// use fixel::prelude::*;
/// let mut bytes = [0_u8; 32]; // not `[[0_u8; 2]; 16]`
/// let canvas = Canvas::new(&mut bytes, 4, 4);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be a pixel of this canvas",
    label = "not a color, nor an array of bytes that the canvas's type asks for",
    note = "a slice of colors makes a canvas of colors; a slice of arrays makes one of bytes if its type says so: \
            `let canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut bytes, width, height)?`, where `bytes` is \
            `[[u8; 2]; N]`",
    note = "`slice.as_chunks_mut().0` views a slice of bytes as arrays"
)]
pub trait Cell<C, O> {}

impl<C: PixelColor> Cell<C, Native> for C {}
impl<C: ToBytes<Bytes = [u8; N]>, const N: usize> Cell<C, BigEndian> for [u8; N] {}
impl<C: ToBytes<Bytes = [u8; N]>, const N: usize> Cell<C, LittleEndian> for [u8; N] {}

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
