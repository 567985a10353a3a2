//! Draws the scene on your computer: `cargo run --example picture > scene.ppm`. Three numbers as arguments set
//! the width, the height and the time in milliseconds. With `--features ball`, it is the other scene.

use std::error::Error;
use std::io::{self, Write};

use boards::scene::{Memory, Scene};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

fn main() -> Result<(), Box<dyn Error>> {
    let numbers: Result<Vec<u32>, _> = std::env::args().skip(1).map(|text| text.parse()).collect();
    let [width, height, now_ms] = match *numbers? {
        [] => [320, 240, 1000],
        [width, height, now_ms] => [width, height, now_ms],
        _ => return Err("expected width, height and time".into()),
    };
    let mut pixels = vec![Rgb565::BLACK; (width * height) as usize];
    let mut canvas = Canvas::new(&mut pixels, width, height)?;
    let (scene, mut memory) = (Scene::new(width, height)?, Memory::new());
    scene.at(now_ms.into(), &mut memory)?.draw(&mut canvas);

    let mut picture = format!("P6 {width} {height} 255\n").into_bytes();
    for color in canvas.pixels().map(Rgb888::from) {
        picture.extend([color.r(), color.g(), color.b()]);
    }
    Ok(io::stdout().write_all(&picture)?)
}
