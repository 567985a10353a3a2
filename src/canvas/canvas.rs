//! The canvas: the caller's memory as a frame or a band of it.

use core::marker::PhantomData;
use core::ops::Range;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
use embedded_graphics::pixelcolor::{BinaryColor, PixelColor};
use embedded_graphics::primitives::{PointsIter, Rectangle};

use super::depth::{Depth, DepthBuffer, NoDepth};
use super::format::{DepthFormat, Linear};
use super::memory::{Cells, Memory};
use super::packed::{Packed, Pages};
use super::storage::{Bytes, Native, RowSpan, Storage};
use crate::Error;
use crate::error::check_length;

/// Largest width and height of a frame, in pixels.
pub const MAX_SIZE: u32 = 2048;

/// The pixels of a frame, or of a horizontal band of it, in memory that belongs to the caller.
///
#[cfg_attr(doc, doc = diagram!("band"))]
/// Column 0, row 0 is the frame's top left pixel. A band knows which rows of which frame it holds. Everything is
/// drawn in the frame's coordinates, and pixels outside the band are skipped. Put together, the bands of a frame
/// equal the whole frame, bit for bit.
///
/// `C` is the color, `O` the way it is stored, and `D` the depth buffer: [`NoDepth`] or [`Depth`].
///
/// | pixels in memory | a whole frame | a band of it |
/// |---|---|---|
/// | colors ([`Native`]) | [`new`](Self::new) | [`band`](Self::band) |
/// | bytes, most significant first ([`BigEndian`]) | [`big_endian`](Self::big_endian) | [`big_endian_band`](Self::big_endian_band) |
/// | bytes, least significant first ([`LittleEndian`]) | [`little_endian`](Self::little_endian) | [`little_endian_band`](Self::little_endian_band) |
/// | 8, 4 or 2 pixels in a byte, side by side ([`Packed`]) | [`packed`](Self::packed) | [`packed_band`](Self::packed_band) |
/// | 8 pixels in a byte, one below the other ([`Pages`]) | [`pages`](Self::pages) | [`pages_band`](Self::pages_band) |
///
/// [`with_depth`](Self::with_depth) and [`with_depth_format`](Self::with_depth_format) add a depth buffer.
///
/// Compared with a canvas of colors, drawing a pixel in black and white takes 4 instructions more on a canvas of pages
/// and 15 more on a packed one, on a Cortex-M4; on a Cortex-M0+, it takes 7 and 18 more. With a palette, a pixel is a
/// [`ColorIndex`](super::ColorIndex), stored as a color.
///
/// A canvas is an embedded-graphics [`DrawTarget`], so text and gauges can be drawn over the picture.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
///
/// const WIDTH: u32 = 32;
/// const HEIGHT: u32 = 24;
/// let mut color = [Rgb565::BLACK; (WIDTH * HEIGHT) as usize];
/// let mut depth = [0; (WIDTH * HEIGHT) as usize];
/// let mut canvas = Canvas::new(&mut color, WIDTH, HEIGHT)?.with_depth(&mut depth)?;
/// canvas.clear(Rgb565::BLUE);
/// assert!(canvas.pixels().all(|pixel| pixel == Rgb565::BLUE));
/// # Ok::<(), Error>(())
/// ```
///
/// `Canvas<Rgb565>` has no depth buffer. So a function that draws names the whole type, or takes any:
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// use fixel::canvas::{Depth, DepthBuffer, Native, Storage};
///
/// fn with_depth(canvas: &mut Canvas<Rgb565, Native, Depth>) {
///     on_any(canvas);
/// }
///
/// fn on_any<O: Storage<Rgb565>, D: DepthBuffer>(canvas: &mut Canvas<Rgb565, O, D>) {
///     canvas.clear(Rgb565::BLUE);
/// }
/// ```
#[derive(Debug)]
pub struct Canvas<'a, C, O: Storage<C> = Native, D = NoDepth> {
    cells: &'a mut [O::Cell],
    depth: D,
    width: u32,
    height: u32,
    rows: Range<u32>,
}

impl<'a, C: PixelColor> Canvas<'a, C> {
    /// A canvas of `width` x `height` pixels, stored as colors, row by row from the top.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] if a side is 0 or above [`MAX_SIZE`]; [`Error::Length`] if `pixels` does
    /// not have exactly one element per pixel.
    pub fn new(pixels: &'a mut [C], width: u32, height: u32) -> Result<Self, Error> {
        Self::over(pixels, width, height)
    }

