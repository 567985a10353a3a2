//! Measures the errors of a case in a mode: in texels, and as a picture.

use std::cell::RefCell;

use crc32fast::Hasher;
use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::canvas::DepthBuffer;
use fixel::mode::Mode;
use fixel::prelude::*;

use super::Result;
use super::case::{Case, Shot};
use super::record::{Recorder, Seen};
use super::spread::Spread;
use super::surface::{Job, Target};
use super::time::Times;
use super::truth::{Expected, Truth, order};

/// The measurements of one case in one mode.
#[derive(Clone, Debug)]
pub struct Figures {
    pub mode: &'static str,
    /// The number of pixels drawn, in all drawings.
    pub pixels: usize,
    /// The number of drawings.
    pub frames: usize,
    /// The texel errors; `None` if no attribute is interpolated.
    pub error: Option<Spread>,
    /// The PSNR of the covered pixels in dB. The PSNR is infinite if all these pixels are equal to the model's pixels.
    pub psnr: f64,
    /// The time of each drawing.
    pub times: Times,
    /// The CRC-32 of the first picture's pixels, row by row. The more significant byte comes first.
    pub crc: u32,
}

impl Figures {
    pub fn ns_per_pixel(&self) -> f64 {
        self.times.ns() / self.pixels as f64
    }
}

/// A case, and the exact picture of each drawing in it.
pub struct Subject<'a> {
    case: &'a Case,
    truths: Vec<Truth>,
}

impl<'a> Subject<'a> {
    pub fn new(case: &'a Case) -> Result<Self> {
        let truths = case.shots.iter().map(|shot| Truth::of(case, shot));
        let truths = truths.collect::<Result<_>>()?;
        Ok(Self { case, truths })
    }

    fn shots(&self) -> impl Iterator<Item = (&Shot, &Truth)> {
        self.case.shots.iter().zip(&self.truths)
    }

    /// Measures everything about the case in a mode, except the time.
    pub fn measure<I: Mode>(&self, name: &'static str, mode: I) -> Result<Figures> {
        let options = DrawOptions::new().with_mode(mode);
        let error = if self.case.interpolates {
            Some(self.errors(&options)?)
        } else {
            None
        };
        let mut figures = Figures {
            mode: name,
            pixels: self.truths.iter().map(|truth| truth.pixels.len()).sum(),
            frames: self.truths.len(),
            error,
            psnr: 0.,
            times: Times::default(),
            crc: 0,
        };
        let drawing = Drawing {
            subject: self,
            options: &options,
            figures: &mut figures,
        };
        self.case.surface.give(self.case.size, drawing)?;
        Ok(figures)
    }

    /// The texel errors at every pixel of every triangle.
    fn errors<I: Mode>(&self, options: &DrawOptions<I>) -> Result<Spread> {
        let Case {
            name,
            size: (width, height),
            texels_log2,
            ..
        } = *self.case;
        let mut colors = vec![Rgb565::default(); width as usize * height as usize];
        let mut canvas = Canvas::new(&mut colors, width, height)?;
        let texels = f64::from(1 << texels_log2);
        let mut errors = Vec::new();
        for (shot, truth) in self.shots() {
            let seen = RefCell::new(Vec::with_capacity(truth.pixels.len()));
            let recorder = Recorder {
                seen: &seen,
                texels_log2,
            };
            canvas.draw_with(options, &shot.mesh()?, &shot.mvp, &recorder);
            let mut seen = seen.into_inner();
            seen.sort_unstable_by_key(|seen| order(seen.face, seen.pixel));
            let places = |(seen, wanted): (&Seen, &Expected)| {
                (seen.face, seen.pixel) == (wanted.face, wanted.pixel)
            };
            if seen.len() != truth.pixels.len() || !seen.iter().zip(&truth.pixels).all(places) {
                return Err(format!("{name}: the crate draws other pixels than the model").into());
            }
            errors.extend(seen.iter().zip(&truth.pixels).map(|(seen, wanted)| {
                let off = |axis: usize| {
                    (f64::from(seen.texel[axis]) / 65536. - wanted.uv[axis] * texels).abs()
                };
                off(0).max(off(1))
            }));
        }
        Spread::of(errors)
    }
}

/// A subject that is drawn in a mode, to compare its pictures.
struct Drawing<'a, I> {
    subject: &'a Subject<'a>,
    options: &'a DrawOptions<I>,
    figures: &'a mut Figures,
}

impl<I: Mode> Job for Drawing<'_, I> {
    fn run<D: DepthBuffer, F: ShaderFor<Rgb565>>(
        self,
        canvas: &mut Target<'_, D>,
        shader: &F,
    ) -> Result<()> {
        let Self {
            subject,
            options,
            figures,
        } = self;
        let mut error = SquareError::default();
        for (i, (shot, truth)) in subject.shots().enumerate() {
            canvas.clear(Rgb565::BLACK);
            canvas.draw_with(options, &shot.mesh()?, &shot.mvp, shader);
            error.add(canvas.pixels(), &truth.picture);
            if i == 0 {
                figures.crc = crc(canvas.pixels());
            }
        }
        figures.psnr = error.psnr();
        Ok(())
    }
}

/// The sum of the squared differences between pictures.
#[derive(Default)]
struct SquareError {
    sum: f64,
    count: usize,
}

impl SquareError {
    /// Adds the pixels that should be drawn. The difference of a channel is relative to the channel's range.
    fn add(&mut self, drawn: impl Iterator<Item = Rgb565>, wanted: &[Option<Rgb565>]) {
        let channels = |color: Rgb565| {
            [(color.r(), 31.), (color.g(), 63.), (color.b(), 31.)]
                .map(|(c, most)| f64::from(c) / most)
        };
        for (drawn, wanted) in drawn.zip(wanted) {
            let Some(wanted) = wanted else { continue };
            for (a, b) in channels(drawn).into_iter().zip(channels(*wanted)) {
                self.sum += (a - b) * (a - b);
                self.count += 1;
            }
        }
    }

    fn psnr(&self) -> f64 {
        10. * (self.count as f64 / self.sum).log10()
    }
}

/// Computes the checksum in the same way as the firmware does.
fn crc(pixels: impl Iterator<Item = Rgb565>) -> u32 {
    let mut crc = Hasher::new();
    for pixel in pixels {
        crc.update(&pixel.to_be_bytes());
    }
    crc.finalize()
}
