//! Build script of programs for emulated boards: links them with the runtime crate's script and memory.x.
//!
//! It is not in .cargo/config.toml because the settings there also hold for the projects in boards/, which have
//! memories and scripts of their own.

use std::env::var;

/// Prints what the linker needs.
pub fn main() {
    println!("cargo::rerun-if-changed=../../memory.x");
    if var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        if var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "riscv32") {
            println!("cargo::rustc-link-arg-bins=-Tmemory.x");
        }
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
}
