//! Draws frames on a desktop computer. valgrind counts their instructions for `.ci/host`.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::Drawn;
use fixel::prelude::*;

use super::common::scenes::{self, HEIGHT, POSES, WIDTH};
use super::painter;

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// Calls `draw`, which makes a draw call. Callgrind counts the instructions in functions with this name.
#[inline(never)]
fn only_drawing(draw: impl FnOnce() -> Drawn) {
    let _ = draw();
}

/// Draws all poses of a scene in the default mode.
fn draw(scene: &str) -> Result<(), Error> {
    let (mut colors, mut depths) = (vec![Rgb565::BLACK; PIXELS], vec![0; PIXELS]);
    let options = DrawOptions::new();
    for pose in 0..POSES {
        colors.fill(Rgb565::BLACK);
        depths.fill(0);
        let mut flat = Canvas::new(&mut colors, WIDTH, HEIGHT)?;
        if scene == "sphere-flat" {
            let mvp = scenes::sphere_mvp(pose)?;
            only_drawing(|| scenes::sphere_flat(&mut flat, &options, &mvp));
            continue;
        }
        let mut canvas = flat.with_depth(&mut depths)?;
        match scene {
            "floor" => {
                let mvp = scenes::floor_mvp(pose)?;
                only_drawing(|| scenes::floor(&mut canvas, &options, &mvp));
            }
            "cube" => {
                let mvp = scenes::cube_mvp(pose)?;
                only_drawing(|| scenes::cube(&mut canvas, &options, &mvp));
            }
            _ => {
                let mvp = scenes::sphere_mvp(pose)?;
                only_drawing(|| scenes::sphere(&mut canvas, &options, &mvp));
            }
        }
    }
    Ok(())
}

pub fn main() -> Result<(), Error> {
    let scene = std::env::args().nth(1).unwrap_or_default();
    if ["floor", "cube", "sphere", "sphere-flat"].contains(&scene.as_str()) {
        return draw(&scene);
    }
    if scene == "painter" {
        let (name, way) = (std::env::args().nth(2), std::env::args().nth(3));
        let is_chosen = |scene: &str| name.as_deref().is_none_or(|name| name == scene);
        let mut scenes = painter::SCENES.into_iter().filter(|scene| is_chosen(scene));
        return scenes.try_for_each(|scene| painter::run(scene, way.as_deref()));
    }
    println!("On a microcontroller, kernels measures: add --target thumbv7em-none-eabi.");
    println!("On the host, it draws the poses of a scene: floor, cube, sphere or sphere-flat.");
    Ok(())
}
