//! From arguments to files: the whole run.

use std::ffi::OsString;
use std::path::PathBuf;
use std::time::Duration;

use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888};
use fixel::prelude::*;
use fixel::shade::Channels;
use fixel::{Drawn, Mesh};
use image::RgbImage;
use indicatif::{ProgressBar, ProgressStyle};

use super::Result;
use super::common::{lighthouse, scenes};
use crate::args::{Args, Color, SceneName, Shade};
use crate::dump::{self, Record};
use crate::framing::{Framing, middle};
use crate::job::{self, Done, Model, Strip, Turn};
use crate::load;
use crate::output::{self, Format, Output};
use crate::paint::{Shown, add};
use crate::parts::{self, Part};
use crate::skin::Skin;
use crate::view::View;
use crate::window::{self, Screen};

/// Does what `args` ask for.
///
/// # Errors
///
/// Anything that is wrong with them or with a file, in words.
pub fn run(args: &Args) -> Result<()> {
    let mut targets = Targets::open(args)?;
    if let Some(scene) = args.scene {
        let size = (scenes::WIDTH, scenes::HEIGHT);
        let record = |strip: Strip<'_, Record>, frame| job::record_scene(scene, strip, frame);
        macro_rules! in_color {
            ($($color:ident)+) => {
                match args.color {
                    Color::Rgb565 => targets.fill(size, record, |strip: Strip<'_, Rgb565>, frame| {
                        job::paint_scene(scene, strip, frame)
                    })?,
                    $(Color::$color => {
                        type C = color_type::$color;
                        targets.fill(size, record, |strip: Strip<'_, C>, frame| {
                            job::paint_scene_in(scene, strip, frame)
                        })?;
                    })+
                }
            };
        }
        in_color!(Rgb888 Gray8 Gray4 Mono);
        return Ok(());
    }
    let subject = Subject::load(args)?;
    let meshes = subject.meshes()?;
    let model = subject.model(args, &meshes)?;
    let record = |strip: Strip<'_, Record>, frame| model.record(strip, frame);
    match args.color {
        Color::Rgb565 => paint::<Rgb565, _>(&mut targets, args, &model, &subject.skin, record),
        Color::Rgb888 => paint::<Rgb888, _>(&mut targets, args, &model, &subject.skin, record),
        Color::Gray8 => paint::<Gray8, _>(&mut targets, args, &model, &subject.skin, record),
        Color::Gray4 => paint::<Gray4, _>(&mut targets, args, &model, &subject.skin, record),
        Color::Mono => paint::<BinaryColor, _>(&mut targets, args, &model, &subject.skin, record),
    }
}

/// The colours by the names of their arguments.
mod color_type {
    pub use embedded_graphics::pixelcolor::{BinaryColor as Mono, Gray4, Gray8, Rgb888};
}

fn paint<C: Shown + Channels<K>, const K: usize>(
    targets: &mut Targets<'_>,
    args: &Args,
    model: &Model<'_>,
    skin: &Skin,
    record: impl Fn(Strip<'_, Record>, u32) -> Result<Done>,
) -> Result<()> {
    let texels = skin.texels();
    targets.fill(args.size, record, |strip: Strip<'_, C>, frame| {
        model.paint(strip, frame, &texels)
    })
}

/// A model, with all that belongs to it.
struct Subject {
    /// Empty for the project's own.
    parts: Vec<Part>,
    points: Vec<[f64; 3]>,
    skin: Skin,
    largest_uv: f64,
    shade: Option<Shade>,
}

