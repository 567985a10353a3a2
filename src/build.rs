//! The build script: tells `num/wide.rs` which products the target's core has.
//!
//! This file is not a module of the library. Stable Rust has no `cfg` that tells Cortex-M23 from Cortex-M33, or
//! Cortex-M3 from Cortex-M4; only the target's name does.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=src/build.rs");
    println!("cargo::rustc-check-cfg=cfg(narrow_core, dsp_core)");
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
