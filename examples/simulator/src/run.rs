//! The whole run, from arguments to pictures, in each color.

use std::path::Path;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray4, Gray8, GrayColor, Rgb565, Rgb888, RgbColor,
};
use fixel::canvas::Contrast;
use fixel::shade::PixelFormat;

use super::Result;
use super::common::scenes;
use crate::args::{Args, Color, HELP, Shade};
use crate::draw::{Lines, Style, is_blended};
use crate::idle;
use crate::look::{BRIGHT, Backdrop, DARK, Look};
use crate::paint::Shown;
use crate::progress;
use crate::report;
use crate::scene::{self, Moment, Motion, Scene};
use crate::sight::{self, Sight};
use crate::skin::{Skin, Texels};
use crate::subject::Subject;
use crate::targets::{self, Targets};

/// Runs the program with `args`.
///
/// # Errors
///
/// Any problem with the arguments or with a file. The message is for the user.
pub fn run(args: &Args) -> Result<()> {
    if args.help {
        return report::print(HELP.trim_end());
    }
    if args.version {
        return report::print(concat!("simulator ", env!("CARGO_PKG_VERSION")));
    }
    targets::check_size(args)?;
    match (&args.model, args.scene) {
        (Some(path), _) => model(args, path),
        (None, Some(name)) => {
            let targets = Targets::open(args, &[])?;
            let scene = Scene::measured(args, name)?;
            let stage = Stage {
                scene: &scene,
                skins: &[],
                scale: 1.0,
                size: (scenes::WIDTH, scenes::HEIGHT),
                lines: Lines::None,
                motion: &|_, _| None,
            };
            stage.show(args, targets, idle::options(args, &scene, true), None)
        }
        (None, None) => own(args),
    }
}

/// Draws a model.
fn model(args: &Args, path: &Path) -> Result<()> {
    let subject = Subject::load(args, path)?;
    let targets = Targets::open(args, &subject.inputs)?;
    let mut scene = subject.scene(args)?;
    let mut pieces = scene.pieces.iter();
    let has_textures = pieces.any(|piece| piece.finish.texture.is_some());
    let mut notes = idle::options(args, &scene, has_textures);
    let step = progress::step(args, scene.faces(), "looking");
    let sight = sight::check(&mut scene, args, &mut notes)?;
    drop(step);
    let is_coarse = matches!(args.color, Color::Gray4 | Color::Mono);
    let mut pieces = scene.pieces.iter();
    if is_coarse && pieces.any(|piece| is_blended(piece, scene.shade)) {
        notes.push("few colors show blended faces as patterns: see --color".into());
    }
    let stage = Stage {
        scene: &scene,
        skins: &subject.skins,
        scale: subject.units.scale(),
        size: args.size,
        lines: sight.lines,
        motion: &|option, other| subject.motion_without(option, other),
    };
    stage.show(args, targets, notes, Some(sight))?;
    report::say(args, format_args!("camera {}", subject.framing.options()))
}

/// Draws the project's own scene.
fn own(args: &Args) -> Result<()> {
    let (island, skins) = (scene::island()?, scene::own_skins());
    let targets = Targets::open(args, &[])?;
    let (mut scene, framing) = Scene::own(args, &island)?;
    let mut notes = idle::options(args, &scene, true);
    let sight = sight::check(&mut scene, args, &mut notes)?;
    let stage = Stage {
        scene: &scene,
        skins: &skins,
        scale: 1.0,
        size: args.size,
        lines: sight.lines,
        motion: &|_, other| {
            let (scene, plain) = Scene::own(other, &island).ok()?;
            (!plain.has_planes_of(&framing)).then_some(scene.motion)
        },
    };
    stage.show(args, targets, notes, Some(sight))?;
    report::say(args, format_args!("camera {}", framing.options()))
}

/// The background of a small picture that is drawn to count the model's colors. The background itself does not count.
const HOLE: Rgb888 = Rgb888::MAGENTA;

/// Everything that a picture needs, except the look that the arguments choose.
#[derive(Clone, Copy)]
struct Stage<'a> {
    scene: &'a Scene<'a>,
    skins: &'a [Skin],
    /// The length at which one of the model's units is drawn.
    scale: f64,
    size: (u32, u32),
    lines: Lines,
    /// The motion without the option of a plane; `None` if the planes stay the same.
    motion: &'a dyn Fn(&str, &Args) -> Option<Motion>,
}

