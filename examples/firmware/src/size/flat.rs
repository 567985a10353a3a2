//! Size probe: triangles of one color.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;
use probe::MODEL;

probe!(
    |pixels, _, now_ms| probe::draw(pixels, now_ms, |canvas, mvp| {
        canvas.draw(&MODEL, mvp, &Flat::new(Rgb565::GREEN));
    })
);
