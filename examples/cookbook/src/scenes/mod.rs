//! Small scenes, one idea each. Each scene is a function that draws on any canvas of type [`Frame`].

#[cfg(not(target_os = "none"))]
mod bands;
mod blending;
mod corridor;
mod cut_out;
mod detail;
mod drone;
mod files;
mod fog;
mod hello;
mod hidden;
#[cfg(not(target_os = "none"))]
mod instruments;
mod keyframes;
mod labels;
mod lights;
mod materials;
mod mipmaps;
mod mirror;
mod normals;
mod packed;
mod painter;
mod panels;
#[cfg(not(target_os = "none"))]
mod picking;
mod points;
mod quantized;
mod sky;
mod sky_box;
mod smooth;
mod sprites;
mod stencil;
mod terrain;
mod toon;
#[cfg(not(target_os = "none"))]
mod two_cores;
mod windmill;
mod wireframe;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::prelude::*;

/// The canvas that all scenes draw on.
pub type Frame<'c> = Canvas<'c, Rgb565, Native, LinearDepth>;

/// A function that draws a scene.
pub type Draw = fn(&mut Frame<'_>) -> Result<(), Error>;

/// The scenes by name.
pub const SCENES: &[(&str, Draw)] = &[
    #[cfg(not(target_os = "none"))] // allocates a vector for its band
    ("bands", bands::draw),
    ("blending", blending::draw),
    ("corridor", corridor::draw),
    ("cut_out", cut_out::draw),
    ("detail", detail::draw),
    ("drone", drone::draw),
    ("files", files::draw),
    ("fog", fog::draw),
    ("hello", hello::draw),
    ("hidden", hidden::draw),
    #[cfg(not(target_os = "none"))] // draws arcs of embedded-graphics, which need floats
    ("instruments", instruments::draw),
    ("keyframes", keyframes::draw),
    ("labels", labels::draw),
    ("lights", lights::draw),
    ("materials", materials::draw),
    ("mipmaps", mipmaps::draw),
    ("mirror", mirror::draw),
    ("normals", normals::draw),
    ("packed", packed::draw),
    ("painter", painter::draw),
    ("panels", panels::draw),
    #[cfg(not(target_os = "none"))] // formats a text, which allocates
    ("picking", picking::draw),
    ("points", points::draw),
    ("quantized", quantized::draw),
    ("sky", sky::draw),
    ("sky_box", sky_box::draw),
    ("sprites", sprites::draw),
    ("stencil", stencil::draw),
    ("smooth", smooth::draw),
    ("terrain", terrain::draw),
    ("toon", toon::draw),
    #[cfg(not(target_os = "none"))] // starts a thread
    ("two_cores", two_cores::draw),
    ("windmill", windmill::draw),
    ("wireframe", wireframe::draw),
];
