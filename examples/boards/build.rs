//! Build script: links a board's program with the scripts of its chip.

use std::env::var_os;

fn main() {
    let has = |board| var_os(format!("CARGO_FEATURE_{board}")).is_some();
    let folder = if has("PICO2") { "pico2" } else { "pico" };
    if has("PICOS") || has("EMBASSY") || has("STM32F4") {
        println!("cargo::rustc-link-arg-bins=--nmagic");
        println!("cargo::rustc-link-arg-bins=-Tlink.x"); // of cortex-m-rt
    }
    if has("MODEL") && has("PICOS") {
        // Where the model begins in flash.
        println!("cargo::rustc-link-arg-bin=pico_model=--defsym=_model=0x10040000");
        // A small file, because the playground loads it.
        println!("cargo::rustc-link-arg-bin=pico_model=--strip-all");
    }
    if has("PICOS") || has("EMBASSY") {
        // Not beside Cargo.toml: linkers look there first, and Embassy defines the memory of an STM32.
        println!(
            "cargo::rustc-link-search={}/{folder}",
            env!("CARGO_MANIFEST_DIR")
        );
        println!("cargo::rerun-if-changed={folder}/memory.x");
    }
}
