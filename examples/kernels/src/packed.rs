//! Measures pixels in black and white, stored as colors, in rows with 8 pixels to a byte, and in pages with 8 rows to a
//! byte.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{BinaryColor, Gray8};
use fixel::canvas::{Contrast, ErrorDiffusion, Storage};
use fixel::mode::Affine;
use fixel::prelude::*;

use super::ticks::Stopwatch;
use super::wall::{self, ROWS, UVS};

static WHITE: [[BinaryColor; 2]; 2] = [[BinaryColor::On; 2]; 2];

/// Widths of the frames that are compared. Both lie within one span.
const WIDTHS: [u32; 2] = [16, 48];
const PIXELS: usize = 48 * ROWS as usize;

/// Measures textured pixels in each storage, and prints them.
pub fn measure(watch: &mut Stopwatch) -> Result<(), Error> {
    print(watch, "mono-native", |watch, width| {
        let mut pixels = [BinaryColor::Off; PIXELS];
        let pixels = &mut pixels[..(width * ROWS) as usize];
        draw(watch, &mut Canvas::new(pixels, width, ROWS)?)
    })?;
    let mut bytes = [0; PIXELS / 8];
    print(watch, "mono-packed", |watch, width| {
        let bytes = &mut bytes[..(width * ROWS / 8) as usize];
        draw(watch, &mut Canvas::packed(bytes, width, ROWS)?)
    })?;
    print(watch, "mono-pages", |watch, width| {
        let bytes = &mut bytes[..(width * ROWS / 8) as usize];
        draw(watch, &mut Canvas::pages(bytes, width, ROWS)?)
    })?;
    let mut grays = [Gray8::new(0); PIXELS];
    for (at, gray) in (0..).zip(&mut grays) {
        *gray = Gray8::new((at * 7 >> 3) as u8);
    }
    print(watch, "mono-diffused", |watch, width| {
        let (pixels, size) = ((width * ROWS) as usize, (width * ROWS / 8) as usize);
        let gray = Canvas::new(&mut grays[..pixels], width, ROWS)?;
        let mut panel: Canvas<BinaryColor, _> = Canvas::packed(&mut bytes[..size], width, ROWS)?;
        let mut errors = [0; WIDTHS[1] as usize];
        let mut diffusion = ErrorDiffusion::new(&mut errors);
        let contrast = black_box(Contrast::default());
        watch.time(|| {
            let Ok(()) = gray.show_diffused(&mut panel, contrast, &mut diffusion);
            Ok(())
        })
    })
}

/// Prints the cost of the pixels that only the wider frame has.
fn print(
    watch: &mut Stopwatch,
    name: &str,
    mut draw: impl FnMut(&mut Stopwatch, u32) -> Result<u64, Error>,
) -> Result<(), Error> {
    let [narrow, wide] = WIDTHS;
    let (less, more) = (draw(watch, narrow)?, draw(watch, wide)?);
    watch.print(name, "pixel", (wide - narrow) * ROWS, more - less);
    Ok(())
}

/// Draws a wall that covers the canvas, and returns its ticks.
fn draw<O: Storage<BinaryColor>>(
    watch: &mut Stopwatch,
    canvas: &mut Canvas<'_, BinaryColor, O>,
) -> Result<u64, Error> {
    let width = canvas.frame_size().width;
    let (positions, mvp) = (wall::positions(width), wall::mvp(width)?);
    let wall = Mesh::new(&positions, &[[0, 1, 2]])?.with_uvs(&UVS, None)?;
    let options = DrawOptions::new().with_mode(Affine);
    let (options, shader) = black_box((options, Textured::new(&WHITE)));
    let ticks = watch.time(|| {
        let drawn = canvas.draw_with(&options, &wall, &mvp, &shader);
        assert_eq!(drawn.drawn, 1, "triangles drawn");
        Ok::<(), Error>(())
    })?;
    assert!(canvas.pixels().all(BinaryColor::is_on), "pixels drawn");
    Ok(ticks)
}
