//! Measures the test of whether a box is in view.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mesh::Bounds;
use fixel::prelude::*;

use super::common::scenes::{self, HEIGHT, WIDTH};
use super::ticks::Stopwatch;

const TESTS: u32 = 64;

/// Tests a box against a band of 16 rows below it. Returns the number of tests and the ticks.
pub fn measure(watch: &mut Stopwatch) -> Result<(u32, u64), Error> {
    let mut pixels = [Rgb565::BLACK; WIDTH as usize * 16];
    let canvas = Canvas::band(&mut pixels, WIDTH, HEIGHT, HEIGHT - 16)?;
    let bounds = Bounds::new(vec3!(-0.3, -0.3, -0.3), vec3!(0.3, 0.3, 0.3));
    let mvp = scenes::sphere_mvp(0)?;
    let ticks = watch.time(|| {
        for _ in 0..TESTS {
            let is_in_view = canvas.is_in_view(&DrawOptions::new(), black_box(&bounds), &mvp);
            assert!(!is_in_view, "the band is below the box");
        }
        Ok::<_, Error>(())
    })?;
    Ok((TESTS, ticks))
}
