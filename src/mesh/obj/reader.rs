//! Reads OBJ text, statement by statement.

use embedded_graphics::pixelcolor::Rgb888;

use super::decimal::{Format, SCALAR, TEX_COORD, decimal, digits};
use crate::error::ok;
use crate::{Error, Mesh, TexCoord, Vec2, Vec3};

/// The indices of a corner, counted from 0.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) position: u16,
    pub(super) uv: Option<u16>,
    pub(super) normal: Option<u16>,
}

/// Reads OBJ text.
///
/// It matches patterns of slices because it runs in the compiler: there, a call to `len` or `get` takes as long as the
/// rest of what a byte needs, and a pattern makes no call.
pub(super) struct Reader<'a> {
    /// What has not been read.
    rest: &'a [u8],
    /// The current line, counted from 1.
    line: usize,
    /// How many positions, texture coordinates and normals have been read.
    seen: [usize; 3],
    /// How many positions, texture coordinates and normals an index may refer to.
    known: [usize; 3],
    /// One more than the greatest index of a position, texture coordinate and normal so far.
    named: [usize; 3],
}

/// The most elements of each kind that 16-bit indices can name; `Mesh::NO_VALUE` takes one index from the attributes.
pub(super) const MOST: [usize; 3] = [
    Mesh::MAX_POSITIONS,
    Mesh::NO_VALUE as usize,
    Mesh::NO_VALUE as usize,
];

const TOO_MANY: [&str; 3] = [
    "more than 65536 positions",
    "more than 65535 texture coordinates",
    "more than 65535 normals",
];

const MALFORMED: &str = "a corner is malformed: it must be like 1, 1/2, 1//3 or 1/2/3";

const NOT_THERE: [&str; 3] = [
    "an index names a position that does not exist",
    "an index names a texture coordinate that does not exist",
    "an index names a normal that does not exist",
];

/// What follows a word, as a pattern: the end of the text, or one of these bytes, or another that is given.
macro_rules! word_end {
    ($($other:literal)?) => {
        [] | [b' ' | b'\t' | b'\n' | b'\r' | b'\\' | b'#' $(| $other)?, ..]
    };
}

