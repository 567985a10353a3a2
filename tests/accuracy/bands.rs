//! Helpers for the tests of lines and of sized points: drawing in bands with a shader that records its input, and
//! random positions.

use embedded_graphics::pixelcolor::Gray8;
use fixel::Drawn;
use fixel::prelude::*;
use rand::Rng;
use support::random::{Random, within};
use support::recorder::{Probe, Recorder, Seen, record};
use support::reference::coverage::Bounds;

/// The number of random inputs that a test checks.
pub const CASES: u32 = 400;

/// A position on the screen in 24.8 (1/256 pixel).
pub type Point = [i32; 2];

pub const SIZE: (u32, u32) = (90, 40);

pub type Frame<'f> = Canvas<'f, Gray8, Native, LinearDepth>;
/// Records the interpolated x of the position.
pub type XRecorder<'p, 'v> = Recorder<'p, Probe<'v, [i32; 1]>, 1>;

/// Draws in bands of `rows` rows. Returns the drawn pixels, each with the interpolated x of the position.
pub fn drawn(
    rows: u32,
    draw: &dyn Fn(&mut Frame<'_>, &XRecorder<'_, '_>) -> Drawn,
) -> Vec<Seen<1>> {
    let values = |corner: &Corner<'_>| [corner.position().x.to_bits()];
    let probe = Probe {
        values: &values,
        color: Some(Gray8::new(1)),
    };
    let (width, height) = SIZE;
    let mut all = Vec::new();
    for first in (0..height).step_by(rows as usize) {
        let pixels = (width * rows.min(height - first)) as usize;
        let (mut colors, mut depths) = (vec![Gray8::new(0); pixels], vec![0; pixels]);
        let band = Canvas::band(&mut colors, width, height, first).unwrap();
        let mut band = band.with_depth(&mut depths).unwrap();
        let record = record(probe, |recorder| {
            draw(&mut band, recorder);
        });
        all.extend(record.seen);
    }
    all.sort_by_key(|seen| (seen.pixel[1], seen.pixel[0]));
    all
}

/// How often each pixel was drawn.
pub fn counts(seen: &[Seen<1>]) -> Vec<u32> {
    let mut counts = vec![0; (SIZE.0 * SIZE.1) as usize];
    for seen in seen {
        counts[seen.pixel[1] as usize * SIZE.0 as usize + seen.pixel[0] as usize] += 1;
    }
    counts
}

/// How often the model draws each pixel: once if `has` is true for the pixel, otherwise never.
pub fn modeled(has: &dyn Fn([i32; 2]) -> bool) -> Vec<u32> {
    let pixels = Bounds::new(SIZE.0, SIZE.1).pixels();
    pixels.map(|pixel| u32::from(has(pixel))).collect()
}

/// A position in or around a picture: on a pixel's corner, on its center, or on any subpixel.
pub fn point(random: &mut Random, (width, height): (u32, u32)) -> Point {
    let [width, height] = [width, height].map(u32::cast_signed);
    let pixels = [-10..width + 10, -10..height + 10];
    match random.random_range(0..4) {
        0 => within(random, pixels).map(|at| at * 256),
        1 => within(random, pixels).map(|at| at * 256 + 128),
        2 => within(
            random,
            pixels.map(|range| range.start * 256..range.end * 256),
        ),
        _ => within(random, [-500_000..500_000, -500_000..500_000]),
    }
}
