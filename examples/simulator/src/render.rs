//! The whole run, from arguments to pictures, in each color.

use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888};

use super::Result;
use super::common::scenes;
use crate::args::{Args, Color};
use crate::job::{Measured, Model};
use crate::mode::Mode;
use crate::notes;
use crate::paint::Shown;
use crate::sight;
use crate::skin::{Skin, Texels};
use crate::subject::Subject;
use crate::targets::Targets;

/// Runs the program with `args`.
///
/// # Errors
///
/// Any problem with the arguments or a file, in words.
pub fn run(args: &Args) -> Result<()> {
    let targets = Targets::open(args)?;
    let note = |note: &str| eprintln!("note: {note}");
    if let Some(scene) = args.scene {
        for idle in notes::idle(args, None) {
            note(&idle);
        }
        let measured = Measured {
            scene,
            mode: Mode::new(args, 1.0)?,
            depth: args.depth,
        };
        return match args.color {
            Color::Rgb565 => targets.fill(
                MEASURED,
                |band, frame| measured.record(band, frame),
                |band, frame| measured.paint(band, frame),
            ),
            Color::Rgb888 => measured_in::<Rgb888>(measured, targets),
            Color::Gray8 => measured_in::<Gray8>(measured, targets),
            Color::Gray4 => measured_in::<Gray4>(measured, targets),
            Color::Mono => measured_in::<BinaryColor>(measured, targets),
        };
    }
    let subject = Subject::load(args)?;
    targets.refuse_inputs(&subject.inputs)?;
    let pieces = subject.pieces()?;
    let model = subject.model(args, &pieces)?;
    for idle in notes::idle(args, model.shade) {
        note(&idle);
    }
    if let Some(hint) = sight::check(&model, args)? {
        note(hint);
    }
    println!("camera {}", subject.framing.options());
    let skins = &subject.skins;
    match args.color {
        Color::Rgb565 => picture_in::<Rgb565>(&model, skins, args, targets),
        Color::Rgb888 => picture_in::<Rgb888>(&model, skins, args, targets),
        Color::Gray8 => picture_in::<Gray8>(&model, skins, args, targets),
        Color::Gray4 => picture_in::<Gray4>(&model, skins, args, targets),
        Color::Mono => picture_in::<BinaryColor>(&model, skins, args, targets),
    }
}

/// The size of the measured scenes.
const MEASURED: (u32, u32) = (scenes::WIDTH, scenes::HEIGHT);

fn measured_in<C: Shown>(measured: Measured, targets: Targets<'_>) -> Result<()> {
    targets.fill(
        MEASURED,
        |band, frame| measured.record(band, frame),
        |band, frame| measured.paint_in::<C>(band, frame),
    )
}

fn picture_in<C: Shown>(
    model: &Model<'_>,
    skins: &[Skin],
    args: &Args,
    targets: Targets<'_>,
) -> Result<()> {
    let texels: Vec<_> = skins.iter().map(Skin::texels).collect();
    let textures: Vec<_> = texels.iter().map(Texels::texture).collect::<Result<_>>()?;
    targets.fill(
        args.size,
        |band, frame| model.record(band, frame),
        |band, frame| model.paint::<C>(band, frame, &textures),
    )
}
