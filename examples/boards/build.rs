//! Build script: links a board's program with the scripts of its chip.

use std::env::var_os;

fn main() {
    let has = |board| var_os(format!("CARGO_FEATURE_{board}")).is_some();
    if has("ESP32C3") {
        println!("cargo::rustc-link-arg-bins=-Tlinkall.x"); // of esp-hal
    } else if has("PICO") || has("EMBASSY") || has("STM32F4") {
        println!("cargo::rustc-link-arg-bins=--nmagic");
        println!("cargo::rustc-link-arg-bins=-Tlink.x"); // of cortex-m-rt
    }
    if has("MODEL") && has("PICO") {
        // A small file, because the playground loads it.
        println!("cargo::rustc-link-arg-bin=pico_model=--strip-all");
    }
    if has("PICO") || has("EMBASSY") {
        // Not beside Cargo.toml: linkers look there first, and Embassy defines the memory of an STM32.
        let folder = if has("MODEL") { "pico/model" } else { "pico" };
        println!(
            "cargo::rustc-link-search={}/{folder}",
            env!("CARGO_MANIFEST_DIR")
        );
        println!("cargo::rerun-if-changed={folder}/memory.x");
    }
}
