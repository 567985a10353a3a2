//! Several pixels in a byte: how a canvas packs its pixels for displays that need packed pixels.

use std::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::framebuffer::{Framebuffer, buffer_size_bpp};
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawData, RawU1, RawU2, RawU4, RawU16};
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, PixelColor, Rgb565};
use embedded_graphics::primitives::Rectangle;
use fixel::prelude::*;
use rand::Rng;

use super::pictures::{self, HEIGHT, WIDTH};
use support::random::{cases, sampled};

/// A target that keeps only the lowest bits of each color.
struct Coarse<T>(T);

impl<T: Dimensions> Dimensions for Coarse<&mut T> {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

fn coarse<C: PixelColor + From<C::Raw>>(color: Rgb565) -> C {
    C::Raw::from_u32(RawU16::from(color).into_inner().into()).into()
}

impl<T> DrawTarget for Coarse<&mut T>
where
    T: DrawTarget<Color: From<<T::Color as PixelColor>::Raw>, Error = Infallible>,
{
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        let coarse = |Pixel(at, color)| Pixel(at, coarse(color));
        self.0.draw_iter(pixels.into_iter().map(coarse))
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        self.0
            .fill_contiguous(area, colors.into_iter().map(coarse::<T::Color>))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        self.0.fill_solid(area, coarse(color))
    }

    fn clear(&mut self, color: Rgb565) -> Result<(), Infallible> {
        self.0.clear(coarse(color))
    }
}

/// Draws the same pictures on a canvas and on embedded-graphics' packed framebuffer. Shows the canvas on a second
/// framebuffer, whole and in bands, and compares the bytes of both framebuffers.
macro_rules! shows_as_a_framebuffer {
    ($color:ty, $raw:ty) => {{
        const ROWS: usize = 5;
        const fn bytes(rows: usize) -> usize {
            buffer_size_bpp(WIDTH as usize, rows, <$raw>::BITS_PER_PIXEL)
        }
        type Packed<const ROWS: usize, const BYTES: usize> =
            Framebuffer<$color, $raw, LittleEndian, { WIDTH as usize }, ROWS, BYTES>;
        const FRAME: usize = HEIGHT as usize;
        let blank = <$color>::from(<$raw>::from_u32(0));
        cases(sampled(500), |random| {
            let mut theirs = Packed::<FRAME, { bytes(FRAME) }>::new();
            pictures::draw(&mut Coarse(&mut theirs), random.clone());

            let mut pixels = [blank; (WIDTH * HEIGHT) as usize];
            let mut canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT).unwrap();
            pictures::draw(&mut Coarse(&mut canvas), random.clone());
            let mut ours = Packed::<FRAME, { bytes(FRAME) }>::new();
            let Ok(()) = canvas.show(&mut ours);
            assert!(ours.data() == theirs.data(), "frame");

            let mut in_bands = Vec::new();
            for first in (0..HEIGHT).step_by(ROWS) {
                let rows = ROWS.min((HEIGHT - first) as usize);
                let mut pixels = [blank; WIDTH as usize * ROWS];
                let pixels = &mut pixels[..rows * WIDTH as usize];
                let mut band = Canvas::band(pixels, WIDTH, HEIGHT, first).unwrap();
                pictures::draw(&mut Coarse(&mut band), random.clone());
                let mut packed = Packed::<ROWS, { bytes(ROWS) }>::new();
                let up = Point::new(0, -first.cast_signed());
                let Ok(()) = band.show(&mut packed.translated(up));
                in_bands.extend_from_slice(&packed.data()[..bytes(rows)]);
            }
            assert!(in_bands == theirs.data(), "bands");
        });
    }};
}

#[test]
fn a_canvas_is_packed_by_a_framebuffer() {
    shows_as_a_framebuffer!(BinaryColor, RawU1);
    shows_as_a_framebuffer!(Gray2, RawU2);
    shows_as_a_framebuffer!(Gray4, RawU4);
}

