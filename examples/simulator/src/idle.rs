//! Notes for the user about options without effect.

use crate::args::{Args, Kind, Named, SceneName, Shade};

/// Returns a sentence for each option that was given, but has no effect on the picture. `shade` is `None` if the scene
/// is not a model. `has_textures` says whether any face has a texture.
pub fn options(args: &Args, shade: Option<Shade>, has_textures: bool) -> Vec<String> {
    use Shade::{Depth, Flat, Lit, Normal, Texture, Wire};
    let is = |wanted: &[Shade]| shade.is_some_and(|shade| wanted.contains(&shade));
    let shaded = shade.map_or(String::new(), |shade| {
        format!("with --shade {}", shade.name())
    });
    let projected = format!("with --projection {}", args.projection.name());
    let is_parallel = args.projection != Kind::Perspective;
    let unlit = is(&[Texture, Wire, Depth, Normal]);
    let untextured = !is(&[Texture, Lit]);
    // The mode always changes a dump, whatever the shade is.
    let exact = args.dump.is_none() && is(&[Wire, Depth, Flat]);
    let flat_scene = args.scene == Some(SceneName::SphereFlat);
    let rows = [
        ("texture", untextured, &*shaded),
        ("filter", untextured, &shaded),
        (
            "filter",
            !untextured && !has_textures,
            "because the model has no texture",
        ),
        ("light", unlit, &shaded),
        ("ambient", unlit, &shaded),
        ("fog", is(&[Wire, Depth, Normal]), &shaded),
        ("wire", is(&[Wire]), &shaded),
        ("mode", is_parallel, &projected),
        ("mode", exact && !is_parallel, &shaded),
        ("mode", flat_scene, "with --scene sphere-flat"),
        ("fov", is_parallel && args.eye.is_none(), &projected),
    ];
    let mut notes = Vec::new();
    for (option, is_idle, why) in rows {
        if is_idle && args.given.contains(&option) {
            notes.push(format!("--{option} has no effect {why}"));
        }
    }
    if args.window && args.scene.is_some() {
        notes.push("in the window, a measured scene cannot be turned".into());
    }
    notes
}
