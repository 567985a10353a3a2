//! Small scenes, one idea each, and a little world: see `--help`.

mod animation;
mod pages;
mod scenes;
mod world;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use base64::prelude::{BASE64_STANDARD, Engine};
use clap::Parser;
use clap::builder::PossibleValuesParser;
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use fixel::prelude::*;

use scenes::{Draw, Frame, SCENES};

/// The size of the documentation's pictures.
const SIZE: Size = Size::new(320, 240);

/// The scene that is longer than the others, and is animated.
const WORLD: &str = "world";

/// All scenes by name.
fn all() -> impl Iterator<Item = (&'static str, Draw)> {
    let world = [(WORLD, world::draw as Draw)];
    SCENES.iter().copied().chain(world)
}

/// Draws small scenes, one idea each, and saves a picture of each as a PNG file in the current folder; for `world`,
/// also an animation.
#[derive(Parser)]
struct Args {
    /// Draw only these scenes.
    #[arg(value_parser = PossibleValuesParser::new(all().map(|(name, _)| name)))]
    scenes: Vec<String>,

    /// Picture size in pixels, if not 320x240.
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<Size>,

    /// Renew the pictures of the documentation instead: PNG files, and for the guide the same files in base64.
    #[arg(long, conflicts_with = "size")]
    renew: bool,

    /// Print a checksum of each picture instead, computed from its pixels row by row, two bytes each, the more
    /// significant first.
    #[arg(long, conflicts_with = "renew")]
    crc: bool,
}

fn size(text: &str) -> Result<Size, String> {
    text.split_once('x')
        .and_then(|(width, height)| Some(Size::new(width.parse().ok()?, height.parse().ok()?)))
        .ok_or_else(|| "write a size as WxH, for example 128x64".into())
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::parse();
    let folder = if args.renew { assets() } else { PathBuf::new() };
    let size = args.size.unwrap_or(SIZE);
    for (name, draw) in all() {
        if args.scenes.is_empty() || args.scenes.iter().any(|scene| scene == name) {
            let shown = picture(draw, size)?;
            if args.crc {
                let pixels = shown.to_be_bytes();
                println!("{name} {:08x}", crc32fast::hash(&pixels));
                continue;
            }
            let path = folder.join(name).with_extension("png");
            shown
                .to_rgb_output_image(&OutputSettings::default())
                .save_png(&path)?;
            println!("{}", path.display());
            if args.renew {
                fs::write(path.with_extension("base64"), base64_of(&path)?)?;
            }
            if name == WORLD {
                let path = path.with_extension("gif");
                let turns = (0..world::FRAMES).map(world::turn_of);
                let frames = turns.map(|turn| picture(|canvas| world::walk(canvas, turn), size));
                animation::save(&path, &frames.collect::<Result<Vec<_>, _>>()?)?;
                println!("{}", path.display());
            }
        }
    }
    if args.renew && args.scenes.is_empty() {
        for &(name, draw) in pages::PAGES {
            let path = page(name);
            picture(draw, pages::SIZE)?
                .to_rgb_output_image(&OutputSettings::default())
                .save_png(&path)?;
            println!("{}", path.display());
            fs::write(path.with_extension("base64"), base64_of(&path)?)?;
        }
    }
    Ok(())
}

/// The picture of a type's page.
fn page(name: &str) -> PathBuf {
    assets().join("pages").join(name).with_extension("png")
}

/// Draws a scene.
fn picture(
    draw: impl Fn(&mut Frame<'_>) -> Result<(), fixel::Error>,
    size: Size,
) -> Result<SimulatorDisplay<Rgb565>, fixel::Error> {
    let mut colors = vec![Rgb565::BLACK; (size.width * size.height) as usize];
    let mut depths = vec![0; colors.len()];
    let mut canvas = Canvas::new(&mut colors, size.width, size.height)?.with_depth(&mut depths)?;
    draw(&mut canvas)?;
    let mut display = SimulatorDisplay::new(size);
    canvas.show(&mut display)?;
    Ok(display)
}

/// The folder of the documentation's pictures.
fn assets() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets")
}

/// A file as text, for a `data:` URI.
fn base64_of(path: &Path) -> std::io::Result<String> {
    Ok(BASE64_STANDARD.encode(fs::read(path)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// After a change that is meant to change a picture, run `cargo run -p cookbook -- --renew`, look at the picture,
    /// and say why in the changelog.
    #[test]
    fn pictures_are_those_of_the_documentation() {
        for (name, draw) in all() {
            let path = assets().join(name).with_extension("png");
            let found = picture(draw, SIZE).unwrap();
            let shown = SimulatorDisplay::load_png(&path).unwrap();
            assert!(found.diff(&shown).is_none(), "{name} has changed");
            let in_guide = fs::read_to_string(path.with_extension("base64")).unwrap();
            assert!(
                in_guide == base64_of(&path).unwrap(),
                "the guide shows another {name}"
            );
        }
    }

    #[test]
    fn pictures_of_pages_are_those_of_the_documentation() {
        for &(name, draw) in pages::PAGES {
            let found = picture(draw, pages::SIZE).unwrap();
            let shown = SimulatorDisplay::load_png(page(name)).unwrap();
            assert!(found.diff(&shown).is_none(), "{name} has changed");
            let in_page = fs::read_to_string(page(name).with_extension("base64")).unwrap();
            assert!(
                in_page == base64_of(&page(name)).unwrap(),
                "the page shows another {name}"
            );
            // Each page of the documentation is loaded with its picture.
            assert!(
                in_page.len() <= 4096 * 4 / 3,
                "{name} has {} characters",
                in_page.len()
            );
        }
    }

    #[test]
    fn scenes_draw_in_the_size_of_a_small_display() {
        for (name, draw) in all() {
            let drawn = picture(draw, Size::new(128, 64));
            assert!(drawn.is_ok(), "{name}: {:?}", drawn.err());
        }
    }

    #[test]
    fn scenes_are_short() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/scenes");
        for (name, _) in SCENES {
            let text = fs::read_to_string(folder.join(name).with_extension("rs")).unwrap();
            assert!(text.lines().count() < 60, "{name} has 60 lines or more");
        }
    }
}
