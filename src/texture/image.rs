//! A picture inside the bytes of a file: where each pixel is and how it is read.

use embedded_graphics::pixelcolor::Rgb888;

use super::{ImageColor, Palette, Texture, bmp, tga};
use crate::Error;

/// A picture inside the bytes of an uncompressed BMP or TGA file.
///
/// It is for files that are read at run time, for example from a memory card. The constructors check the file;
/// [`read_texture`](Self::read_texture) and [`read_palette`](Self::read_palette) convert it into the caller's memory.
/// For files that are known at compile time, use [`include_bmp!`](crate::include_bmp) or
/// [`include_tga!`](crate::include_tga).
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::{prelude::*, texture::Image};
/// let bytes = include_bytes!("samples/brick.bmp"); // or bytes read at run time
/// let image = Image::from_bmp(bytes)?;
/// assert_eq!((image.width(), image.height()), (8, 4));
/// let mut texels = [Rgb565::new(0, 0, 0); 8 * 4];
/// let skin: Texture<Rgb565> = image.read_texture(&mut texels)?;
///
/// let error = Image::from_bmp(&bytes[..100]).unwrap_err();
/// assert_eq!(error.to_string(), "file has 100 bytes: it needs at least 150");
/// # let _ = skin;
/// # Ok::<(), Error>(())
/// ```
///
/// # Formats
///
/// | | pixels |
/// |---|---|
/// | BMP | 24 and 32 bits; 16 bits (5-5-5 and 5-6-5); 8, 4 and 1 bits with a color table. The header has 40, 108 or 124 bytes; the bottom or the top row comes first |
/// | TGA | 24 and 32 bits; 15 and 16 bits (5-5-5); 8 bits gray; 8 bits with a color table. Any corner comes first |
///
/// An alpha channel is ignored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Image<'a> {
    pub(super) bytes: &'a [u8],
    /// At least 1, like the height.
    pub(super) width: u32,
    pub(super) height: u32,
    /// Offset of the top left pixel.
    pub(super) first: usize,
    /// From a pixel to the next one on the right, in bytes; 0 if pixels are smaller than a byte.
    pub(super) right: isize,
    /// From a row to the next one below, in bytes.
    pub(super) down: isize,
    pub(super) pixel: Pixel,
}

/// How a pixel is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Pixel {
    /// Bytes, at these offsets for red, green and blue.
    Bytes([u8; 3]),
    /// 16 bits, the low byte first: blue in the lowest 5 bits, green in the next 5.
    Rgb555,
    /// The same with 6 bits of green.
    Rgb565,
    /// An index of this many bits: 8, 4 or 1, the first pixel in the high bits.
    Index(u32, Table),
}

/// The color table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Table {
    /// Offset of the first entry.
    pub(super) at: usize,
    /// Bytes per entry.
    pub(super) step: usize,
    /// The index that means the first entry.
    pub(super) first: usize,
    /// Number of entries, at least 1.
    pub(super) count: usize,
    pub(super) entry: Entry,
}

/// How an entry of a color table is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Entry {
    /// Blue, green, red.
    Bytes,
    /// As [`Pixel::Rgb555`].
    Rgb555,
}

// The following macros stand in place of functions: at compile time, a call takes longer than all their operations,
// and the compiler stops after two million calls and loop iterations.

/// The byte at an offset. `$length` is the number of bytes. A reader has checked that the picture lies within them,
/// so the 0 is never used.
macro_rules! byte {
    ($bytes:expr, $length:expr, $at:expr) => {{
        let at = $at;
        if at < $length { $bytes[at] } else { 0 }
    }};
}

/// The number in two bytes, the low one first.
macro_rules! word {
    ($bytes:expr, $length:expr, $at:expr) => {{
        let low = $at;
        byte!($bytes, $length, low) as u32 | (byte!($bytes, $length, low + 1) as u32) << 8
    }};
}

/// Widens a channel of 5 or 6 bits to 255 steps, rounded to nearest.
macro_rules! widened {
    ($word:expr, $shift:literal, 5) => {
        ((($word >> $shift & 0x1f) * 527 + 23) >> 6) as u8
    };
    ($word:expr, $shift:literal, 6) => {
        ((($word >> $shift & 0x3f) * 259 + 33) >> 6) as u8
    };
}

/// Red, green and blue of 16 bits; the numbers are the lowest bits of red and green.
macro_rules! channels {
    ($word:expr, 10, 5) => {{
        let word = $word;
        [
            widened!(word, 10, 5),
            widened!(word, 5, 5),
            widened!(word, 0, 5),
        ]
    }};
    ($word:expr, 11, 5) => {{
        let word = $word;
        [
            widened!(word, 11, 5),
            widened!(word, 5, 6),
            widened!(word, 0, 5),
        ]
    }};
}

