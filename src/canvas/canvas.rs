//! The canvas: a frame, or a band of a frame, in memory of the caller.

use core::hint::black_box;
use core::marker::PhantomData;
use core::ops::Range;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::pixelcolor::{BinaryColor, PixelColor};
use embedded_graphics::primitives::{PointsIter, Rectangle};

use super::depth::{DepthBuffer, LinearDepth, NoDepth};
use super::storage::{Cell, Cells, Memory, Native, Storage};
use crate::error::Error;
use crate::error::{check_count, check_length, ok};
use crate::num::wide::STORES_ANYWHERE;
use crate::view::Viewport;

/// Largest width and height of a frame, in pixels.
const MAX_SIZE: u32 = 2048;

/// Your memory as a picture that draw calls write to: a frame, or a band of a frame (some of its rows).
///
#[cfg_attr(doc, doc = include_str!("../guide/diagrams/band.svg"))]
///
/// Column 0, row 0 is the frame's top left pixel. A band knows the size of its frame, and which rows of the frame it
/// holds. Draw everything in the frame's coordinates; the band skips the pixels outside its rows. Put together, the
/// bands of a frame equal the whole frame, bit for bit.
///
/// `C` is the color, `O` the way it is stored, and `D` the depth buffer.
///
/// | pixels in memory | element of the slice | type |
/// |---|---|---|
/// | colors | `Rgb565` | `Canvas<Rgb565>` |
/// | words of raw bits, for a bus of 16-bit words | `u16` | `Canvas<Rgb565, `[`Words`](super::Words)`>` |
/// | bytes, most significant first | `[u8; 2]` | `Canvas<Rgb565, BigEndian>` |
/// | bytes, least significant first | `[u8; 2]` | `Canvas<Rgb565, LittleEndian>` |
/// | indices of colors in a palette | [`ColorIndex`](super::ColorIndex) | `Canvas<ColorIndex>` |
///
/// [`BigEndian`](embedded_graphics::pixelcolor::raw::BigEndian) and
/// [`LittleEndian`](embedded_graphics::pixelcolor::raw::LittleEndian) are embedded-graphics' types. For displays with
/// several pixels in a byte, [`show`](Self::show) and [`pages`](Self::pages) pack the pixels. For these displays, draw
/// in bands: before packing, a band of 8 rows of 128 pixels takes 1 KiB, as much as a whole packed frame of 128x64.
///
/// [`with_depth`](Self::with_depth) and [`with_depth_format`](Self::with_depth_format) add a depth buffer.
///
/// A canvas is an embedded-graphics [`DrawTarget`](DrawTarget), so text and gauges can be drawn over the picture.
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
/// The type `Canvas<Rgb565>` has no depth buffer. A function that takes a canvas with a depth buffer must name the
/// canvas's whole type, or be generic:
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// use fixel::canvas::{DepthBuffer, Storage};
///
/// fn with_depth(canvas: &mut Canvas<Rgb565, Native, LinearDepth>) {
///     on_any(canvas);
/// }
///
/// fn on_any<O: Storage<Rgb565>, D: DepthBuffer>(canvas: &mut Canvas<Rgb565, O, D>) {
///     canvas.clear(Rgb565::BLUE);
/// }
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[derive(Debug)]
pub struct Canvas<'a, C, O: Storage<C> = Native, D = NoDepth> {
    cells: &'a mut [O::Cell],
    /// Empty without a depth buffer.
    depths: &'a mut [u16],
    buffer: PhantomData<D>,
    width: u32,
    height: u32,
    rows: Range<u32>,
}

impl<'a, C, O: Storage<C>> Canvas<'a, C, O> {
    /// Largest width and height of a frame, in pixels.
    pub const MAX_SIZE: u32 = MAX_SIZE;

