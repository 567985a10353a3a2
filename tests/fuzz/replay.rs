//! Replays the inputs that fuzzing found worth keeping.
//!
//! tests/fuzz/README.md explains where these inputs come from.

use std::panic;

use base64::prelude::{BASE64_STANDARD, Engine};

/// Checks all inputs, one per line in base64. With `copies`, also checks this number of damaged copies of each input, and
/// its shortest beginnings. Panics with a list of the inputs that fail.
fn replay(inputs: &str, check: fn(&[u8]), copies: u64) {
    let fails = |(number, line): &(u64, &str)| {
        let input = BASE64_STANDARD.decode(line).unwrap();
        let seeds = number * copies..(number + 1) * copies;
        panic::catch_unwind(|| {
            check(&input);
            seeds.for_each(|seed| check(&damaged(input.clone(), seed)));
            let short = input.len().min(if copies > 0 { 24 } else { 0 });
            (0..short).for_each(|end| check(&input[..end]));
        })
        .is_err()
    };
    let failed: Vec<_> = (0..).zip(inputs.lines()).filter(fails).collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

/// Replaces, removes or repeats some bytes, differently for each `seed`.
fn damaged(mut bytes: Vec<u8>, seed: u64) -> Vec<u8> {
    let mut state = seed;
    let mut random = |most: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005);
        state = state.wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 33).unwrap() % most.max(1)
    };
    for _ in 0..=random(8) {
        let at = random(bytes.len());
        let end = (at + random(20)).min(bytes.len());
        match random(5) {
            0 => bytes[at..end].fill(b"0#/-\n e.9\xff\0,"[random(12)]),
            1 => bytes[at..end]
                .iter_mut()
                .for_each(|byte| *byte ^= 1 << random(8)),
            2 => drop(bytes.drain(at..end)),
            3 => bytes.extend_from_within(at..end),
            _ => bytes.truncate(end.max(bytes.len() / 2)),
        }
    }
    bytes
}

#[test]
fn inputs_that_once_failed_pass() {
    replay(include_str!("mended.base64"), fuzz::draw::check, 0);
}

#[test]
fn kept_draw_inputs_pass() {
    replay(include_str!("kept_draw.base64"), fuzz::draw::check, 0);
}

#[test]
fn kept_models_pass_and_damaged_ones_do_no_harm() {
    let inputs = include_str!("kept_model.base64");
    replay(inputs, fuzz::import::model, 8);
}

#[test]
fn kept_pictures_pass_and_damaged_ones_do_no_harm() {
    let inputs = include_str!("kept_picture.base64");
    replay(inputs, fuzz::import::picture, 20);
}