impl Subject {
    fn load(args: &Args) -> Result<Self> {
        let skin = args.texture.as_deref().map(Skin::read).transpose()?;
        let Some(path) = &args.model else {
            let points = lighthouse::ISLAND.positions().iter();
            let plain = args.shade.is_none() && skin.is_none() && !args.two_sided;
            return Ok(Self {
                parts: Vec::new(),
                points: points
                    .map(|p| p.to_bits().map(|bits| f64::from(bits) / 65536.0))
                    .collect(),
                skin: skin.unwrap_or_else(|| Skin::of(&lighthouse::SKIN)),
                largest_uv: 20.0,
                shade: args.shade.or(if plain { None } else { Some(Shade::Lit) }),
            });
        };
        let mut model = load::model(path)?;
        if let Some(scale) = scale(args, &model.positions) {
            println!("scaled by {scale} to suit the number format");
            for position in &mut model.positions {
                *position = position.map(|x| x * scale);
            }
        }
        let textured = skin.is_some() || model.had_uvs;
        let shade = if textured { Shade::Lit } else { Shade::Gouraud };
        Ok(Self {
            parts: parts::split(&model)?,
            largest_uv: model
                .uvs
                .iter()
                .flatten()
                .fold(0.0, |all, x| x.abs().max(all)),
            points: model.positions,
            skin: skin.unwrap_or_else(Skin::checker),
            shade: Some(args.shade.unwrap_or(shade)),
        })
    }

    fn meshes(&self) -> Result<Vec<Mesh<'_>>> {
        if self.parts.is_empty() {
            return Ok(match self.shade {
                None => vec![lighthouse::SEA, lighthouse::ISLAND],
                Some(_) => vec![lighthouse::ISLAND],
            });
        }
        self.parts.iter().map(Part::mesh).collect()
    }

    fn model<'a>(&self, args: &Args, meshes: &'a [Mesh<'a>]) -> Result<Model<'a>> {
        let rate = job::rate(args)?;
        let about = if self.parts.is_empty() {
            [0.0; 3]
        } else {
            middle(&self.points)
        };
        let turn = Turn {
            about: Vec3::try_from(about)?,
            frames: args.frames,
            rate,
        };
        let turns = args.frames > 1 || rate.is_some();
        let mut framing = if turns {
            Framing::new(args, &ring(&self.points, about))
        } else {
            Framing::new(args, &self.points)
        };
        let own = self.shade.is_none();
        let mut view;
        if own && !args.has_camera() {
            view = View::new(args, &framing)?;
            view.lens = crate::view::Lens::Perspective(lighthouse::lens(args.size)?);
            view.camera = lighthouse::camera()?;
        } else {
            if own {
                // The sea goes on behind the island.
                framing.far = args.far.unwrap_or(framing.far * 3.0);
            }
            view = View::new(args, &framing)?;
        }
        Ok(Model {
            meshes,
            view,
            turn,
            shade: self.shade,
            largest_uv: self.largest_uv,
        })
    }
}

/// The points that a turning model passes: each on its circle about the axis, a step of the turn apart.
fn ring(points: &[[f64; 3]], about: [f64; 3]) -> Vec<[f64; 3]> {
    const STEPS: u32 = 24;
    let turned = |p: &[f64; 3], step: u32| {
        let (sin, cos) = (f64::from(step) / f64::from(STEPS) * std::f64::consts::TAU).sin_cos();
        let (x, z) = (p[0] - about[0], p[2] - about[2]);
        [
            about[0] + x * cos + z * sin,
            p[1],
            about[2] + z * cos - x * sin,
        ]
    };
    points
        .iter()
        .flat_map(|p| (0..STEPS).map(move |step| turned(p, step)))
        .collect()
}

/// What to scale a model by that is too large to be seen whole from a representable place, or so
/// small that the format's steps show. Only where nothing was given in the model's own units.
fn scale(args: &Args, points: &[[f64; 3]]) -> Option<f64> {
    if args.has_camera() {
        return None;
    }
    let middle = middle(points);
    let reach = |from: [f64; 3]| {
        let distance = |p: &[f64; 3]| (0..3).map(|i| (p[i] - from[i]).abs()).fold(0.0, f64::max);
        points.iter().map(distance).fold(0.0, f64::max)
    };
    let (size, far) = (reach(middle), reach([0.0; 3]).max(reach(middle) * 8.0));
    let scale = if far > 32_000.0 {
        (32_000.0 / far).log2().floor()
    } else if size < 0.5 && size > 0.0 {
        (1.0 / size)
            .log2()
            .floor()
            .min((32_000.0 / far).log2().floor())
    } else {
        0.0
    };
    (scale.abs() > 0.5).then(|| scale.exp2())
}

