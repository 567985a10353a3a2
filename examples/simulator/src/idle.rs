//! Notes for the user about options without effect. Each names a remedy.

use crate::args::{Args, Kind, Named, SceneName, Shade};
use crate::scene::Scene;

/// The options whose effect is found by drawing the first frame without them, and when they have an effect.
pub const COMPARED: [(&str, &str); 11] = [
    (
        "near",
        "nothing in view is nearer; leave it out, or give a larger number",
    ),
    (
        "far",
        "nothing in view is farther; leave it out, or give a smaller number",
    ),
    (
        "shade",
        "this model looks the same with the default; try --shade wire, depth or normal",
    ),
    (
        "filter",
        "it matters where texels are larger than pixels; move nearer with --eye",
    ),
    (
        "mode",
        "it matters where textures or colors are seen at a flat angle; move with --eye, or see the numbers in --dump",
    ),
    (
        "depth",
        "it matters where surfaces almost touch far from the eye; see --near and --far",
    ),
    (
        "background",
        "the model covers the picture, or the default has this color; give another color, or move away with --eye",
    ),
    (
        "light",
        "it matters on faces in view that are lit; give another direction",
    ),
    (
        "ambient",
        "it matters on faces in view that are lit, and the default is the same; give another value",
    ),
    (
        "fog",
        "all faces in view are nearer than its beginning; give smaller distances",
    ),
    (
        "color",
        "its colors look the same in the default format; try another --shade",
    ),
];

/// Returns a sentence for each option that was given, but has no effect because of another option or because of the
/// model. `has_textures` says whether any face has a texture.
pub fn options(args: &Args, scene: &Scene<'_>, has_textures: bool) -> Vec<String> {
    use Shade::{Depth, Flat, Gouraud, Normal, Texture, Wire};
    let shade = scene.shade;
    let is = |wanted: &[Shade]| shade.is_some_and(|shade| wanted.contains(&shade));
    let shaded = shade.map_or(String::new(), |shade| {
        format!("with --shade {}", shade.name())
    });
    let projected = format!("with --projection {}", args.projection.name());
    let is_parallel = args.projection != Kind::Perspective;
    let unlit = is(&[Texture, Wire, Depth, Normal]);
    let untextured = is(&[Gouraud, Flat, Wire, Depth, Normal]);
    // The mode always changes a dump, whatever the shade is.
    let exact = args.dump.is_none() && is(&[Wire, Depth, Flat]);
    let is_whole = args.bands.is_some_and(|rows| rows >= args.size.1);
    let textured = "it needs --shade texture or lit";
    let lit = "it needs --shade lit, gouraud or flat";
    let still = args.scene == Some(SceneName::Floor);
    let rows = [
        ("texture", untextured, &*shaded, textured),
        ("filter", untextured, &shaded, textured),
        (
            "filter",
            !untextured && !has_textures,
            "because the model has no texture",
            "give it one with --texture",
        ),
        ("light", unlit, &shaded, lit),
        ("ambient", unlit, &shaded, lit),
        (
            "fog",
            is(&[Wire, Depth, Normal]),
            &shaded,
            "it needs --shade texture, lit, gouraud or flat",
        ),
        ("wire", is(&[Wire]), &shaded, "leave it out"),
        ("cull", is(&[Wire]), &shaded, "it needs another --shade"),
        (
            "mode",
            is_parallel,
            &projected,
            "it needs --projection perspective",
        ),
        (
            "mode",
            exact && !is_parallel,
            &shaded,
            "it needs --shade texture, lit, gouraud or normal, or --dump",
        ),
        (
            "fov",
            is_parallel && args.eye.is_none() && !scene.is_own,
            &projected,
            "give --eye, too",
        ),
        (
            "frames",
            still,
            "with --scene floor, which stands still",
            "leave it out, or try --scene cube",
        ),
        (
            "bands",
            is_whole,
            "because it is not below the picture's height",
            "give fewer rows",
        ),
    ];
    let mut notes = Vec::new();
    for (option, is_idle, why, remedy) in rows {
        if is_idle && args.has(option) {
            notes.push(format!("--{option} has no effect {why}: {remedy}"));
        }
    }
    if args.window && args.scene.is_some() {
        notes.push(
            "in the window, a measured scene cannot be turned: draw a model, or leave out --scene"
                .into(),
        );
    }
    notes
}