    /// A band of a frame of `width` x `height` pixels: as many rows as `pixels` holds, starting at `first_row`.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] if a side of the frame is 0 or above [`MAX_SIZE`]; [`Error::Length`] if `pixels` is not a
    /// whole number of rows; [`Error::Rows`] if it holds no row, or a row outside the frame.
    pub fn band(
        pixels: &'a mut [C],
        width: u32,
        height: u32,
        first_row: u32,
    ) -> Result<Self, Error> {
        Self::band_over(pixels, width, height, first_row)
    }
}

impl<'a, C> Canvas<'a, C, BigEndian>
where
    BigEndian: Storage<C>,
{
    /// A canvas of pixels stored as bytes, most significant first: the order that most displays expect. Each element of
    /// `pixels` is the array of a pixel's bytes, `[u8; 2]` for `Rgb565`. From Rust 1.88 on,
    /// `bytes.as_chunks_mut().0` views a slice of bytes in this way.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use fixel::prelude::*;
    /// let mut bytes = [[0; 2]; 4];
    /// let mut canvas: Canvas<Rgb565, _> = Canvas::big_endian(&mut bytes, 2, 2)?;
    /// canvas.clear(Rgb565::RED);
    /// assert_eq!(canvas.as_bytes()[..2], [0xf8, 0x00]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`new`](Canvas::new).
    pub fn big_endian(
        pixels: &'a mut [<BigEndian as Storage<C>>::Cell],
        width: u32,
        height: u32,
    ) -> Result<Self, Error> {
        Self::over(pixels, width, height)
    }

    /// A band stored as bytes, most significant first.
    ///
    /// # Errors
    ///
    /// As for [`band`](Canvas::band).
    pub fn big_endian_band(
        pixels: &'a mut [<BigEndian as Storage<C>>::Cell],
        width: u32,
        height: u32,
        first_row: u32,
    ) -> Result<Self, Error> {
        Self::band_over(pixels, width, height, first_row)
    }
}

impl<'a, C> Canvas<'a, C, LittleEndian>
where
    LittleEndian: Storage<C>,
{
    /// A canvas of pixels stored as bytes, least significant first. The elements of `pixels` are arrays, as for
    /// [`big_endian`](Canvas::big_endian).
    ///
    /// # Errors
    ///
    /// As for [`new`](Canvas::new).
    pub fn little_endian(
        pixels: &'a mut [<LittleEndian as Storage<C>>::Cell],
        width: u32,
        height: u32,
    ) -> Result<Self, Error> {
        Self::over(pixels, width, height)
    }

    /// A band stored as bytes, least significant first.
    ///
    /// # Errors
    ///
    /// As for [`band`](Canvas::band).
    pub fn little_endian_band(
        pixels: &'a mut [<LittleEndian as Storage<C>>::Cell],
        width: u32,
        height: u32,
        first_row: u32,
    ) -> Result<Self, Error> {
        Self::band_over(pixels, width, height, first_row)
    }
}

impl<'a, C> Canvas<'a, C, Packed>
where
    Packed: Storage<C, Cell = u8>,
{
    /// A canvas with 8, 4 or 2 pixels in a byte, side by side; see [`Packed`].
    ///
    /// # Errors
    ///
    /// As for [`new`](Canvas::new), with one element per byte; each row begins with a new byte.
    pub fn packed(pixels: &'a mut [u8], width: u32, height: u32) -> Result<Self, Error> {
        Self::over(pixels, width, height)
    }

    /// A band with 8, 4 or 2 pixels in a byte.
    ///
    /// # Errors
    ///
    /// As for [`band`](Canvas::band).
    pub fn packed_band(
        pixels: &'a mut [u8],
        width: u32,
        height: u32,
        first_row: u32,
    ) -> Result<Self, Error> {
        Self::band_over(pixels, width, height, first_row)
    }
}

impl<'a> Canvas<'a, BinaryColor, Pages> {
    /// A canvas of pages: a byte is 8 rows of one column; see [`Pages`].
    ///
    /// # Errors
    ///
    /// As for [`new`](Canvas::new), with one element per column and page.
    pub fn pages(pixels: &'a mut [u8], width: u32, height: u32) -> Result<Self, Error> {
        Self::over(pixels, width, height)
    }

    /// A band of pages. The last page may reach below the frame. The first row in memory is the first bit of a page, so
    /// `first_row` must be a multiple of 8 if the band is sent to such a display.
    ///
    /// # Errors
    ///
    /// As for [`band`](Canvas::band).
    pub fn pages_band(
        pixels: &'a mut [u8],
        width: u32,
        height: u32,
        first_row: u32,
    ) -> Result<Self, Error> {
        Self::band_over(pixels, width, height, first_row)
    }
}