    /// A canvas of `width` x `height` pixels, row by row from the top.
    ///
    /// Give it a slice of colors, and the canvas stores colors unchanged. Give it a slice of byte arrays, and the
    /// canvas stores bytes; then write out the color and the byte order: `Canvas::<Rgb565, BigEndian>::new` takes a
    /// slice of `[u8; 2]`. Most displays expect the most significant byte first. `bytes.as_chunks_mut().0` views a
    /// slice of bytes as byte arrays.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
    /// use fixel::prelude::*;
    /// let mut bytes = [[0; 2]; 4];
    /// let mut canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut bytes, 2, 2)?;
    /// canvas.clear(Rgb565::RED);
    /// assert_eq!(canvas.as_bytes()[..2], [0xf8, 0x00]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if a side is 0 or above [`MAX_SIZE`](Self::MAX_SIZE), or if `pixels` does not have exactly one
    /// element per pixel.
    pub fn new<P: Cell<C, O>>(pixels: &'a mut [P], width: u32, height: u32) -> Result<Self, Error>
    where
        O: Storage<C, Cell = P>,
    {
        check_size(width, height)?;
        check_length("pixels", pixels.len(), (width * height) as usize)?;
        // `new` does not call `band`. So if the size is a constant, the compiler knows the first and the last row.
        Ok(Self {
            cells: pixels,
            depths: &mut [],
            buffer: PhantomData,
            width,
            height,
            rows: 0..height,
        })
    }

    /// A band of a frame of `width` x `height` pixels: as many rows as `pixels` holds, starting at `first_row`.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if a side of the frame is 0 or above [`MAX_SIZE`](Self::MAX_SIZE), if the band has no row or has
    /// a row outside the frame, or if `pixels` is not a whole number of rows.
    pub fn band<P: Cell<C, O>>(
        pixels: &'a mut [P],
        width: u32,
        height: u32,
        first_row: u32,
    ) -> Result<Self, Error>
    where
        O: Storage<C, Cell = P>,
    {
        check_size(width, height)?;
        let above = [0, height as usize - 1];
        check_count("rows above the band", first_row as usize, above)?;
        let rows = pixels.len() / width as usize;
        let room = (height - first_row) as usize;
        check_count("rows of the band", rows, [1, room])?;
        check_length("pixels", pixels.len(), width as usize * rows)?;
        Ok(Self {
            cells: pixels,
            depths: &mut [],
            buffer: PhantomData,
            width,
            height,
            rows: first_row..first_row + rows as u32,
        })
    }

    /// Adds a depth buffer in [`LinearDepth`] format: one `u16` per pixel. Keep the far plane at most 500 times as far
    /// away as the near plane: see [Depth](crate::guide::concepts#depth).
    ///
    /// [`clear`](Canvas::clear) and [`clear_depth`](Canvas::clear_depth) clear the depth buffer. Before the first draw
    /// call, clear the buffer or fill it with 0, which means infinitely far.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if `depth` does not have exactly one element per pixel.
    pub fn with_depth(self, depth: &'a mut [u16]) -> Result<Canvas<'a, C, O, LinearDepth>, Error> {
        self.with_depth_format::<LinearDepth>(depth)
    }

    /// Adds a depth buffer in a format of your choice. [`DepthBuffer`] compares the formats.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::prelude::*;
    /// use fixel::canvas::FloatDepth;
    /// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
    /// let mut canvas = Canvas::new(&mut pixels, 2, 2)?.with_depth_format::<FloatDepth>(&mut depths)?;
    /// canvas.clear(Gray8::new(0));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The same as for [`with_depth`](Self::with_depth).
    pub fn with_depth_format<D: DepthBuffer>(
        self,
        depth: &'a mut [u16],
    ) -> Result<Canvas<'a, C, O, D>, Error> {
        check_length(
            "depths",
            depth.len(),
            (self.width * self.row_count()) as usize,
        )?;
        Ok(Canvas {
            cells: self.cells,
            depths: depth,
            buffer: PhantomData,
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

    /// The viewport of the whole frame. Draw calls project to this viewport unless their options name another. The
    /// viewport also tells where points and meshes are on the screen: see [`Viewport::project`].
    #[must_use]
    pub const fn viewport(&self) -> Viewport {
        Viewport::whole(self.frame_size())
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
    #[must_use]
    pub fn pixels(&self) -> impl ExactSizeIterator<Item = C> {
        self.cells.iter().map(|&cell| O::load(cell))
    }

    /// The pixels in their stored form, row by row from the top, each row from the left.
    #[must_use]
    pub const fn as_cells(&self) -> &[O::Cell] {
        self.cells
    }

    /// The bytes of the pixels, in the order in which a bus sends them, for a canvas that stores bytes. Nothing is
    /// copied.
    #[must_use]
    pub const fn as_bytes<const N: usize>(&self) -> &[u8]
    where
        O: Storage<C, Cell = [u8; N]>,
    {
        self.cells.as_flattened()
    }

    /// Shows the canvas on a display of the same color type, in one call of
    /// [`fill_contiguous`](DrawTarget::fill_contiguous). A band is shown at its place in the frame.
    /// [`show_with`](Self::show_with) shows the canvas on a display of another color type.
    ///
    /// embedded-graphics' `Framebuffer` packs 8, 4 or 2 pixels that are side by side into a byte. Panels of electronic
    /// paper and many displays with few grays expect this format. To pack a canvas, show it on a framebuffer:
    ///
    /// ```
    /// use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
    /// use embedded_graphics::pixelcolor::{BinaryColor, raw::{LittleEndian, RawU1}};
    /// use embedded_graphics::{geometry::Point, draw_target::DrawTargetExt};
    /// use fixel::prelude::*;
    /// let mut pixels = [BinaryColor::Off; 16 * 2];
    /// let mut packed: Framebuffer<BinaryColor, RawU1, LittleEndian, 16, 2, { buffer_size::<BinaryColor>(16, 2) }> =
    ///     Framebuffer::new();
    /// let first_row = 4;
    /// let mut band = Canvas::band(&mut pixels, 16, 8, first_row)?;
    /// band.clear(BinaryColor::On);
    /// // The framebuffer is as large as the band, so its first row shows the band's first row.
    /// let Ok(()) = band.show(&mut packed.translated(Point::new(0, -(first_row as i32))));
    /// assert_eq!(packed.data(), &[0xff; 4]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The display's own errors.
    pub fn show<T>(&self, display: &mut T) -> Result<(), T::Error>
    where
        C: PixelColor,
        T: DrawTarget<Color = C>,
    {
        display.fill_contiguous(&self.bounding_box(), self.pixels())
    }

    /// Like [`show`](Self::show), for a display of another color type. The function `color` gets each point of the
    /// frame and its color, and returns the display's color.
    ///
    /// For a canvas of [`ColorIndex`](super::ColorIndex), `color` looks up each color in a palette. A gray canvas can
    /// be dithered after the whole frame is drawn, when its [`Contrast`](super::Contrast) is known:
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{BinaryColor, Gray8, GrayColor};
    /// use fixel::{prelude::*, canvas::Contrast};
    /// let mut grays = [Gray8::new(40), Gray8::new(60)];
    /// let gray = Canvas::new(&mut grays, 2, 1)?;
    /// let mut shown = [BinaryColor::Off; 2];
    /// let mut panel = Canvas::new(&mut shown, 2, 1)?;
    /// let contrast = Contrast::of(&gray, 0);
    /// let Ok(()) = gray.show_with(&mut panel, |at, gray| {
    ///     BinaryColor::from_rgb(contrast.stretch(gray).into(), at)
    /// });
    /// assert_eq!(shown, [BinaryColor::Off, BinaryColor::On]);
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
        let area = self.bounding_box();
        let colors = area.points().zip(self.pixels());
        display.fill_contiguous(&area, colors.map(|(at, pixel)| color(at, pixel)))
    }
}

impl<O: Storage<BinaryColor>, D> Canvas<'_, BinaryColor, O, D> {
    /// The pixels as bytes for an SSD1306 or a similar display: each byte holds 8 rows of a column, the topmost in the
    /// least significant bit.
    ///
    /// 8 rows form a *page*. A page has one byte for each column, from the left. Pages follow each other from the top,
    /// and the first row of the canvas is the first row of a page. So begin each band at a row that is a multiple of 8,
    /// and give the band 8, 16, … rows. If the last page of a band has fewer than 8 rows, its other bits are 0.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::BinaryColor;
    /// use fixel::prelude::*;
    /// let mut pixels = [BinaryColor::Off; 128 * 8];
    /// let mut page = [0; 128];
    /// for first_row in (0..64).step_by(8) {
    ///     let mut band = Canvas::band(&mut pixels, 128, 64, first_row)?;
    ///     band.clear(BinaryColor::On); // and draw
    ///     for (byte, rows) in page.iter_mut().zip(band.pages()) {
    ///         *byte = rows;
    ///     }
    ///     assert_eq!(page, [0xff; 128]); // send it as page `first_row / 8`
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn pages(&self) -> impl Iterator<Item = u8> {
        let (cells, width) = (&*self.cells, self.width);
        // The index cannot overflow: a canvas has at most 2^22 pixels, and the last page reaches at most 7 rows
        // further.
        let is_on = move |row: u32, column| {
            let cell = cells.get((row * width + column) as usize);
            cell.is_some_and(|&cell| O::load(cell).is_on())
        };
        (0..self.row_count().div_ceil(8)).flat_map(move |page| {
            (0..width).map(move |column| {
                let bits = (0..8).rev().map(|bit| is_on(8 * page + bit, column));
                bits.fold(0, |byte, bit| byte << 1 | u8::from(bit))
            })
        })
    }
}

impl<C, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Sets every pixel to `color` and, if there is a depth buffer, every depth to infinity.
    ///
    /// embedded-graphics' [`DrawTarget::clear`](DrawTarget::clear) does the same.
    pub fn clear(&mut self, color: C) {
        fill(self.cells, O::store(color));
        self.clear_depth();
    }

    /// Sets every depth to infinity and keeps the colors. Everything that is drawn afterwards covers the picture.
    ///
    /// Use this function for a second scene over the first, such as a cockpit or a gauge that no wall may hide. Without
    /// a depth buffer, this function does nothing.
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
        fill(self.depths, 0);
    }

    /// The stored depth of a pixel, as the depth buffer encodes it; `None` if the pixel is outside this canvas, or if
    /// there is no depth buffer.
    ///
    /// A point of the scene is hidden if its [`ScreenPoint::depth`](crate::ScreenPoint::depth) is less than the depth
    /// stored at its pixel:
    ///
    /// ```
    /// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
    /// use fixel::prelude::*;
    /// static WALL: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let (mut pixels, mut depths) = ([Gray8::new(0); 64], [0; 64]);
    /// let mut canvas = Canvas::new(&mut pixels, 8, 8)?.with_depth(&mut depths)?;
    /// let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.5), fx!(20))?;
    /// canvas.draw(&WALL, &(projection * Transform::translate(vec3!(0, 0, -3))), &Flat::new(Gray8::new(9)));
    /// let behind = canvas.viewport().project(vec3!(0, 0, -9), &projection).unwrap();
    /// assert!(canvas.depth_at(Point::new(4, 4)) > Some(behind.depth::<LinearDepth>()));
    /// assert_eq!(canvas.depth_at(Point::new(0, 0)), Some(0)); // nothing is there
    /// assert_eq!(canvas.depth_at(Point::new(8, 0)), None);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn depth_at(&self, point: Point) -> Option<u16> {
        if !self.bounding_box().contains(point) {
            return None;
        }
        // No point in the area has a negative coordinate.
        let (x, y) = (point.x.cast_unsigned(), point.y.cast_unsigned());
        let at = (y - self.rows.start) * self.width + x;
        self.depths.get(at as usize).copied()
    }

