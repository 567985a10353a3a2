//! Opens and fills the output files, and reports about them.

use std::path::PathBuf;
use std::time::Duration;

use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::Drawn;

use super::Result;
use crate::args::{Args, Named, Shade};
use crate::draw::Style;
use crate::dump;
use crate::encoder::{self, Encoder, Format};
use crate::output::{self, Output};
use crate::progress::{self, Progress};
use crate::report;
use crate::scene::{Moment, Scene};
use crate::sight::{self, Sight};
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
    /// Opens all output files before anything is drawn, so that no time is wasted on a file that cannot be written. No
    /// output may be one of the `inputs`.
    ///
    /// # Errors
    ///
    /// A file cannot be written, or the options contradict each other.
    pub fn open(args: &'a Args, inputs: &[PathBuf]) -> Result<Self> {
        let several = args.frames > 1;
        let path = match (&args.out, args.window) {
            (Some(path), _) => path.clone(),
            (None, true) => PathBuf::new(),
            (None, false) => {
                let stem = match (&args.model, args.scene) {
                    (Some(model), _) => PathBuf::from(model.file_stem().unwrap_or_default()),
                    (None, Some(scene)) => PathBuf::from(scene.name()),
                    (None, None) => "lighthouse".into(),
                };
                encoder::free_name(&stem, if several { ".gif" } else { ".png" }, inputs)?
            }
        };
        let is_wanted = args.out.is_some() || !args.window;
        let format = is_wanted
            .then(|| Format::of(&path, args.frames))
            .transpose()?;
        if let Some(dump) = &args.dump
            && format.is_some()
            && output::are_same(dump, &path)
        {
            return Err(format!("--dump and --out are both {}", path.display()).into());
        }
        let screen = args.window.then(|| window::open(args.size)).transpose()?;
        let targets = Self {
            args,
            picture: format
                .map(|format| Output::create(&path).map(|output| (output, format)))
                .transpose()?,
            dump: args.dump.as_deref().map(Output::create).transpose()?,
            screen,
            path,
        };
        let picture = targets.picture.is_some().then_some(&targets.path);
        for path in picture.into_iter().chain(&args.dump) {
            output::refuse_inputs(path, inputs)?;
        }
        Ok(targets)
    }

    /// Draws all frames, writes the files, and prints a report.
    ///
    /// `sight` is what the first frame shows, if it is known.
    ///
    /// # Errors
    ///
    /// A file cannot be written.
    pub fn fill(
        mut self,
        size: (u32, u32),
        scene: &Scene<'_>,
        style: &Style<'_>,
        sight: Option<Sight>,
    ) -> Result<()> {
        let edges = scene.shade == Some(Shade::Wire);
        let args = self.args;
        let rows = args.bands.unwrap_or(u32::MAX);
        let mut total = Total::default();
        let mut colors = Vec::new();
        let draw = |moment| scene.draw(size, rows, moment, style);
        if let Some((mut output, format)) = self.picture.take() {
            let progress = match args.frames {
                1 => progress::step(args, scene.faces(), "drawing"),
                _ => Progress::new(args, "drawing", true),
            };
            let mut encoder = Encoder::new(format, &mut output.bytes, size, args.frames)?;
            let mut known = sight.map(|sight| (sight.records, sight.counts));
            for frame in 0..args.frames {
                let moment = Moment::of(frame);
                // Count in one band, because in several bands, triangles would be counted several times. Counting comes
                // first: it loads the model into the caches, so the time of the picture is more even.
                let (records, counts) = match known.take() {
                    Some(first) => first,
                    None => scene.record(size, u32::MAX, moment, edges, None)?,
                };
                let (pixels, _, time) = draw(moment)?;
                total.time += time;
                total.pixels += sight::covered(&records);
                total.counts += counts;
                encoder.frame(&pixels)?;
                colors = pixels;
                progress.set(frame as usize + 1, args.frames as usize, "frames");
            }
            drop(progress);
            encoder.finish()?;
            output.finish()?;
        }
        if let Some(screen) = &mut self.screen {
            let turns = args.frames > 1;
            let mut moment = Moment::default();
            colors = draw(moment)?.0;
            while let Some(orbit) = screen.show(&colors) {
                if turns || orbit != moment.orbit {
                    moment.frame += u32::from(turns);
                    moment.orbit = orbit;
                    colors = draw(moment)?.0;
                }
                std::thread::sleep(Duration::from_millis(encoder::FRAME_MS / 2));
            }
        }
        if let Some(mut out) = self.dump.take() {
            let last = Moment::of(args.frames - 1);
            let (records, _) = scene.record(size, rows, last, edges, None)?;
            dump::write(&records, size.0 as usize, &mut out.bytes)?;
            out.finish()?;
        }
        self.say(size, &total, &colors)
    }

    fn say(&self, (width, height): (u32, u32), total: &Total, colors: &[Rgb888]) -> Result<()> {
        let args = self.args;
        let say = |line: String| report::say(args, line);
        if colors.len() > 1 && colors.iter().all(|color| *color == colors[0]) {
            report::notes(args, ["all pixels of the picture have the same color"])?;
        }
        if args.out.is_some() || self.screen.is_none() {
            let bands = args.bands.filter(|&rows| rows < height).map(|rows| {
                let count = height.div_ceil(rows);
                format!(", in {count} bands of {rows} rows")
            });
            let bands = bands.unwrap_or_default();
            say(format!(
                "wrote {}, {width}x{height}{bands}",
                self.path.display()
            ))?;
            let Drawn {
                submitted,
                drawn,
                culled,
                clipped,
                ..
            } = total.counts;
            let outside = total.counts.outside();
            if args.frames > 1 {
                say(format!("{} frames, all together:", args.frames))?;
            }
            let what = match args.shade {
                Some(Shade::Wire) => "edges",
                _ => "triangles",
            };
            say(format!(
                "{what} {submitted} in, {culled} culled, {outside} outside, {drawn} drawn, {clipped} of them clipped"
            ))?;
            #[allow(clippy::cast_precision_loss)] // three digits are shown
            let each = total.time.as_nanos() as f64 / total.pixels.max(1) as f64;
            say(format!(
                "pixels {} covered, {each:.2} ns per pixel",
                total.pixels
            ))?;
        }
        if let Some(dump) = &args.dump {
            say(format!("wrote {}", dump.display()))?;
        }
        if args.crc {
            let mut crc = crc32fast::Hasher::new();
            for &color in colors {
                crc.update(&Rgb565::from(color).to_be_bytes());
            }
            report::answer(args, format_args!("crc {:08x}", crc.finalize()))?;
        }
        Ok(())
    }
}

/// The sums over all frames.
#[derive(Default)]
struct Total {
    counts: Drawn,
    time: Duration,
    pixels: usize,
}

/// Refuses a size that no picture can have.
///
/// # Errors
///
/// The message states the possible sizes.
pub fn check_size(args: &Args) -> Result<()> {
    const MOST: u32 = 2048;
    let (width, height) = args.size;
    if [width, height].iter().all(|side| (1..=MOST).contains(side)) {
        return Ok(());
    }
    Err(format!("--size {width}x{height}: both must be from 1 to {MOST}").into())
}
