//! The writer of models for flash says what the other readers say about a file.

#[path = "../../../src/assets/tests/common/kinds.rs"]
mod kinds;

use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};

use fixel_assets::Files;
use flash_model::{Board, Module, write};

struct Memory(HashMap<PathBuf, Vec<u8>>);

impl Files for Memory {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let file = self.0.get(path).cloned();
        file.ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        self.0.contains_key(path).then(|| path.into())
    }
}

#[test]
fn the_writer_says_what_the_other_readers_say() {
    for kind in kinds::all() {
        let name = kind.files[0].0;
        let file = |(name, bytes): &(&str, Vec<u8>)| (PathBuf::from(name), bytes.clone());
        let files = Memory(kind.files.iter().map(file).collect());
        let mut notes = Vec::new();
        let written = write(name, &files, None, Board::Pico, Module::ILI9341, &mut notes);
        let said = written.map(|_| notes);
        let wanted = kind.says.map_err(|why| format!("model {name}: {why}"));
        assert_eq!(said, wanted, "{:?}", kind.files);
    }
}

/// Hidden faces take time, too: on a board, and when the writer looks for the backs that are seen.
#[test]
fn faces_that_cover_the_picture_too_often_are_refused() {
    for (count, is_refused) in [(100, false), (20_000, true)] {
        let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_string() + &"f 1 2 3\n".repeat(count);
        let files = Memory([("same.obj".into(), obj.into_bytes())].into());
        let written = write(
            "same.obj",
            &files,
            None,
            Board::Pico,
            Module::ILI9341,
            &mut Vec::new(),
        );
        let refusal = written.err().unwrap_or_default();
        assert_eq!(
            refusal.contains("at most 50 times"),
            is_refused,
            "{refusal}"
        );
    }
}