/// The index of the pixel in column `$x`, at most 2^31, of the row that begins at offset `$row`; 0 if pixels are not
/// indices.
macro_rules! index {
    ($image:expr, $length:expr, $row:expr, $x:expr) => {
        match $image.pixel {
            Pixel::Index(8, _) => {
                let at = ($row + $x as isize * $image.right) as usize;
                byte!($image.bytes, $length, at)
            }
            Pixel::Index(4, _) => {
                let at = $row as usize + $x as usize / 2;
                byte!($image.bytes, $length, at) >> (4 * (1 - $x % 2)) & 0xf
            }
            Pixel::Index(..) => {
                let at = $row as usize + $x as usize / 8;
                byte!($image.bytes, $length, at) >> (7 - $x % 8) & 1
            }
            _ => 0,
        }
    };
}

/// Red, green and blue of an index; an index beyond the ends of the table has its first or last color.
macro_rules! entry {
    ($table:expr, $bytes:expr, $length:expr, $index:expr) => {{
        let (table, index) = ($table, $index as usize);
        let last = table.count - 1;
        let entry = if index < table.first {
            0
        } else {
            index - table.first
        };
        let at = table.at + table.step * if entry < last { entry } else { last };
        match table.entry {
            Entry::Bytes => [
                byte!($bytes, $length, at + 2),
                byte!($bytes, $length, at + 1),
                byte!($bytes, $length, at),
            ],
            Entry::Rgb555 => channels!(word!($bytes, $length, at), 10, 5),
        }
    }};
}

/// Red, green and blue of the pixel in column `$x` of the row that begins at offset `$row`.
macro_rules! rgb {
    ($image:expr, $length:expr, $row:expr, $x:expr) => {{
        let at = ($row + $x as isize * $image.right) as usize;
        match $image.pixel {
            Pixel::Bytes([r, g, b]) => [
                byte!($image.bytes, $length, at + r as usize),
                byte!($image.bytes, $length, at + g as usize),
                byte!($image.bytes, $length, at + b as usize),
            ],
            Pixel::Rgb555 => channels!(word!($image.bytes, $length, at), 10, 5),
            Pixel::Rgb565 => channels!(word!($image.bytes, $length, at), 11, 5),
            Pixel::Index(_, table) => {
                let index = index!($image, $length, $row, $x);
                entry!(table, $image.bytes, $length, index)
            }
        }
    }};
}

/// Writes a color to each of `$count` elements of a list: `$value`, computed from `$rgb`, which is red, green and
/// blue of the pixels of `$image`, row by row from the top.
macro_rules! write_colors {
    ($list:ident[..$count:expr] = $image:expr, |$rgb:ident| $value:expr) => {
        let image = $image;
        let (bytes, length) = (image.bytes, image.bytes.len());
        let (mut row, mut written) = (image.first as isize, 0);
        while written < $count {
            // The most frequent format has its own loop, which halves the compile time.
            if let Pixel::Bytes([r, g, b]) = image.pixel {
                let (r, g, b) = (r as usize, g as usize, b as usize);
                let (mut at, mut x) = (row, 0);
                while x < image.width && written < $count {
                    let pixel = at as usize;
                    let $rgb = [
                        byte!(bytes, length, pixel + r),
                        byte!(bytes, length, pixel + g),
                        byte!(bytes, length, pixel + b),
                    ];
                    $list[written] = $value;
                    written += 1;
                    x += 1;
                    at += image.right;
                }
            } else {
                let mut x = 0;
                while x < image.width && written < $count {
                    let $rgb = rgb!(image, length, row, x);
                    $list[written] = $value;
                    written += 1;
                    x += 1;
                }
            }
            row += image.down;
        }
    };
}

/// Writes to each of `$count` elements of a list the index of a pixel of `$image`, row by row from the top.
macro_rules! write_indices {
    ($list:ident[..$count:expr] = $image:expr) => {
        let image = $image;
        let length = image.bytes.len();
        let (mut row, mut written) = (image.first as isize, 0);
        while written < $count {
            let mut x = 0;
            while x < image.width && written < $count {
                $list[written] = index!(image, length, row, x);
                written += 1;
                x += 1;
            }
            row += image.down;
        }
    };
}

pub(super) use {byte, channels, entry, index, rgb, widened, word, write_colors, write_indices};

impl<'a> Image<'a> {
    /// Reads the header of a BMP file, and checks that all pixels are there.
    ///
    /// # Errors
    ///
    /// [`Error::Image`] if a field of the header has an unsupported value; [`Error::Truncated`] if bytes are missing.
    pub const fn from_bmp(bytes: &'a [u8]) -> Result<Self, Error> {
        bmp::read(bytes)
    }

