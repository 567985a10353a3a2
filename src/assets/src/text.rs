//! Helpers for the text of models, which may have any size and any encoding.

use std::borrow::Cow;

/// The largest number of characters in a quotation.
const QUOTED: usize = 40;

/// A quotation of the file, short enough for a message.
pub fn quote(word: &[u8]) -> String {
    let word = String::from_utf8_lossy(&word[..word.len().min(4 * QUOTED)]).into_owned();
    if word.chars().count() <= QUOTED {
        return format!("'{}'", word.escape_debug());
    }
    let start: String = word.chars().take(QUOTED).collect();
    format!("'{}…'", start.escape_debug())
}

/// A message in one line of printable characters, cut after a few hundred of them.
pub fn one_line(message: &str) -> String {
    let words: Vec<&str> = message.split_whitespace().collect();
    let mut line: String = words
        .join(" ")
        .chars()
        .filter(|c| !c.is_control())
        .collect();
    if let Some((end, _)) = line.char_indices().nth(300) {
        line.truncate(end);
        line.push('…');
    }
    line
}

/// The statements of OBJ and MTL text, each with the number of its first line and the offset of its end. Comments are
/// cut off, and lines that end with a backslash are joined with the next one.
pub struct Statements<'a> {
    text: &'a [u8],
    at: usize,
    line: usize,
}

/// A statement: its line, and its text without comment.
pub type Statement<'a> = (usize, Cow<'a, [u8]>);

impl<'a> Statements<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        Self {
            text,
            at: 0,
            line: 0,
        }
    }

    /// How many bytes have been read.
    pub fn read(&self) -> usize {
        self.at
    }

    /// The next line of the file without its end, and whether it goes on in the next one.
    fn line(&mut self) -> Option<(&'a [u8], bool)> {
        let rest = self.text.get(self.at..).filter(|rest| !rest.is_empty())?;
        self.line += 1;
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let line = &rest[..end.unwrap_or(rest.len())];
        let crlf = end.is_some_and(|end| rest[end..].starts_with(b"\r\n"));
        self.at += line.len() + usize::from(end.is_some()) + usize::from(crlf);
        let comment = line.iter().position(|&byte| byte == b'#');
        let line = line[..comment.unwrap_or(line.len())].trim_ascii_end();
        Some(match line.strip_suffix(b"\\") {
            Some(line) => (line, true),
            None => (line, false),
        })
    }
}

impl<'a> Iterator for Statements<'a> {
    type Item = Statement<'a>;

    fn next(&mut self) -> Option<Self::Item> {
        let (line, mut goes_on) = self.line()?;
        let first = self.line;
        let mut statement = Cow::Borrowed(line);
        while goes_on {
            let Some((line, more)) = self.line() else {
                break;
            };
            let statement = statement.to_mut();
            statement.push(b' ');
            statement.extend_from_slice(line);
            goes_on = more;
        }
        Some((first, statement))
    }
}

/// The words of a statement.
pub fn words(statement: &[u8]) -> impl Iterator<Item = &[u8]> {
    statement
        .split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

/// The statement after its first word.
pub fn after_keyword(statement: &[u8]) -> &[u8] {
    let statement = statement.trim_ascii_start();
    let end = statement.iter().position(u8::is_ascii_whitespace);
    statement[end.unwrap_or(statement.len())..].trim_ascii()
}

/// A number.
pub fn number(word: &[u8]) -> Result<f64, String> {
    std::str::from_utf8(word)
        .ok()
        .and_then(|word| word.parse().ok())
        .ok_or_else(|| format!("{} is not a number", quote(word)))
}
