//! Reads STL, text and binary.

use std::cell::Cell;
use std::collections::HashMap;
use std::io::{Cursor, Read, Result as IoResult, Seek, SeekFrom};

use super::files::Folder;
use super::sniff::{STL, is_binary_stl};
use super::text::{number, quote, words};
use super::{Corner, Model, Smoothing, next};

/// Reads an STL file. Its normals are ignored, because they only repeat those of the triangles, or are zero.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut model = Builder::default();
    let begins = bytes.trim_ascii_start().get(..5);
    let is_text = begins.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
        && !bytes.iter().take(1024).any(|&byte| byte == 0);
    // The header of a binary file may also begin with "solid".
    if is_text && !is_binary_stl(bytes) {
        text(&mut model, bytes, folder)?;
    } else {
        binary(&mut model, bytes, folder)?;
    }
    Ok(model.model)
}

fn binary(model: &mut Builder, bytes: &[u8], folder: Folder<'_>) -> Result<(), String> {
    let [header, each] = STL;
    let Some(count) = bytes.get(..header).and_then(<[u8]>::last_chunk::<4>) else {
        return Err(format!(
            "it is neither text that begins with 'solid' nor binary: a header takes {header} bytes, and it has {}",
            bytes.len()
        ));
    };
    if bytes[..header]
        .iter()
        .all(|byte| byte.is_ascii_graphic() || byte.is_ascii_whitespace())
    {
        return Err("it is text, and does not begin with 'solid'".into());
    }
    let count = u32::from_le_bytes(*count);
    let room = (bytes.len() - header) / each;
    if (room as u64) < u64::from(count) {
        return Err(format!(
            "byte {}: it ends within triangle {} of {count}",
            bytes.len(),
            room + 1
        ));
    }
    let mut file = Cursor::new(bytes);
    // The reader would take a header that begins with "solid" for text.
    let mut unmarked = Unmarked(&mut file);
    let triangles = stl_io::create_stl_reader(&mut unmarked).map_err(|error| error.to_string())?;
    for (at, triangle) in triangles.enumerate() {
        let offset = header + at * each;
        let triangle = triangle.map_err(|error| format!("byte {offset}: {error}"))?;
        model
            .triangle(&triangle)
            .map_err(|problem| format!("byte {offset}: {problem}"))?;
        folder.progress(at, offset);
    }
    Ok(())
}

/// A binary file with zeros in place of its first five bytes.
struct Unmarked<'a, 'b>(&'a mut Cursor<&'b [u8]>);

impl Read for Unmarked<'_, '_> {
    fn read(&mut self, out: &mut [u8]) -> IoResult<usize> {
        let from = self.0.position();
        let count = self.0.read(out)?;
        for (at, byte) in (from..5).zip(&mut out[..count]) {
            debug_assert!(at < 5);
            *byte = 0;
        }
        Ok(count)
    }
}

impl Seek for Unmarked<'_, '_> {
    fn seek(&mut self, to: SeekFrom) -> IoResult<u64> {
        self.0.seek(to)
    }
}

fn text(model: &mut Builder, bytes: &[u8], folder: Folder<'_>) -> Result<(), String> {
    // The reader accepts only lower case and UTF-8.
    let text = String::from_utf8_lossy(bytes)
        .to_ascii_lowercase()
        .replace("\r\n", "\n")
        .replace('\r', "\n");
    let position = TextPosition::default();
    let mut solid = 0;
    while let Some(start) = next_solid(text.as_bytes(), &position)? {
        // A file may have several solids, and names may be missing. The reader accepts neither.
        let mut lines = Lines {
            text: text.as_bytes(),
            position: &position,
            from: start,
            first: true,
        };
        let at_line = |problem: String| format!("line {}: {problem}", position.line.get());
        let failed = |error: std::io::Error| {
            let line = text.lines().nth(position.line.get().saturating_sub(1));
            at_line(explain(line.unwrap_or_default(), &error.to_string()))
        };
        let triangles = stl_io::create_stl_reader(&mut lines).map_err(failed)?;
        for (at, triangle) in triangles.enumerate() {
            let triangle = triangle.map_err(failed)?;
            model.triangle(&triangle).map_err(at_line)?;
            folder.progress(at, position.byte.get());
        }
        solid += 1;
    }
    debug_assert!(solid > 0);
    Ok(())
}

