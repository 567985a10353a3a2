//! Shows the progress of a long task in a line on the terminal.

use std::cell::Cell;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use fixel_assets::{Disk, Files};

use crate::args::Args;

/// The shortest time between two changes of the line.
const PAUSE: Duration = Duration::from_millis(100);

/// A model with at least this number of triangles has a line that shows the current step.
const MANY: usize = 100_000;
/// A file with at least this number of bytes has a line that shows how much of the file has been read.
const BIG: usize = 16 << 20;

/// A line such as "reading: 30 of 120 MB". The line is erased at the end of the task.
pub struct Progress {
    task: &'static str,
    /// Whether the line is shown.
    is_long: bool,
    next: Cell<Instant>,
    is_shown: Cell<bool>,
}

impl Progress {
    /// Begins a task. The line is shown only if the task `is_long` and standard error is a terminal.
    pub fn new(args: &Args, task: &'static str, is_long: bool) -> Self {
        Self {
            task,
            is_long: is_long && !args.quiet && io::stderr().is_terminal(),
            next: Cell::new(Instant::now() + PAUSE),
            is_shown: Cell::new(false),
        }
    }

    /// Shows how much is done.
    pub fn set(&self, done: usize, total: usize, unit: &str) {
        if self.is_long && Instant::now() >= self.next.get() {
            self.next.set(Instant::now() + PAUSE);
            self.show(&format!(": {done} of {total} {unit}"));
        }
    }

    fn show(&self, how_much: &str) {
        self.is_shown.set(true);
        write(&format!("\r{}{how_much}", self.task));
    }
}

/// Shows a step of work on a model with this many triangles, until the result is dropped.
pub fn step(args: &Args, triangles: usize, task: &'static str) -> Progress {
    let line = Progress::new(args, task, triangles >= MANY);
    if line.is_long {
        line.show(" ...");
    }
    line
}

fn write(line: &str) {
    let mut terminal = io::stderr();
    // An error is ignored, because nobody needs the line.
    let _ = terminal
        .write_all(line.as_bytes())
        .and_then(|()| terminal.flush());
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.is_shown.get() {
            // Move back to the start of the line, and erase it.
            write("\r\x1b[K");
        }
    }
}

/// The files of the disk. A line shows the progress while a big model is read.
pub struct Reading(pub Progress);

impl Files for Reading {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        Disk.read(path)
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        Disk.find(path)
    }

    fn progress(&self, done: usize, all: usize) {
        if all >= BIG {
            self.0.set(done >> 20, all >> 20, "MB");
        }
    }
}