    /// Reads the header of a TGA file, and checks that all pixels are there.
    ///
    /// # Errors
    ///
    /// As for [`from_bmp`](Self::from_bmp).
    pub const fn from_tga(bytes: &'a [u8]) -> Result<Self, Error> {
        tga::read(bytes)
    }

    /// Number of columns, at least 1.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// Number of rows, at least 1.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// Whether pixels are indices into a color table.
    #[must_use]
    pub const fn is_indexed(&self) -> bool {
        matches!(self.pixel, Pixel::Index(..))
    }

    /// The pixel in column `x` and row `y`, where (0, 0) is the top left; `None` outside the picture.
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32) -> Option<Rgb888> {
        if x < self.width && y < self.height {
            let row = self.first as isize + y as isize * self.down;
            let [r, g, b] = rgb!(self, self.bytes.len(), row, x);
            Some(Rgb888::new(r, g, b))
        } else {
            None
        }
    }

    /// Converts the picture to a texture in `texels`; [`ImageColor`] describes how colors are rounded.
    ///
    /// # Errors
    ///
    /// [`Error::PowerOfTwo`] unless the width and the height are powers of two, at most 32,768; [`Error::Length`]
    /// unless there are as many texels as pixels. Then nothing is written.
    pub fn read_texture<'t, C: ImageColor>(
        &self,
        texels: &'t mut [C],
    ) -> Result<Texture<'t, C>, Error> {
        // Checked before anything is written.
        Texture::new(texels, self.width, self.height)?;
        let count = texels.len();
        write_colors!(texels[..count] = *self, |pixel| C::nearest(pixel));
        Texture::new(texels, self.width, self.height)
    }

    /// Converts the picture to a texture of indices: it writes the pixels to `indices` and the color table to
    /// `colors`.
    ///
    /// Colors beyond the end of the table repeat its last one.
    ///
    /// # Errors
    ///
    /// As for [`read_texture`](Self::read_texture), and [`Error::Image`] if pixels are not indices.
    pub fn read_palette<'t, C: ImageColor>(
        &self,
        indices: &'t mut [u8],
        colors: &'t mut [C; 256],
    ) -> Result<Palette<'t, C>, Error> {
        let table = self.table()?;
        Texture::new(indices, self.width, self.height)?;
        let count = indices.len();
        write_indices!(indices[..count] = *self);
        for (index, color) in colors.iter_mut().enumerate() {
            *color = C::nearest(entry!(table, self.bytes, self.bytes.len(), index));
        }
        Palette::new(indices, colors, self.width, self.height)
    }

    /// The color table; an error for a palette if there is none.
    pub(super) const fn table(&self) -> Result<Table, Error> {
        let of = "bits per pixel";
        let needed = "8 (BMP: or 4 or 1) with a color table, for a palette";
        let given = match self.pixel {
            Pixel::Index(_, table) => return Ok(table),
            Pixel::Rgb555 | Pixel::Rgb565 => 16,
            // `right` may be negative.
            Pixel::Bytes(_) => 8 * self.right.unsigned_abs() as u32,
        };
        refused(of, given, needed)
    }
}

/// Where the first of `count` rows or columns is, and the way to the next one, if a file holds them in this order or
/// from the last to the first.
pub(super) const fn along(
    start: usize,
    step: usize,
    count: u32,
    is_reversed: bool,
) -> (usize, isize) {
    if is_reversed {
        (start + step * (count as usize - 1), -(step as isize))
    } else {
        (start, step as isize)
    }
}

/// An error about a field of a file's header.
pub(super) const fn refused<T>(
    of: &'static str,
    given: u32,
    needed: &'static str,
) -> Result<T, Error> {
    Err(Error::Image { of, given, needed })
}

/// The number in two bytes, the low one first.
pub(super) const fn u16_at(bytes: &[u8], at: usize) -> u32 {
    word!(bytes, bytes.len(), at)
}

/// The number in four bytes, the low one first.
pub(super) const fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u16_at(bytes, at) | u16_at(bytes, at + 2) << 16
}

/// An error if there are fewer than `needed` bytes.
pub(super) const fn at_least(bytes: &[u8], needed: u64) -> Result<(), Error> {
    let given = bytes.len();
    if given as u64 >= needed {
        return Ok(());
    }
    // Saturated, because a word may not hold the number.
    let needed = if needed > usize::MAX as u64 {
        usize::MAX
    } else {
        needed as usize
    };
    Err(Error::Truncated { given, needed })
}
