//! The canvas, as a target of embedded-graphics, shows the same picture as embedded-graphics' own framebuffer.

use std::cell::Cell;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb565, RgbColor};
use embedded_graphics::primitives::{Primitive, PrimitiveStyle, Rectangle};
use embedded_graphics::text::Text;
use embedded_graphics::{Drawable, Pixel};
use fixel::ScreenPoint;
use fixel::canvas::{Storage, Words};
use fixel::num::Subpixel;
use fixel::prelude::*;
use rand::Rng;

use super::pictures::{self, HEIGHT, WIDTH};
use support::random::{Random, cases, sampled};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// embedded-graphics' own framebuffer of the same size.
type Theirs<O> = Framebuffer<
    Rgb565,
    RawU16,
    O,
    { WIDTH as usize },
    { HEIGHT as usize },
    { buffer_size::<Rgb565>(WIDTH as usize, HEIGHT as usize) },
>;

/// Whatever is drawn, the canvas has the same bytes, in both byte orders, and the same colors as embedded-graphics'
/// framebuffer. Bands put together equal the frame.
#[test]
fn a_canvas_is_a_framebuffer() {
    cases(sampled(4000), |random| {
        let rows = random.random_range(1..=HEIGHT);
        let mut theirs = (Theirs::<BigEndian>::new(), Theirs::<LittleEndian>::new());
        pictures::draw(&mut theirs.0, random.clone());
        pictures::draw(&mut theirs.1, random.clone());

        let big = drawn::<BigEndian>(random, HEIGHT);
        let little = drawn::<LittleEndian>(random, HEIGHT);
        assert!(big.as_flattened() == theirs.0.data(), "big-endian");
        assert!(little.as_flattened() == theirs.1.data(), "little-endian");
        let wanted = big.iter().map(|&bytes| u16::from_be_bytes(bytes));
        assert!(wanted.eq(drawn::<Words>(random, HEIGHT)), "words");
        let at = |i: u32| Point::new((i % WIDTH).cast_signed(), (i / WIDTH).cast_signed());
        let wanted = (0..WIDTH * HEIGHT).map(|i| theirs.0.pixel(at(i)).unwrap());
        let colors = drawn::<Native>(random, HEIGHT);
        assert!(wanted.eq(colors.iter().copied()), "native");

        assert!(drawn::<Native>(random, rows) == colors, "native bands");
        assert!(drawn::<BigEndian>(random, rows) == big, "bands of bytes");
    });
}

/// The cells of the picture that `random` describes, drawn in bands of `rows` rows.
fn drawn<O: Storage<Rgb565>>(random: &Random, rows: u32) -> Vec<O::Cell> {
    let mut cells = vec![O::store(Rgb565::BLACK); PIXELS];
    let mut first = 0;
    for cells in cells.chunks_mut((rows * WIDTH) as usize) {
        let mut canvas = Canvas::<Rgb565, O>::band(cells, WIDTH, HEIGHT, first).unwrap();
        let (place, rows) = (first.cast_signed(), canvas.rows().len() as u32);
        let band = Rectangle::new(Point::new(0, place), Size::new(WIDTH, rows));
        assert_eq!(canvas.bounding_box(), band);
        pictures::draw(&mut canvas, random.clone());
        first += rows;
    }
    cells
}

/// Counts how often its drawable is drawn.
struct Counted<'t, T>(T, &'t Cell<u32>);

impl<T: Dimensions> Dimensions for Counted<'_, T> {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

impl<T: Drawable> Drawable for Counted<'_, T> {
    type Color = T::Color;
    type Output = T::Output;

    fn draw<D: DrawTarget<Color = T::Color>>(&self, target: &mut D) -> Result<T::Output, D::Error> {
        self.1.set(self.1.get() + 1);
        self.0.draw(target)
    }
}

/// Draws a drawable over a band. Returns whether the band shows a part of the drawable. Checks that the drawable was
/// drawn only in this case.
fn is_overlaid(
    band: &mut Canvas<'_, Rgb565>,
    thing: impl Drawable<Color = Rgb565> + Dimensions,
) -> bool {
    let (count, area) = (Cell::new(0), thing.bounding_box());
    band.overlay(&Counted(thing, &count));
    let is_seen = !band.bounding_box().intersection(&area).is_zero_sized();
    assert_eq!(count.get(), u32::from(is_seen), "{area:?}");
    is_seen
}

/// Text and shapes look the same in bands and in the frame. A text or shape is drawn only in bands that show a part of
/// it.
#[test]
fn overlays_are_drawn_in_the_bands_that_show_them() {
    let (mut drawn, mut skipped) = (0, 0);
    cases(1000, |random| {
        let at = Point::new(random.random_range(-40..50), random.random_range(-20..40));
        let size = Size::new(random.random_range(0..30), random.random_range(0..30));
        let style = MonoTextStyle::new(&FONT_6X10, Rgb565::YELLOW);
        let text = Text::new("fixel\n3D", at, style);
        let line = PrimitiveStyle::with_stroke(Rgb565::RED, random.random_range(1..6));
        let shape = Rectangle::new(at, size).into_styled(line);
        let rows = random.random_range(1..=HEIGHT);
        let mut whole = [Rgb565::BLACK; PIXELS];
        let mut frame = Canvas::new(&mut whole, WIDTH, HEIGHT).unwrap();
        shape.draw(&mut frame).unwrap();
        text.draw(&mut frame).unwrap();
        let mut pixels = [Rgb565::BLACK; PIXELS];
        let mut first = 0;
        for pixels in pixels.chunks_mut((rows * WIDTH) as usize) {
            let mut band = Canvas::band(pixels, WIDTH, HEIGHT, first).unwrap();
            first += rows;
            for is_seen in [is_overlaid(&mut band, shape), is_overlaid(&mut band, text)] {
                drawn += u32::from(is_seen);
                skipped += u32::from(!is_seen);
            }
        }
        assert!(pixels == whole, "{size} at {at}, in bands of {rows}");
    });
    assert!(drawn > 500 && skipped > 500, "{drawn}, {skipped}");
}

