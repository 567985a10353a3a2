//! What fuzzing found worth keeping, once more.
//!
//! tests/fuzz/README.md tells how these inputs came about.

// f64 holds every integer used here, and no pixel is left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

#[path = "accuracy/bounds.rs"]
#[allow(dead_code)] // of each a part is used
mod bounds;
mod fuzzed;
#[path = "accuracy/mode.rs"]
#[allow(dead_code)]
mod mode;
#[path = "accuracy/moves.rs"]
#[allow(dead_code)]
mod moves;
#[path = "common/recorder.rs"]
mod recorder;
#[path = "reference/mod.rs"]
mod reference;

use std::panic;

use base64::prelude::{BASE64_STANDARD, Engine};

/// Checks each input, one in base64 a line; fails with those that do.
fn replay(inputs: &str, check: fn(&[u8])) {
    let fails = |line: &&str| {
        let input = BASE64_STANDARD.decode(line).unwrap();
        panic::catch_unwind(|| check(&input)).is_err()
    };
    let failed: Vec<&str> = inputs.lines().filter(fails).collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn what_failed_once() {
    replay(include_str!("fuzzed/mended.base64"), fuzzed::draw::check);
}

#[test]
fn draw() {
    replay(include_str!("fuzzed/draw.base64"), fuzzed::draw::check);
}

#[test]
fn obj() {
    replay(include_str!("fuzzed/obj.base64"), fuzzed::obj::check);
}
