//! Where the importer finds files.

use std::io;
use std::path::{Path, PathBuf};

/// The files that the importer may read: files on the disk, or files from any other source.
pub trait Files {
    /// The contents of a file.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// Whether the file exists.
    fn has(&self, path: &Path) -> bool;

    /// Called now and then while a model is read: `done` of its `all` bytes have been read.
    fn progress(&self, _done: usize, _all: usize) {}
}

/// The files on the disk.
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
    /// The model's size in bytes.
    pub all: usize,
}

impl Folder<'_> {
    /// The path of a file that a model names relative to the model's folder. If no such file exists, for example
    /// because the model comes from another computer, the path is the model's folder and the last part of the name.
    pub fn beside(&self, name: &str) -> PathBuf {
        let name = name.replace('\\', "/");
        let path = self.path.join(&name);
        if self.files.has(&path) {
            return path;
        }
        self.path.join(name.rsplit('/').next().unwrap_or(&name))
    }

    /// Reports that `bytes` bytes have been read. Readers can call this for each `element`, because most calls do
    /// nothing.
    pub fn progress(&self, element: usize, bytes: usize) {
        if element.trailing_zeros() >= 14 {
            self.files.progress(bytes, self.all);
        }
    }
}
