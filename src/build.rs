//! The build script: tells `num/wide.rs` whether the target is a core with products of 32 bits only.
//!
//! This file is not a module of the library. Stable Rust has no `cfg` that tells Cortex-M23 from Cortex-M33; only the
//! target's name does.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=src/build.rs");
    println!("cargo::rustc-check-cfg=cfg(narrow_core)");
    // Armv6-M (Cortex-M0, M0+, M1) and the baseline of Armv8-M (Cortex-M23).
    let target = env::var("TARGET").unwrap_or_default();
    if target.starts_with("thumbv6m") || target.starts_with("thumbv8m.base") {
        println!("cargo::rustc-cfg=narrow_core");
    }
}
