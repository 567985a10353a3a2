//! Draws the scene on your computer: `cargo run --example picture > scene.ppm`. Three numbers as arguments set
//! the width, the height and the time in milliseconds. With `--features ball` or `--features world`, it is another scene.

use std::error::Error;
use std::io::{self, Write};

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
    draw(now_ms.into(), &mut pixels, (width, height))?;

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
