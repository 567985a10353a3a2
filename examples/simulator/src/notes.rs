//! Options that are given in vain.

use clap::ValueEnum;

use crate::args::{Args, DepthFormat, Filter, Kind, Mode, SceneName, Shade};

/// The name of an option's value, as it is written.
pub fn name(value: &impl ValueEnum) -> String {
    let value = value.to_possible_value();
    value.map_or(String::new(), |value| value.get_name().into())
}

/// Returns a sentence for each option that does not change anything in a picture with this `shade`; a shade of None is
/// that of a scene of the project's own.
pub fn idle(args: &Args, shade: Option<Shade>) -> Vec<String> {
    let mut notes = Vec::new();
    let mut note = |is_idle: bool, option: &str, why: &str| {
        if is_idle {
            notes.push(format!("{option} has no effect {why}"));
        }
    };
    let shaded = shade.map_or(String::new(), |shade| {
        format!("with --shade {}", name(&shade))
    });
    let is_parallel = args.projection != Kind::Perspective;
    let projected = format!("with --projection {}", name(&args.projection));
    let is_textured = matches!(shade, None | Some(Shade::Texture | Shade::Lit));
    let is_flat = args.scene == Some(SceneName::SphereFlat);

    let has_mode = args.mode != Mode::Newton;
    let mode = format!("--mode {}", name(&args.mode));
    let is_constant = matches!(shade, Some(Shade::Flat | Shade::Depth | Shade::Wire));
    note(has_mode && is_parallel, &mode, &projected);
    note(
        has_mode && !is_parallel && is_constant && args.dump.is_none(),
        &mode,
        &shaded,
    );
    note(has_mode && is_flat, &mode, "with --scene sphere-flat");
    note(
        args.tolerance.is_some() && args.mode != Mode::Fast,
        "--tolerance",
        "without --mode fast",
    );
    note(args.texture.is_some() && !is_textured, "--texture", &shaded);
    note(
        args.filter == Filter::Bilinear && !is_textured,
        "--filter bilinear",
        &shaded,
    );
    note(
        args.two_sided && shade == Some(Shade::Wire),
        "--two-sided",
        &shaded,
    );
    note(
        args.depth != DepthFormat::Linear && is_flat,
        "--depth",
        "with --scene sphere-flat, which has no depth buffer",
    );
    note(
        args.rpm.is_some() && args.frames == 1 && !args.window,
        "--rpm",
        "on a single frame: give --frames too",
    );
    note(
        args.fov.is_some() && is_parallel && args.eye.is_none(),
        "--fov",
        &format!("{projected}, unless --eye is given too: the model fills the picture"),
    );
    notes
}
