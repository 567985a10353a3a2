//! Size probe: every stage of the pipeline once, in the default mode.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;
mod whole;

use fixel::mode::Newton;

probe!(|pixels, depths, now_ms| whole::draw(pixels, depths, now_ms, Newton));
