//! The whole run, from arguments to pictures, in each color.

use clap::ArgMatches;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888};

use super::Result;
use super::common::scenes;
use crate::args::{Args, Color, SceneName};
use crate::draw::{Shown, Style};
use crate::export;
use crate::idle::{self, name};
use crate::job::{Measured, Model};
use crate::look::Look;
use crate::mode::Mode;
use crate::report;
use crate::sight;
use crate::skin::{Skin, Texels};
use crate::subject::Subject;
use crate::targets::{self, Targets};

/// Runs the program with `args`, of which the user has given those in `matches`.
///
/// # Errors
///
/// Any problem with the arguments or a file, in words.
pub fn run(args: &Args, matches: &ArgMatches) -> Result<()> {
    targets::check_size(args)?;
    if let Some(scene) = args.scene {
        let targets = Targets::open(args, &[])?;
        let has_textures = matches!(scene, SceneName::Floor | SceneName::Cube);
        report::notes(args, idle::options(args, matches, None, has_textures))?;
        let measured = Measured {
            scene,
            mode: Mode::new(args, 1.0)?,
            depth: args.depth,
        };
        let surface = match args.color {
            Color::Rgb565 => measured.surface::<Rgb565>(),
            Color::Rgb888 => measured.surface::<Rgb888>(),
            Color::Gray8 => measured.surface::<Gray8>(),
            Color::Gray4 => measured.surface::<Gray4>(),
            Color::Mono => measured.surface::<BinaryColor>(),
        }?;
        return targets.fill(
            MEASURED,
            &|band, moment| measured.record(band, moment),
            &|band, moment| measured.draw(band, moment, &surface),
        );
    }
    let subject = Subject::load(args)?;
    let targets = Targets::open(args, &subject.inputs)?;
    let pieces = subject.pieces()?;
    let model = subject.model(args, &pieces)?;
    let has_textures = pieces.iter().any(|piece| piece.finish.texture.is_some());
    let idle = idle::options(args, matches, model.shade, has_textures);
    report::notes(args, &idle)?;
    if let (None, false, Some(shade)) = (&args.model, model.is_scene, model.shade) {
        let note = format!("--shade {} leaves out the sea and the sky", name(&shade));
        report::notes(args, &[note])?;
    }
    report::notes(args, &sight::check(&model, args)?)?;
    export::write(args, &subject.exports)?;
    match args.color {
        Color::Rgb565 => picture_in::<Rgb565>(&model, &subject, args, targets),
        Color::Rgb888 => picture_in::<Rgb888>(&model, &subject, args, targets),
        Color::Gray8 => picture_in::<Gray8>(&model, &subject, args, targets),
        Color::Gray4 => picture_in::<Gray4>(&model, &subject, args, targets),
        Color::Mono => picture_in::<BinaryColor>(&model, &subject, args, targets),
    }?;
    report::say(args, format_args!("camera {}", subject.framing.options()))
}

/// The size of the measured scenes.
const MEASURED: (u32, u32) = (scenes::WIDTH, scenes::HEIGHT);

fn picture_in<C: Shown>(
    model: &Model<'_>,
    subject: &Subject,
    args: &Args,
    targets: Targets<'_>,
) -> Result<()> {
    let texels: Vec<_> = subject.skins.iter().map(Skin::texels).collect();
    let textures: Vec<_> = texels.iter().map(Texels::texture).collect::<Result<_>>()?;
    let look = Look::new::<C>(args, model, subject.units.scale())?;
    let style = Style::new::<C>(&look, &model.view, model.pieces, &textures, args.samples)?;
    targets.fill(
        args.size,
        &|band, moment| model.record(band, moment),
        &|band, moment| model.draw(band, moment, &style),
    )
}
