//! Output files, and the report about them.

use std::ffi::OsString;
use std::path::PathBuf;
use std::time::Duration;

use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888, RgbColor};
use fixel::Drawn;
use fixel::prelude::*;
use image::RgbImage;
use indicatif::{ProgressBar, ProgressStyle};

use super::Result;
use crate::args::{Args, SceneName, Shade};
use crate::dump::{self, Record};
use crate::export::refuse_inputs;
use crate::job::{Band, Done};
use crate::output::{self, Format, Output};
use crate::paint::add;
use crate::window::{self, Screen};

/// The output files.
pub struct Targets<'a> {
    args: &'a Args,
    path: PathBuf,
    picture: Option<(Output, Format)>,
    dump: Option<Output>,
    screen: Option<Screen>,
}

impl<'a> Targets<'a> {
    /// Opens all output files first, so that no frame is drawn in vain.
    pub fn open(args: &'a Args) -> Result<Self> {
        let mut name: OsString = match (&args.model, args.scene) {
            (Some(model), _) => model.file_stem().unwrap_or_default().into(),
            (None, Some(scene)) => file_name(scene).into(),
            (None, None) => "lighthouse".into(),
        };
        let several = args.frames > 1;
        name.push(if several { ".gif" } else { ".png" });
        let path = args.out.clone().unwrap_or_else(|| name.into());
        let format = Format::of(&path)?;
        if several && format == Format::Png && !args.window {
            let frames = args.frames;
            return Err(
                format!("{frames} frames make an animation: it needs --out FILE.gif").into(),
            );
        }
        if args.dump.as_ref() == Some(&path) {
            return Err(format!("--dump and --out are both {}", path.display()).into());
        }
        check_size(args)?;
        let screen = args.window.then(|| window::open(args.size)).transpose()?;
        let wanted = args.out.is_some() || screen.is_none();
        Ok(Self {
            args,
            picture: wanted
                .then(|| Output::create(&path).map(|output| (output, format)))
                .transpose()?,
            dump: args.dump.as_deref().map(Output::create).transpose()?,
            screen,
            path,
        })
    }

    /// Refuses an output that is one of the `inputs`.
    pub fn refuse_inputs(&self, inputs: &[PathBuf]) -> Result<()> {
        let picture = self.picture.is_some().then_some(&self.path);
        for path in picture.into_iter().chain(&self.args.dump) {
            refuse_inputs(path, inputs)?;
        }
        Ok(())
    }

