//! Canvases with several pixels in a byte.

use std::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size_bpp};
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawData, RawU1, RawU2, RawU4, RawU16};
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::primitives::Rectangle;
use fixel::canvas::{Blending, Contrast, DepthBuffer, ErrorDiffusion, Opacity, Replace, Storage};
use fixel::mode::{Compact, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::shade::{Levels, NormalView};
use rand::{Rng, SeedableRng};

use super::pictures::{self, HEIGHT, WIDTH};
use crate::common::random::{Random, cases};

/// A target that reduces each color to its lowest bits.
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

/// Compares the pictures of a packed canvas, whole and in bands, with those of embedded-graphics' framebuffer.
macro_rules! is_a_framebuffer {
    ($color:ty, $raw:ty) => {{
        const BYTES: usize =
            buffer_size_bpp(WIDTH as usize, HEIGHT as usize, <$raw>::BITS_PER_PIXEL);
        const ROW: usize = BYTES / HEIGHT as usize;
        cases(500, |random| {
            let (crops, band) = (random.random(), random.random_range(1..=HEIGHT as usize));
            let mut theirs = Framebuffer::<
                $color,
                $raw,
                LittleEndian,
                { WIDTH as usize },
                { HEIGHT as usize },
                BYTES,
            >::new();
            pictures::draw(&mut Coarse(&mut theirs), &mut random.clone(), crops);

            let mut bytes = [0; BYTES];
            let mut canvas: Canvas<$color, _> = Canvas::packed(&mut bytes, WIDTH, HEIGHT).unwrap();
            pictures::draw(&mut Coarse(&mut canvas), &mut random.clone(), crops);
            assert!(no_padding(canvas.as_cells(), ROW) == no_padding(theirs.data(), ROW));
            let drawn: Vec<$color> = canvas.pixels().collect();

            let mut native = [<$color>::from(<$raw>::from_u32(0)); (WIDTH * HEIGHT) as usize];
            let mut canvas = Canvas::new(&mut native, WIDTH, HEIGHT).unwrap();
            pictures::draw(&mut Coarse(&mut canvas), &mut random.clone(), crops);
            assert!(drawn == native, "pixels");
            if crops {
                return;
            }
            let mut in_bands = [0; BYTES];
            let mut first = 0;
            for bytes in in_bands.chunks_mut(band * ROW) {
                let mut canvas: Canvas<$color, _> =
                    Canvas::packed_band(bytes, WIDTH, HEIGHT, first).unwrap();
                first += canvas.rows().len() as u32;
                pictures::draw(&mut Coarse(&mut canvas), &mut random.clone(), crops);
            }
            assert!(
                no_padding(&in_bands, ROW) == no_padding(theirs.data(), ROW),
                "bands"
            );
        });
    }};
}

/// Each row's bytes that hold only pixels. The others contain padding, which `clear` may change.
fn no_padding(bytes: &[u8], row: usize) -> Vec<&[u8]> {
    bytes.chunks(row).map(|row| &row[..row.len() - 1]).collect()
}

#[test]
fn a_packed_canvas_is_a_framebuffer() {
    is_a_framebuffer!(BinaryColor, RawU1);
    is_a_framebuffer!(Gray2, RawU2);
    is_a_framebuffer!(Gray4, RawU4);
}

/// In a page, bit n of a byte belongs to row n.
#[test]
fn paged_canvases_show_the_same_as_packed_ones() {
    let pages = WIDTH * HEIGHT.div_ceil(8);
    cases(500, |random| {
        let down = random.random_range(1..=4) * WIDTH as usize;
        let mut native = [BinaryColor::Off; (WIDTH * HEIGHT) as usize];
        let mut canvas = Canvas::new(&mut native, WIDTH, HEIGHT).unwrap();
        pictures::draw(&mut Coarse(&mut canvas), &mut random.clone(), false);

        let mut bytes = vec![0; pages as usize];
        let mut canvas = Canvas::pages(&mut bytes, WIDTH, HEIGHT).unwrap();
        pictures::draw(&mut Coarse(&mut canvas), &mut random.clone(), false);
        assert!(canvas.pixels().eq(native));
        for (i, pixel) in (0..).zip(native) {
            let (x, y) = (i % WIDTH, i / WIDTH);
            let byte = bytes[(y / 8 * WIDTH + x) as usize];
            assert_eq!(byte >> (y % 8) & 1 == 1, pixel.is_on());
        }

        let mut in_bands = vec![0; pages as usize];
        let mut first = 0;
        for bytes in in_bands.chunks_mut(down) {
            let mut canvas = Canvas::pages_band(bytes, WIDTH, HEIGHT, first).unwrap();
            first += canvas.rows().len() as u32;
            pictures::draw(&mut Coarse(&mut canvas), &mut random.clone(), false);
        }
        assert_eq!(first, HEIGHT);
        assert!(in_bands == bytes, "bands");
    });
}

#[test]
fn memory_of_another_size_is_refused() {
    let too_long =
        |given, needed| format!("slice has {given} elements: exactly {needed} are needed");
    // 11 pixels of 1, 2 and 4 bits take 2, 3 and 6 bytes.
    let mut bytes = [0; 100];
    assert!(Canvas::<BinaryColor, _>::packed(&mut bytes[..6], 11, 3).is_ok());
    let error = Canvas::<BinaryColor, _>::packed(&mut bytes[..5], 11, 3).unwrap_err();
    assert_eq!(error.to_string(), too_long(5, 6));
    assert!(Canvas::<Gray2, _>::packed(&mut bytes[..9], 11, 3).is_ok());
    let error = Canvas::<Gray2, _>::packed(&mut bytes[..10], 11, 3).unwrap_err();
    assert_eq!(error.to_string(), too_long(10, 9));
    assert!(Canvas::<Gray4, _>::packed_band(&mut bytes[..12], 11, 3, 1).is_ok());
    let error = Canvas::<Gray4, _>::packed_band(&mut bytes[..13], 11, 3, 1).unwrap_err();
    assert_eq!(error.to_string(), too_long(13, 12));
    let error = Canvas::<Gray4, _>::packed_band(&mut bytes[..18], 11, 3, 1).unwrap_err();
    assert!(error.to_string().starts_with("band has 3 rows from row 1"));

    assert!(Canvas::pages(&mut bytes[..33], 11, 17).is_ok());
    let error = Canvas::pages(&mut bytes[..32], 11, 17).unwrap_err();
    assert_eq!(error.to_string(), too_long(32, 33));
    for (length, first, rows) in [
        (22, 8, 8..17),
        (11, 5, 5..13),
        (11, 16, 16..17),
        (33, 0, 0..17),
    ] {
        let band = Canvas::pages_band(&mut bytes[..length], 11, 17, first).unwrap();
        assert_eq!(*band.rows(), rows);
    }
    // The last page would contain no row of the frame.
    for (length, first, rows) in [(22, 9, 16), (11, 17, 8), (0, 0, 0), (44, 0, 32)] {
        let error = Canvas::pages_band(&mut bytes[..length], 11, 17, first).unwrap_err();
        let wanted = format!("band has {rows} rows from row {first}");
        assert!(error.to_string().starts_with(&wanted), "{error}");
    }
}

static BALL: Mesh = shape!(sphere(9, 7));

/// Draws a ball and its edges: near, far, across the borders of the frame, and outside it.
fn ball<C, O, D, I, B>(canvas: &mut Canvas<'_, C, O, D>, number: i16, mode: I, blending: B)
where
    C: Levels,
    O: Storage<C>,
    D: DepthBuffer,
    I: Mode,
    B: Blending<C, Source = C>,
{
    let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.25), fx!(30)).unwrap();
    let [x, y] = [number % 7 - 3, number % 5 - 2].map(Scalar::from_num);
    let place = Vec3::new(x, y, fx!(-1.25) - Scalar::from_num(number % 9));
    let mvp = projection * Transform::translate(place);
    let options = DrawOptions::new().with_mode(mode).with_blending(blending);
    canvas.draw_with(&options, &BALL, &mvp, &NormalView::new());
    let gray = u8::try_from(number).unwrap();
    canvas.draw_with(
        &options,
        BALL.edges(LineStyle::HAIRLINE),
        &mvp,
        &Flat::rgb(Rgb888::new(gray, gray, 9)),
    );
}

