//! Size probe: textured triangles.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;

use fixel::prelude::*;
use probe::{MODEL, SKIN};

probe!(
    |pixels, _, now_ms| probe::draw(pixels, now_ms, |canvas, mvp| {
        canvas.draw(&MODEL, mvp, &Textured::new(&SKIN));
    })
);
