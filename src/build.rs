//! The build script. It tells the folder `num/wide` which multiplications the target's core has. It also sets
//! `for_size` if the program is optimized for size. Functions that are otherwise copied into their callers for speed
//! are then not copied.
//!
//! This file is not a module of the library. Stable Rust has no `cfg` that tells Cortex-M23 from Cortex-M33, or
//! Cortex-M3 from Cortex-M4; only the target's name does.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=src/build.rs");
    println!("cargo::rustc-check-cfg=cfg(narrow_core, dsp_core, for_size)");
    // The optimizer copies functions that it considers short into all callers, even if it optimizes for size.
    if env::var("OPT_LEVEL").is_ok_and(|level| level == "s" || level == "z") {
        println!("cargo::rustc-cfg=for_size");
    }
    // Armv6-M (Cortex-M0, M0+, M1) and the baseline of Armv8-M (Cortex-M23).
    let target = env::var("TARGET").unwrap_or_default();
    if target.starts_with("thumbv6m") || target.starts_with("thumbv8m.base") {
        println!("cargo::rustc-cfg=narrow_core");
    }
    // Cortex-M4 and M7.
    if target.starts_with("thumbv7em") {
        println!("cargo::rustc-cfg=dsp_core");
    }
}
