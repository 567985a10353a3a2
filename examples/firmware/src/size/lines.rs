//! Size probe: points and lines of one color each.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;
use probe::MODEL;

probe!(
    |pixels, _, now_ms| probe::draw(pixels, now_ms, |canvas, mvp| {
        let (green, white) = (Flat::new(Rgb565::GREEN), Flat::new(Rgb565::WHITE));
        canvas.draw(MODEL.edges(LineStyle::HAIRLINE), mvp, &green);
        canvas.draw(MODEL.points(PointStyle::PIXEL), mvp, &white);
    })
);
