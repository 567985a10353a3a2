//! Where the importer finds files.

use std::io;
use std::path::{Path, PathBuf};

/// The files that the importer may read: files of the disk, or files from any other source.
pub trait Files {
    /// The contents of a file.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// Whether the file exists.
    fn has(&self, path: &Path) -> bool;

    /// Called now and then with the number of a model's bytes that have been read, and the number of all its bytes.
    fn progress(&self, _done: usize, _all: usize) {}
}

/// The files of the disk.
#[derive(Clone, Copy, Debug)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        std::fs::read(path)
    }

    fn has(&self, path: &Path) -> bool {
        path.is_file()
    }
}

/// The folder of a model, and the files in it.
#[derive(Clone, Copy)]
pub struct Folder<'a> {
    pub files: &'a dyn Files,
    pub path: &'a Path,
    /// How many bytes the model has.
    pub all: usize,
}

impl Folder<'_> {
    /// A file that a model names, relative to the model's folder. If it does not exist, for example because the model
    /// comes from another computer, only the last part of its name is used.
    pub fn beside(&self, name: &str) -> PathBuf {
        let name = name.replace('\\', "/");
        let path = self.path.join(&name);
        if self.files.has(&path) {
            return path;
        }
        self.path.join(name.rsplit('/').next().unwrap_or(&name))
    }

    /// Reports how many bytes have been read. Can be called for each `element`, because most calls do nothing.
    pub fn progress(&self, element: usize, bytes: usize) {
        if element.trailing_zeros() >= 14 {
            self.files.progress(bytes, self.all);
        }
    }
}
