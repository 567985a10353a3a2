//! Finds the format of a file by its name and its first bytes.

use std::path::Path;

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

impl Format {
    /// The format that the ending of `path` names.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_ascii_lowercase();
        Some(match ending.to_str()? {
            "obj" => Self::Obj,
            "stl" => Self::Stl,
            "ply" => Self::Ply,
            "gltf" | "glb" => Self::Gltf,
            _ => return None,
        })
    }

    /// Its name with an article, and its ending.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Obj => ["an OBJ", ".obj"],
            Self::Stl => ["an STL", ".stl"],
            Self::Ply => ["a PLY", ".ply"],
            Self::Gltf => ["a glTF", ".glb or .gltf"],
        }
    }
}

/// How many bytes an STL file has before its triangles, and for each.
pub const STL: [usize; 2] = [84, 50];

/// Whether the size of a file agrees with the header of a binary STL file.
pub fn is_binary_stl(bytes: &[u8]) -> bool {
    let Some(count) = bytes[..bytes.len().min(STL[0])].last_chunk::<4>() else {
        return false;
    };
    bytes.len() >= STL[0]
        && u64::from(u32::from_le_bytes(*count)) * STL[1] as u64 + STL[0] as u64
            == bytes.len() as u64
}

/// The format whose signature the file begins with; OBJ has none.
fn marked(bytes: &[u8]) -> Option<Format> {
    let start = &bytes[..bytes.len().min(1024)];
    let text = start
        .strip_prefix(b"\xef\xbb\xbf")
        .unwrap_or(start)
        .trim_ascii_start();
    let has = |word: &[u8]| {
        text.windows(word.len())
            .any(|at| at.eq_ignore_ascii_case(word))
    };
    if bytes.starts_with(b"glTF") || (text.starts_with(b"{") && has(b"\"")) {
        Some(Format::Gltf)
    } else if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
        Some(Format::Ply)
    } else if is_binary_stl(bytes)
        || (text
            .get(..5)
            .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
            && (has(b"facet") || has(b"endsolid")))
    {
        Some(Format::Stl)
    } else {
        None
    }
}

/// The format of a file.
///
/// # Errors
///
/// The file is empty, is not in the format that its ending names, or is UTF-16 text.
pub fn format(path: &Path, bytes: &[u8]) -> Result<Format, String> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err("its text is UTF-16: save it as UTF-8".into());
    }
    if bytes.trim_ascii().is_empty() {
        return Err("it is empty: it has no faces".into());
    }
    let found = marked(bytes);
    match (Format::of(path), found) {
        (Some(named), Some(found)) if named != found => {
            let ([found, ending], [named, _]) = (found.words(), named.words());
            Err(format!(
                "it is {found} file, not {named} file: give it the ending {ending}"
            ))
        }
        (named, found) => Ok(named.or(found).unwrap_or(Format::Obj)),
    }
}
