//! Progress while a big model loads.

use indicatif::{ProgressBar, ProgressStyle};

/// Files from this size on show their progress, in bytes.
const BIG: usize = 16 << 20;

/// How much of a file has been read, as a bar on the terminal if the file is big.
pub struct Progress(ProgressBar);

impl Progress {
    /// A bar for a file of this size; none if `quiet`.
    pub fn new(bytes: usize, quiet: bool) -> Self {
        if quiet || bytes < BIG {
            return Self(ProgressBar::hidden());
        }
        let bar = ProgressBar::new(bytes as u64);
        if let Ok(style) = ProgressStyle::with_template("reading {bar:40} {bytes} of {total_bytes}")
        {
            bar.set_style(style);
        }
        Self(bar)
    }

    /// Says how many bytes have been read. It is cheap to call it for each `element`: most calls do nothing.
    pub fn set(&self, element: usize, bytes: usize) {
        if element.trailing_zeros() >= 14 {
            self.0.set_position(bytes as u64);
        }
    }

    /// Removes the bar.
    pub fn end(&self) {
        self.0.finish_and_clear();
    }
}
