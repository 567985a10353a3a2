//! Measures the time of draw calls as the median of repetitions.

use std::hint::black_box;
use std::time::{Duration, Instant};

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::canvas::DepthBuffer;
use fixel::mode::Mode;
use fixel::prelude::*;

use super::Result;
use super::case::Case;
use super::spread::median;
use super::surface::{Job, Target};

/// The number of drawings before the first drawing that counts. These drawings warm up caches and branch predictors,
/// like the earlier frames of a program.
const WARM: u32 = 4;
/// The shortest time to measure, a thousand times the resolution of the clock. Faster drawings are repeated.
const LEAST: Duration = Duration::from_micros(50);

/// The nanoseconds of each repetition, for each drawing of a case.
#[derive(Clone, Debug, Default)]
pub struct Times(Vec<Vec<f64>>);

impl Times {
    /// Returns the nanoseconds of all drawings together: the sum of their medians.
    pub fn ns(&self) -> f64 {
        self.0.iter().map(|samples| median(samples.clone())).sum()
    }

    /// Draws a case `repeats` more times.
    pub fn add<I: Mode>(&mut self, case: &Case, mode: I, repeats: u32) -> Result<()> {
        self.0.resize(case.shots.len(), Vec::new());
        let timing = Timing {
            case,
            options: &DrawOptions::new().with_mode(mode),
            repeats,
            times: self,
        };
        case.surface.give(case.size, timing)
    }
}

struct Timing<'a, I> {
    case: &'a Case,
    options: &'a DrawOptions<I>,
    repeats: u32,
    times: &'a mut Times,
}

impl<I: Mode> Job for Timing<'_, I> {
    fn run<D: DepthBuffer, F: ShaderFor<Rgb565>>(
        self,
        canvas: &mut Target<'_, D>,
        shader: &F,
    ) -> Result<()> {
        for (shot, samples) in self.case.shots.iter().zip(&mut self.times.0) {
            let mesh = shot.mesh()?;
            // Repeat the drawing until it takes long enough. With a depth buffer, draw only once, because a second
            // drawing would be hidden.
            let mut times = 1_u32;
            for repeat in 0..WARM + self.repeats {
                canvas.clear(Rgb565::BLACK);
                let start = Instant::now();
                for _ in 0..times {
                    let (mesh, mvp) = (black_box(&mesh), black_box(&shot.mvp));
                    black_box(canvas.draw_with(self.options, mesh, mvp, shader));
                }
                let time = start.elapsed();
                if repeat >= WARM {
                    samples.push(time.as_secs_f64() * 1e9 / f64::from(times));
                } else if self.case.surface.may_repeat() {
                    let once = time.as_nanos() / u128::from(times);
                    times = u32::try_from(LEAST.as_nanos() / once.max(1))? + 1;
                }
            }
        }
        Ok(())
    }
}
