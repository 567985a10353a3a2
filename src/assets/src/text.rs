//! Helpers for the text of models. The text can have any size and any encoding.

use std::borrow::Cow;
use std::str::FromStr;

use super::Notes;

/// Cuts a text after its first `most` characters.
fn cut(text: &str, most: usize) -> String {
    let end = text.char_indices().nth(most);
    end.map_or_else(|| text.into(), |(end, _)| format!("{}…", &text[..end]))
}

/// A quotation from the file, short enough for a message.
pub fn quote(word: &[u8]) -> String {
    let word = String::from_utf8_lossy(&word[..word.len().min(160)]);
    format!("'{}'", cut(&word, 40).escape_debug())
}

/// A message as one line of printable characters, cut after 300 characters.
pub fn one_line(message: &str) -> String {
    let words: Vec<&str> = message.split_whitespace().collect();
    cut(&words.join(" ").replace(char::is_control, ""), 300)
}

/// The character that ends the lines of a text: a carriage return if most lines end with only a carriage return, else a
/// line feed.
pub fn line_end(text: &[u8]) -> u8 {
    let count = |end| text.split(|&byte| byte == end).count();
    b"\n\r"[usize::from(count(b'\r') > 2 * count(b'\n'))]
}

/// A line with its number.
type Line<'a> = (usize, Cow<'a, [u8]>);

/// The lines of OBJ and MTL text, without comments and empty lines. A line that ends with a backslash is joined with
/// the next line. `progress` gets the number of each line, and the number of bytes read so far.
pub fn statements(text: &[u8], progress: impl Fn(usize, usize)) -> impl Iterator<Item = Line<'_>> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let (end, mut read) = (line_end(text), 0);
    let lines = text.split(move |&byte| byte == end);
    let mut lines = (1..).zip(lines).map(move |(number, line)| {
        read += line.len() + 1;
        progress(number, read);
        let line = line.trim_ascii();
        (number, if line.starts_with(b"#") { b"" } else { line })
    });
    let lines = std::iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let mut line = Cow::Borrowed(line);
        while line.ends_with(b"\\") {
            let line = line.to_mut();
            line.pop();
            line.push(b' ');
            line.extend(lines.next().map_or(b"".as_slice(), |(_, next)| next));
        }
        Some((number, line))
    });
    lines.filter(|(_, line)| !line.is_empty())
}

/// The words of a text, up to its first comment.
pub fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let words = text.split(u8::is_ascii_whitespace);
    let words = words.filter(|word| !word.is_empty());
    words.take_while(|word| !word.starts_with(b"#"))
}

/// The first word of a text, and the rest of the text.
pub fn first_word(text: &[u8]) -> Option<(&[u8], &[u8])> {
    let text = text.trim_ascii_start();
    let end = text.iter().position(u8::is_ascii_whitespace);
    let (word, rest) = text.split_at(end.unwrap_or(text.len()));
    (!word.is_empty()).then(|| (word, rest.trim_ascii()))
}

/// Converts a word to a number of the type `T`; `None` if the word is not such a number.
pub fn parse<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Reads a number. A decimal comma counts as a point. A value that is not a number, as C programs write it (such as
/// 1.#IND or nan(ind)), becomes NaN.
pub fn number(word: &[u8]) -> Result<f64, String> {
    let text = || String::from_utf8_lossy(word).replacen(',', ".", 1);
    let is_nan = || text().contains(".#") || text().contains("nan(");
    let number = parse(word).or_else(|| text().parse().ok());
    let number = number.or_else(|| is_nan().then_some(f64::NAN));
    number.ok_or_else(|| format!("{} is not a number", quote(word)))
}

/// Reads the first 7 words of a text as numbers; `None` for a missing word, and for a word that is not a number.
pub fn numbers(text: &[u8], notes: &mut Notes) -> [Option<f64>; 7] {
    let mut numbers = [None; 7];
    for (place, word) in numbers.iter_mut().zip(words(text)) {
        *place = number(word).ok();
        if place.is_none() {
            notes.add("a word of a line is skipped: it is not a number");
        } else if word.contains(&b',') {
            notes.add("a decimal comma is read as a point");
        }
    }
    numbers
}

/// The bytes of a URI, or of another text with escapes such as %20.
pub fn unescaped(uri: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let code = after
            .get(..2)
            .filter(|_| first == b'%')
            .and_then(|digits| u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok());
        bytes.push(code.unwrap_or(first));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    bytes
}
