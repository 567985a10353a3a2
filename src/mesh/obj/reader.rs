//! Reads the text of OBJ and MTL files: statements, words, names and numbers.

use embedded_graphics::pixelcolor::Rgb888;

use super::decimal::{Format, decimal};
use crate::Error;

/// Reads text, statement by statement. It also counts the elements of an OBJ text, to check the indices that name them.
///
/// It matches patterns of slices because it runs in the compiler: there, a call to `len` or `get` takes as long as the
/// rest of what a byte needs, and a pattern makes no call.
pub(super) struct Reader<'a> {
    /// What has not been read.
    pub(super) rest: &'a [u8],
    /// The current line, counted from 1.
    line: usize,
    /// How many positions, texture coordinates and normals have been read.
    pub(super) seen: [usize; 3],
    /// How many positions, texture coordinates and normals an index may refer to.
    pub(super) known: [usize; 3],
    /// One more than the greatest index of a position, texture coordinate and normal so far.
    pub(super) named: [usize; 3],
}

/// What follows a word, as a pattern: the end of the text, or one of these bytes, or another that is given.
macro_rules! word_end {
    ($($other:literal)?) => {
        [] | [b' ' | b'\t' | b'\n' | b'\r' | b'\\' | b'#' $(| $other)?, ..]
    };
}
pub(super) use word_end;

/// What follows `start` in a text that begins with it.
const fn after<'a>(mut text: &'a [u8], mut start: &[u8]) -> Option<&'a [u8]> {
    while let [wanted, later @ ..] = start {
        match text {
            [c, rest @ ..] if *c == *wanted => (text, start) = (rest, later),
            _ => return None,
        }
    }
    Some(text)
}

impl<'a> Reader<'a> {
    /// A reader of `text`; `known` says how many elements of each kind an index may refer to.
    pub(super) const fn new(text: &'a [u8], known: [usize; 3]) -> Self {
        // Some programs write a byte-order mark.
        let ([0xEF, 0xBB, 0xBF, rest @ ..] | rest) = text;
        Self {
            rest,
            line: 1,
            seen: [0; 3],
            known,
            named: [0; 3],
        }
    }

    pub(super) const fn error<T>(&self, problem: &'static str) -> Result<T, Error> {
        Err(Error::Obj {
            line: self.line,
            problem,
        })
    }

    /// Skips a line's end, which is LF, CR or both, and a backslash before it, which joins the next line to this one.
    const fn end_line(&mut self) {
        let ([b'\\', rest @ ..] | rest) = self.rest;
        if let [b'\r', b'\n', rest @ ..] | [_, rest @ ..] = rest {
            self.rest = rest;
            self.line += 1;
        }
    }

    /// Skips blanks; returns whether another word of this statement follows.
    pub(super) const fn word(&mut self) -> bool {
        loop {
            match self.rest {
                [b' ' | b'\t', rest @ ..] => self.rest = rest,
                [b'\\', b'\n' | b'\r', ..] => self.end_line(),
                [] | [b'\n' | b'\r' | b'#', ..] => return false,
                _ => return true,
            }
        }
    }

    /// Skips to the end of the statement, across continued lines; a comment, which begins after a blank, ends with its
    /// line.
    pub(super) const fn skip(&mut self, mut comment: bool) {
        loop {
            match self.rest {
                [] | [b'\n' | b'\r', ..] => return,
                [b'\\', b'\n' | b'\r', ..] if !comment => {
                    self.end_line();
                    comment = matches!(self.rest, [b'#', ..]);
                }
                [b' ' | b'\t', b'#', rest @ ..] => (self.rest, comment) = (rest, true),
                [_, rest @ ..] => self.rest = rest,
            }
        }
    }

    /// Moves to the first word of the next statement; returns whether there is one.
    pub(super) const fn begins(&mut self) -> bool {
        while !self.word() {
            self.skip(true);
            if self.rest.is_empty() {
                return false;
            }
            self.end_line();
        }
        true
    }

    /// Whether a statement begins with this word; moves past it if so.
    pub(super) const fn keyword(&mut self, word: &[u8]) -> bool {
        match after(self.rest, word) {
            Some(rest @ word_end!()) => {
                self.rest = rest;
                true
            }
            _ => false,
        }
    }

    /// Reads the numbers up to the end of the statement; returns them and how many there are.
    pub(super) const fn numbers<const MAX: usize>(
        &mut self,
        format: Format,
    ) -> Result<([i32; MAX], usize), Error> {
        let mut numbers = [0; MAX];
        let mut count = 0;
        while self.word() {
            if count == MAX {
                return self.error("too many numbers");
            }
            match decimal(self.rest, format) {
                Ok((bits, rest @ word_end!())) => {
                    numbers[count] = bits;
                    self.rest = rest;
                }
                Ok(_) => return self.error(super::decimal::MALFORMED),
                Err(problem) => return self.error(problem),
            }
            count += 1;
        }
        Ok((numbers, count))
    }

    /// A color of three components from 0 to 1, rounded to the nearest 255th.
    pub(super) const fn rgb(&self, components: [i32; 3]) -> Result<Rgb888, Error> {
        let mut rgb = [0; 3];
        let mut at = 0;
        while at < 3 {
            let bits = components[at];
            if bits < 0 || bits > 1 << 16 {
                return self.error("a color is out of range: it must lie between 0 and 1");
            }
            let rounded = bits.cast_unsigned() * 255 + (1 << 15);
            rgb[at] = (rounded >> 16) as u8;
            at += 1;
        }
        Ok(Rgb888::new(rgb[0], rgb[1], rgb[2]))
    }
}