/// Draws all scenes in canvases of one color type, and compares them with native ones.
macro_rules! draws_as_native {
    ($color:ty, $canvas:path, $bytes:expr, $mode:expr, $blending:expr) => {
        for number in 0..64 {
            let mut native = [<$color>::from_rgb(Rgb888::WHITE, Point::zero()); PIXELS];
            ball(
                &mut Canvas::new(&mut native, WIDTH, HEIGHT).unwrap(),
                number,
                $mode,
                $blending,
            );
            let mut bytes = [0xff; $bytes];
            let mut canvas: Canvas<$color, _> = $canvas(&mut bytes, WIDTH, HEIGHT).unwrap();
            ball(&mut canvas, number, $mode, $blending);
            assert!(canvas.pixels().eq(native), "{number}");

            let mut native = [<$color>::from_rgb(Rgb888::WHITE, Point::zero()); PIXELS];
            let mut depths = [0x1000; PIXELS];
            let canvas = Canvas::new(&mut native, WIDTH, HEIGHT).unwrap();
            ball(
                &mut canvas.with_depth(&mut depths).unwrap(),
                number,
                $mode,
                $blending,
            );
            let (mut bytes, mut other_depths) = ([0xff; $bytes], [0x1000; PIXELS]);
            let canvas: Canvas<$color, _> = $canvas(&mut bytes, WIDTH, HEIGHT).unwrap();
            let mut canvas = canvas.with_depth(&mut other_depths).unwrap();
            ball(&mut canvas, number, $mode, $blending);
            assert!(canvas.pixels().eq(native), "with depths {number}");
            assert!(depths == other_depths, "depths {number}");
        }
    };
}

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// In each mode, and with blending, which reads the colors below.
#[test]
fn packed_canvases_show_the_same_as_native_ones() {
    const PAGES: usize = WIDTH as usize * (HEIGHT as usize).div_ceil(8);
    const fn rows(pixels_in_byte: usize) -> usize {
        (WIDTH as usize).div_ceil(pixels_in_byte) * HEIGHT as usize
    }
    let fast = Fast::within(fx!(0.5));
    draws_as_native!(BinaryColor, Canvas::packed, rows(8), Newton, Replace);
    draws_as_native!(BinaryColor, Canvas::packed, rows(8), Exact, Replace);
    draws_as_native!(BinaryColor, Canvas::packed, rows(8), fast, Opacity(99));
    draws_as_native!(Gray2, Canvas::packed, rows(4), Compact, Opacity(99));
    draws_as_native!(Gray4, Canvas::packed, rows(2), Newton, Opacity(99));
    draws_as_native!(BinaryColor, Canvas::pages, PAGES, Newton, Replace);
    draws_as_native!(BinaryColor, Canvas::pages, PAGES, Compact, Opacity(99));
    draws_as_native!(BinaryColor, Canvas::pages, PAGES, fast, Replace);
}

