//! Notes about what a reader replaced or left out.

/// At most this many different sentences are kept, and at most this many names. Without a limit, a file could cause any
/// number of both.
const MOST: usize = 32;

/// Sentences for the user about what was replaced or left out. Equal sentences are kept once, with a count.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Notes {
    sentences: Vec<(String, usize)>,
    others: usize,
    left_out: Vec<String>,
}

impl Notes {
    /// Adds a sentence. A sentence that has been added before is only counted.
    pub fn add(&mut self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        let is_full = self.sentences.len() == MOST;
        match self
            .sentences
            .iter_mut()
            .find(|(other, _)| *other == sentence)
        {
            Some((_, times)) => *times += 1,
            None if is_full => self.others += 1,
            None => self.sentences.push((sentence, 1)),
        }
    }

    /// Adds the name of something in the file that is not drawn. All names share one sentence.
    pub fn left_out(&mut self, feature: impl Into<String>) {
        let feature = feature.into();
        if self.left_out.len() < MOST && !self.left_out.contains(&feature) {
            self.left_out.push(feature);
        }
    }

    /// The sentences, in the order of their first occurrence.
    pub fn iter(&self) -> impl Iterator<Item = String> + '_ {
        let sentences = self.sentences.iter().map(|(sentence, times)| match times {
            1 => sentence.clone(),
            _ => format!("{sentence} ({times} times)"),
        });
        let more = if self.left_out.len() == MOST {
            ", …"
        } else {
            ""
        };
        let left_out = format!("not drawn: {}{more}", self.left_out.join(", "));
        let others = format!("there are {} other notes", self.others);
        sentences
            .chain((self.others > 0).then_some(others))
            .chain((!self.left_out.is_empty()).then_some(left_out))
    }

    /// Whether there is no sentence, only names.
    pub(crate) fn is_quiet(&self) -> bool {
        self.sentences.is_empty()
    }

    /// Whether nothing was replaced or left out.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.sentences.is_empty() && self.left_out.is_empty()
    }
}