impl<'a, C, O: Storage<C>> Canvas<'a, C, O> {
    fn over(cells: &'a mut [O::Cell], width: u32, height: u32) -> Result<Self, Error> {
        check_size(width, height)?;
        let needed = cells_across::<C, O>(width) * height.div_ceil(O::ROWS);
        check_length(cells.len(), needed as usize)?;
        Ok(Self {
            cells,
            depth: NoDepth,
            width,
            height,
            rows: 0..height,
        })
    }

    fn band_over(
        cells: &'a mut [O::Cell],
        width: u32,
        height: u32,
        first: u32,
    ) -> Result<Self, Error> {
        check_size(width, height)?;
        let across = cells_across::<C, O>(width);
        // A frame has fewer than 2^32 pixels, so a longer slice is refused with any row count.
        let down = u32::try_from(cells.len() / across as usize).unwrap_or(u32::MAX);
        let rows = down.saturating_mul(O::ROWS);
        match first.checked_add(rows) {
            // The last cells may reach below the frame.
            Some(end) if rows > 0 && first < height && end < height + O::ROWS => {
                check_length(cells.len(), (across * down) as usize)?;
                Ok(Self {
                    cells,
                    depth: NoDepth,
                    width,
                    height,
                    rows: first..end.min(height),
                })
            }
            _ => Err(Error::Rows {
                first,
                rows,
                height,
            }),
        }
    }

    /// Adds a depth buffer in [`Linear`] format: one `u16` per pixel.
    ///
    /// [`clear`](Canvas::clear) and [`clear_depth`](Canvas::clear_depth) clear it. A new buffer must
    /// be all 0 (infinitely far) or be cleared before the first draw call.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if `depth` does not have exactly one element per pixel.
    pub fn with_depth<'d>(
        self,
        depth: &'d mut [u16],
    ) -> Result<Canvas<'a, C, O, Depth<'d>>, Error> {
        self.with_depth_format::<Linear>(depth)
    }

    /// Adds a depth buffer in a format of your choice. [`Depth`] compares the formats.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::prelude::*;
    /// use fixel::canvas::Float;
    /// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
    /// let mut canvas = Canvas::new(&mut pixels, 2, 2)?.with_depth_format::<Float>(&mut depths)?;
    /// canvas.clear(Gray8::new(0));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`with_depth`](Self::with_depth).
    pub fn with_depth_format<'d, F: DepthFormat>(
        self,
        depth: &'d mut [u16],
    ) -> Result<Canvas<'a, C, O, Depth<'d, F>>, Error> {
        check_length(depth.len(), (self.width * self.row_count()) as usize)?;
        Ok(Canvas {
            cells: self.cells,
            depth: Depth {
                cells: depth,
                format: PhantomData,
            },
            width: self.width,
            height: self.height,
            rows: self.rows,
        })
    }
}