/// Diffusion keeps the sum of all grays: `errors` holds the part that is not shown. The grays are so far from black and
/// white that no error moves them past either.
#[test]
fn diffusion_loses_no_brightness() {
    let mut random = Random::seed_from_u64(1);
    for (width, height) in [(1, 1), (1, 9), (2, 3), (17, 12), (70, 40)] {
        let pixels = (width * height) as usize;
        let mut gray = || Gray8::new(random.random_range(90..=165));
        let mut grays: Vec<Gray8> = (0..pixels).map(|_| gray()).collect();
        let sum: i32 = grays.iter().map(|gray| i32::from(gray.luma())).sum();
        let gray = Canvas::new(&mut grays, width, height).unwrap();

        let (mut errors, mut shown) = (vec![0; width as usize], vec![BinaryColor::Off; pixels]);
        let mut panel = Canvas::new(&mut shown, width, height).unwrap();
        let mut diffusion = ErrorDiffusion::new(&mut errors);
        let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
        let white: i32 = shown
            .iter()
            .map(|color| 255 * i32::from(color.is_on()))
            .sum();
        let lost: i32 = errors.iter().map(|&error| i32::from(error)).sum();
        assert_eq!((sum - white) * 16, lost, "{width}x{height}");

        let (mut errors, mut shown) = (vec![0; width as usize], vec![Gray4::new(0); pixels]);
        let mut panel = Canvas::new(&mut shown, width, height).unwrap();
        let mut diffusion = ErrorDiffusion::new(&mut errors);
        let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
        let white: i32 = shown.iter().map(|color| 17 * i32::from(color.luma())).sum();
        let lost: i32 = errors.iter().map(|&error| i32::from(error)).sum();
        assert_eq!((sum - white) * 16, lost, "{width}x{height}");
        // An error is at most half a step of 17, plus less than 1/16 for each of three shares that are rounded down.
        assert!(errors.iter().all(|error| error.abs() <= 9 * 16));
    }
}