    /// The memory of all pixels and depths.
    #[inline]
    pub(crate) fn memory(&mut self) -> Memory<'_, C, O, D> {
        Memory {
            colors: self.cells,
            depths: self.depths,
            width: self.width,
            first_row: self.rows.start,
            buffer: PhantomData,
        }
    }

    /// The pixels of a row in `columns`. Row and columns must lie within the canvas.
    #[inline(always)]
    #[allow(clippy::inline_always)] // kernels keep the pixels in registers
    pub(crate) fn cells(&mut self, row: i32, columns: Range<i32>) -> Option<Cells<'_, C, O, D>> {
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        self.memory().cells(row.cast_unsigned(), columns)
    }
}

impl<C, O: Storage<C>, D> Dimensions for Canvas<'_, C, O, D> {
    /// The part of the frame that is in memory.
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(
            Point::new(0, self.rows.start.cast_signed()),
            Size::new(self.width, self.row_count()),
        )
    }
}

/// Fills pixels. For a 16-bit pixel, [`slice::fill`] stores each pixel by itself, or calls a routine that takes four
/// instructions for a word. Here, a store has a word, and a turn of the loop has 16 pixels.
#[cfg_attr(not(for_size), inline(never))] // a copy takes 300 bytes
fn fill<T: Copy>(pixels: &mut [T], pixel: T) {
    if cfg!(for_size) || !STORES_ANYWHERE {
        return pixels.fill(pixel);
    }
    // If the compiler knew that the pixels are alike, it would store them one by one.
    let four = black_box([pixel; 4]);
    let (blocks, rest) = pixels.as_chunks_mut::<16>();
    for block in blocks {
        for quarter in block.as_chunks_mut::<4>().0 {
            *quarter = four;
        }
    }
    rest.fill(pixel);
}

pub(crate) const fn check_size(width: u32, height: u32) -> Result<(), Error> {
    let sides = [1, MAX_SIZE as usize];
    ok!(check_count("columns of the frame", width as usize, sides));
    check_count("rows of the frame", height as usize, sides)
}
