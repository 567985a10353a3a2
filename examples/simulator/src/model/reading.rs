//! Progress while a big model loads.

use crate::progress::Progress;

/// Models from this size on show their progress, in bytes.
const BIG: usize = 16 << 20;

/// How much of a model has been read.
pub struct Reading(Progress);

impl Reading {
    /// Begins to read this number of bytes; shows nothing if `quiet`.
    pub fn new(bytes: usize, quiet: bool) -> Self {
        let megabytes = bytes as u64 >> 20;
        Self(Progress::new(
            "reading",
            megabytes,
            "MB",
            bytes >= BIG && !quiet,
        ))
    }

    /// Sets how many bytes have been read. It may be called for each `element`, because most calls do nothing.
    pub fn set(&self, element: usize, bytes: usize) {
        if element.trailing_zeros() >= 14 {
            self.0.set(bytes as u64 >> 20);
        }
    }
}