impl Stage<'_> {
    /// Prints the notes, draws all frames, and writes them.
    fn show(
        &self,
        args: &Args,
        targets: Targets<'_>,
        mut notes: Vec<String>,
        mut sight: Option<Sight>,
    ) -> Result<()> {
        if !args.quiet {
            self.find_idle(args, &mut notes)?;
        }
        report::notes(args, notes)?;
        let mut targets = Some(targets);
        self.styled(args, &mut |style| match targets.take() {
            Some(targets) => targets.fill(self.size, self.scene, style, sight.take()),
            None => Ok(()),
        })
    }

    /// Draws the first frame.
    fn frame(&self, args: &Args) -> Result<Vec<Rgb888>> {
        let mut pixels = Vec::new();
        self.styled(args, &mut |style| {
            let moment = Moment::default();
            (pixels, ..) = self.scene.draw(self.size, u32::MAX, moment, style)?;
            Ok(())
        })?;
        Ok(pixels)
    }

    /// Adds a note for each option of the look without which the first frame is the same, if there is none yet.
    fn find_idle(&self, args: &Args, notes: &mut Vec<String>) -> Result<()> {
        let mut frame = None;
        for (option, remedy) in idle::COMPARED {
            let is_noted = notes
                .iter()
                .any(|note| note.starts_with(&format!("--{option} ")));
            let is_dumped = option == "mode" && args.dump.is_some();
            let Some(other) = args.without(option).filter(|_| !is_noted && !is_dumped) else {
                continue;
            };
            let motion = match option {
                "near" | "far" => (self.motion)(option, &other),
                _ => Some(self.scene.motion),
            };
            let Some(motion) = motion else {
                continue;
            };
            let scene = &self.scene.with(&other, motion)?;
            if option == "shade" && scene.shade == self.scene.shade {
                continue;
            }
            if frame.is_none() {
                frame = Some(self.frame(args)?);
            }
            // Without the option, another one can be wrong: then the picture differs, too.
            let stage = Stage { scene, ..*self };
            if frame == stage.frame(&other).ok() {
                let picture = if args.frames > 1 {
                    "the first frame"
                } else {
                    "this picture"
                };
                notes.push(format!("--{option} has no effect on {picture}: {remedy}"));
            }
        }
        Ok(())
    }

    /// Draws with the look of `args`.
    fn styled(&self, args: &Args, draw: &mut Draw<'_>) -> Result<()> {
        match args.color {
            Color::Rgb565 => self.styled_in::<Rgb565>(args, draw),
            Color::Rgb888 => self.styled_in::<Rgb888>(args, draw),
            Color::Gray8 => self.styled_in::<Gray8>(args, draw),
            Color::Gray4 => self.styled_in::<Gray4>(args, draw),
            Color::Mono => self.styled_in::<BinaryColor>(args, draw),
        }
    }

    fn styled_in<C: Shown>(&self, args: &Args, draw: &mut Draw<'_>) -> Result<()> {
        let &Self {
            scene,
            skins,
            scale,
            size,
            lines,
            motion: _,
        } = self;
        let mut backdrop = Backdrop::of::<C>(args, scene);
        let mut contrast = None;
        let is_lit = !matches!(
            scene.shade,
            None | Some(Shade::Wire | Shade::Depth | Shade::Normal)
        );
        let is_needed = args.background.is_none() || args.color == Color::Mono;
        if is_lit && is_needed {
            let texels: Vec<_> = skins.iter().map(Skin::texels).collect();
            let textures: Vec<_> = texels.iter().map(Texels::texture).collect::<Result<_>>()?;
            let look = Look::new(args, scene, scale, Backdrop::Color(HOLE), None)?;
            let style = Style::new::<Rgb888>(args, &look, scene, &textures, Lines::None)?;
            let mut colors = sight::colors(scene, size, &style)?;
            colors.retain(|&color| color != HOLE);
            if args.color == Color::Mono {
                contrast = stretched(&mut colors);
            }
            if args.background.is_none() {
                backdrop = apart::<C>(backdrop, &colors);
            }
        }
        let texels: Vec<_> = skins.iter().map(Skin::texels).collect();
        let textures: Vec<_> = texels.iter().map(Texels::texture).collect::<Result<_>>()?;
        let look = Look::new(args, scene, scale, backdrop, contrast)?;
        draw(&Style::new::<C>(args, &look, scene, &textures, lines)?)
    }
}

/// Draws one or more frames in a style.
type Draw<'a> = dyn FnMut(&Style<'_>) -> Result<()> + 'a;

/// Stretches the grays of `colors` from black to white, and returns the contrast. The darkest and the brightest
/// fiftieth of the pixels are ignored.
fn stretched(colors: &mut [Rgb888]) -> Option<Contrast> {
    let gray = |&color: &Rgb888| Gray8::from_rgb(color, Point::zero());
    let mut lumas: Vec<u8> = colors.iter().map(|color| gray(color).luma()).collect();
    lumas.sort_unstable();
    let ignored = lumas.len() / 50;
    let (black, white) = (*lumas.get(ignored)?, *lumas.iter().rev().nth(ignored)?);
    if white < black.saturating_add(16) {
        return None;
    }
    let contrast = Contrast::new(black, white);
    for color in colors {
        *color = contrast.stretch(gray(color)).into();
    }
    Some(contrast)
}

/// Returns the given backdrop, or another backdrop if most of the model has a similar color.
fn apart<C: PixelFormat>(backdrop: Backdrop, colors: &[Rgb888]) -> Backdrop {
    let hidden = |backdrop: &Backdrop| {
        let Backdrop::Color(behind) = *backdrop else {
            return 0;
        };
        let channels = |color: Rgb888| [color.r(), color.g(), color.b()];
        let is_near = |&&color: &&Rgb888| {
            let mut pairs = channels(color).into_iter().zip(channels(behind));
            pairs.all(|(a, b)| a.abs_diff(b) < 56)
        };
        colors.iter().filter(is_near).count()
    };
    let others = if C::MAX_STEPS[0] < 31 {
        [Rgb888::WHITE, Rgb888::BLACK]
    } else {
        [BRIGHT, DARK]
    };
    if 2 * hidden(&backdrop) <= colors.len() {
        return backdrop;
    }
    let others = others.map(Backdrop::Color).into_iter();
    others.min_by_key(hidden).unwrap_or(backdrop)
}
