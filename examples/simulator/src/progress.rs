//! Shows the progress of a long task in a line on the terminal.

use std::cell::Cell;
use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

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
