//! Tests of the canvas as an embedded-graphics target, as bytes, and on a display.

use std::any::TypeId;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, ToBytes};
use embedded_graphics::pixelcolor::{Gray4, Gray8, GrayColor, Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::Rectangle;
use fixel::canvas::{ColorIndex, NoDepth, Storage, Words};
use fixel::prelude::*;

const MAX_SIZE: u32 = Canvas::<Gray8>::MAX_SIZE;

mod depth;
mod diffusion;
mod framebuffer;
mod packing;
mod pictures;

/// A display that records its calls and may fail.
#[derive(Default)]
struct Display {
    calls: Vec<(Rectangle, Vec<Rgb888>)>,
    broken: bool,
}

#[derive(Debug, PartialEq)]
struct BusError(u8);

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        Size::new(4, 6)
    }
}

impl DrawTarget for Display {
    type Color = Rgb888;
    type Error = BusError;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, _: I) -> Result<(), BusError> {
        panic!("all pixels must come in one call");
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb888>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), BusError> {
        if self.broken {
            return Err(BusError(42));
        }
        self.calls.push((*area, colors.into_iter().collect()));
        Ok(())
    }
}

#[test]
fn show_sends_all_pixels_in_one_call() {
    let picture: Vec<Rgb888> = (0..24).map(|i| Rgb888::new(i, 255 - i, 7 * i)).collect();
    let mut display = Display::default();
    Canvas::new(&mut picture.clone(), 4, 6)
        .unwrap()
        .show(&mut display)
        .unwrap();
    Canvas::band(&mut picture[4..12].to_vec(), 4, 6, 1)
        .unwrap()
        .show(&mut display)
        .unwrap();
    let mut bytes: Vec<[u8; 3]> = picture.iter().map(|c| c.to_le_bytes()).collect();
    let swapped: Canvas<Rgb888, LittleEndian> = Canvas::new(&mut bytes, 4, 6).unwrap();
    swapped.show(&mut display).unwrap();
    let whole = Rectangle::new(Point::zero(), Size::new(4, 6));
    let band = Rectangle::new(Point::new(0, 1), Size::new(4, 2));
    assert_eq!(
        display.calls,
        [
            (whole, picture.clone()),
            (band, picture[4..12].to_vec()),
            (whole, picture)
        ]
    );
}

#[test]
fn a_display_error_is_passed_on() {
    let mut display = Display {
        broken: true,
        ..Display::default()
    };
    let mut pixels = [Rgb888::BLACK; 24];
    let canvas = Canvas::new(&mut pixels, 4, 6).unwrap();
    assert_eq!(canvas.show(&mut display), Err(BusError(42)));
}

/// The bytes of a color are in bus order, for colors of one, two and three bytes.
#[test]
fn bytes_are_in_bus_order() {
    let mut pixels = [[0; 2]; 2];
    let mut canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut pixels, 2, 1).unwrap();
    canvas.clear(Rgb565::new(1, 2, 3));
    assert_eq!(canvas.as_bytes(), [0x08, 0x43, 0x08, 0x43]);
    assert_eq!(canvas.as_cells(), [[0x08, 0x43]; 2]);
    assert!(canvas.pixels().all(|pixel| pixel == Rgb565::new(1, 2, 3)));
    let mut canvas: Canvas<Rgb565, LittleEndian> = Canvas::new(&mut pixels, 2, 1).unwrap();
    canvas.clear(Rgb565::new(1, 2, 3));
    assert_eq!(canvas.as_bytes(), [0x43, 0x08, 0x43, 0x08]);
    let mut pixels = [[0; 3]; 1];
    let mut canvas: Canvas<Rgb888, BigEndian> = Canvas::new(&mut pixels, 1, 1).unwrap();
    canvas.clear(Rgb888::new(1, 2, 3));
    assert_eq!(canvas.as_bytes(), [1, 2, 3]);
    let mut canvas: Canvas<Rgb888, LittleEndian> = Canvas::new(&mut pixels, 1, 1).unwrap();
    canvas.clear(Rgb888::new(1, 2, 3));
    assert_eq!(canvas.as_bytes(), [3, 2, 1]);
    let mut pixels = [[0; 1]; 1];
    let mut canvas: Canvas<Gray8, BigEndian> = Canvas::new(&mut pixels, 1, 1).unwrap();
    canvas.clear(Gray8::new(7));
    assert_eq!(canvas.as_bytes(), [7]);
}

/// `Words` stores the raw bits of each color in the smallest integer that holds them.
#[test]
fn words_are_raw_bits() {
    let mut pixels = [0_u16; 2];
    let mut canvas: Canvas<Rgb565, Words> = Canvas::new(&mut pixels, 2, 1).unwrap();
    canvas.clear(Rgb565::new(1, 2, 3));
    assert!(canvas.pixels().all(|pixel| pixel == Rgb565::new(1, 2, 3)));
    assert_eq!(pixels, [1 << 11 | 2 << 5 | 3; 2]);
    let mut pixels = [0_u32];
    let mut canvas = any_of::<Rgb888, Words>(&mut pixels);
    canvas.clear(Rgb888::new(1, 2, 3));
    assert!(canvas.pixels().eq([Rgb888::new(1, 2, 3)]));
    assert_eq!(pixels, [0x01_0203]);
    let mut pixels = [0_u8];
    any_of::<Gray4, Words>(&mut pixels).clear(Gray4::new(7));
    assert_eq!(pixels, [7]);
}

/// Makes a canvas of one pixel in any storage.
fn any_of<C, O: Storage<C>>(cells: &mut [O::Cell]) -> Canvas<'_, C, O> {
    Canvas::new(cells, 1, 1).unwrap()
}

