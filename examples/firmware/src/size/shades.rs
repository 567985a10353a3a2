//! Size probe: triangles with every shader of `fixel::shade`, each in its own draw call.
//!
//! No firmware needs all shaders on one canvas. The probe shows an upper limit of their cost.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod probe;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use probe::{HEIGHT, MODEL, PLACE, SKIN, WIDTH, projection};

fn draw(pixels: &mut [Rgb565], depths: &mut [u16], now_ms: u64) -> Result<(), Error> {
    static COLORS: [Rgb565; 2] = [Rgb565::RED, Rgb565::GREEN];
    let spin = Transform::translate(PLACE) * Transform::rotate_y(probe::angle(now_ms));
    let mvp = projection()? * spin;
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
    let skin = Textured::new(&SKIN);
    let mut canvas = Canvas::new(pixels, WIDTH, HEIGHT)?.with_depth(depths)?;
    canvas.clear(Rgb565::BLACK);
    canvas.draw(&MODEL, &mvp, &Flat::new(Rgb565::BLUE));
    canvas.draw(&MODEL, &mvp, &FaceColors::new(&COLORS));
    canvas.draw(&MODEL, &mvp, &Gouraud::new());
    canvas.draw(&MODEL, &mvp, &Flat::<Rgb565>::rgb(Rgb888::RED).lit(sun));
    canvas.draw(
        &MODEL,
        &mvp,
        &Flat::<Rgb565>::rgb(Rgb888::RED).lit_faces(sun),
    );
    canvas.draw(&MODEL, &mvp, &skin);
    canvas.draw(&MODEL, &mvp, &skin.clamped());
    canvas.draw(&MODEL, &mvp, &skin.lit(sun));
    canvas.draw(&MODEL, &mvp, &skin.tinted());
    Ok(())
}

#[cfg(not(target_os = "none"))]
fn main() {
    probe::host();
}
