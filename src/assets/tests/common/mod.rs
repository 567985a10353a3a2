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

    fn find(&self, path: &Path) -> Option<PathBuf> {
        let lower = |path: &Path| path.to_string_lossy().to_lowercase();
        let mut paths = self.0.keys().filter(|other| lower(other) == lower(path));
        let exact = self.0.contains_key(path).then(|| path.into());
        exact.or_else(|| paths.next().cloned())
    }
}

/// Reads the model in the first of several files. Each file is given by its name and contents.
pub fn read<T: AsRef<[u8]>>(files: &[(&str, T)]) -> Result<Model, String> {
    fixel_assets::read(Path::new(files[0].0), &memory(files))
}

/// Files in memory, each given by its name and contents.
pub fn memory<T: AsRef<[u8]>>(files: &[(&str, T)]) -> Memory {
    let file = |(name, bytes): &(&str, T)| (name.into(), bytes.as_ref().to_vec());
    Memory(files.iter().map(file).collect())
}

/// The notes of the reader, as a list.
pub fn notes(model: &Model) -> Vec<String> {
    model.notes.iter().collect()
}

/// A file in the format RIFF.
pub fn riff(chunks: &[(&[u8; 4], Vec<u8>)]) -> Vec<u8> {
    let mut bytes = b"RIFF\0\0\0\0WEBP".to_vec();
    for (name, data) in chunks {
        bytes.extend(*name);
        bytes.extend(u32::try_from(data.len()).unwrap().to_le_bytes());
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(2), 0);
    }
    let len = u32::try_from(bytes.len() - 8).unwrap();
    bytes[4..8].copy_from_slice(&len.to_le_bytes());
    bytes
}

/// The data of a WebP with loss, of `first` bytes in its first part and `data` in all. A decoder reads bytes of 0 as the
/// answer "no" to every question: there are no details, and all pixels have the value that is predicted without them.
pub fn vp8(side: u16, first: usize, data: usize) -> Vec<u8> {
    let tag = (u32::try_from(first).unwrap() << 5 | 1 << 4).to_le_bytes();
    let [low, high] = side.to_le_bytes();
    let start = [&tag[..3], &[0x9d, 0x01, 0x2a, low, high, low, high]].concat();
    [start, vec![0; data]].concat()
}
