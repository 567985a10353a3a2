//! Finds the format of a file by its name and its first bytes.

use std::io;
use std::path::Path;

use crate::text::unescaped;

/// The format of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// STL, text or binary.
    Stl,
    /// PLY, text or binary.
    Ply,
    /// glTF 2.0, text or binary.
    Gltf,
}

/// The known formats, one a line: the name with an article, the file name extensions, the bytes with which files begin,
/// if any identify them, and what to do with a file that cannot be read, if not to save it in another format.
const FORMATS: &str = include_str!("formats.tsv");

const CAN_BE_READ: &str = "OBJ, STL, PLY, glTF and GLB can be read";

/// The remedy for archives.
const UNPACK: &str = "unpack it";

/// A line of [`FORMATS`].
#[derive(Clone, Copy)]
struct Row<'a> {
    name: &'a str,
    ends: &'a str,
    start: &'a str,
    remedy: &'a str,
}

fn rows() -> impl Iterator<Item = Row<'static>> {
    FORMATS.lines().skip(1).map(|line| {
        let mut cells = line.split('\t');
        let [name, ends, start, remedy] = [(); 4].map(|()| cells.next().unwrap_or(""));
        Row {
            name,
            ends,
            start,
            remedy,
        }
    })
}

impl Row<'_> {
    /// The format, if it is one of a model that can be read.
    fn format(self) -> Option<Format> {
        Some(match self.name {
            "an STL" => Format::Stl,
            "an OBJ" => Format::Obj,
            "a PLY" => Format::Ply,
            "a glTF" => Format::Gltf,
            _ => return None,
        })
    }

    /// Why a file of this format cannot be read.
    fn refusal(self, can_be_read: &str) -> String {
        let remedy = Some(self.remedy).filter(|remedy| !remedy.is_empty());
        let remedy = remedy.unwrap_or(can_be_read);
        format!("it is {} file: {remedy}", self.name)
    }
}

/// The row with the extension of `path`.
fn named(path: &Path) -> Option<Row<'static>> {
    let ending = path.extension()?.to_ascii_lowercase();
    rows().find(|row| row.ends.split(' ').any(|other| ending == other))
}

impl Format {
    /// The format that the extension of `path` names.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        named(path)?.format()
    }
}

/// Whether the size of a file agrees with the header of a binary STL file.
pub fn is_binary_stl(bytes: &[u8]) -> bool {
    let count = bytes.get(80..).and_then(<[u8]>::first_chunk);
    count.is_some_and(|&count| u64::from(u32::from_le_bytes(count)) * 50 + 84 == bytes.len() as u64)
}

/// The row of the format that the start of the file shows. OBJ files have no signature.
fn marked(bytes: &[u8]) -> Option<Row<'static>> {
    let start = &bytes[..bytes.len().min(1024)];
    let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start);
    let text = text.trim_ascii_start();
    let lower = text.to_ascii_lowercase();
    let has = |word: &[u8]| lower.windows(word.len()).any(|part| part == word);
    let is_stl = is_binary_stl(bytes) || (lower.starts_with(b"solid") && has(b"facet"));
    let begins = |text: &[u8], mark: &[u8]| {
        let mut pairs = mark.iter().zip(text);
        text.len() >= mark.len() && pairs.all(|(mark, byte)| *mark == b'?' || mark == byte)
    };
    rows().find(|row| match row.start {
        "" => is_stl && row.format() == Some(Format::Stl),
        // In an XML file, declarations and comments can come before the mark, which can have any case.
        xml if xml.starts_with('<') => text.starts_with(b"<") && has(xml.as_bytes()),
        mark => [start, text]
            .iter()
            .any(|text| begins(text, &unescaped(mark))),
    })
}

/// The contents of materials or of a buffer, unless a pointer or a page stands in their place.
pub fn contents(read: io::Result<Vec<u8>>) -> Result<Vec<u8>, String> {
    let bytes = read.map_err(|error| error.to_string())?;
    let row = marked(&bytes).filter(|row| row.remedy.contains("the file itself"));
    row.map_or(Ok(bytes), |row| Err(row.refusal("")))
}

/// Why a file cannot be read, if it begins like one of a known format.
pub fn refusal(bytes: &[u8], can_be_read: &str) -> Option<String> {
    marked(bytes).map(|row| row.refusal(can_be_read))
}

/// Finds the format of a file.
///
/// # Errors
///
/// The file is empty or UTF-16 text, its format cannot be read, or the contents contradict the extension.
pub fn format(path: &Path, bytes: &[u8]) -> Result<Format, String> {
    if bytes.trim_ascii().is_empty() {
        return Err("it is empty: it has no faces".into());
    }
    let (marked, named) = (marked(bytes), named(path));
    if marked.is_none() && (bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff")) {
        return Err("its text is UTF-16: save it as UTF-8".into());
    }
    // The name tells what an archive is.
    let is_archive = marked.is_some_and(|row| row.remedy == UNPACK);
    let archive = named.filter(|row| is_archive && row.format().is_none());
    let Some(row) = archive.or(marked).or(named) else {
        return Ok(Format::Obj);
    };
    let format = row.format().ok_or_else(|| row.refusal(CAN_BE_READ))?;
    match named.filter(|named| named.format().is_some_and(|named| named != format)) {
        None => Ok(format),
        Some(named) => Err(format!(
            "it is {} file, not {} file: give it the ending .{}",
            row.name,
            named.name,
            row.ends.replace(' ', " or .")
        )),
    }
}
