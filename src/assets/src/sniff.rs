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

/// A file format: the [`Format`], or `None` if fixel cannot read it; the name with an article; the file name
/// extensions; and the text that identifies its files, or "" if no text does.
type Row = (Option<Format>, &'static str, &'static str, &'static str);

const FORMATS: [Row; 17] = [
    (Some(Format::Stl), "an STL", "stl", ""),
    (Some(Format::Obj), "an OBJ", "obj", ""),
    (Some(Format::Ply), "a PLY", "ply", "ply"),
    (Some(Format::Gltf), "a glTF", "glb gltf", "glTF"),
    (Some(Format::Gltf), "a glTF", "glb gltf", "{"),
    (None, "an FBX", "fbx", "Kaydara FBX"),
    (None, "a COLLADA", "dae", "<COLLADA"),
    (None, "an X3D", "x3d", "<X3D"),
    (None, "a 3MF", "3mf", ""),
    (None, "a USDZ", "usdz", ""),
    (None, "an OFF", "off", "OFF"),
    (None, "a Blender", "blend", "BLENDER"),
    (None, "a STEP", "step stp", "ISO-10303-21"),
    (None, "a MilkShape 3D", "ms3d", "MS3D000000"),
    (None, "a 3D Studio", "3ds", ""),
    (None, "an MD2", "md2", "IDP2"),
    (None, "a VRML", "vrml wrl", "#VRML"),
];

const CAN_BE_READ: &str = "OBJ, STL, PLY, glTF and GLB can be read";

/// The row with the extension of `path`.
fn named(path: &Path) -> Option<&'static Row> {
    let ending = path.extension()?.to_ascii_lowercase();
    let has = |row: &&Row| row.2.split(' ').any(|other| ending == other);
    FORMATS.iter().find(has)
}

impl Format {
    /// The format that the extension of `path` names.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        named(path)?.0
    }
}

/// Whether the size of a file agrees with the header of a binary STL file.
pub fn is_binary_stl(bytes: &[u8]) -> bool {
    let count = bytes.get(80..).and_then(<[u8]>::first_chunk);
    count.is_some_and(|&count| u64::from(u32::from_le_bytes(count)) * 50 + 84 == bytes.len() as u64)
}

/// The row of the format that the start of the file shows. OBJ files have no signature.
fn marked(bytes: &[u8]) -> Option<&'static Row> {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(1024)]);
    let text = start.trim_start_matches('\u{feff}').trim_start();
    let lower = text.to_ascii_lowercase();
    let is_stl = is_binary_stl(bytes) || (lower.starts_with("solid") && lower.contains("facet"));
    let is_found = |(format, _, _, mark): &&Row| match format {
        Some(Format::Stl) => is_stl,
        // In an XML file, declarations and comments can come before the mark.
        _ if mark.starts_with('<') => text.starts_with('<') && text.contains(mark),
        _ => !mark.is_empty() && text.starts_with(mark),
    };
    FORMATS.iter().find(is_found)
}

/// Finds the format of a file.
///
/// # Errors
///
/// The file is empty or UTF-16 text, its format cannot be read, or the contents contradict the extension.
pub fn format(path: &Path, bytes: &[u8]) -> Result<Format, String> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err("its text is UTF-16: save it as UTF-8".into());
    }
    if bytes.trim_ascii().is_empty() {
        return Err("it is empty: it has no faces".into());
    }
    let named = named(path);
    match (marked(bytes).or(named), named) {
        (None, _) => Ok(Format::Obj),
        (Some((None, name, ..)), _) => Err(format!("it is {name} file: {CAN_BE_READ}")),
        (Some((Some(_), found, ends, _)), Some((Some(_), name, ..))) if found != name => {
            let what = format!("it is {found} file, not {name} file");
            let ending = ends.replace(' ', " or .");
            Err(format!("{what}: give it the ending .{ending}"))
        }
        (Some((Some(format), ..)), _) => Ok(*format),
    }
}
