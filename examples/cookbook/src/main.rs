//! Small scenes, one idea each. `cargo run -p cookbook` writes a picture of each to the current folder; with names
//! as arguments, only of these.

mod blending;
mod fog;
mod keyframes;
mod labels;
mod lights;
mod mipmaps;
mod packed;
mod painter;
mod picking;
mod sky;
mod sprites;
mod terrain;
mod wireframe;

use std::error::Error;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use fixel::prelude::*;
use fixel::target::{Depth, Native};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;

/// The canvas that all scenes draw on.
type Frame<'c> = Canvas<'c, Rgb565, Native, Depth<'c>>;

/// A scene: its name, and what draws it.
type Recipe = (&'static str, fn(&mut Frame<'_>) -> Result<(), fixel::Error>);

const RECIPES: &[Recipe] = &[
    ("blending", blending::draw),
    ("fog", fog::draw),
    ("keyframes", keyframes::draw),
    ("labels", labels::draw),
    ("lights", lights::draw),
    ("mipmaps", mipmaps::draw),
    ("packed", packed::draw),
    ("painter", painter::draw),
    ("picking", picking::draw),
    ("sky", sky::draw),
    ("sprites", sprites::draw),
    ("terrain", terrain::draw),
    ("wireframe", wireframe::draw),
];

fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let known = |name: &String| RECIPES.iter().any(|(recipe, _)| recipe == name);
    if let Some(name) = names.iter().find(|name| !known(name)) {
        let all: Vec<&str> = RECIPES.iter().map(|(name, _)| *name).collect();
        return Err(format!("no scene is called {name}: there are {}", all.join(", ")).into());
    }
    for &(name, draw) in RECIPES {
        if names.is_empty() || names.iter().any(|wanted| wanted == name) {
            let path = format!("{name}.png");
            let settings = OutputSettings::default();
            picture(draw)?
                .to_rgb_output_image(&settings)
                .save_png(&path)?;
            println!("{path}");
        }
    }
    Ok(())
}

/// Draws a scene.
fn picture(
    draw: fn(&mut Frame<'_>) -> Result<(), fixel::Error>,
) -> Result<SimulatorDisplay<Rgb565>, fixel::Error> {
    let mut colors = vec![Rgb565::BLACK; (WIDTH * HEIGHT) as usize];
    let mut depths = vec![0; colors.len()];
    let mut canvas = Canvas::new(&mut colors, WIDTH, HEIGHT)?.with_depth(&mut depths)?;
    draw(&mut canvas)?;
    let mut display = SimulatorDisplay::new(Size::new(WIDTH, HEIGHT));
    canvas.show(&mut display)?;
    Ok(display)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    /// The pictures of the documentation. After a change that is meant to change one, run `cargo run -p cookbook` in
    /// their folder, look at them, and say why in the changelog.
    #[test]
    fn pictures_are_those_of_the_documentation() {
        let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets");
        for &(name, draw) in RECIPES {
            let path = assets.join(name).with_extension("png");
            let shown = SimulatorDisplay::load_png(path).unwrap();
            let found = picture(draw).unwrap();
            assert!(found.diff(&shown).is_none(), "{name} has changed");
        }
    }
}
