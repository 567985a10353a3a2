//! Helpers for the tests of several formats.

#![allow(dead_code)] // Each test binary uses only some of these helpers.

use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};

use fixel_assets::{Files, Model};

/// Files in memory.
pub struct Memory(pub HashMap<PathBuf, Vec<u8>>);

impl Files for Memory {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let file = self.0.get(path).cloned();
        file.ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn has(&self, path: &Path) -> bool {
        self.0.contains_key(path)
    }
}

/// Reads the model in the first of several files. Each file is given by its name and contents.
pub fn read<T: AsRef<[u8]>>(files: &[(&str, T)]) -> Result<Model, String> {
    let file = |(name, bytes): &(&str, T)| (name.into(), bytes.as_ref().to_vec());
    let memory = Memory(files.iter().map(file).collect());
    fixel_assets::read(Path::new(files[0].0), &memory)
}

/// The notes of the reader, as a list.
pub fn notes(model: &Model) -> Vec<String> {
    model.notes.iter().collect()
}

/// A copy of the bytes, with some bytes replaced, removed or repeated, differently for each `seed`.
pub fn mutated(bytes: &[u8], seed: u64) -> Vec<u8> {
    let mut state = seed;
    let mut random = |most: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005);
        state = state.wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 33).unwrap() % most.max(1)
    };
    let mut bytes = bytes.to_vec();
    for _ in 0..=random(8) {
        let at = random(bytes.len());
        let end = (at + random(20)).min(bytes.len());
        match random(4) {
            0 => bytes[at..end].fill(b"0#/-\n e.9\xff\0,"[random(12)]),
            1 => drop(bytes.drain(at..end)),
            2 => bytes.extend_from_within(at..end),
            _ => bytes.truncate(end.max(bytes.len() / 2)),
        }
    }
    bytes
}
