//! Small scenes, one idea each, and a little world: see `--help`.

mod webp_file;

use std::error::Error;
use std::path::PathBuf;

use clap::Parser;
use clap::builder::PossibleValuesParser;
use cookbook::{
    DISPLAYS, MOVING, PAGE_SIZE, PAGES, RATE, SIZE, THUMBNAIL, WORLD, all, animation, display,
    frames, page, picture, pictures, thumbnail, world,
};
use embedded_graphics::geometry::Size;
use embedded_graphics_simulator::OutputSettings;
use webp_file::Quality;

/// Draws small scenes, one idea each, and saves a picture of each as a PNG file in the current folder; for `world`,
/// also an animation.
#[derive(Parser)]
struct Args {
    /// Draw only these scenes, or what these programs show on displays.
    #[arg(value_parser = PossibleValuesParser::new(names()))]
    scenes: Vec<String>,

    /// Picture size of scenes in pixels, if not 320x240.
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<Size>,

    /// Renew the pictures of the documentation instead.
    #[arg(long, conflicts_with = "size")]
    renew: bool,

    /// Print a checksum of each picture instead, computed from its pixels row by row, two bytes each, the more
    /// significant first.
    #[arg(long, conflicts_with = "renew")]
    crc: bool,
}

fn names() -> impl Iterator<Item = &'static str> {
    let displays = DISPLAYS.iter().map(|&(name, _)| name);
    all().map(|(name, _)| name).chain(displays)
}

fn size(text: &str) -> Result<Size, String> {
    text.split_once('x')
        .and_then(|(width, height)| Some(Size::new(width.parse().ok()?, height.parse().ok()?)))
        .ok_or_else(|| "write a size as WxH, for example 128x64".into())
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::parse();
    let folder = if args.renew {
        pictures()
    } else {
        PathBuf::new()
    };
    let size = args.size.unwrap_or(SIZE);
    let is_wanted = |name| args.scenes.is_empty() || args.scenes.iter().any(|scene| scene == name);
    for (name, draw) in all() {
        if is_wanted(name) {
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
                picture(draw, THUMBNAIL)?
                    .to_rgb_output_image(&OutputSettings::default())
                    .save_png(thumbnail(name))?;
            }
            if name == WORLD {
                let path = path.with_extension("webp");
                let turns = (0..world::FRAMES).map(world::turn_of);
                let frames = turns.map(|turn| picture(|canvas| world::walk(canvas, turn), size));
                let frames = frames.collect::<Result<Vec<_>, _>>()?;
                webp_file::save(&path, &frames, world::RATE, Quality::Visible)?;
                println!("{}", path.display());
            }
        }
    }
    for &(name, draw, period) in MOVING {
        if args.renew && is_wanted(name) {
            let path = animation(name);
            webp_file::save(&path, &frames(draw, period)?, RATE, Quality::Exact)?;
            println!("{}", path.display());
        }
    }
    if args.renew && args.scenes.is_empty() {
        for &(name, draw) in PAGES {
            let path = page(name);
            picture(draw, PAGE_SIZE)?
                .to_rgb_output_image(&OutputSettings::default())
                .save_png(&path)?;
            println!("{}", path.display());
        }
    }
    for &(name, draw) in DISPLAYS {
        if is_wanted(name) && !args.crc {
            let path = if args.renew {
                display(name)
            } else {
                PathBuf::from(name).with_extension("png")
            };
            draw()?
                .to_rgb_output_image(&OutputSettings::default())
                .save_png(&path)?;
            println!("{}", path.display());
        }
    }
    Ok(())
}
