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
