//! Options without effect, of which the user should hear.

use clap::ArgMatches;
use clap::parser::ValueSource;

use crate::args::{Args, Kind, Mode, SceneName, Shade};

/// Returns a sentence for each option that was given and changes nothing.
pub fn options(args: &Args, given: &ArgMatches) -> Vec<String> {
    let mut idle = Vec::new();
    let mut check = |option: &str, is_idle: bool, why: &str| {
        let is_given = given.value_source(option) == Some(ValueSource::CommandLine);
        if is_given && is_idle {
            let option = option.replace('_', "-");
            idle.push(format!("--{option} has no effect {why}"));
        }
    };
    let scene = args.scene;
    let shade = |wanted: &[Shade]| {
        scene.is_none() && args.shade.is_some_and(|shade| wanted.contains(&shade))
    };
    let untextured = [
        Shade::Gouraud,
        Shade::Flat,
        Shade::Wire,
        Shade::Depth,
        Shade::Normal,
    ];
    let unlit = [Shade::Texture, Shade::Wire, Shade::Depth, Shade::Normal];
    let exact = [Shade::Wire, Shade::Depth, Shade::Flat];
    let named = args
        .shade
        .and_then(|shade| clap::ValueEnum::to_possible_value(&shade))
        .map_or(String::new(), |value| {
            format!("with --shade {}", value.get_name())
        });
    check("texture", shade(&untextured), &named);
    check("filter", shade(&untextured), &named);
    check("light", shade(&unlit), &named);
    check("ambient", shade(&unlit), &named);
    check("fog", shade(&unlit[1..]), &named);
    check("two_sided", shade(&[Shade::Wire]), &named);
    check("wire", shade(&[Shade::Wire]), &named);
    let is_parallel = args.projection != Kind::Perspective;
    check("mode", is_parallel, "under a parallel projection");
    check("mode", !is_parallel && shade(&exact), &named);
    check("tolerance", args.mode != Mode::Fast, "without --mode fast");
    let tolerates = args.mode == Mode::Fast && (is_parallel || shade(&untextured));
    check(
        "tolerance",
        tolerates,
        "on this picture: nothing textured is in perspective",
    );
    let without_depth = scene == Some(SceneName::SphereFlat);
    check("depth", without_depth, "on a scene without a depth buffer");
    check(
        "rpm",
        args.frames == 1 && !args.window,
        "without --frames or --window",
    );
    idle
}
