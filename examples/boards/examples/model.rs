//! Makes a UF2 of the program `pico_model` and a model; draws what such a UF2 shows:
//!
//! ```sh
//! model PROGRAM st7789|ili9341 MODEL [PICTURE] > model.uf2
//! model UF2 MILLISECONDS > picture.ppm
//! ```
//!
//! PROGRAM is the program for a Pico or a Pico 2, or a UF2 with the program and another model.

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

use boards::model::Scene;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel_assets::{Disk, Picture};
use flash_model::{Board, Panel, board, region, uf2, write};

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let bytes = match args[..] {
        [program, panel, model, ref picture @ ..] if picture.len() < 2 => {
            let panel = match panel {
                "st7789" => Panel::St7789,
                "ili9341" => Panel::Ili9341,
                _ => return Err("the panel is st7789 or ili9341".into()),
            };
            let picture = match picture {
                [path] => Some(Picture::decode(&fs::read(path)?)?),
                _ => None,
            };
            let mut notes = Vec::new();
            let program = fs::read(program)?;
            let board = board(&program)?;
            let words = write(model, &Disk, picture.as_ref(), board, panel, &mut notes)?;
            for note in notes {
                eprintln!("{note}");
            }
            uf2(&program, &words)?
        }
        [path, now_ms] => picture(Path::new(path), now_ms.parse()?)?,
        _ => return Err("model PROGRAM PANEL MODEL [PICTURE], or model UF2 MILLISECONDS".into()),
    };
    Ok(io::stdout().write_all(&bytes)?)
}

fn picture(path: &Path, now_ms: u64) -> Result<Vec<u8>, Box<dyn Error>> {
    let bytes = region(&fs::read(path)?, Board::Pico2.flash());
    let words: Vec<u32> = bytes
        .as_chunks()
        .0
        .iter()
        .copied()
        .map(u32::from_le_bytes)
        .collect();
    let scene = Scene::new(&words)?;
    let (width, height) = scene.size();
    let mut pixels = vec![Rgb565::BLACK; (width * height) as usize];
    let mut depths = vec![0; pixels.len()];
    scene.draw(
        now_ms,
        Canvas::new(&mut pixels, width, height)?,
        &mut depths,
    )?;
    let mut picture = format!("P6 {width} {height} 255\n").into_bytes();
    for color in pixels.into_iter().map(Rgb888::from) {
        picture.extend([color.r(), color.g(), color.b()]);
    }
    Ok(picture)
}
