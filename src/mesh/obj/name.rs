//! Names of materials and of files, as places in a text.

use super::decimal::byte;

/// A name: where it starts in its text, and where it ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name {
    pub(super) start: usize,
    pub(super) end: usize,
}

impl Name {
    pub(super) const EMPTY: Self = Self { start: 0, end: 0 };

    pub(super) const fn len(self) -> usize {
        self.end - self.start
    }

    /// Whether this name in `text` is the same as `other` in `names`.
    pub(super) const fn is(self, text: &[u8], other: Self, names: &[u8]) -> bool {
        if self.len() != other.len() {
            return false;
        }
        let mut at = 0;
        while at < self.len() {
            if text[self.start + at] != names[other.start + at] {
                return false;
            }
            at += 1;
        }
        true
    }

    /// The bytes of this name in `text`.
    pub(super) const fn bytes(self, text: &[u8]) -> &[u8] {
        text.split_at(self.start).1.split_at(self.len()).0
    }

    /// What follows the last blank in this name: a file after its options.
    pub(super) const fn last_word(self, text: &[u8]) -> Self {
        let mut start = self.end;
        while start > self.start && !matches!(byte!(text, start - 1), b' ' | b'\t') {
            start -= 1;
        }
        Self { start, ..self }
    }
}
