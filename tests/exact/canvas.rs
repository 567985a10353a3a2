//! The canvas as an embedded-graphics target, as bytes, and on a display.

use std::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_6X10;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Text;
use fixel::prelude::*;
use fixel::target::{Depth, MAX_SIZE, Native, NoDepth};
use proptest::prelude::*;

const WIDTH: u32 = 19;
const HEIGHT: u32 = 13;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// embedded-graphics' own frame of the same size, which the canvas must equal byte for byte.
type Theirs<O> = Framebuffer<
    Rgb565,
    RawU16,
    O,
    { WIDTH as usize },
    { HEIGHT as usize },
    { buffer_size::<Rgb565>(WIDTH as usize, HEIGHT as usize) },
>;

/// Something that a picture can be drawn with.
#[derive(Clone, Debug)]
enum Step {
    Iter(Vec<Pixel<Rgb565>>),
    Contiguous(Rectangle, Vec<Rgb565>),
    Solid(Rectangle, Rgb565),
    Clear(Rgb565),
    Text(String, Point),
}

impl Step {
    fn apply<T: DrawTarget<Color = Rgb565, Error = Infallible>>(&self, target: &mut T) {
        let done = match self {
            Self::Iter(pixels) => target.draw_iter(pixels.iter().copied()),
            Self::Contiguous(area, colors) => target.fill_contiguous(area, colors.iter().copied()),
            Self::Solid(area, color) => target.fill_solid(area, *color),
            Self::Clear(color) => target.clear(*color),
            Self::Text(text, at) => {
                let style = MonoTextStyle::new(&FONT_6X10, Rgb565::CSS_ORANGE);
                Text::new(text, *at, style).draw(target).map(|_| ())
            }
        };
        let Ok(()) = done;
    }
}

fn colors() -> impl Strategy<Value = Rgb565> {
    any::<u16>().prop_map(|raw| RawU16::new(raw).into())
}

fn points() -> impl Strategy<Value = Point> {
    (-9..30i32, -9..24i32).prop_map(|(x, y)| Point::new(x, y))
}

/// Rectangles of any size in any place: inside, across each edge, outside, empty.
fn areas() -> impl Strategy<Value = Rectangle> {
    (points(), 0..40u32, 0..30u32).prop_map(|(at, w, h)| Rectangle::new(at, Size::new(w, h)))
}

