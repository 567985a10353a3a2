//! Measures pixels in black and white: drawn, diffused from grays, and packed into pages with 8 rows in a byte.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{BinaryColor, Gray8};
use fixel::canvas::{Contrast, ErrorDiffusion};
use fixel::mode::Affine;
use fixel::prelude::*;

use super::ticks::Stopwatch;
use super::wall::{self, ROWS, UVS};

static WHITE: [[BinaryColor; 2]; 2] = [[BinaryColor::On; 2]; 2];

/// The widths of the frames that are compared. Both lie within one span.
const WIDTHS: [u32; 2] = [16, 48];
const PIXELS: usize = 48 * ROWS as usize;

/// Measures a textured pixel, a diffused pixel and a packed pixel, and prints their costs.
pub fn measure(watch: &mut Stopwatch) -> Result<(), Error> {
    let mut shown = [BinaryColor::Off; PIXELS];
    print(watch, "mono-native", |watch, width| {
        let shown = &mut shown[..(width * ROWS) as usize];
        draw(watch, &mut Canvas::new(shown, width, ROWS)?)
    })?;
    let mut grays = [Gray8::new(0); PIXELS];
    for (at, gray) in (0..).zip(&mut grays) {
        *gray = Gray8::new((at * 7 >> 3) as u8);
    }
    print(watch, "mono-diffused", |watch, width| {
        let pixels = (width * ROWS) as usize;
        let gray = Canvas::new(&mut grays[..pixels], width, ROWS)?;
        let mut panel = Canvas::new(&mut shown[..pixels], width, ROWS)?;
        let mut errors = [0; WIDTHS[1] as usize];
        let mut diffusion = ErrorDiffusion::new(&mut errors);
        let contrast = black_box(Contrast::default());
        watch.time(|| {
            let Ok(()) = gray.show_diffused(&mut panel, contrast, &mut diffusion);
            Ok(())
        })
    })?;
    let mut pages = [0; PIXELS / 8];
    print(watch, "mono-pages", |watch, width| {
        let panel = Canvas::new(&mut shown[..(width * ROWS) as usize], width, ROWS)?;
        watch.time(|| {
            for (page, byte) in black_box(&mut pages).iter_mut().zip(panel.pages()) {
                *page = byte;
            }
            Ok(())
        })
    })
}

/// Prints the cost of the pixels that only the wider of the two frames has.
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

/// Draws a wall that covers the canvas. Returns the ticks.
fn draw(watch: &mut Stopwatch, canvas: &mut Canvas<'_, BinaryColor>) -> Result<u64, Error> {
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
