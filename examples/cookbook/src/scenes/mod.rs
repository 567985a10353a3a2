//! Small scenes, one idea each. Each scene is a function that draws on any canvas of type [`Frame`].

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

/// A function that draws a moment of a scene that moves. The time is in milliseconds.
#[cfg(not(target_os = "none"))]
pub type Move = fn(&mut Frame<'_>, u64) -> Result<(), Error>;

/// The scenes that move, by name, and the milliseconds after which they repeat.
#[cfg(not(target_os = "none"))]
pub const MOVING: &[(&str, Move, u64)] = &[
    ("corridor", corridor::draw, 1000),
    ("drone", drone::draw, 2500),
    ("files", files::draw, 4000),
    ("instruments", instruments::draw, 2500),
    ("packed", packed::draw, 4000),
    ("picking", picking::draw, 4000),
    ("terrain", terrain::draw, 2000),
    ("toon", toon::draw, 2000),
];

/// The scenes by name. Those that move are drawn at the time 0.
pub const SCENES: &[(&str, Draw)] = &[
    ("bands", bands::draw),
    ("blending", blending::draw),
    ("corridor", |canvas| corridor::draw(canvas, 0)),
    ("cut_out", cut_out::draw),
    ("detail", detail::draw),
    ("drone", |canvas| drone::draw(canvas, 0)),
    ("files", |canvas| files::draw(canvas, 0)),
    ("fog", fog::draw),
    ("hello", hello::draw),
    ("hidden", hidden::draw),
    ("instruments", |canvas| instruments::draw(canvas, 0)),
    ("keyframes", keyframes::draw),
    ("labels", labels::draw),
    ("lights", lights::draw),
    ("materials", materials::draw),
    ("mipmaps", mipmaps::draw),
    ("mirror", mirror::draw),
    ("normals", normals::draw),
    ("packed", |canvas| packed::draw(canvas, 0)),
    ("painter", painter::draw),
    ("panels", panels::draw),
    ("picking", |canvas| picking::draw(canvas, 0)),
    ("points", points::draw),
    ("quantized", quantized::draw),
    ("sky", sky::draw),
    ("sky_box", sky_box::draw),
    ("sprites", sprites::draw),
    ("stencil", stencil::draw),
    ("smooth", smooth::draw),
    ("terrain", |canvas| terrain::draw(canvas, 0)),
    ("toon", |canvas| toon::draw(canvas, 0)),
    #[cfg(not(target_os = "none"))] // starts a thread
    ("two_cores", two_cores::draw),
    ("windmill", windmill::draw),
    ("wireframe", wireframe::draw),
];
