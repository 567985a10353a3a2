//! Helpers for the text of models, which may have any size and any encoding.

use std::borrow::Cow;
use std::iter;
use std::str::FromStr;

use super::Notes;

/// A text of at most so many characters.
fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into(),
    }
}

/// A quotation of the file, short enough for a message.
pub fn quote(word: &[u8]) -> String {
    let word = String::from_utf8_lossy(&word[..word.len().min(160)]);
    format!("'{}'", cut(&word, 40).escape_debug())
}

/// A message in one line of printable characters, cut after a few hundred of them.
pub fn one_line(message: &str) -> String {
    let words: Vec<&str> = message.split_whitespace().collect();
    cut(&words.join(" ").replace(char::is_control, ""), 300)
}

/// The byte that ends the lines of a text, maybe with another.
pub fn line_end(text: &[u8]) -> u8 {
    if text.contains(&b'\n') { b'\n' } else { b'\r' }
}

/// The lines of OBJ and MTL text, each with its number. Comments are empty, and a line that ends with a backslash is
/// joined with the next one. `progress` is told the number of each line, and of the bytes so far.
pub fn statements(
    text: &[u8],
    progress: impl Fn(usize, usize),
) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let (end, mut read) = (line_end(text), 0);
    let lines = text.split(move |&byte| byte == end);
    let mut lines = (1..).zip(lines).map(move |(number, line)| {
        read += line.len() + 1;
        progress(number, read);
        let line = line.trim_ascii();
        (number, if line.starts_with(b"#") { b"" } else { line })
    });
    iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let mut line = Cow::Borrowed(line);
        while line.ends_with(b"\\") {
            let line = line.to_mut();
            line.pop();
            line.push(b' ');
            line.extend(lines.next().map_or(b"".as_slice(), |(_, next)| next));
        }
        Some((number, line))
    })
}

/// The words of a text.
pub fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let words = text.split(u8::is_ascii_whitespace);
    words.filter(|word| !word.is_empty())
}

/// The statement after its first word.
pub fn after_keyword(statement: &[u8]) -> &[u8] {
    let statement = statement.trim_ascii_start();
    let end = statement.iter().position(u8::is_ascii_whitespace);
    statement[end.unwrap_or(statement.len())..].trim_ascii()
}

/// Reads a word as a number of a type.
pub fn parse<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A number. A decimal comma is read as a point, and what C programs write for a value that is no number as NaN.
pub fn number(word: &[u8]) -> Result<f64, String> {
    let text = std::str::from_utf8(word).unwrap_or_default();
    let with_point = || text.replacen(',', ".", 1).parse().ok();
    let is_nan = text.contains(".#") || text.starts_with("nan(") || text.starts_with("-nan(");
    let number = parse(word).or_else(with_point);
    let number = number.or(is_nan.then_some(f64::NAN));
    number.ok_or_else(|| format!("{} is not a number", quote(word)))
}

/// At least `least` numbers, at most 7, and their count. The others are 0.
pub fn numbers<'a>(
    words: impl Iterator<Item = &'a [u8]>,
    least: usize,
    notes: &mut Notes,
) -> Result<([f64; 7], usize), String> {
    let (mut numbers, mut count) = ([0.0; 7], 0);
    for word in words.take(7) {
        let number = number(word);
        if number.is_err() && count >= least {
            notes.add("what follows the numbers of a line is not read");
            break;
        }
        numbers[count] = number?;
        count += 1;
        if word.contains(&b',') {
            notes.add("a decimal comma is read as a point");
        }
    }
    if count < least {
        return Err(format!("it needs {least} numbers, and has {count}"));
    }
    Ok((numbers, count))
}
