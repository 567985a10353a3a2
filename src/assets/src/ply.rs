//! Reads PLY, text and binary.

use std::io::Cursor;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};

use super::files::Folder;
use super::text::{number, quote, words};
use super::{Corner, Model, Smoothing, next};

/// How many elements are read at a time, between two steps of the progress bar.
const STEP: usize = 1 << 14;

/// Reads a PLY file: its elements `vertex` and `face`.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut reader = Reader::new(Cursor::new(bytes));
    let header = Parser::<Row>::new()
        .read_header(&mut reader)
        .map_err(|error| refused(&error, bytes, None))?;
    #[allow(clippy::cast_possible_truncation)] // a position in memory
    let start = reader.get_ref().position() as usize;
    let mut file = File {
        reader,
        header,
        bytes,
        start: Some(start),
    };
    let mut model = Model::default();
    let mut has = Attributes::default();
    let elements: Vec<ElementDef> = file.header.elements.values().cloned().collect();
    for element in elements {
        let names = |name: &str| element.properties.contains_key(name);
        match element.name.as_str() {
            "vertex" => {
                for axis in ["x", "y", "z"] {
                    if !names(axis) {
                        return Err(format!("its vertices have no property {axis}"));
                    }
                }
                has = Attributes {
                    normals: names("nx") && names("ny") && names("nz"),
                    colors: names("red") && names("green") && names("blue"),
                    uvs: UVS.iter().any(|[u, v]| names(u) && names(v)),
                };
                file.rows(&element, folder, |row| {
                    model.positions.push(row.position);
                    if has.normals {
                        model.normals.push(row.normal);
                    }
                    if has.colors {
                        model.colors.push(row.color);
                    }
                    if has.uvs {
                        // In the file, v points up.
                        model.uvs.push([row.uv[0], 1.0 - row.uv[1]]);
                    }
                    Ok(())
                })?;
            }
            "face" => {
                if !names("vertex_indices") && !names("vertex_index") {
                    return Err("its faces have no property vertex_indices".into());
                }
                let count = model.positions.len();
                let vertices = next(&model.positions)?;
                let mut corners = Vec::new();
                file.rows(&element, folder, |row| {
                    if row.indices.len() < 3 {
                        return Err(format!("a face has {} corners: it needs at least 3", row.indices.len()));
                    }
                    corners.clear();
                    for &index in &row.indices {
                        let position = u32::try_from(index)
                            .ok()
                            .filter(|&index| index < vertices)
                            .ok_or_else(|| {
                                format!("vertex {index} does not exist: there are {count}, counted from 0")
                            })?;
                        corners.push(Corner {
                            position,
                            uv: has.uvs.then_some(position),
                            normal: has.normals.then_some(position),
                            color: has.colors.then_some(position),
                        });
                    }
                    if row.uvs.len() == 2 * corners.len() {
                        for (corner, uv) in corners.iter_mut().zip(row.uvs.chunks_exact(2)) {
                            corner.uv = Some(next(&model.uvs)?);
                            model.uvs.push([uv[0], 1.0 - uv[1]]);
                        }
                    }
                    model.polygon(&mut corners, None, Smoothing::Angle)
                })?;
            }
            _ => file.rows(&element, folder, |_| Ok(()))?,
        }
    }
    if model.triangles.is_empty() && !model.positions.is_empty() {
        return Err("it is a cloud of points: only faces are drawn, and it has none".into());
    }
    Ok(model)
}

/// Explains why the reader refuses a file: names the mistake in its header, or in an element.
fn refused(error: &ParseError, bytes: &[u8], element: Option<&ElementDef>) -> String {
    // The reader's message begins with the line of a text.
    let message = error.to_string();
    let place = message
        .strip_prefix("Line ")
        .and_then(|rest| rest.split_once(':'));
    let Some((at, rest)) = place.and_then(|(at, rest)| Some((at.parse::<usize>().ok()?, rest)))
    else {
        return message;
    };
    let problem = match (line(bytes, at), element) {
        (None, _) => Some("the file ends here".into()),
        (Some(line), Some(element)) => explain(line, element),
        (Some(line), None) => Some(format!("{} is not a line of a PLY header", quote(line))),
    };
    format!(
        "line {at}: {}",
        problem.unwrap_or_else(|| rest.trim().into())
    )
}

