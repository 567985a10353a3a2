//! Size probe: textured triangles with a depth buffer, in mode `Affine`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;
mod with_depth;

use fixel::mode::Affine;

probe!(|pixels, depths, now_ms| with_depth::draw(pixels, depths, now_ms, Affine));
