//! Writes outputs to a file (which is complete or does not exist), to standard output, or to a device or pipe.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

use super::Result;

/// Whether `path` stands for standard output.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-") || path == Path::new("/dev/stdout")
}

/// Whether `path` is standard output, a device or a pipe.
pub fn is_stream(path: &Path) -> bool {
    is_stdout(path) || fs::metadata(path).is_ok_and(|is| !is.is_file() && !is.is_dir())
}

/// Refuses an output that is one of the `inputs`, even under another name.
///
/// # Errors
///
/// The message names the output and the input.
pub fn refuse_inputs(output: &Path, inputs: &[PathBuf]) -> Result<()> {
    for input in inputs {
        // A pipe must not be opened to compare it: the program would wait for the pipe's other end.
        if !is_stream(output) && same_file::is_same_file(output, input).unwrap_or(false) {
            return Err(format!(
                "cannot write {}: it is an input, {}",
                output.display(),
                input.display()
            )
            .into());
        }
    }
    Ok(())
}

/// Whether two outputs are the same file. The file may not exist yet.
pub fn are_same(a: &Path, b: &Path) -> bool {
    if is_stream(a) || is_stream(b) {
        return a == b || (is_stdout(a) && is_stdout(b));
    }
    if let Ok(same) = same_file::is_same_file(a, b) {
        return same;
    }
    a.file_name() == b.file_name() && same_file::is_same_file(folder(a), folder(b)).unwrap_or(false)
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| *folder != Path::new(""))
        .unwrap_or(Path::new("."))
}

/// An output, kept in memory until it is complete.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    pub bytes: Vec<u8>,
}

impl Output {
    /// Checks `path`, so that no time is wasted on a file that cannot be written. Writes nothing yet.
    ///
    /// # Errors
    ///
    /// The file's folder does not exist, or the file is read-only or a directory.
    pub fn create(path: &Path) -> Result<Self> {
        let refuse =
            |problem: &str| Err(format!("cannot write {}: {problem}", path.display()).into());
        if !is_stdout(path) {
            match fs::metadata(path) {
                Ok(is) if is.is_dir() => return refuse("it is a directory"),
                Ok(is) if is.permissions().readonly() => return refuse("it is read-only"),
                Err(_) if path.file_name().is_none() => return refuse("it is not a file name"),
                Err(_) if !folder(path).is_dir() => return refuse("its folder does not exist"),
                _ => {}
            }
        }
        Ok(Self {
            path: path.into(),
            bytes: Vec::new(),
        })
    }

    /// Writes the output.
    ///
    /// # Errors
    ///
    /// The file cannot be written.
    pub fn finish(self) -> Result<()> {
        let Self { path, bytes } = &self;
        if is_stdout(path) {
            let mut stdout = io::stdout();
            let written = stdout.write_all(bytes).and_then(|()| stdout.flush());
            return written
                .map_err(|error| format!("cannot write standard output: {error}").into());
        }
        write(path, bytes)
            .map_err(|error| format!("cannot write {}: {error}", path.display()).into())
    }
}

/// Writes a file. Nobody ever sees an unfinished file, because it gets its name when it is complete.
fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // A link stays a link, because the program writes to the link's target.
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.into());
    let permissions = match fs::symlink_metadata(path) {
        // A device, a pipe, or a link to a file that does not exist yet.
        Ok(is) if !is.is_file() => return fs::write(path, bytes),
        found => found.ok().map(|is| is.permissions()),
    };
    // This name is short enough for any file system.
    let partial = &path.with_file_name(format!(".fixel-{}.partial", process::id()));
    let mut file = File::create_new(partial)?;
    let written = file
        .write_all(bytes)
        .and_then(|()| permissions.map_or(Ok(()), |as_before| file.set_permissions(as_before)))
        .and_then(|()| fs::rename(partial, path));
    written.inspect_err(|_| drop(fs::remove_file(partial)))
}