/// A line of text, counted from 1.
fn line(bytes: &[u8], at: usize) -> Option<&[u8]> {
    bytes.split(|&byte| byte == b'\n').nth(at.checked_sub(1)?)
}

/// Explains the mistake in a line of text with an element; `None` if there is no short explanation.
fn explain(line: &[u8], element: &ElementDef) -> Option<String> {
    let mut words = words(line);
    for (name, property) in &element.properties {
        let (count, kind) = match &property.data_type {
            PropertyType::Scalar(kind) => (1, kind),
            PropertyType::List(_, kind) => {
                let Some(count) = words.next() else {
                    return Some(format!("the list '{name}' is missing"));
                };
                match std::str::from_utf8(count)
                    .ok()
                    .and_then(|count| count.parse().ok())
                {
                    Some(count) => (count, kind),
                    None => return Some(format!("{} is not a count", quote(count))),
                }
            }
        };
        for found in 0..count {
            let Some(word) = words.next() else {
                return Some(match property.data_type {
                    PropertyType::Scalar(_) => format!("the value of '{name}' is missing"),
                    PropertyType::List(..) => {
                        format!("the list '{name}' has {found} values, and promises {count}")
                    }
                });
            };
            let value = match number(word) {
                Err(problem) => return Some(problem),
                Ok(value) => value,
            };
            let is_fraction = matches!(kind, ScalarType::Float | ScalarType::Double);
            if !is_fraction && value.fract() != 0.0 {
                return Some(format!("{} is not a whole number", quote(word)));
            }
        }
    }
    None
}

/// How many bytes a number takes in a binary file.
fn size(kind: &ScalarType) -> usize {
    match kind {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

/// How many bytes an element takes in a binary file, if all take the same number.
fn stride(element: &ElementDef) -> Option<usize> {
    let sizes = element.properties.values().map(|property| {
        let PropertyType::Scalar(kind) = &property.data_type else {
            return None;
        };
        Some(size(kind))
    });
    sizes.sum()
}

/// The data that vertices have besides their position.
#[derive(Clone, Copy, Default)]
struct Attributes {
    normals: bool,
    colors: bool,
    uvs: bool,
}

/// The names of texture coordinates.
const UVS: [[&str; 2]; 3] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];

struct File<'a> {
    reader: Reader<Cursor<&'a [u8]>>,
    header: Header,
    bytes: &'a [u8],
    /// Where the next elements begin, if it is known.
    start: Option<usize>,
}

impl File<'_> {
    /// Calls `each` with every element of one kind.
    fn rows(
        &mut self,
        element: &ElementDef,
        folder: Folder<'_>,
        mut each: impl FnMut(Row) -> Result<(), String>,
    ) -> Result<(), String> {
        let parser = Parser::<Row>::new();
        let is_text = self.header.encoding == Encoding::Ascii;
        if element.properties.is_empty() && !is_text {
            return Ok(());
        }
        let stride = stride(element);
        let place = |at: usize| Some(self.start? + at * stride?);
        let mut done = 0;
        while done < element.count {
            let count = STEP.min(element.count - done);
            let part = ElementDef {
                count,
                ..element.clone()
            };
            let line = self.reader.line();
            let rows = parser
                .read_payload_for_element(&mut self.reader, &part, &self.header)
                .map_err(|error| match error.kind() {
                    std::io::ErrorKind::UnexpectedEof => format!(
                        "byte {}: it ends within the {} elements '{}' that its header promises",
                        self.bytes.len(),
                        element.count,
                        element.name
                    ),
                    _ => refused(&error, self.bytes, Some(element)),
                })?;
            for (at, row) in rows.into_iter().enumerate() {
                each(row).map_err(|problem| {
                    if is_text {
                        let line = line + at;
                        let text = self::line(self.bytes, line).unwrap_or_default();
                        let problem = explain(text, element).unwrap_or(problem);
                        return format!("line {line}: {problem}");
                    }
                    match place(done + at) {
                        Some(byte) => format!("byte {byte}: {problem}"),
                        None => format!("element '{}' {}: {problem}", element.name, done + at),
                    }
                })?;
            }
            done += count;
            #[allow(clippy::cast_possible_truncation)] // a position in memory
            folder.progress(
                done.next_multiple_of(STEP),
                self.reader.get_ref().position() as usize,
            );
        }
        self.start = place(element.count);
        Ok(())
    }
}

