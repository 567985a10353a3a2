//! Counts the triangles of a file before it is read.

use std::path::Path;

use fixel_assets::{Files, Format};

/// The most triangles of a model: twice as many as a closed surface of 65,536 positions has.
const MOST: usize = 4 << 16;

/// Refuses a file with far more triangles than a board can hold. To read them all would take long.
///
/// # Errors
///
/// The file has too many triangles, and its header or its lines say so.
pub fn check(path: &Path, files: &dyn Files) -> Result<(), String> {
    // A problem of the file is for its reader.
    let bytes = files.read(path).unwrap_or_default();
    let count = match Format::of(path) {
        Some(Format::Stl) => triangles_of_stl(&bytes),
        Some(Format::Ply) => faces_of_ply(&bytes),
        Some(Format::Obj) => lines(&bytes, b"f "),
        _ => 0,
    };
    if count <= MOST {
        return Ok(());
    }
    Err(format!(
        "it has {count} faces: a board can show at most {MOST}; save it with fewer triangles"
    ))
}

/// The number of triangles that a binary STL promises and has the bytes for, or of the facets of a text.
fn triangles_of_stl(bytes: &[u8]) -> usize {
    let promised = bytes.get(80..).and_then(<[u8]>::first_chunk);
    let promised = promised.map_or(0, |&count| u32::from_le_bytes(count) as usize);
    if promised == bytes.len().saturating_sub(84) / 50 {
        promised
    } else {
        lines(bytes, b"facet")
    }
}

/// The number of faces that the header of a PLY promises.
fn faces_of_ply(bytes: &[u8]) -> usize {
    let header = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let header = header.split("end_header").next().unwrap_or_default();
    let count = header
        .lines()
        .find_map(|line| line.strip_prefix("element face "));
    count
        .and_then(|count| count.trim().parse().ok())
        .unwrap_or(0)
}

/// The number of lines that begin with a word, after blanks.
fn lines(text: &[u8], word: &[u8]) -> usize {
    let lines = text.split(|byte| matches!(byte, b'\n' | b'\r'));
    lines
        .filter(|line| line.trim_ascii_start().starts_with(word))
        .count()
}
