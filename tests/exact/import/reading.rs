//! Helpers that read OBJ text into meshes.

use fixel::mesh::{Counts, obj};
use fixel::prelude::*;

use super::owned::Owned;

pub fn read(text: &str) -> Result<Owned, Error> {
    let counts = obj::count(text.as_bytes())?;
    let owned = Owned::read(text.as_bytes(), counts)?;
    // Duplicate edges are counted before they are removed.
    let edges = owned.counts.edges;
    assert_eq!(owned.counts, Counts { edges, ..counts });
    Ok(owned)
}

pub fn ok(text: &str) -> Owned {
    read(text).unwrap()
}

/// Checks that reading fails at this line, with a problem that contains this word.
pub fn fails(text: &str, line: usize, word: &str) {
    match read(text) {
        Err(Error::Obj {
            line: at, problem, ..
        }) => {
            assert_eq!(at, line, "{problem}");
            assert!(problem.contains(word), "{problem}");
        }
        other => panic!("{text:?} gave {other:?}"),
    }
}

/// The four corners of a unit square.
pub const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
