//! What a reader replaced or left out.

use std::fmt;

/// Sentences for the user about what was replaced or left out, one for each kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Notes(Vec<(String, usize)>);

impl Notes {
    /// Adds a sentence, or counts it if it is there already.
    pub fn add(&mut self, note: impl Into<String>) {
        let note = note.into();
        match self.0.iter_mut().find(|(other, _)| *other == note) {
            Some((_, times)) => *times += 1,
            None => self.0.push((note, 1)),
        }
    }

    /// The sentences, in the order of their first occurrence.
    pub fn iter(&self) -> impl Iterator<Item = impl fmt::Display + '_> {
        self.0.iter().map(Note)
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

struct Note<'a>(&'a (String, usize));

impl fmt::Display for Note<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (note, times) = self.0;
        f.write_str(note)?;
        match times {
            1 => Ok(()),
            _ => write!(f, " ({times} times)"),
        }
    }
}
