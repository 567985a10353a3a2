//! The build script of programs for emulated boards. The script links these programs with the runtime crate's linker
//! script and memory.x.
//!
//! The linker's arguments are not in .cargo/config.toml, because the settings there also hold for the project in
//! boards/. The chips of that project have their own memories and linker scripts.

use std::env::var;

fn main() {
    println!("cargo::rerun-if-changed=../../memory.x");
    if var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        if var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "riscv32") {
            println!("cargo::rustc-link-arg-bins=-Tmemory.x");
        }
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
}