/// Every window is as bright as the original, except for the errors that cross its borders.
///
/// An error is at most half a step, 127.5. Each pixel of the first and last rows passes 9/16 of its error across the
/// upper or lower border. Each pixel of the first and last columns passes 7/16 + 1/16 across one side and 3/16 across
/// the other. Half an error crosses the corners. Rounding shares to 16ths loses at most one gray per three pixels of a
/// border.
#[test]
fn diffusion_keeps_the_brightness_of_every_window() {
    const SIZE: (u32, u32) = (160, 120);
    let wave = |x: f64, y: f64| 127.5 + 60. * (x / 19.).sin() + 55. * (x / 40. + y / 23.).cos();
    let places = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (f64::from(x), f64::from(y))));
    let mut grays: Vec<Gray8> = places
        .map(|(x, y)| Gray8::new((wave(x, y).round() as i32).cast_unsigned() as u8))
        .collect();
    let gray = Canvas::new(&mut grays, SIZE.0, SIZE.1).unwrap();
    let mut shown = vec![BinaryColor::Off; (SIZE.0 * SIZE.1) as usize];
    let mut panel = Canvas::new(&mut shown, SIZE.0, SIZE.1).unwrap();
    let mut errors = [0; SIZE.0 as usize];
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    let mut widest: f64 = 0.;
    cases(500, |random| {
        let [width, height] = [random.random_range(1..100_u32), random.random_range(1..100)];
        // The window must stay away from the sides of the frame, which have a rule of their own.
        let left = random.random_range(1..SIZE.0 - width);
        let top = random.random_range(0..=SIZE.1 - height);
        let mut excess = 0.;
        for y in top..top + height {
            for x in left..left + width {
                let is_on = shown[(y * SIZE.0 + x) as usize].is_on();
                excess += 255. * f64::from(u8::from(is_on)) - wave(x.into(), y.into()).round();
            }
        }
        let [w, h] = [width, height].map(f64::from);
        let most = 127.5 * (w * 9. / 8. + h * 11. / 8. + 0.5) + (2. * w + 2. * h) / 3.;
        assert!(
            f64::abs(excess) <= most,
            "{width}x{height} at {left}, {top}: {excess}"
        );
        widest = widest.max(f64::abs(excess) / (w * h));
    });
    // Some windows must differ by more than a gray; otherwise the bound tests nothing.
    assert!(widest > 1., "{widest}");
}

