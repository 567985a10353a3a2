//! Build script: links a program for a Cortex-M. Embassy defines the chip's memory.

fn main() {
    println!("cargo::rustc-link-arg-bins=--nmagic");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
}
