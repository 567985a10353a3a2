//! README shows the program of examples/rings.rs, and badges that are true.

const README: &str = include_str!("../../README.md");
const BADGES: &str = include_str!("../../examples/assets/badges.svg");

#[test]
fn readme_shows_the_example() {
    let (_, shown) = README.split_once("```rust,no_run\n").unwrap();
    let (shown, _) = shown.split_once("```").unwrap();
    assert_eq!(shown, include_str!("../../examples/rings.rs"));
}

/// `.ci/firmware` checks "no FPU needed" and "no alloc" in linked programs, and `.ci/sizes` checks "no panic".
#[test]
fn badges_are_true() {
    let library = include_str!("../../src/lib.rs");
    assert!(library.contains("#![forbid(unsafe_code)]"));
    assert!(library.contains("#![no_std]"));
    let rust = env!("CARGO_PKG_RUST_VERSION");
    assert!(BADGES.contains(&format!(">Rust {rust}+<")));
    assert!(README.contains(&format!("Rust {rust} or later")));
    assert_eq!(env!("CARGO_PKG_LICENSE"), "MIT OR Apache-2.0");
    assert!(BADGES.contains(">MIT or Apache-2.0<"));
}
