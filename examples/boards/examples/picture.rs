//! Draws the scene on your computer: `cargo run --example picture > scene.ppm`. Three numbers as arguments set
//! the width, the height and the time in milliseconds. With `--features ball` or `--features world`, it is another scene.
//! With a text in place of the time, the picture is what a Pico's display shows of a panic with this text.

use std::error::Error;
use std::fmt::Write as _;
use std::io::{self, Write};

use boards::report::Report;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (width, height, what) = match args.as_slice() {
        [] => (320, 240, "1000"),
        [width, height, what] => (width.parse()?, height.parse()?, what.as_str()),
        _ => return Err("expected width, height, and a time or a text".into()),
    };
    let mut pixels = vec![Rgb565::BLACK; (width * height) as usize];
    if let Ok(now_ms) = what.parse() {
        draw(now_ms, &mut pixels, (width, height))?;
    } else {
        let mut report = Report::new((width, height));
        report.write_str(what)?;
        report.draw(&mut Canvas::new(&mut pixels, width, height)?);
    }

    let mut picture = format!("P6 {width} {height} 255\n").into_bytes();
    for color in pixels.into_iter().map(Rgb888::from) {
        picture.extend([color.r(), color.g(), color.b()]);
    }
    Ok(io::stdout().write_all(&picture)?)
}

#[cfg(not(feature = "world"))]
fn draw(
    now_ms: u64,
    pixels: &mut [Rgb565],
    (width, height): (u32, u32),
) -> Result<(), fixel::Error> {
    use boards::scene::{Memory, Scene};
    let (scene, mut memory) = (Scene::new(width, height)?, Memory::new());
    let mut canvas = Canvas::new(pixels, width, height)?;
    scene.at(now_ms, &mut memory)?.draw(&mut canvas);
    Ok(())
}

#[cfg(feature = "world")]
fn draw(
    now_ms: u64,
    pixels: &mut [Rgb565],
    (width, height): (u32, u32),
) -> Result<(), fixel::Error> {
    let mut depths = vec![0; pixels.len()];
    let canvas = Canvas::new(pixels, width, height)?;
    boards::walk::draw(now_ms, &mut canvas.with_depth(&mut depths)?)
}
