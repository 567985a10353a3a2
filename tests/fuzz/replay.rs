//! Replays the inputs that fuzzing found worth keeping.
//!
//! tests/fuzz/README.md explains where these inputs come from.

use std::panic;

use base64::prelude::{BASE64_STANDARD, Engine};

/// Checks all inputs, one per line in base64. Panics with a list of the inputs that fail.
fn replay(inputs: &str, check: fn(&[u8])) {
    let fails = |line: &&str| {
        let input = BASE64_STANDARD.decode(line).unwrap();
        panic::catch_unwind(|| check(&input)).is_err()
    };
    let failed: Vec<&str> = inputs.lines().filter(fails).collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn inputs_that_once_failed_pass() {
    replay(include_str!("mended.base64"), fuzz::draw::check);
}

#[test]
fn kept_draw_inputs_pass() {
    replay(include_str!("kept_draw.base64"), fuzz::draw::check);
}

#[test]
fn kept_models_pass() {
    replay(include_str!("kept_model.base64"), fuzz::import::model);
}

#[test]
fn kept_pictures_pass() {
    replay(include_str!("kept_picture.base64"), fuzz::import::picture);
}