fn steps() -> impl Strategy<Value = Step> {
    prop_oneof![
        prop::collection::vec((points(), colors()).prop_map(|(at, c)| Pixel(at, c)), 0..20)
            .prop_map(Step::Iter),
        // As many colours as the area has, or fewer, or more.
        (areas(), prop::collection::vec(colors(), 0..1300))
            .prop_map(|(area, c)| Step::Contiguous(area, c)),
        (areas(), any::<u16>()).prop_map(|(area, start)| {
            let count = u16::try_from(area.size.width * area.size.height).unwrap();
            let colors =
                (0..count).map(|i| RawU16::new(start.wrapping_add(i.wrapping_mul(77))).into());
            Step::Contiguous(area, colors.collect())
        }),
        (areas(), colors()).prop_map(|(area, c)| Step::Solid(area, c)),
        colors().prop_map(Step::Clear),
        ("[a-z]{1,4}", points()).prop_map(|(text, at)| Step::Text(text, at)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Whatever is drawn, wherever it lies: the bytes are those of embedded-graphics' framebuffer, in
    /// both orders, and the colours too; and bands are strips of it.
    #[test]
    fn a_canvas_is_a_framebuffer(steps in prop::collection::vec(steps(), 1..8), cut in 1..HEIGHT) {
        let (mut theirs_be, mut theirs_le) = (Theirs::<BigEndian>::new(), Theirs::<LittleEndian>::new());
        let mut native = [Rgb565::BLACK; PIXELS];
        let (mut be, mut le) = ([[0; 2]; PIXELS], [[0; 2]; PIXELS]);
        let cut_at = (cut * WIDTH) as usize;
        let mut strips = [[0; 2]; PIXELS];
        let (above, below) = strips.split_at_mut(cut_at);
        {
            let mut native = Canvas::new(&mut native, WIDTH, HEIGHT).unwrap();
            let mut be: Canvas<Rgb565, _> = Canvas::big_endian(&mut be, WIDTH, HEIGHT).unwrap();
            let mut le: Canvas<Rgb565, _> = Canvas::little_endian(&mut le, WIDTH, HEIGHT).unwrap();
            let mut above: Canvas<Rgb565, _> = Canvas::big_endian_band(above, WIDTH, HEIGHT, 0).unwrap();
            let mut below: Canvas<Rgb565, _> = Canvas::big_endian_band(below, WIDTH, HEIGHT, cut).unwrap();
            prop_assert_eq!(below.bounding_box(), Rectangle::new(Point::new(0, cut.cast_signed()), Size::new(WIDTH, HEIGHT - cut)));
            for step in &steps {
                step.apply(&mut theirs_be);
                step.apply(&mut theirs_le);
                step.apply(&mut native);
                step.apply(&mut be);
                step.apply(&mut le);
                step.apply(&mut above);
                step.apply(&mut below);
            }
            prop_assert_eq!(be.bytes(), theirs_be.data());
            prop_assert_eq!(le.bytes(), theirs_le.data());
            prop_assert!(native.pixels().eq(be.pixels()) && native.pixels().eq(le.pixels()));
            prop_assert_eq!(above.bytes(), &theirs_be.data()[..2 * cut_at]);
            prop_assert_eq!(below.bytes(), &theirs_be.data()[2 * cut_at..]);
            let at = |i: u32| Point::new((i % WIDTH).cast_signed(), (i / WIDTH).cast_signed());
            prop_assert!((0..WIDTH * HEIGHT).map(|i| theirs_be.pixel(at(i)).unwrap()).eq(native.pixels()));
        }
    }
}

/// `fill_contiguous` takes from an iterator that never ends no more than it needs.
#[test]
fn fill_contiguous_ends() {
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

/// A picture with a triangle in it, and with depth.
fn triangle<C: PixelColor>(canvas: &mut Canvas<'_, C, Native, Depth<'_>>, color: C, distance: i16) {
    #[derive(Clone, Copy)]
    struct One<C>(C);
    impl<C: PixelColor> Shader<0> for One<C> {
        type Color = C;
        fn varyings(&self, _: &Corner) -> [i32; 0] {
            []
        }
        fn shade(&self, _: &Fragment, []: [i32; 0]) -> Option<C> {
            Some(self.0)
        }
    }
    let projection =
        Projection::orthographic(fx!(0), fx!(8), fx!(-8), fx!(0), fx!(0), fx!(10)).unwrap();
    let positions = [(0, 0), (0, -8), (8, -8)].map(|(x, y)| Vec3::from_ints(x, y, -distance));
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    canvas.draw(&mesh, &projection.into(), &One(color));
}

/// Text goes over the picture and leaves the depth as it is.
#[test]
fn text_over_the_picture() {
    let mut pixels = [BinaryColor::Off; 64];
    let mut depths = [0; 64];
    let mut canvas = Canvas::new(&mut pixels, 8, 8)
        .unwrap()
        .with_depth(&mut depths)
        .unwrap();
    triangle(&mut canvas, BinaryColor::On, 5);
    let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    Text::new("!", Point::new(3, 6), style)
        .draw(&mut canvas)
        .unwrap();
    let mut display = MockDisplay::new();
    canvas.show(&mut display).unwrap();
    display.assert_pattern(&[
        ".....#..", "#....#..", "##...#..", "###..#..", "####.#..", "#####...", "######..",
        "#######.",
    ]);
    let drawn: Vec<bool> = depths.iter().map(|&depth| depth > 0).collect();
    let covered: Vec<bool> = (0..64).map(|i| i % 8 < i / 8).collect();
    assert_eq!(drawn, covered);
}

/// `Canvas::clear` forgets the depth, embedded-graphics' own `clear` is a fill and does not.
#[test]
fn clearing_forgets_the_depth() {
    let mut pixels = [Gray8::BLACK; 64];
    let mut depths = [0; 64];
    let mut canvas = Canvas::new(&mut pixels, 8, 8)
        .unwrap()
        .with_depth(&mut depths)
        .unwrap();
    triangle(&mut canvas, Gray8::new(1), 2);
    let Ok(()) = DrawTarget::clear(&mut canvas, Gray8::new(9));
    triangle(&mut canvas, Gray8::new(2), 3);
    assert!(
        canvas.pixels().all(|pixel| pixel == Gray8::new(9)),
        "the nearer one still hides it"
    );
    canvas.clear(Gray8::new(8));
    triangle(&mut canvas, Gray8::new(3), 3);
    assert_eq!(
        canvas
            .pixels()
            .filter(|&pixel| pixel == Gray8::new(3))
            .count(),
        28
    );
    assert_eq!(
        canvas
            .pixels()
            .filter(|&pixel| pixel == Gray8::new(8))
            .count(),
        36
    );
}

/// A display that notes what it is asked to do, and may fail.
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
        panic!("pixels are to come in one piece");
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
fn a_canvas_shows_itself_in_one_piece() {
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
    let swapped: Canvas<Rgb888, _> = Canvas::little_endian(&mut bytes, 4, 6).unwrap();
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
fn a_failing_displays_error_comes_through() {
    let mut display = Display {
        broken: true,
        ..Display::default()
    };
    let mut pixels = [Rgb888::BLACK; 24];
    let canvas = Canvas::new(&mut pixels, 4, 6).unwrap();
    assert_eq!(canvas.show(&mut display), Err(BusError(42)));
}

/// Bytes as on the bus, for each number of bytes to the pixel.
#[test]
fn byte_orders() {
    let mut pixels = [[0; 2]; 2];
    let mut canvas: Canvas<Rgb565, _> = Canvas::big_endian(&mut pixels, 2, 1).unwrap();
    canvas.clear(Rgb565::new(1, 2, 3));
    assert_eq!(canvas.bytes(), [0x08, 0x43, 0x08, 0x43]);
    assert_eq!(canvas.cells(), [[0x08, 0x43]; 2]);
    assert!(canvas.pixels().all(|pixel| pixel == Rgb565::new(1, 2, 3)));
    let mut canvas: Canvas<Rgb565, _> = Canvas::little_endian(&mut pixels, 2, 1).unwrap();
    canvas.clear(Rgb565::new(1, 2, 3));
    assert_eq!(canvas.bytes(), [0x43, 0x08, 0x43, 0x08]);
    let mut pixels = [[0; 3]; 1];
    let mut canvas: Canvas<Rgb888, _> = Canvas::big_endian(&mut pixels, 1, 1).unwrap();
    canvas.clear(Rgb888::new(1, 2, 3));
    assert_eq!(canvas.bytes(), [1, 2, 3]);
    let mut canvas: Canvas<Rgb888, _> = Canvas::little_endian(&mut pixels, 1, 1).unwrap();
    canvas.clear(Rgb888::new(1, 2, 3));
    assert_eq!(canvas.bytes(), [3, 2, 1]);
    let mut pixels = [[0; 1]; 1];
    let mut canvas: Canvas<Gray8, _> = Canvas::big_endian(&mut pixels, 1, 1).unwrap();
    canvas.clear(Gray8::new(7));
    assert_eq!(canvas.bytes(), [7]);
}

/// What is refused, with the numbers that the message is to name.
#[test]
fn errors_name_the_numbers() {
    let pixels = |count: usize| vec![Gray8::BLACK; count];
    let new = |count, width, height| Canvas::new(&mut pixels(count), width, height).err();
    let band =
        |count, width, height, first| Canvas::band(&mut pixels(count), width, height, first).err();

    for (width, height) in [
        (0, 4),
        (4, 0),
        (0, 0),
        (MAX_SIZE + 1, 1),
        (1, MAX_SIZE + 1),
        (u32::MAX, u32::MAX),
    ] {
        let error = Some(Error::Size {
            width,
            height,
            max: MAX_SIZE,
        });
        assert_eq!(new(4, width, height), error);
        assert_eq!(band(4, width, height, 0), error);
    }
    assert_eq!(new(MAX_SIZE as usize, MAX_SIZE, 1), None);

    for given in [0, 11, 13] {
        assert_eq!(new(given, 4, 3), Some(Error::Length { given, needed: 12 }));
    }
    assert_eq!(new(12, 4, 3), None);

    let rows = |first, rows| {
        Some(Error::Rows {
            first,
            rows,
            height: 3,
        })
    };
    assert_eq!(band(0, 4, 3, 0), rows(0, 0));
    assert_eq!(band(3, 4, 3, 0), rows(0, 0), "less than a row");
    assert_eq!(band(8, 4, 3, 2), rows(2, 2));
    assert_eq!(band(16, 4, 3, 0), rows(0, 4));
    assert_eq!(band(4, 4, 3, 3), rows(3, 1));
    assert_eq!(band(4, 4, 3, u32::MAX), rows(u32::MAX, 1));
    assert_eq!(
        band(9, 4, 3, 1),
        Some(Error::Length {
            given: 9,
            needed: 8
        })
    );
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
        with_depth(12, 1),
        Some(Error::Length {
            given: 12,
            needed: 8
        }),
        "of the band, not the frame"
    );
    assert_eq!(with_depth(8, 1), None);

    let mut cells = [[0; 2]; 5];
    let error = |error| Some(error);
    assert_eq!(
        Canvas::<Rgb565, BigEndian>::big_endian(&mut cells, 2, 2).err(),
        error(Error::Length {
            given: 5,
            needed: 4
        })
    );
    assert_eq!(
        Canvas::<Rgb565, LittleEndian>::little_endian_band(&mut cells, 5, 2, 2).err(),
        error(Error::Rows {
            first: 2,
            rows: 1,
            height: 2
        })
    );
}
