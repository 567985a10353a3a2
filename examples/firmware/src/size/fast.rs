//! Size probe: textured triangles with a depth buffer, in mode `Fast`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;
mod with_depth;

use fixel::mode::Fast;

probe!(|pixels, depths, now_ms| with_depth::draw(
    pixels,
    depths,
    now_ms,
    Fast::within(fixel::fx!(0.25))
));
