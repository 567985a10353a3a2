//! The guide: from the first words to firmware.
//!
//! Read in this order, or jump in where your question is. Every program on these pages is compiled and run by the
//! tests.
//!
//! 1. **[Concepts](concepts)**: mesh, projection, camera, shader, options, canvas, depth and band, with diagrams; and
//!    the numbers that you write.
//! 2. **[Coming from](coming_from)** OpenGL, tgx, embedded-3dgfx or small3dlib: their words and ours, and what differs.
//! 3. **[Cookbook](cookbook)**: a short program and its picture for each thing that can be drawn.
//! 4. **[Firmware](firmware)**: from `cargo new` to a panel on SPI, with bands and DMA.
//! 5. **[Choosing a mode](modes)**: speed against accuracy, and where each bound comes from.
//! 6. **[Limits](limits)**: the range of each quantity, and what happens beyond it.
//! 7. **[Benchmarks](benchmarks)**: what drawing costs, beside other libraries.
#![cfg_attr(doc, doc = page_picture!("shaders", "Balls in eight shaders"))]

/// A title and the picture of a scene of the cookbook. The picture is part of the page, so that it is there wherever
/// the page is.
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

pub mod concepts;

/// What you call it, what it is called here, and what differs in a way that shows in the picture.
///
#[cfg_attr(doc, doc = diagram!("axes"))]
#[doc = include_str!("coming_from.md")]
pub mod coming_from {}

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
/// A walk through a garden at dusk puts most of this together. Walls, grass and water have mipmaps. Trees are sprites,
/// and so is the glow of the lamps, which light the walls near them. There is fog, a sky with stars and a moon, and a
/// mirror image under translucent water. Labels, a compass, gauges and a map are drawn over the picture. The command
/// `cargo run -p cookbook world` draws it and makes an animation; `examples/common/world` is its program, for frames
/// and bands, with no memory but the canvas.
pub mod cookbook {}

#[doc = include_str!("firmware.md")]
pub mod firmware {}

/// Speed against accuracy: which mode suits which scene and core, what error to expect, and where each bound comes
/// from.
///
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by the default mode"))]
#[doc = include_str!("modes.md")]
pub mod modes {}

/// What drawing costs, measured alike for this crate and for the libraries that come nearest to it; how to repeat the
/// measurement; and where the others are ahead.
///
#[cfg_attr(doc, doc = page_picture!("measured", "The measured scenes: floor, cube, smooth sphere, flat sphere"))]
#[doc = include_str!("benchmarks.md")]
pub mod benchmarks {}

/// This guide gives, for each quantity, the range in which accuracy is promised, the behavior beyond it, and the errors
/// measured at its ends.
///
#[cfg_attr(doc, doc = diagram!("eye"))]
#[doc = include_str!("limits.md")]
#[doc = include_str!("extremes.md")]
pub mod limits {}
