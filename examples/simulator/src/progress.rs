//! Shows the progress of a long task in a line on the terminal.

use std::cell::{Cell, OnceCell};
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use fixel_assets::{Disk, Files};

use crate::args::Args;

/// The least time between two changes of the line.
const PAUSE: Duration = Duration::from_millis(100);

/// A line such as "reading: 30 of 120 MB", which is erased at the end.
pub struct Progress {
    task: &'static str,
    unit: &'static str,
    /// The number of units in the task; 0 to show nothing.
    total: u64,
    next: Cell<Instant>,
    is_shown: Cell<bool>,
}

impl Progress {
    /// Begins a task of `total` units; it is shown only if it `is_long` and standard error is a terminal.
    pub fn new(task: &'static str, total: u64, unit: &'static str, is_long: bool) -> Self {
        Self {
            task,
            unit,
            total: if is_long && io::stderr().is_terminal() {
                total
            } else {
                0
            },
            next: Cell::new(Instant::now() + PAUSE),
            is_shown: Cell::new(false),
        }
    }

    /// Says how much is done.
    pub fn set(&self, done: u64) {
        if self.total == 0 || Instant::now() < self.next.get() {
            return;
        }
        self.next.set(Instant::now() + PAUSE);
        self.is_shown.set(true);
        let Self {
            task, unit, total, ..
        } = self;
        write(&format!("\r{task}: {done} of {total} {unit}"));
    }
}

fn write(line: &str) {
    let mut terminal = io::stderr();
    // An error does not matter: nobody needs the line.
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

/// Shows a step of work on a model of many triangles, until the result is dropped.
pub fn step(args: &Args, triangles: usize, task: &'static str) -> Progress {
    let is_long = triangles >= MANY && !args.quiet;
    let line = Progress::new(task, 1, "", is_long);
    if line.total > 0 {
        line.is_shown.set(true);
        write(&format!("\r{task} ..."));
    }
    line
}

/// Models of this many triangles show what is done with them.
const MANY: usize = 100_000;

/// Models from this size on show their progress, in bytes.
const BIG: usize = 16 << 20;

/// The files of the disk, with a line of progress while a big model is read.
pub struct Reading {
    quiet: bool,
    line: OnceCell<Progress>,
}

impl Reading {
    /// Shows nothing if `quiet`.
    pub fn new(quiet: bool) -> Self {
        Self {
            quiet,
            line: OnceCell::new(),
        }
    }
}

impl Files for Reading {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        Disk.read(path)
    }

    fn has(&self, path: &Path) -> bool {
        Disk.has(path)
    }

    fn progress(&self, done: usize, all: usize) {
        let line = self.line.get_or_init(|| {
            let is_long = all >= BIG && !self.quiet;
            Progress::new("reading", all as u64 >> 20, "MB", is_long)
        });
        line.set(done as u64 >> 20);
    }
}