/// White beside gray: errors that white pixels cannot absorb must not accumulate at the border, where they would whiten
/// the darker rows below.
#[test]
fn diffusion_does_not_whiten_darker_rows_below() {
    const WIDTH: u32 = 240;
    let mut grays = vec![Gray8::new(60); (WIDTH * 280) as usize];
    for row in grays.chunks_mut(WIDTH as usize) {
        row[220..].fill(Gray8::new(255));
    }
    grays.extend(vec![Gray8::new(0); (WIDTH * 8) as usize]);
    let gray = Canvas::new(&mut grays, WIDTH, 288).unwrap();
    let mut shown = vec![BinaryColor::Off; (WIDTH * 288) as usize];
    let mut panel = Canvas::new(&mut shown, WIDTH, 288).unwrap();
    let mut errors = [0; WIDTH as usize];
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    // A share of half a step may make one pixel white.
    let stray = shown[(WIDTH * 280) as usize..].chunks(WIDTH as usize);
    let stray = stray.map(|row| row[200..].iter().filter(|color| color.is_on()).count());
    assert!(stray.sum::<usize>() <= 1);
}

/// The ramp runs from black on the left to 253 of 255 on the right.
#[test]
fn diffusion_of_a_gray_ramp() {
    let ramp = |i: u8| Gray8::new(i % 24 * 11);
    let mut grays: Vec<Gray8> = (0..192).map(ramp).collect();
    let gray = Canvas::new(&mut grays, 24, 8).unwrap();
    let mut display: MockDisplay<BinaryColor> = MockDisplay::new();
    let mut errors = [0; 24];
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    gray.show_diffused(&mut display, Contrast::default(), &mut diffusion)
        .unwrap();
    display.assert_pattern(&[
        "........#.#.#.##.#######",
        ".....#.#...#.#.###.#####",
        "........#.#.#.#.########",
        "...#.#..#.#.##.##.#.###.",
        ".......#..#..##.#####.##",
        ".....#..#..##.##.#.#####",
        ".......#.#.#.#.#########",
        "...#.#....#.#.#.#.#.####",
    ]);

    // Grays that the display can show do not change.
    let mut grays = [0, 85, 170, 255].map(Gray8::new);
    let gray = Canvas::new(&mut grays, 4, 1).unwrap();
    let mut shown = [Gray2::new(0); 4];
    let mut panel = Canvas::new(&mut shown, 4, 1).unwrap();
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    assert_eq!(shown, [0, 1, 2, 3].map(Gray2::new));
}

#[test]
fn diffused_bands_equal_the_frame() {
    let mut grays: Vec<Gray8> = (0..=255).map(|i| Gray8::new(i / 2 + 50)).collect();
    let whole = {
        let gray = Canvas::new(&mut grays, 16, 16).unwrap();
        let mut shown = [BinaryColor::Off; 256];
        let mut panel = Canvas::new(&mut shown, 16, 16).unwrap();
        let mut errors = [0; 16];
        let mut diffusion = ErrorDiffusion::new(&mut errors);
        let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
        shown
    };
    // Errors that the previous frame left have no effect.
    let (mut shown, mut errors) = ([BinaryColor::Off; 256], [i16::MAX; 16]);
    let mut panel = Canvas::new(&mut shown, 16, 16).unwrap();
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    for (first, grays) in (0..).step_by(5).zip(grays.chunks_mut(5 * 16)) {
        let gray = Canvas::band(grays, 16, 16, first).unwrap();
        let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    }
    assert_eq!(shown, whole);
}

/// The list of errors may have any length, and canvases of several widths may share it.
#[test]
fn diffusion_takes_memory_of_any_length() {
    let mut errors = [i16::MIN; 20];
    for length in [0, 1, 2, 3, 20] {
        let mut diffusion = ErrorDiffusion::new(&mut errors[..length]);
        for (width, height) in [(3, 2), (6, 1), (1, 6)] {
            let mut grays = [0, 255, 128, 7, 200, 90].map(Gray8::new);
            let gray = Canvas::new(&mut grays, width, height).unwrap();
            let mut shown = [BinaryColor::Off; 6];
            let mut panel = Canvas::new(&mut shown, width, height).unwrap();
            let Ok(()) = gray.show_diffused(&mut panel, Contrast::new(9, 3), &mut diffusion);
            // With this contrast, every gray becomes black or white.
            assert_eq!(
                shown.map(BinaryColor::is_on),
                [0, 1, 1, 0, 1, 1].map(|on| on == 1)
            );
        }
    }
}