impl<C, O: Storage<C>, D> Canvas<'_, C, O, D> {
    /// Width and height of the frame, in pixels.
    #[must_use]
    pub const fn frame_size(&self) -> Size {
        Size::new(self.width, self.height)
    }

    /// The rows of the frame that are in memory: all of them, unless the canvas is a band.
    #[must_use]
    pub const fn rows(&self) -> &Range<u32> {
        &self.rows
    }

    const fn row_count(&self) -> u32 {
        self.rows.end - self.rows.start
    }

    /// The colors in memory, row by row from the top, each row from the left.
    pub fn pixels(&self) -> impl ExactSizeIterator<Item = C> {
        O::pixels(self.cells, [self.width, self.row_count()])
    }

    /// The pixels in their stored form, in the same order.
    #[must_use]
    pub const fn as_cells(&self) -> &[O::Cell] {
        self.cells
    }

    /// The pixels as bytes, in the order in which a bus sends them. This is a view, not a copy.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8]
    where
        O::Cell: Bytes,
    {
        Bytes::flatten(self.cells)
    }

    /// Shows the canvas on a display of the same color, in one
    /// [`fill_contiguous`](DrawTarget::fill_contiguous). A band goes to its place in the frame.
    /// [`show_with`](Self::show_with) shows it on a display of another color.
    ///
    /// # Errors
    ///
    /// The display's own errors.
    pub fn show<T>(&self, display: &mut T) -> Result<(), T::Error>
    where
        C: PixelColor,
        T: DrawTarget<Color = C>,
    {
        display.fill_contiguous(&self.area(), self.pixels())
    }

    /// Shows the canvas on a display of another color, as [`show`](Self::show) does. `color` converts the color at each
    /// point of the frame.
    ///
    /// A canvas of [`ColorIndex`](super::ColorIndex) looks its colors up in a palette this way. A gray canvas can be
    /// dithered once the whole frame is drawn and its [`Contrast`](super::Contrast) is known:
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{BinaryColor, Gray8, GrayColor};
    /// use fixel::{prelude::*, canvas::Contrast};
    /// let mut grays = [Gray8::new(40), Gray8::new(60)];
    /// let gray = Canvas::new(&mut grays, 2, 1)?;
    /// let mut bytes = [0; 1];
    /// let mut panel: Canvas<BinaryColor, _> = Canvas::packed(&mut bytes, 2, 1)?;
    /// let contrast = Contrast::of(&gray, 0);
    /// let Ok(()) = gray.show_with(&mut panel, |at, gray| {
    ///     BinaryColor::from_rgb(contrast.stretch(gray).into(), at)
    /// });
    /// assert_eq!(bytes, [0b0100_0000]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The display's own errors.
    pub fn show_with<T: DrawTarget>(
        &self,
        display: &mut T,
        mut color: impl FnMut(Point, C) -> T::Color,
    ) -> Result<(), T::Error> {
        let area = self.area();
        let colors = area.points().zip(self.pixels());
        display.fill_contiguous(&area, colors.map(|(at, pixel)| color(at, pixel)))
    }

    /// The part of the frame that is in memory.
    pub(super) fn area(&self) -> Rectangle {
        Rectangle::new(
            Point::new(0, self.rows.start.cast_signed()),
            Size::new(self.width, self.row_count()),
        )
    }

    /// The pixels of `columns` of `row`; both must lie within [`area`](Self::area).
    #[inline]
    pub(super) fn pixels_mut(
        &mut self,
        row: u32,
        columns: &Range<u32>,
    ) -> impl Iterator<Item = O::PixelRef<'_>> {
        let span = RowSpan::new(row - self.rows.start, columns.clone(), self.width);
        let (cells, mut cursor) = O::locate(span);
        let mut cells = self.cells.get_mut(cells).unwrap_or_default();
        O::first(&mut cells, &mut cursor, usize::MAX)
    }
}

impl<C, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Sets every pixel to `color` and every depth, if there is a depth buffer, to infinity.
    ///
    /// embedded-graphics' [`DrawTarget::clear`] does the same.
    pub fn clear(&mut self, color: C) {
        self.cells.fill(O::store(color));
        self.clear_depth();
    }

    /// Sets every depth to infinity and keeps the colors, so that the next draw call covers them.
    ///
    /// Use it for a second scene over the first, such as a cockpit or a gauge that no wall may hide. Without a depth
    /// buffer, it does nothing.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::prelude::*;
    /// let (mut pixels, mut depths) = ([Gray8::new(5); 4], [7; 4]);
    /// let mut canvas = Canvas::new(&mut pixels, 2, 2)?.with_depth(&mut depths)?;
    /// canvas.clear_depth();
    /// assert!(canvas.pixels().all(|pixel| pixel == Gray8::new(5)));
    /// assert_eq!(depths, [0; 4]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn clear_depth(&mut self) {
        self.depth.clear();
    }

    /// [`Memory::cells`] for a single row.
    #[inline]
    pub(crate) fn cells(&mut self, row: u32, columns: Range<u32>) -> Option<Cells<'_, C, O, D>> {
        self.memory().cells(row, columns)
    }

    /// The memory of all pixels and depths.
    #[inline]
    pub(crate) fn memory(&mut self) -> Memory<'_, C, O, D> {
        Memory {
            cells: self.cells,
            depth: &mut self.depth,
            width: self.width,
            first_row: self.rows.start,
        }
    }
}

impl<C, O: Storage<C>, D> Dimensions for Canvas<'_, C, O, D> {
    /// The part of the frame that is in memory.
    fn bounding_box(&self) -> Rectangle {
        self.area()
    }
}

pub(crate) const fn check_size(width: u32, height: u32) -> Result<(), Error> {
    if width == 0 || height == 0 || width > MAX_SIZE || height > MAX_SIZE {
        return Err(Error::Size {
            width,
            height,
            max: MAX_SIZE,
        });
    }
    Ok(())
}

/// The number of cells of a row.
const fn cells_across<C, O: Storage<C>>(width: u32) -> u32 {
    width.div_ceil(O::COLUMNS)
}
