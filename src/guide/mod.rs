//! Guides, longer than an item's page. Their drawing code is compiled and run as doctests.

/// Shows the program of a scene of the cookbook, which is compiled as it stands.
macro_rules! recipe {
    ($title:literal, $file:literal $(, $attribute:literal)?) => {
        concat!(
            "# ",
            $title,
            "\n\n```",
            $($attribute,)?
            "\n",
            include_str!(concat!("../../examples/cookbook/src/", $file)),
            "```\n"
        )
    };
}

#[doc = include_str!("cookbook.md")]
#[doc = recipe!("Lights", "lights.rs")]
#[doc = recipe!("Fog", "fog.rs")]
#[doc = recipe!("Sky", "sky.rs")]
#[doc = recipe!("Mipmaps", "mipmaps.rs")]
#[doc = recipe!("Blending", "blending.rs")]
#[doc = recipe!("Painter's order", "painter.rs")]
// They read files beside their own folder.
#[doc = recipe!("Wireframe", "wireframe.rs", "ignore")]
#[doc = recipe!("Black and white", "packed.rs", "ignore")]
#[doc = recipe!("Terrain", "terrain.rs")]
#[doc = recipe!("Keyframes", "keyframes.rs")]
#[doc = recipe!("Sprites", "sprites.rs")]
#[doc = recipe!("Labels", "labels.rs")]
#[doc = recipe!("Picking", "picking.rs")]
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