/// Where pictures go.
struct Targets<'a> {
    args: &'a Args,
    path: PathBuf,
    picture: Option<(Output, Format)>,
    dump: Option<Output>,
    screen: Option<Screen>,
}

impl<'a> Targets<'a> {
    /// Opens everything that will be written, so that nothing is drawn in vain.
    fn open(args: &'a Args) -> Result<Self> {
        let mut name: OsString = match (&args.model, args.scene) {
            (Some(model), _) => model.file_stem().unwrap_or_default().into(),
            (None, Some(scene)) => file_name(scene).into(),
            (None, None) => "lighthouse".into(),
        };
        let several = args.frames > 1;
        let extension = if several { ".gif" } else { ".png" };
        let path = match &args.out {
            Some(path) => path.clone(),
            None => {
                name.push(extension);
                name.into()
            }
        };
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

    /// Draws all frames, writes what there is to write and says what was done.
    fn fill<C: PixelColor + Into<Rgb888> + Default>(
        &mut self,
        size: (u32, u32),
        record: impl Fn(Strip<'_, Record>, u32) -> Result<Done>,
        paint: impl Fn(Strip<'_, C>, u32) -> Result<Done>,
    ) -> Result<()> {
        let args = self.args;
        let rows = args.bands.unwrap_or(size.1);
        let mut total = Total::default();
        let mut colors = Vec::new();
        let mut draw = |frame| -> Result<RgbImage> {
            let (drawn, (_, mut time)) = in_bands(size, rows, |strip| paint(strip, frame))?;
            // One frame alone is measured with cold caches: draw it again for the time only.
            for _ in 1..if args.frames == 1 && !args.window {
                10
            } else {
                1
            } {
                let (_, (_, again)) = in_bands(size, rows, |strip| paint(strip, frame))?;
                time = time.min(again);
            }
            colors = drawn.into_iter().map(Into::into).collect();
            let (records, (counts, _)) = in_bands(size, size.1, |strip| record(strip, frame))?;
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
            let (records, _) = in_bands(size, rows, |strip| record(strip, last))?;
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
        println!("{what} {submitted} in, {drawn} drawn, {clipped} of them clipped");
        #[allow(clippy::cast_precision_loss)] // three digits are shown
        let each = total.time.as_nanos() as f64 / (total.pixels.max(1)) as f64;
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

/// What a picture of a measured scene is called.
fn file_name(scene: SceneName) -> &'static str {
    match scene {
        SceneName::Floor => "floor",
        SceneName::Cube => "cube",
        SceneName::Sphere => "sphere",
        SceneName::SphereFlat => "sphere-flat",
    }
}

/// What was drawn in all frames.
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
        self.pixels += records.iter().filter(|record| record.covered).count() as u64;
    }
}

/// Draws a frame in strips of some `rows`; gives the pixels of all.
fn in_bands<C: PixelColor + Default>(
    size: (u32, u32),
    rows: u32,
    paint: impl Fn(Strip<'_, C>) -> Result<Done>,
) -> Result<(Vec<C>, Done)> {
    let width = size.0 as usize;
    let rows = rows.min(size.1) as usize;
    let mut pixels = vec![C::default(); width * size.1 as usize];
    let mut depth = vec![0; width * rows];
    let mut sum = (Drawn::default(), Duration::ZERO);
    let mut first_row = 0;
    for strip in pixels.chunks_mut(width * rows) {
        let len = strip.len();
        let (drawn, time) = paint(Strip {
            pixels: strip,
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
    use embedded_graphics::pixelcolor::RgbColor;
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
