//! The whole run, from arguments to pictures, in each color.

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
use crate::scene::{self, Scene};
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
    let Some(path) = &args.model else {
        let targets = Targets::open(args, &[])?;
        let island = scene::island()?;
        let (scene, size) = match args.scene {
            Some(name) => (
                Scene::measured(args, name)?,
                (scenes::WIDTH, scenes::HEIGHT),
            ),
            None => (Scene::own(args, &island)?, args.size),
        };
        report::notes(args, idle::options(args, None, true))?;
        return picture(args, &scene, &[], 1.0, None, (targets, size));
    };
    let subject = Subject::load(args, path)?;
    let targets = Targets::open(args, &subject.inputs)?;
    let mut scene = subject.scene(args)?;
    let has_textures = scene
        .pieces
        .iter()
        .any(|piece| piece.finish.texture.is_some());
    let mut notes = idle::options(args, scene.shade, has_textures);
    let step = progress::step(args, scene.faces(), "looking");
    let sight = sight::check(&mut scene, args, &mut notes)?;
    drop(step);
    let is_coarse = matches!(args.color, Color::Gray4 | Color::Mono);
    let mut pieces = scene.pieces.iter();
    if is_coarse && pieces.any(|piece| is_blended(piece, scene.shade)) {
        notes.push("few colors show blended faces as patterns: see --color".into());
    }
    report::notes(args, notes)?;
    let scale = subject.units.scale();
    picture(
        args,
        &scene,
        &subject.skins,
        scale,
        Some(sight),
        (targets, args.size),
    )?;
    report::say(args, format_args!("camera {}", subject.framing.options()))
}

/// The background of a small picture that is drawn to count the model's colors. The background itself does not count.
const HOLE: Rgb888 = Rgb888::MAGENTA;

/// Draws the picture in the color of `args`, and writes it.
fn picture(
    args: &Args,
    scene: &Scene<'_>,
    skins: &[Skin],
    scale: f64,
    sight: Option<Sight>,
    to: (Targets<'_>, (u32, u32)),
) -> Result<()> {
    match args.color {
        Color::Rgb565 => picture_in::<Rgb565>(args, scene, skins, scale, sight, to),
        Color::Rgb888 => picture_in::<Rgb888>(args, scene, skins, scale, sight, to),
        Color::Gray8 => picture_in::<Gray8>(args, scene, skins, scale, sight, to),
        Color::Gray4 => picture_in::<Gray4>(args, scene, skins, scale, sight, to),
        Color::Mono => picture_in::<BinaryColor>(args, scene, skins, scale, sight, to),
    }
}

fn picture_in<C: Shown>(
    args: &Args,
    scene: &Scene<'_>,
    skins: &[Skin],
    scale: f64,
    sight: Option<Sight>,
    (targets, size): (Targets<'_>, (u32, u32)),
) -> Result<()> {
    let mut backdrop = Backdrop::of::<C>(args, scene);
    let mut contrast = None;
    let is_lit = !matches!(
        scene.shade,
        None | Some(Shade::Wire | Shade::Depth | Shade::Normal)
    );
    let is_needed = args.background.is_none() || args.color == Color::Mono;
    if args.model.is_some() && is_lit && is_needed {
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
    let lines = sight.as_ref().map_or(Lines::None, |sight| sight.lines);
    let style = Style::new::<C>(args, &look, scene, &textures, lines)?;
    targets.fill(size, scene, &style, sight)
}

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
