//! The scenes of the cookbook, the pictures of the documentation's pages, and a little world.
//!
//! The program and the tests share this library, so that the meshes and textures are built only once. The meshes and
//! textures take the compiler longer than the code.

pub mod bus;
pub mod displays;
mod pages;
mod scenes;
pub mod world;

use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_simulator::SimulatorDisplay;
use fixel::prelude::*;

pub use displays::DISPLAYS;
pub use pages::{PAGES, SIZE as PAGE_SIZE};
pub use scenes::{Draw, Frame, MOVING, Move, SCENES};

/// The size of the documentation's pictures.
pub const SIZE: Size = Size::new(320, 240);

/// The size of the small pictures that lead to the recipes.
pub const THUMBNAIL: Size = Size::new(96, 72);

/// The pictures a second of the README's animations.
pub const RATE: u64 = 12;

/// The scene that is longer than the other scenes, and is animated.
pub const WORLD: &str = "world";

/// All scenes by name.
pub fn all() -> impl Iterator<Item = (&'static str, Draw)> {
    let world = [(WORLD, world::draw as Draw)];
    SCENES.iter().copied().chain(world)
}

/// Draws a scene.
///
/// # Errors
///
/// The errors of the scene, and of a canvas of this size.
pub fn picture(
    draw: impl Fn(&mut Frame<'_>) -> Result<(), Error>,
    size: Size,
) -> Result<SimulatorDisplay<Rgb565>, Error> {
    let mut colors = vec![Rgb565::BLACK; (size.width * size.height) as usize];
    let mut depths = vec![0; colors.len()];
    let mut canvas = Canvas::new(&mut colors, size.width, size.height)?.with_depth(&mut depths)?;
    draw(&mut canvas)?;
    let mut display = SimulatorDisplay::new(size);
    canvas.show(&mut display)?;
    Ok(display)
}

/// Draws the pictures of an animation.
///
/// # Errors
///
/// The errors of the scene.
pub fn frames(draw: Move, period: u64) -> Result<Vec<SimulatorDisplay<Rgb565>>, Error> {
    let times = (0..period * RATE / 1000).map(|frame| frame * 1000 / RATE);
    times
        .map(|ms| picture(|canvas| draw(canvas, ms), SIZE))
        .collect()
}

/// The folder of the documentation's pictures.
#[must_use]
pub fn pictures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../src/assets/macros/pictures")
}

/// The picture of a program that drives a display.
#[must_use]
pub fn display(name: &str) -> PathBuf {
    pictures().join("displays").join(name).with_extension("png")
}

/// The picture of a type's page.
#[must_use]
pub fn page(name: &str) -> PathBuf {
    pictures().join("pages").join(name).with_extension("png")
}

/// The small picture of a scene.
#[must_use]
pub fn thumbnail(name: &str) -> PathBuf {
    pictures()
        .join("thumbnails")
        .join(name)
        .with_extension("png")
}

/// The animation of a scene. Only README shows it, so it is in no package.
#[must_use]
pub fn animation(name: &str) -> PathBuf {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets");
    assets.join(name).with_extension("webp")
}
