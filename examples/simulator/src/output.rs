//! Writes outputs to a file (which is complete or does not exist), to standard output, or to a device or pipe.

use std::error::Error;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};

use super::Result;

/// Files that are being written, for [`remove_on_interrupt`].
static PARTIAL: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn partial_files() -> std::sync::MutexGuard<'static, Vec<PathBuf>> {
    PARTIAL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes unfinished files when the user interrupts or terminates the program.
///
/// # Errors
///
/// The system does not let the program handle signals.
pub fn remove_on_interrupt() -> Result<()> {
    ctrlc::set_handler(|| {
        // The lock is kept until the program ends, so that the program begins no other file.
        for path in partial_files().iter() {
            let _ = fs::remove_file(path);
        }
        process::exit(130);
    })
    .map_err(|error| format!("cannot handle interrupts: {error}").into())
}

/// Whether `path` stands for standard output.
pub fn is_stdout(path: &Path) -> bool {
    // Standard output can be a file that the shell opened. Opening the path again would overwrite this file from its
    // start.
    ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].contains(&&*path.to_string_lossy())
}

/// Whether `path` is standard output, a device or a pipe, which is written directly, without an unfinished file.
pub fn is_stream(path: &Path) -> bool {
    // A file that a shell opened, such as /dev/fd/3, must not be replaced.
    let is_special = ["/dev/fd", "/dev/stderr", "/proc"]
        .iter()
        .any(|folder| path.starts_with(folder));
    is_stdout(path)
        || is_special
        || fs::metadata(path).is_ok_and(|is| !is.is_file() && !is.is_dir())
}

/// Refuses an output that is one of the `inputs`, even under another name.
///
/// # Errors
///
/// The message names the output and the input.
pub fn refuse_inputs(output: &Path, inputs: &[PathBuf]) -> Result<()> {
    for input in inputs {
        if !is_stdout(output) && same_file::is_same_file(output, input).unwrap_or(false) {
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
    if is_stdout(a) || is_stdout(b) {
        return is_stdout(a) && is_stdout(b);
    }
    if let Ok(same) = same_file::is_same_file(a, b) {
        return same;
    }
    let folder = |path: &Path| {
        fs::canonicalize(
            path.parent()
                .filter(|path| *path != Path::new(""))
                .unwrap_or(Path::new(".")),
        )
        .ok()
    };
    a.file_name() == b.file_name() && folder(a).is_some() && folder(a) == folder(b)
}

/// An output. [`finish`](Self::finish) gives the unfinished file its final name. Without a call to `finish`, the
/// unfinished file is removed.
#[derive(Debug)]
pub struct Output {
    name: String,
    /// The file, and the unfinished file, which is renamed when it is complete. So nobody ever sees an unfinished file.
    /// `None` for a stream.
    file: Option<(PathBuf, PathBuf)>,
    /// The permissions of the file that is replaced.
    permissions: Option<Permissions>,
    writer: Option<Writer>,
}

#[derive(Debug)]
enum Writer {
    File(BufWriter<File>),
    Stdout(BufWriter<io::Stdout>),
}

impl Output {
    /// Opens `path`.
    ///
    /// # Errors
    ///
    /// The file cannot be created, is read-only, or is a directory.
    pub fn create(path: &Path) -> Result<Self> {
        let name = if is_stdout(path) {
            "standard output".into()
        } else {
            path.display().to_string()
        };
        let refuse = |problem: String| format!("cannot write {name}: {problem}");
        let failed = |error: io::Error| refuse(error.to_string());
        if is_stream(path) {
            let writer = if is_stdout(path) {
                Writer::Stdout(BufWriter::new(io::stdout()))
            } else {
                let file = OpenOptions::new().write(true).open(path).map_err(failed)?;
                Writer::File(BufWriter::new(file))
            };
            return Ok(Self {
                name,
                file: None,
                permissions: None,
                writer: Some(writer),
            });
        }
        // A link stays a link, because the program writes to the link's target.
        let path = match fs::symlink_metadata(path) {
            Ok(link) if link.is_symlink() => target(path).map_err(failed)?,
            _ => path.to_path_buf(),
        };
        let permissions = match fs::metadata(&path) {
            Ok(is) if is.is_dir() => return Err(refuse("it is a directory".into()).into()),
            Ok(is) if is.permissions().readonly() => {
                return Err(refuse("it is read-only".into()).into());
            }
            found => found.ok().map(|is| is.permissions()),
        };
        if path.file_name().is_none() {
            return Err(refuse("it is not a file name".into()).into());
        }
        let partial = path.with_file_name(partial_name());
        let mut files = partial_files();
        let file = File::create_new(&partial).map_err(failed)?;
        files.push(partial.clone());
        Ok(Self {
            name,
            file: Some((path, partial)),
            permissions,
            writer: Some(Writer::File(BufWriter::new(file))),
        })
    }

    /// Returns a function that adds the name of this output to an error.
    pub fn failed(&self) -> impl Fn(Box<dyn Error>) -> Box<dyn Error> + use<> {
        let name = self.name.clone();
        move |error| format!("cannot write {name}: {error}").into()
    }

    /// Gives the unfinished file its final name.
    ///
    /// # Errors
    ///
    /// The file cannot be written or renamed.
    pub fn finish(mut self) -> Result<()> {
        let failed = self.failed();
        let mut finish = || {
            self.flush()?;
            self.writer = None;
            if let Some((path, partial)) = &self.file {
                if let Some(permissions) = self.permissions.take() {
                    fs::set_permissions(partial, permissions)?;
                }
                fs::rename(partial, path)?;
            }
            Ok(())
        };
        finish().map_err(|error: io::Error| failed(error.into()))
    }
}

/// Makes a name for an unfinished file. The name is short enough for any file system.
fn partial_name() -> String {
    static COUNT: AtomicU32 = AtomicU32::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    format!(".fixel-{}-{count}.partial", process::id())
}

/// The file to which a link points. The file may not exist.
fn target(link: &Path) -> io::Result<PathBuf> {
    match fs::canonicalize(link) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let target = fs::read_link(link)?;
            Ok(link.parent().unwrap_or(Path::new("")).join(target))
        }
        found => found,
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.writer {
            Some(Writer::File(file)) => file.write(bytes),
            Some(Writer::Stdout(stdout)) => stdout.write(bytes),
            None => Ok(0),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.writer {
            Some(Writer::File(file)) => file.flush(),
            Some(Writer::Stdout(stdout)) => stdout.flush(),
            None => Ok(()),
        }
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        self.writer = None;
        if let Some((_, partial)) = &self.file {
            let mut files = partial_files();
            // After `finish`, the unfinished file has been renamed, so this removes nothing.
            let _ = fs::remove_file(partial);
            files.retain(|path| path != partial);
        }
    }
}
