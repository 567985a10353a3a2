//! Error diffusion in bands, compared with error diffusion of whole frames in f64.

use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor};
use fixel::canvas::{Contrast, ErrorDiffusion};
use fixel::prelude::*;
use fixel::shade::PixelFormat;
use rand::Rng;

use support::random::{Random, cases};
use support::reference::diffusion::steps;

/// Grays of a frame: noise, a slope, or areas of black, white and a third gray. Errors cannot cross black and white
/// areas.
fn frame(random: &mut Random, width: usize, height: usize) -> Vec<Vec<u8>> {
    let kind = random.random_range(0..3);
    let [across, down] = [random.random_range(0..20), random.random_range(0..20)];
    let gray = |random: &mut Random, x: usize, y: usize| match kind {
        0 => random.random(),
        1 => ((x * across + y * down) % 256) as u8,
        _ => [0, 255, 255 - across as u8][(x / 5 + y / 3) % 3],
    };
    (0..height)
        .map(|y| (0..width).map(|x| gray(random, x, y)).collect())
        .collect()
}

/// Shows a frame in bands of random heights, and compares every pixel with the model. All numbers of the model are
/// multiples of 1/16, so f64 represents them exactly, and the results must be equal. Returns the number of pixels.
fn compare<C>(random: &mut Random, most: i32, step: impl Fn(C) -> i32) -> usize
where
    C: PixelFormat<Channels = i32> + PixelColor + Default,
{
    let (width, height) = (
        random.random_range(1..40_usize),
        random.random_range(1..30_usize),
    );
    let grays = frame(random, width, height);
    let expected = steps(&grays, most);
    let mut errors = vec![random.random(); width];
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    let mut shown = Vec::new();
    let mut row = 0;
    while row < height {
        let rows = random.random_range(1..=height - row);
        let mut band: Vec<_> = grays[row..row + rows]
            .concat()
            .into_iter()
            .map(Gray8::new)
            .collect();
        let [frame_width, frame_height, first] = [width, height, row].map(|number| number as u32);
        let band = Canvas::band(&mut band, frame_width, frame_height, first).unwrap();
        let mut pixels = vec![C::default(); width * rows];
        let mut panel = Canvas::band(&mut pixels, frame_width, frame_height, first).unwrap();
        let Ok(()) = band.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
        shown.extend(pixels);
        row += rows;
    }
    let shown: Vec<i32> = shown.into_iter().map(step).collect();
    assert_eq!(shown, expected.concat(), "{width}x{height}, {most} steps");
    shown.len()
}

#[test]
fn bands_are_diffused_as_a_whole_frame_is() {
    let mut pixels = 0;
    cases(400, |random| {
        pixels += compare(random, 1, |color: BinaryColor| color.is_on().into());
        pixels += compare(random, 3, |color: Gray2| color.luma().into());
        pixels += compare(random, 15, |color: Gray4| color.luma().into());
    });
    assert!(pixels > 300_000, "{pixels}");
}