/// `fill_contiguous` stops reading an endless iterator when the area is full.
#[test]
fn fill_contiguous_stops_when_the_area_is_full() {
    let mut pixels = [Gray8::BLACK; 12];
    let mut canvas = Canvas::new(&mut pixels, 4, 3).unwrap();
    let area = Rectangle::new(Point::new(-1, 1), Size::new(3, 9));
    let mut taken = 0;
    let colors = std::iter::repeat_with(|| {
        taken += 1;
        Gray8::new(taken)
    });
    let Ok(()) = canvas.fill_contiguous(&area, colors);
    let lumas: Vec<u8> = pixels.iter().map(GrayColor::luma).collect();
    assert_eq!(lumas, [0, 0, 0, 0, 2, 3, 0, 0, 5, 6, 0, 0]);
    assert!(taken <= 27);
}

/// An iterator over the colors of an area. A color depends on the pixel's number. The iterator skips any number of
/// pixels at once.
struct Colors(u64);

fn color(number: u64) -> Gray8 {
    Gray8::new(1 + (number % 251) as u8)
}

impl Iterator for Colors {
    type Item = Gray8;

    fn next(&mut self) -> Option<Gray8> {
        self.nth(0)
    }

    fn nth(&mut self, skipped: usize) -> Option<Gray8> {
        let number = self.0 + skipped as u64;
        self.0 = number + 1;
        Some(color(number))
    }
}

/// Points at the ends of `i32` are ignored.
#[test]
fn points_at_the_ends_of_i32_are_ignored() {
    let mut pixels = [Gray8::BLACK; 4];
    let mut canvas = Canvas::new(&mut pixels, 2, 2).unwrap();
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, 2, i32::MAX - 1, i32::MAX];
    let points = ends
        .into_iter()
        .flat_map(|y| ends.map(|x| Point::new(x, y)));
    let colors = (0..).map(Gray8::new);
    let Ok(()) = canvas.draw_iter(points.zip(colors).map(|(at, color)| Pixel(at, color)));
    assert_eq!(pixels.map(|pixel| pixel.luma()), [27, 28, 35, 36]);
}

/// Areas that begin or end beyond the range of `i32` are filled like all other areas, in a debug build, too. A label's
/// origin moves them, even if this moves a side out of the range.
#[test]
fn areas_beyond_the_range_of_i32_are_filled() {
    const WIDTH: u32 = 3;
    const FIRST: u32 = 1;
    const END: u32 = 3;
    const PIXELS: usize = (WIDTH * (END - FIRST)) as usize;
    let most = i32::MAX.cast_unsigned();
    let starts = [
        i32::MIN,
        i32::MIN + 1,
        -most.cast_signed(),
        -5,
        -1,
        0,
        1,
        2,
        3,
        i32::MAX - 1,
        i32::MAX,
    ];
    let lengths = [
        0,
        1,
        2,
        6,
        most - 1,
        most,
        most + 1,
        most + 2,
        most + 4,
        u32::MAX - 1,
        u32::MAX,
    ];
    let sides = starts.map(|start| lengths.map(|length| (start, length)));
    let sides = sides.as_flattened();
    for origin in [-5, 0, 2] {
        let at = Subpixel::from_bits(origin * 256);
        let (x, y, nearness) = (at, at, 0);
        let place = ScreenPoint { x, y, nearness };
        // The pixel's place along one side of the area, or `None` if the area does not contain the pixel.
        let along = |at: u32, start: i32, length: u32| {
            let number = i64::from(at) - i64::from(origin) - i64::from(start);
            (0..i64::from(length))
                .contains(&number)
                .then_some(number.cast_unsigned())
        };
        for &(x, width) in sides {
            for &(y, height) in sides {
                let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
                let wanted =
                    (FIRST..END).flat_map(|row| (0..WIDTH).map(move |column| (column, row)));
                let wanted = wanted
                    .map(|(column, row)| Some((along(column, x, width)?, along(row, y, height)?)));
                let wanted: Vec<_> = wanted.collect();

                let mut pixels = [Gray8::BLACK; PIXELS];
                let mut canvas = Canvas::band(&mut pixels, WIDTH, 4, FIRST).unwrap();
                let Ok(()) = canvas.label(place).fill_solid(&area, Gray8::WHITE);
                let solid = wanted
                    .iter()
                    .map(|at| at.map_or(Gray8::BLACK, |_| Gray8::WHITE));
                assert!(solid.eq(pixels), "solid {area:?} at {origin}: {pixels:?}");

                let mut pixels = [Gray8::BLACK; PIXELS];
                let mut canvas = Canvas::band(&mut pixels, WIDTH, 4, FIRST).unwrap();
                let Ok(()) = canvas.label(place).fill_contiguous(&area, Colors(0));
                // There are at most 2^31 + 2 rows of 2^32 - 1 pixels.
                let number = |(column, row): (u64, u64)| color(row * u64::from(width) + column);
                let contiguous = wanted.iter().map(|at| at.map_or(Gray8::BLACK, number));
                assert!(
                    contiguous.eq(pixels),
                    "contiguous {area:?} at {origin}: {pixels:?}"
                );
            }
        }
    }
}