/// Whether two names are the same.
pub(super) const fn are_same(a: &str, b: &str) -> bool {
    matches!(after(a.as_bytes(), b.as_bytes()), Some([]))
}

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

    /// How many positions, texture coordinates and normals have been read.
    pub(super) const fn seen(&self) -> [usize; 3] {
        self.seen
    }

    /// Whether an index named an element that the text does not have.
    pub(super) const fn missed(&self) -> bool {
        self.named[0] > self.seen[0] || self.named[1] > self.seen[1] || self.named[2] > self.seen[2]
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
    const fn word(&mut self) -> bool {
        loop {
            match self.rest {
                [b' ' | b'\t', rest @ ..] => self.rest = rest,
                [b'\\', b'\n' | b'\r', ..] => self.end_line(),
                [] | [b'\n' | b'\r' | b'#', ..] => return false,
                _ => return true,
            }
        }
    }

    /// Skips to the end of the statement, across continued lines; a comment ends with its line.
    pub(super) const fn skip(&mut self, comment: bool) {
        loop {
            match self.rest {
                [] | [b'\n' | b'\r', ..] => return,
                [b'\\', b'\n' | b'\r', ..] if !comment => self.end_line(),
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

    /// Reads the rest of the line as a name, which may contain blanks, up to a comment; `problem` says why there must be
    /// one.
    pub(super) const fn name(&mut self, problem: &'static str) -> Result<&'a str, Error> {
        if !self.word() {
            return self.error(problem);
        }
        let text = self.rest;
        let (mut len, mut read) = (0, 0);
        loop {
            match self.rest {
                [] | [b'\n' | b'\r', ..] => break,
                // A comment begins after a blank.
                [b'#', ..] if read > len => break,
                [c, rest @ ..] => {
                    self.rest = rest;
                    read += 1;
                    if !matches!(c, b' ' | b'\t') {
                        len = read;
                    }
                }
            }
        }
        match core::str::from_utf8(text.split_at(len).0) {
            Ok(name) => Ok(name),
            Err(_) => self.error("a name must be UTF-8"),
        }
    }

    /// Counts the words up to the end of the statement.
    pub(super) const fn count_words(&mut self) -> usize {
        let mut count = 0;
        while self.word() {
            count += 1;
            // A word may begin with a backslash.
            while let [_, rest @ ..] = self.rest {
                self.rest = rest;
                if let word_end!() = rest {
                    break;
                }
            }
        }
        count
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

    /// Counts one more element of a kind, and returns its index.
    const fn see(&mut self, kind: usize) -> Result<usize, Error> {
        let index = self.seen[kind];
        if index == MOST[kind] {
            return self.error(TOO_MANY[kind]);
        }
        self.seen[kind] = index + 1;
        Ok(index)
    }

    /// Reads the numbers of `v`: the position, and its color if it has one.
    pub(super) const fn position(&mut self) -> Result<(usize, Vec3, Option<Rgb888>), Error> {
        let (n, count) = ok!(self.numbers::<7>(SCALAR));
        let color = match count {
            // A fourth number is a weight for curves, a seventh is an opacity.
            3 | 4 => None,
            6 | 7 => Some(ok!(self.rgb([n[3], n[4], n[5]]))),
            _ => return self.error("a position needs 3 numbers, or 6 with its color"),
        };
        Ok((ok!(self.see(0)), Vec3::from_bits([n[0], n[1], n[2]]), color))
    }

    /// Reads the numbers of `vt`, with v pointing down.
    pub(super) const fn uv(&mut self) -> Result<(usize, Vec2), Error> {
        let ([u, up, _], 1..) = ok!(self.numbers(TEX_COORD)) else {
            return self.error("a texture coordinate needs 2 numbers");
        };
        let Some(down) = TexCoord::ONE.to_bits().checked_sub(up) else {
            return self.error(TEX_COORD.range);
        };
        Ok((ok!(self.see(1)), Vec2::from_bits([u, down])))
    }

    /// Reads the numbers of `vn`.
    pub(super) const fn normal(&mut self) -> Result<(usize, Vec3), Error> {
        let (n, 3) = ok!(self.numbers::<3>(SCALAR)) else {
            return self.error("a normal needs 3 numbers");
        };
        Ok((ok!(self.see(2)), Vec3::from_bits(n)))
    }

    /// Reads the next corner of a face or line; `None` at its end.
    pub(super) const fn corner(&mut self) -> Result<Option<Corner>, Error> {
        if !self.word() {
            return Ok(None);
        }
        let mut corner = Corner {
            position: 0,
            uv: None,
            normal: None,
        };
        let mut kind = 0;
        loop {
            // 1//3 has no texture coordinate, and some programs write 1/ and 1/2/.
            if kind == 0 || !matches!(self.rest, word_end!(b'/')) {
                let index = ok!(self.index(kind));
                match kind {
                    0 => corner.position = index,
                    1 => corner.uv = Some(index),
                    _ => corner.normal = Some(index),
                }
            }
            match self.rest {
                word_end!() => return Ok(Some(corner)),
                [b'/', rest @ ..] if kind < 2 => self.rest = rest,
                _ => return self.error(MALFORMED),
            }
            kind += 1;
        }
    }

    /// Reads an index of a kind of element: 1 is the first, −1 the last so far.
    const fn index(&mut self, kind: usize) -> Result<u16, Error> {
        let (negative, start) = match self.rest {
            [b'-', rest @ ..] => (true, rest),
            rest => (false, rest),
        };
        if !matches!(start, [b'0'..=b'9', ..]) {
            return self.error(MALFORMED);
        }
        // Greater numbers are as wrong as this one.
        let (number, rest) = digits!(start, MOST[0] as u64 + 1);
        self.rest = rest;
        let number = number as usize;
        if number == 0 {
            return self.error("an index is 0: the first is 1, and the last -1");
        }
        let (limit, index) = if negative {
            (self.seen[kind], self.seen[kind].wrapping_sub(number))
        } else {
            (self.known[kind], number - 1)
        };
        if number > limit {
            return self.error(NOT_THERE[kind]);
        }
        if index >= self.named[kind] {
            self.named[kind] = index + 1;
        }
        // Below `MOST`.
        Ok(index as u16)
    }
}
