//! Short programs, each with its picture and its cost. Each program shows one idea.
//!
//! <style>
//! .recipes { display: flex; flex-wrap: wrap; gap: 12px; margin-bottom: 1.5em }
//! .recipes a { width: 96px; text-align: center; font-size: 14px; line-height: 1.3 }
//! .recipes img { display: block; margin: 0 0 2px }
//! </style>
//!
//! # Models and memory
//!
#![doc = gallery!("models":
    "Hello" "hello" "hello",
    "Files" "files" "files",
    "Materials" "materials" "materials",
    "Normals" "normals" "normals",
    "Small meshes" "small-meshes" "quantized",
    "Levels of detail" "levels-of-detail" "detail",
    "Bands" "bands" "bands",
    "Two cores" "two-cores" "two_cores",
    "Painter's order" "painters-order" "painter"
)]
//!
//! # Light, sky and fog
//!
#![doc = gallery!("light":
    "Lights" "lights" "lights",
    "Cartoon" "cartoon" "toon",
    "Fog" "fog" "fog",
    "Sky" "sky" "sky",
    "Sky box" "sky-box" "sky_box"
)]
//!
//! # Textures, blending and depth
//!
#![doc = gallery!("surfaces":
    "Mipmaps" "mipmaps" "mipmaps",
    "Modes" "modes" "corridor",
    "Cut-out textures" "cut-out-textures" "cut_out",
    "Blending" "blending" "blending",
    "What is hidden" "what-is-hidden" "hidden",
    "Windows and stencils" "windows-and-stencils" "stencil",
    "Smooth edges" "smooth-edges" "smooth",
    "A mirror" "a-mirror" "mirror"
)]
//!
//! # Lines, points and small panels
//!
#![doc = gallery!("lines":
    "Wireframe" "wireframe" "wireframe",
    "Points" "points" "points",
    "Sprites" "sprites" "sprites",
    "Black and white" "black-and-white" "packed",
    "Panels" "panels" "panels"
)]
//!
//! # Whole scenes
//!
#![doc = gallery!("scenes":
    "Terrain" "terrain" "terrain",
    "Keyframes" "keyframes" "keyframes",
    "A windmill" "a-windmill" "windmill",
    "Labels" "labels" "labels",
    "Picking" "picking" "picking",
    "Instruments" "instruments" "instruments",
    "A drone's display" "a-drones-display" "drone",
    "A little world" "a-little-world" "world"
)]
//!
#![doc = include_str!("cookbook.md")]

/// Models from files, small meshes, levels of detail; frames in bands, on two cores, and without a depth buffer.
///
/// The line below each picture gives the [costs](crate::guide::cookbook#what-a-recipe-costs) of a frame of 320x240
/// pixels. The frames a second are an estimate.
///
#[doc = recipe!("Hello", "hello")]
#[cfg_attr(not(doctest), doc = recipe!("Files", "files"))]
#[cfg_attr(not(doctest), doc = recipe!("Materials", "materials"))]
#[cfg_attr(not(doctest), doc = recipe!("Normals", "normals"))]
#[doc = recipe!("Small meshes", "quantized")]
#[doc = recipe!("Levels of detail", "detail")]
#[doc = recipe!("Bands", "bands")]
#[doc = recipe!("Two cores", "two_cores")]
#[doc = recipe!("Painter's order", "painter")]
///
// The smaller font lets lines of 100 characters fit into the page.
/// <style>.docblock pre.rust { font-size: 15px }</style>
pub mod models {}

/// Lamps, highlights and cartoons; fog, and skies behind a scene.
///
/// The line below each picture gives the [costs](crate::guide::cookbook#what-a-recipe-costs) of a frame of 320x240
/// pixels. The frames a second are an estimate.
///
#[doc = recipe!("Lights", "lights")]
#[doc = recipe!("Cartoon", "toon")]
#[doc = recipe!("Fog", "fog")]
#[doc = recipe!("Sky", "sky")]
#[doc = recipe!("Sky box", "sky_box")]
///
// The smaller font lets lines of 100 characters fit into the page.
/// <style>.docblock pre.rust { font-size: 15px }</style>
pub mod light {}

/// Textures near and far; glass, mirrors and shadows; and depth tests that show hidden surfaces.
///
/// The line below each picture gives the [costs](crate::guide::cookbook#what-a-recipe-costs) of a frame of 320x240
/// pixels. The frames a second are an estimate.
///
#[doc = recipe!("Mipmaps", "mipmaps")]
#[doc = recipe!("Modes", "corridor")]
#[doc = recipe!("Cut-out textures", "cut_out")]
#[doc = recipe!("Blending", "blending")]
#[doc = recipe!("What is hidden", "hidden")]
#[doc = recipe!("Windows and stencils", "stencil")]
#[doc = recipe!("Smooth edges", "smooth")]
#[doc = recipe!("A mirror", "mirror")]
///
// The smaller font lets lines of 100 characters fit into the page.
/// <style>.docblock pre.rust { font-size: 15px }</style>
pub mod surfaces {}

/// Models in lines, discs and sprites; panels with few colors.
///
/// The line below each picture gives the [costs](crate::guide::cookbook#what-a-recipe-costs) of a frame of 320x240
/// pixels. The frames a second are an estimate.
///
#[cfg_attr(not(doctest), doc = recipe!("Wireframe", "wireframe"))]
#[doc = recipe!("Points", "points")]
#[doc = recipe!("Sprites", "sprites")]
#[cfg_attr(not(doctest), doc = recipe!("Black and white", "packed"))]
#[cfg_attr(not(doctest), doc = recipe!("Panels", "panels"))]
///
// The smaller font lets lines of 100 characters fit into the page.
/// <style>.docblock pre.rust { font-size: 15px }</style>
pub mod lines {}

/// Scenes that put these techniques together.
///
/// The line below each picture gives the [costs](crate::guide::cookbook#what-a-recipe-costs) of a frame of 320x240
/// pixels. The frames a second are an estimate.
///
#[doc = recipe!("Terrain", "terrain")]
#[doc = recipe!("Keyframes", "keyframes")]
#[doc = recipe!("A windmill", "windmill")]
#[doc = recipe!("Labels", "labels")]
#[doc = recipe!("Picking", "picking")]
#[doc = recipe!("Instruments", "instruments")]
#[doc = recipe!("A drone's display", "drone")]
#[doc = titled!("A little world", "world")]
/// A walk through a garden at dusk uses most of the techniques of the cookbook. The trees and the glow around each lamp
/// are sprites. The compiler computes the light of the dusk and of the lamps, and keeps it in the colors of vertices; a
/// shader of the scene's own multiplies this light by the texels, and adds haze. The scene also has a sky with stars and
/// a moon, and a mirror image under translucent water. Labels, a compass, gauges and a map are drawn
/// over the picture. The command `cargo run -p cookbook world` draws the picture and an animation. The program in
/// `examples/common/world` draws whole frames or bands, and needs no memory except the canvas.
///
// The smaller font lets lines of 100 characters fit into the page.
/// <style>.docblock pre.rust { font-size: 15px }</style>
pub mod scenes {}
