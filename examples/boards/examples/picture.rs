//! Draws the scene on your computer: `cargo run --example picture > scene.ppm`. Three numbers as arguments set
//! the width, the height and the time in milliseconds. With `--features ball`, it is the other scene. With a text in
//! place of the time, the picture is what a Pico's display shows of a panic with this text.

use std::error::Error;
use std::fmt::Write as _;
use std::io::{self, Write};

use boards::report::Report;
use boards::scene::{Memory, Scene};
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
    let mut canvas = Canvas::new(&mut pixels, width, height)?;
    if let Ok(now_ms) = what.parse() {
        let (scene, mut memory) = (Scene::new(width, height)?, Memory::new());
        scene.at(now_ms, &mut memory)?.draw(&mut canvas);
    } else {
        let mut report = Report::new((width, height));
        report.write_str(what)?;
        report.draw(&mut canvas);
    }

    let mut picture = format!("P6 {width} {height} 255\n").into_bytes();
    for color in canvas.pixels().map(Rgb888::from) {
        picture.extend([color.r(), color.g(), color.b()]);
    }
    Ok(io::stdout().write_all(&picture)?)
}