/// The properties of an element that the program uses, whatever its kind.
#[derive(Default)]
struct Row {
    position: [f64; 3],
    normal: [f64; 3],
    color: [u8; 3],
    uv: [f64; 2],
    indices: Vec<i64>,
    uvs: Vec<f64>,
}

/// A property as a number, and as a component of a color. A component that is not an integer is a fraction.
fn scalar(property: &Property) -> Option<(f64, u8)> {
    let (value, most) = match *property {
        Property::Char(x) => (x.into(), 127.0),
        Property::UChar(x) => (x.into(), 255.0),
        Property::Short(x) => (x.into(), 32_767.0),
        Property::UShort(x) => (x.into(), 65_535.0),
        Property::Int(x) => (x.into(), f64::from(i32::MAX)),
        Property::UInt(x) => (x.into(), f64::from(u32::MAX)),
        Property::Float(x) => (x.into(), 1.0),
        Property::Double(x) => (x, 1.0),
        _ => return None,
    };
    Some((value, super::mtl::byte(value / most)))
}

fn whole<T: Into<i64> + Copy>(list: &[T]) -> Vec<i64> {
    list.iter().map(|&x| x.into()).collect()
}

impl PropertyAccess for Row {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let place = match name {
            "vertex_indices" | "vertex_index" => {
                self.indices = match &property {
                    Property::ListChar(list) => whole(list),
                    Property::ListUChar(list) => whole(list),
                    Property::ListShort(list) => whole(list),
                    Property::ListUShort(list) => whole(list),
                    Property::ListInt(list) => whole(list),
                    Property::ListUInt(list) => whole(list),
                    _ => return PropertyAccessResult::UnsupportedType,
                };
                return PropertyAccessResult::Set;
            }
            "texcoord" => {
                match property {
                    Property::ListFloat(list) => {
                        self.uvs = list.into_iter().map(f64::from).collect();
                    }
                    Property::ListDouble(list) => self.uvs = list,
                    _ => return PropertyAccessResult::Ignored,
                }
                return PropertyAccessResult::Set;
            }
            "red" | "green" | "blue" => {
                let at = ["red", "green", "blue"]
                    .iter()
                    .position(|&color| color == name);
                if let (Some((_, byte)), Some(at)) = (scalar(&property), at) {
                    self.color[at] = byte;
                }
                return PropertyAccessResult::Set;
            }
            "x" => &mut self.position[0],
            "y" => &mut self.position[1],
            "z" => &mut self.position[2],
            "nx" => &mut self.normal[0],
            "ny" => &mut self.normal[1],
            "nz" => &mut self.normal[2],
            "s" | "u" | "texture_u" => &mut self.uv[0],
            "t" | "v" | "texture_v" => &mut self.uv[1],
            _ => return PropertyAccessResult::Ignored,
        };
        match scalar(&property) {
            Some((value, _)) => {
                *place = value;
                PropertyAccessResult::Set
            }
            None => PropertyAccessResult::UnsupportedType,
        }
    }
}