/// The types of a canvas's colors and of its storage.
fn types<C: 'static, O: Storage<C> + 'static, D>(_: &Canvas<'_, C, O, D>) -> [TypeId; 2] {
    [TypeId::of::<C>(), TypeId::of::<O>()]
}

/// Makes a canvas in any storage.
fn any<C, O: Storage<C>>(cells: &mut [O::Cell]) -> Canvas<'_, C, O> {
    Canvas::new(cells, 2, 2).unwrap()
}

/// An array of colors determines all types of a canvas. An array of bytes determines only the number of bytes per
/// pixel.
#[test]
fn constructors_infer_types_from_memory() {
    let native = [TypeId::of::<Gray8>(), TypeId::of::<Native>()];
    let mut colors = [Gray8::BLACK; 4];
    assert_eq!(types(&Canvas::new(&mut colors, 2, 2).unwrap()), native);
    assert_eq!(types(&Canvas::band(&mut colors, 2, 9, 3).unwrap()), native);
    let mut colors = vec![Gray8::BLACK; 4];
    let (canvas, mut depths) = (Canvas::new(&mut colors, 2, 2).unwrap(), [0; 4]);
    assert_eq!(types(&canvas.with_depth(&mut depths).unwrap()), native);
    let indices = &mut [ColorIndex(3); 4][..];
    let canvas = Canvas::new(indices, 2, 2).unwrap();
    assert!(canvas.pixels().eq([ColorIndex(3); 4]));

    let mut bytes = [[0; 2]; 4];
    let mut canvas = Canvas::<_, LittleEndian>::band(&mut bytes, 2, 9, 3).unwrap();
    canvas.clear(Rgb565::RED);
    let little = [TypeId::of::<Rgb565>(), TypeId::of::<LittleEndian>()];
    assert_eq!(types(&canvas), little);
    assert_eq!(bytes, [[0, 0xf8]; 4]);

    let mut bytes = [[0; 3]; 4];
    let mut canvas = any::<Rgb888, BigEndian>(&mut bytes);
    assert_eq!(
        types(&canvas),
        [TypeId::of::<Rgb888>(), TypeId::of::<BigEndian>()]
    );
    canvas.clear(Rgb888::RED);
    assert_eq!(canvas.as_cells(), [[0xff, 0, 0]; 4]);
}

/// An error about a count: what was counted, the number given, the lowest and the highest number allowed.
fn count(error: Option<Error>) -> (&'static str, usize, usize, usize) {
    match error {
        Some(Error::Count {
            of,
            given,
            min,
            max,
            ..
        }) => (of, given, min, max),
        other => panic!("{other:?} is not an error about a count"),
    }
}

/// Checks that errors about refused arguments contain the numbers that their messages need.
#[test]
fn errors_name_the_numbers() {
    let pixels = |count: usize| vec![Gray8::BLACK; count];
    let new = |count, width, height| Canvas::new(&mut pixels(count), width, height).err();
    let band =
        |count, width, height, first| Canvas::band(&mut pixels(count), width, height, first).err();

    let (columns, rows) = ("columns of the frame", "rows of the frame");
    for (width, height, of, given) in [
        (0, 4, columns, 0),
        (4, 0, rows, 0),
        (0, 0, columns, 0),
        (MAX_SIZE + 1, 1, columns, MAX_SIZE + 1),
        (1, MAX_SIZE + 1, rows, MAX_SIZE + 1),
        (u32::MAX, u32::MAX, columns, u32::MAX),
    ] {
        for error in [new(4, width, height), band(4, width, height, 0)] {
            let expected = (of, given as usize, 1, MAX_SIZE as usize);
            assert_eq!(count(error), expected, "{width}x{height}");
        }
    }
    assert_eq!(new(MAX_SIZE as usize, MAX_SIZE, 1), None);

    for given in [0, 11, 13] {
        assert_eq!(count(new(given, 4, 3)), ("pixels", given, 12, 12));
    }
    assert_eq!(new(12, 4, 3), None);

    let rows = "rows of the band";
    assert_eq!(count(band(0, 4, 3, 0)), (rows, 0, 1, 3));
    assert_eq!(count(band(3, 4, 3, 0)), (rows, 0, 1, 3), "less than a row");
    assert_eq!(count(band(8, 4, 3, 2)), (rows, 2, 1, 1));
    assert_eq!(count(band(16, 4, 3, 0)), (rows, 4, 1, 3));
    let above = "rows above the band";
    for first in [3, u32::MAX] {
        assert_eq!(count(band(4, 4, 3, first)), (above, first as usize, 0, 2));
    }
    assert_eq!(count(band(9, 4, 3, 1)), ("pixels", 9, 8, 8));
    assert_eq!(
        (band(4, 4, 3, 2), band(8, 4, 3, 1), band(12, 4, 3, 0)),
        (None, None, None)
    );

    let with_depth = |given: usize, first| {
        let mut pixels = pixels(8);
        let band: Canvas<Gray8, Native, NoDepth> = Canvas::band(&mut pixels, 4, 3, first).unwrap();
        band.with_depth(&mut vec![0; given]).err()
    };
    assert_eq!(
        count(with_depth(12, 1)),
        ("depths", 12, 8, 8),
        "of the band, not the frame"
    );
    assert_eq!(with_depth(8, 1), None);

    let mut cells = [[0; 2]; 5];
    let error = Canvas::<Rgb565, BigEndian>::new(&mut cells, 2, 2).err();
    assert_eq!(count(error), ("pixels", 5, 4, 4));
    let error = Canvas::<Rgb565, LittleEndian>::band(&mut cells, 5, 2, 2).err();
    assert_eq!(count(error), (above, 2, 0, 1));
}