    /// Draws all frames, writes the files and prints a report.
    pub fn fill<C: PixelColor + Into<Rgb888> + Default>(
        mut self,
        size: (u32, u32),
        record: impl Fn(Band<'_, Record>, u32) -> Result<Done>,
        paint: impl Fn(Band<'_, C>, u32) -> Result<Done>,
    ) -> Result<()> {
        let args = self.args;
        let rows = args.bands.unwrap_or(size.1);
        let mut total = Total::default();
        let mut colors = Vec::new();
        let mut draw = |frame| -> Result<RgbImage> {
            let (drawn, (_, mut time)) = in_bands(size, rows, |band| paint(band, frame))?;
            // A single frame is measured with cold caches. Draw it again, only for the time.
            for _ in 1..if args.frames == 1 && !args.window {
                10
            } else {
                1
            } {
                let (_, (_, again)) = in_bands(size, rows, |band| paint(band, frame))?;
                time = time.min(again);
            }
            colors = drawn.into_iter().map(Into::into).collect();
            let (records, (counts, _)) = in_bands(size, size.1, |band| record(band, frame))?;
            total.add(counts, time, &records);
            Ok(picture(size, &colors))
        };
        match self.picture.take() {
            Some((output, Format::Png)) => output::png(&draw(0)?, output)?,
            Some((mut output, Format::Gif)) => {
                let mut gif = output::gif(&mut output)?;
                let bar = progress(args.frames);
                for frame in 0..args.frames {
                    gif.encode_frame(output::frame(&draw(frame)?))?;
                    bar.inc(1);
                }
                bar.finish_and_clear();
                drop(gif);
                output.finish()?;
            }
            None => {}
        }
        if let Some(screen) = &mut self.screen {
            let turns = args.frames > 1 || args.rpm.is_some();
            let mut shown = draw(0)?;
            let mut frame = 0;
            while screen.show(&shown) {
                std::thread::sleep(Duration::from_millis(output::FRAME_MS / 2));
                if turns {
                    frame += 1;
                    shown = draw(frame)?;
                }
            }
        }
        if let Some(mut out) = self.dump.take() {
            let last = args.frames - 1;
            let (records, _) = in_bands(size, rows, |band| record(band, last))?;
            dump::write(&records, size.0 as usize, &mut out)?;
            out.finish()?;
        }
        self.say(size, &total, &colors);
        Ok(())
    }

    fn say(&self, (width, height): (u32, u32), total: &Total, colors: &[Rgb888]) {
        let args = self.args;
        if args.out.is_some() || self.screen.is_none() {
            println!("wrote {}, {width}x{height}", self.path.display());
        }
        if let Some(dump) = &args.dump {
            println!("wrote {}", dump.display());
        }
        let what = if args.shade == Some(Shade::Wire) {
            "edges"
        } else {
            "triangles"
        };
        let Drawn {
            submitted,
            drawn,
            clipped,
            ..
        } = total.counts;
        if args.frames > 1 {
            println!("frames {}, of which together:", args.frames);
        }
        println!("{what} {submitted} in, {drawn} drawn, {clipped} of them clipped");
        #[allow(clippy::cast_precision_loss)] // three digits are shown
        let each = total.time.as_nanos() as f64 / total.pixels.max(1) as f64;
        println!("pixels {} covered, {each:.2} ns per pixel", total.pixels);
        if args.crc {
            let mut crc = crc32fast::Hasher::new();
            for &color in colors {
                crc.update(&Rgb565::from(color).to_be_bytes());
            }
            println!("crc {:08x}", crc.finalize());
        }
    }
}

/// Returns the name of a measured scene's picture.
fn file_name(scene: SceneName) -> &'static str {
    match scene {
        SceneName::Floor => "floor",
        SceneName::Cube => "cube",
        SceneName::Sphere => "sphere",
        SceneName::SphereFlat => "sphere-flat",
    }
}

/// The sums over all frames.
#[derive(Default)]
struct Total {
    counts: Drawn,
    time: Duration,
    pixels: u64,
}

impl Total {
    fn add(&mut self, counts: Drawn, time: Duration, records: &[Record]) {
        self.counts = add(self.counts, counts);
        self.time += time;
        self.pixels += records.iter().filter(|record| record.is_covered()).count() as u64;
    }
}

/// Draws a frame in bands of `rows` rows; returns the pixels of all bands.
fn in_bands<C: PixelColor + Default>(
    size: (u32, u32),
    rows: u32,
    paint: impl Fn(Band<'_, C>) -> Result<Done>,
) -> Result<(Vec<C>, Done)> {
    let width = size.0 as usize;
    let rows = rows.min(size.1) as usize;
    let mut pixels = vec![C::default(); width * size.1 as usize];
    let mut depth = vec![0; width * rows];
    let mut sum = (Drawn::default(), Duration::ZERO);
    let mut first_row = 0;
    for band in pixels.chunks_mut(width * rows) {
        let len = band.len();
        let (drawn, time) = paint(Band {
            pixels: band,
            depth: &mut depth[..len],
            size,
            first_row,
        })?;
        sum = (add(sum.0, drawn), sum.1 + time);
        #[allow(clippy::cast_possible_truncation)] // rows of the frame
        {
            first_row += (len / width) as u32;
        }
    }
    Ok((pixels, sum))
}

fn picture((width, height): (u32, u32), colors: &[Rgb888]) -> RgbImage {
    RgbImage::from_fn(width, height, |x, y| {
        let color = colors[(y * width + x) as usize];
        image::Rgb([color.r(), color.g(), color.b()])
    })
}

fn progress(frames: u32) -> ProgressBar {
    let bar = ProgressBar::new(frames.into());
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} frames, {eta} left") {
        bar.set_style(style);
    }
    bar
}

/// Refuses a size that no canvas can have, in the library's words.
fn check_size(args: &Args) -> Result<()> {
    let (width, height) = args.size;
    match Canvas::<Rgb565>::new(&mut [], width, height) {
        Err(error @ Error::Size { .. }) => Err(error.into()),
        _ => Ok(()),
    }
}
