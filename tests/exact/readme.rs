//! README shows the program of examples/rings.rs.

#[test]
fn readme_shows_the_example() {
    let readme = include_str!("../../README.md");
    let (_, shown) = readme.split_once("```rust,no_run\n").unwrap();
    let (shown, _) = shown.split_once("```").unwrap();
    assert_eq!(shown, include_str!("../../examples/rings.rs"));
}
