//! Notes for the user about options without effect.

use clap::parser::ValueSource;
use clap::{ArgMatches, ValueEnum};

use crate::args::{Args, Kind, SceneName, Shade};

/// The name of an option's value, as the user writes it.
pub fn name(value: &impl ValueEnum) -> String {
    let value = value.to_possible_value();
    value.map_or(String::new(), |value| value.get_name().into())
}

/// Returns a sentence for each option that was given and changes nothing in a picture with this `shade`. The project's
/// own scene may have no shade. `has_textures` says whether any face has a texture.
pub fn options(
    args: &Args,
    matches: &ArgMatches,
    shade: Option<Shade>,
    has_textures: bool,
) -> Vec<String> {
    let mut idle = Vec::new();
    let mut check = |option: &str, is_idle: bool, why: &str| {
        let is_given = matches.value_source(option) == Some(ValueSource::CommandLine);
        if is_given && is_idle {
            let option = option.replace('_', "-");
            idle.push(format!("--{option} has no effect {why}"));
        }
    };
    let named = shade.map_or(String::new(), |shade| {
        format!("with --shade {}", name(&shade))
    });
    let shade = |wanted: &[Shade]| shade.is_some_and(|shade| wanted.contains(&shade));
    let untextured = [
        Shade::Gouraud,
        Shade::Flat,
        Shade::Wire,
        Shade::Depth,
        Shade::Normal,
    ];
    let unlit = [Shade::Texture, Shade::Wire, Shade::Depth, Shade::Normal];
    let exact = [Shade::Wire, Shade::Depth, Shade::Flat];
    check("texture", shade(&untextured), &named);
    let is_untextured = shade(&untextured);
    let bare = "because the model has no texture";
    check("filter", is_untextured, &named);
    check("filter", !is_untextured && !has_textures, bare);
    check("light", shade(&unlit), &named);
    check("ambient", shade(&unlit), &named);
    check("fog", shade(&unlit[1..]), &named);
    check("cull", args.model.is_none(), "without a model");
    check("wire", shade(&[Shade::Wire]), &named);
    let is_parallel = args.projection != Kind::Perspective;
    let projected = format!("with --projection {}", name(&args.projection));
    // A dump shows the mode in any shade.
    let is_shown = args.dump.is_some();
    check("mode", is_parallel, &projected);
    check("mode", !is_parallel && !is_shown && shade(&exact), &named);
    let is_flat = args.scene == Some(SceneName::SphereFlat);
    check("mode", is_flat, "with --scene sphere-flat");
    check(
        "fov",
        is_parallel && args.eye.is_none(),
        &format!("{projected}, unless --eye is given too: the model fills the picture"),
    );
    if args.window && args.scene.is_some() {
        idle.push("in the window, a measured scene cannot be turned".into());
    }
    idle
}
