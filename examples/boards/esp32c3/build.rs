//! Build script: links with esp-hal's memory layout and sections.

fn main() {
    println!("cargo::rustc-link-arg-bins=-Tlinkall.x");
}