/// Explains why the reader refuses a line; `message` is the reader's own.
fn explain(line: &str, message: &str) -> String {
    let mut words = words(line.as_bytes());
    let (what, numbers): (_, Vec<_>) = match words.next() {
        Some(b"vertex") => ("a vertex", words.collect()),
        Some(b"facet") => ("a normal", words.skip(1).collect()),
        _ => {
            // Such as: expected ["endloop"], got ["endfacet"]
            let quoted = message.replace("[\"", "'").replace("\"]", "'");
            return quoted
                .replace("\", \"", " ")
                .replace(", got ", ", and found ");
        }
    };
    for word in &numbers {
        match number(word) {
            Err(problem) => return problem,
            Ok(_) => {}
        }
    }
    if numbers.len() == 3 {
        return message.into();
    }
    format!("{what} needs 3 numbers, and has {}", numbers.len())
}

/// A reader's position in the text.
#[derive(Clone, Default)]
struct TextPosition {
    byte: Cell<usize>,
    line: Cell<usize>,
}

impl TextPosition {
    /// Takes the next line, with its end.
    fn line<'a>(&self, text: &'a [u8]) -> Option<&'a [u8]> {
        let rest = &text[self.byte.get()..];
        if rest.is_empty() {
            return None;
        }
        let end = rest.iter().position(|&byte| byte == b'\n');
        let line = &rest[..end.map_or(rest.len(), |end| end + 1)];
        self.byte.set(self.byte.get() + line.len());
        self.line.set(self.line.get() + 1);
        Some(line)
    }
}

/// Moves past the line that begins the next solid, and returns where that is; `None` at the end of the text.
fn next_solid(text: &[u8], position: &TextPosition) -> Result<Option<TextPosition>, String> {
    while let Some(line) = position.line(text) {
        let line = line.trim_ascii();
        if line.starts_with(b"solid") {
            return Ok(Some(position.clone()));
        }
        if !line.is_empty() {
            let line = quote(line);
            return Err(format!(
                "line {}: expected 'solid', and found {line}",
                position.line.get()
            ));
        }
    }
    Ok(None)
}

/// The lines of a text after the one at `from`, preceded by a line "solid ". A read returns at most one line, so
/// `position` is the reader's.
struct Lines<'a> {
    text: &'a [u8],
    position: &'a TextPosition,
    from: TextPosition,
    first: bool,
}

impl Read for Lines<'_> {
    fn read(&mut self, out: &mut [u8]) -> IoResult<usize> {
        let line = if self.first {
            self.first = false;
            b"solid \n"
        } else {
            self.position.line(self.text).unwrap_or_default()
        };
        let count = line.len().min(out.len());
        out[..count].copy_from_slice(&line[..count]);
        if count < line.len() {
            // The rest comes next.
            self.position
                .byte
                .set(self.position.byte.get() - (line.len() - count));
            self.position.line.set(self.position.line.get() - 1);
        }
        Ok(count)
    }
}

impl Seek for Lines<'_> {
    /// Goes back to the start; the reader asks for nothing else.
    fn seek(&mut self, _: SeekFrom) -> IoResult<u64> {
        self.position.byte.set(self.from.byte.get());
        self.position.line.set(self.from.line.get());
        self.first = true;
        Ok(0)
    }
}

/// A model made of separate triangles.
#[derive(Default)]
struct Builder {
    model: Model,
    indices: HashMap<[u32; 3], u32>,
}

impl Builder {
    fn triangle(&mut self, triangle: &stl_io::Triangle) -> Result<(), String> {
        let mut corners = [Corner::default(); 3];
        for (corner, vertex) in corners.iter_mut().zip(&triangle.vertices) {
            // −0 and 0 are the same position.
            let position = [0, 1, 2].map(|axis| vertex.0[axis] + 0.0);
            let new = next(&self.model.positions)?;
            corner.position = *self
                .indices
                .entry(position.map(f32::to_bits))
                .or_insert(new);
            if corner.position == new {
                self.model.positions.push(position.map(f64::from));
            }
        }
        self.model.polygon(&mut corners, None, Smoothing::Angle)
    }
}
