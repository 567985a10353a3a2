//! A picture inside the bytes of a file: where each pixel is and how it is read.

use embedded_graphics::pixelcolor::Rgb888;

use super::header::refused;
use super::pixel::{
    Entry, Pixel, Table, byte, channels, entry, index, rgb, widened, word, write_colors,
    write_indices,
};
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