/// The pixel in a row of packed pixels of `bits` bits each. The first pixel is in the high bits of the first byte.
fn packed_pixel(row: &[u8], bits: usize, column: usize) -> u8 {
    let first = column * bits;
    let down = 8 - bits - first % 8;
    (row[first / 8] >> down) & ((1 << bits) - 1)
}

/// Shows a canvas of `WIDTH` columns on a packed framebuffer of `BYTES` bytes, whole and in bands, and compares the bits
/// of each pixel. The last byte of a row has bits that belong to no pixel. These bits must be 0.
fn rows_are_packed<C, const WIDTH: usize, const BYTES: usize>()
where
    C: PixelFormat<Raw: RawData<Storage = u8>> + From<C::Raw> + Into<C::Raw>,
    Framebuffer<C, C::Raw, LittleEndian, WIDTH, 11, BYTES>:
        DrawTarget<Color = C, Error = Infallible>,
{
    const HEIGHT: usize = 11;
    let bits = C::Raw::BITS_PER_PIXEL;
    let stride = (WIDTH * bits).div_ceil(8);
    assert_ne!(WIDTH * bits % 8, 0, "rows fill bytes");
    cases(50, |random| {
        let mut pixels: Vec<C> = (0..WIDTH * HEIGHT)
            .map(|_| C::Raw::from_u32(random.random()).into())
            .collect();
        let wanted = pixels.clone();
        let rows = random.random_range(1..=HEIGHT);
        let mut panel = Framebuffer::<C, C::Raw, LittleEndian, WIDTH, 11, BYTES>::new();
        for (first, pixels) in (0..).step_by(rows).zip(pixels.chunks_mut(WIDTH * rows)) {
            let [width, height] = [WIDTH, HEIGHT].map(|size| size as u32);
            let band = Canvas::band(pixels, width, height, first).unwrap();
            let Ok(()) = band.show(&mut panel);
        }
        assert_eq!(panel.data().len(), stride * HEIGHT);
        for (y, (row, wanted)) in panel
            .data()
            .chunks(stride)
            .zip(wanted.chunks(WIDTH))
            .enumerate()
        {
            for (x, &wanted) in wanted.iter().enumerate() {
                let wanted: C::Raw = wanted.into();
                assert_eq!(packed_pixel(row, bits, x), wanted.into_inner(), "{x}, {y}");
            }
            let rest = row[stride - 1] << (WIDTH * bits % 8);
            assert_eq!(rest, 0, "bits beside row {y}");
        }
    });
}

#[test]
fn rows_that_do_not_fill_bytes_are_packed() {
    macro_rules! widths {
        ($color:ty: $($width:literal)+) => {$(
            rows_are_packed::<$color, $width, { buffer_size_bpp($width, 11, <$color as PixelColor>::Raw::BITS_PER_PIXEL) }>();
        )+};
    }
    widths!(BinaryColor: 1 3 7 9 13 122);
    widths!(Gray2: 1 3 7 9 13 122);
    widths!(Gray4: 1 3 7 9 13);
}

/// In a page, bit n of a byte is the pixel in row n. Rows below the canvas are 0.
#[test]
fn pages_are_the_pixels_one_below_the_other() {
    cases(2000, |random| {
        let [width, rows] = [(); 2].map(|()| random.random_range(1..=30_u32));
        let first = random.random_range(0..=9);
        let height = first + rows + random.random_range(0..=9);
        let mut pixels: Vec<BinaryColor> = (0..width * rows)
            .map(|_| BinaryColor::from(random.random::<bool>()))
            .collect();
        let wanted = pixels.clone();
        let band = Canvas::band(&mut pixels, width, height, first).unwrap();
        let pages: Vec<u8> = band.pages().collect();
        assert_eq!(pages.len(), (width * rows.div_ceil(8)) as usize);
        for (at, byte) in (0..).zip(pages) {
            let (column, page) = (at % width, at / width);
            for bit in 0..8 {
                let row = 8 * page + bit;
                let pixel = wanted.get((row * width + column) as usize);
                let is_on = pixel.is_some_and(|pixel| pixel.is_on());
                assert_eq!(byte >> bit & 1 == 1, is_on, "column {column}, row {row}");
            }
        }
    });
}
