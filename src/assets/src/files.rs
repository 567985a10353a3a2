//! Where the importer finds files.

use std::cell::Cell;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// The files that the importer may read: files on the disk, or files from any other source.
pub trait Files {
    /// The contents of a file.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// The path of the file, or of a file whose path differs only in upper and lower case; `None` if there is neither.
    fn find(&self, path: &Path) -> Option<PathBuf>;

    /// Called now and then while a model is read: `done` of its `all` bytes have been read.
    fn progress(&self, _done: usize, _all: usize) {}
}

/// The files on the disk.
#[derive(Clone, Copy, Debug)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        // A pipe or a device may have no end, or may wait forever.
        let kind = fs::metadata(path)?.file_type();
        if !kind.is_file() && !kind.is_dir() {
            return Err(io::Error::other("it is a pipe or a device, not a file"));
        }
        fs::read(path)
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        in_any_case(path).filter(|path| path.is_file())
    }
}

/// The path of a file or a folder that exists: the given path, or else a path that differs only in case.
fn in_any_case(path: &Path) -> Option<PathBuf> {
    if path.exists() {
        return Some(path.into());
    }
    let lower = |name: &OsStr| name.to_string_lossy().to_lowercase();
    let mut found = PathBuf::new();
    for part in path.components() {
        let exact = found.join(part);
        if exact.exists() {
            found = exact;
            continue;
        }
        let wanted = lower(part.as_os_str());
        let entries = fs::read_dir(Path::new(".").join(&found)).ok()?.flatten();
        let names = entries.map(|entry| entry.file_name());
        found.push(names.filter(|name| lower(name) == wanted).min()?);
    }
    Some(found)
}

/// At most this many names are searched for in folders: a search can read whole folders.
pub const SEARCHES: usize = 4096;

/// The folder of a model, and the files in it.
#[derive(Clone, Copy)]
pub struct Folder<'a> {
    pub files: &'a dyn Files,
    pub path: &'a Path,
    /// The folder of the file that names others, if the model's own file does not name them.
    pub own: Option<&'a Path>,
    /// The model's size in bytes.
    pub all: usize,
    /// How many names can still be searched for.
    pub searches: &'a Cell<usize>,
}

impl Folder<'_> {
    /// The path of a file whose name stands in a model or in its materials. First the name is looked for in the folder
    /// of the file that contains it, and in the model's folder; then, because the model may come from another computer,
    /// only the last part of the name; and then the same names in another case. If nothing is found, returns the last
    /// part of the name in the model's folder.
    pub fn beside(&self, name: &str) -> PathBuf {
        let name = name.replace('\\', "/");
        let last = name.rsplit('/').next().unwrap_or(&name);
        let searches = self.searches.get();
        self.searches.set(searches.saturating_sub(1));
        if searches == 0 {
            return self.path.join(name);
        }
        let folders = self.own.into_iter().chain([self.path]);
        let both = |name| folders.clone().map(move |folder| folder.join(name));
        let paths: Vec<PathBuf> = both(name.as_str()).chain(both(last)).collect();
        let found: Vec<_> = paths.iter().map(|path| self.files.find(path)).collect();
        let exact = paths.iter().zip(&found);
        let exact = exact.filter(|(path, found)| found.as_ref() == Some(path));
        let exact = exact.map(|(path, _)| path.clone()).next();
        let found = exact.or_else(|| found.into_iter().flatten().next());
        found.unwrap_or_else(|| self.path.join(last))
    }

    /// Reports that `bytes` bytes have been read. Readers can call this for each `element`, because most calls do
    /// nothing.
    pub fn progress(&self, element: usize, bytes: usize) {
        if element.trailing_zeros() >= 14 {
            self.files.progress(bytes, self.all);
        }
    }
}
