//! Text that is not a model, and the messages about it.

use fixel::mesh::{Buffers, obj};
use fixel::prelude::*;
use rand::seq::IndexedRandom;

use super::reading::{SQUARE, fails};
use crate::common::random::{cases, list};

#[test]
fn malformed_numbers_are_refused() {
    for text in [
        "", "x", ".", "+", "-", "--1", "1e", "1e+", "e1", "1.2.3", "1,5", "nan", "inf", "0x1",
        "1f", "1\\2", "é",
    ] {
        fails(
            &format!("\n\nv 1 0 {text}"),
            3,
            if text.is_empty() {
                "3 numbers"
            } else {
                "malformed"
            },
        );
    }
}

#[test]
fn errors_name_their_line() {
    let first_at_5 = |rest: &str, word| fails(&format!("{SQUARE}{rest}"), 5, word);
    first_at_5("f 0 1 2", "0");
    first_at_5("f 1 2 -0", "0");
    first_at_5("f 1 2 5", "position that does not exist");
    first_at_5("f 1 2 -5", "position that does not exist");
    first_at_5("f 1 2 99999999999999999999", "position that does not exist");
    first_at_5("f 1/1 2 3", "texture coordinate that does not exist");
    first_at_5("f 1//-1 2 3", "normal that does not exist");
    first_at_5("f", "3 corners");
    first_at_5("f 1 2", "3 corners");
    first_at_5("l 1", "2 ends");
    first_at_5("l", "2 ends");
    first_at_5("f 1 2 x", "corner is malformed");
    first_at_5("f 1 2 3/1/1/1", "corner is malformed");
    first_at_5("f 1 2 3.5", "corner is malformed");
    first_at_5("f 1 2 /3", "corner is malformed");
    first_at_5("f 1 2 +3", "corner is malformed");
    first_at_5("v 1 2", "3 numbers");
    first_at_5("v 1 2 3 4 5", "3 numbers");
    first_at_5("v 1 2 3 4 5 6 7 8", "too many");
    first_at_5("v 1 2 3 0 0 1.1", "color");
    first_at_5("v 1 2 3 0 -0.1 1", "color");
    first_at_5("vt", "2 numbers");
    first_at_5("vn 1 2", "3 numbers");
    first_at_5("vn 1 2 3 4", "too many");
    // An element may follow its index, so the index is a mistake only if the whole text is right. No element has the
    // greatest one.
    fails(&format!("{SQUARE}f 1 2 65536\nv 0"), 6, "3 numbers");
    first_at_5("f 1 2 65537\nv 0", "position that does not exist");
    first_at_5("f 1 2 -5\nv 0", "position that does not exist");
    // In a statement that spans several lines, an error names the line where it occurs. A backslash does not continue a
    // comment.
    fails("# a\\\nv 0 0\\\n", 3, "3 numbers");
    fails("\r\n\r\nv", 3, "3 numbers");
    fails("\r\rv", 3, "3 numbers");
}

/// No input causes a panic.
#[test]
fn no_bytes_cause_a_panic() {
    cases(256, |random| {
        let bytes = list(random, 0..200, |random| {
            let characters = b"vvftnl 0123456789./-+eE\\\r\n\n#\t\xff";
            *characters.choose(random).unwrap()
        });
        if let Ok(counts) = obj::count(&bytes) {
            let mut positions = vec![Vec3::ZERO; counts.positions];
            let mut faces = vec![[0; 3]; counts.faces];
            let mut edges = vec![[0; 2]; counts.edges];
            let mut buffers = Buffers::new(&mut positions, &mut faces);
            buffers.edges = &mut edges;
            let _ = obj::parse(&bytes, buffers);
        }
    });
}
