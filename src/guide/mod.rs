//! Guides, longer than an item's page. Their drawing code is compiled and run as doctests.

/// A title and the picture of a scene of the cookbook. The picture is part of the page, so that it is there wherever the
/// page is.
macro_rules! picture {
    ($title:literal, $name:literal) => {
        concat!(
            "# ",
            $title,
            "\n\n![",
            $title,
            "](data:image/png;base64,",
            include_str!(concat!("../../examples/assets/", $name, ".base64")),
            ")\n\n"
        )
    };
}

/// Shows a scene of the cookbook: its picture and its program, which is compiled as it stands.
macro_rules! recipe {
    ($title:literal, $name:literal $(, $attribute:literal)?) => {
        concat!(
            picture!($title, $name),
            "```",
            $($attribute,)?
            "\n",
            include_str!(concat!("../../examples/cookbook/src/scenes/", $name, ".rs")),
            "```\n"
        )
    };
}

#[doc = include_str!("cookbook.md")]
#[doc = recipe!("Hello", "hello")]
#[doc = recipe!("Bands", "bands")]
#[doc = recipe!("Two cores", "two_cores")]
#[doc = recipe!("Lights", "lights")]
#[doc = recipe!("Cartoon", "toon")]
#[doc = recipe!("Fog", "fog")]
#[doc = recipe!("Sky", "sky")]
#[doc = recipe!("Sky box", "sky_box")]
#[doc = recipe!("Mipmaps", "mipmaps")]
#[doc = recipe!("Cut-out textures", "cut_out")]
#[doc = recipe!("Blending", "blending")]
#[doc = recipe!("Painter's order", "painter")]
// Those that are ignored read files beside their own folder.
#[doc = recipe!("Wireframe", "wireframe", "ignore")]
#[doc = recipe!("Points", "points")]
#[doc = recipe!("Black and white", "packed", "ignore")]
#[doc = recipe!("Panels", "panels")]
#[doc = recipe!("Materials", "materials", "ignore")]
#[doc = recipe!("Normals", "normals", "ignore")]
#[doc = recipe!("Small meshes", "quantized")]
#[doc = recipe!("Levels of detail", "detail")]
#[doc = recipe!("Terrain", "terrain")]
#[doc = recipe!("Keyframes", "keyframes")]
#[doc = recipe!("Sprites", "sprites")]
#[doc = recipe!("Labels", "labels")]
#[doc = recipe!("Picking", "picking")]
#[doc = recipe!("Instruments", "instruments")]
#[doc = picture!("A little world", "world")]
/// A walk through a garden at dusk puts most of this together. Walls, grass and water have mipmaps. Trees are sprites, and
/// so is the glow of the lamps, which light the walls near them. There is fog, a sky with stars and a moon, and a mirror
/// image under translucent water. Labels, a compass, gauges and a map are drawn over the picture. `cargo run -p cookbook world` draws it and makes
/// an animation; `examples/common/world` is its program, for frames and bands, with no memory but the canvas.
pub mod cookbook {}

#[doc = include_str!("firmware.md")]
pub mod firmware {}

#[doc = include_str!("modes.md")]
pub mod modes {}

#[doc = include_str!("benchmarks.md")]
pub mod benchmarks {}

#[doc = include_str!("limits.md")]
#[doc = include_str!("extremes.md")]
pub mod limits {}
