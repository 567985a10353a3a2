//! Reads PLY files, both text and binary.

use std::collections::HashMap;

use crate::files::Folder;
use crate::mtl::byte;
use crate::text::{number, parse, quote, words};
use crate::{Corner, Image, Material, Model, Smoothing, merge, next};

/// Reads a PLY file: its elements `vertex`, `face` and `tristrips`.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut model = Model {
        bytes: bytes.len(),
        ..Model::default()
    };
    let mut file = File {
        bytes,
        at: 0,
        line: 0,
        order: Order::Text,
    };
    let elements = file.header(&mut model, folder)?;
    let mut faces = Faces::default();
    for element in &elements {
        if let Err(problem) = file.element(element, &mut model, &mut faces, folder) {
            // The faces that were read before the problem are drawn.
            if faces.ends.is_empty() {
                return Err(problem);
            }
            let note = format!("the rest of the file is left out: {problem}");
            model.notes.add(note);
            break;
        }
    }
    // A file can have its faces before its vertices, so the faces become polygons only after all elements are read.
    let material = (!model.materials.is_empty()).then_some(0);
    let [uv, normal, color] = faces.attributes;
    let mut corners = Vec::new();
    let mut start = 0;
    for (&end, &own_color) in faces.ends.iter().zip(&faces.colors) {
        corners.clear();
        corners.extend_from_slice(&faces.corners[start..end]);
        start = end;
        for corner in &mut corners {
            let of = |first: Option<u32>| first?.checked_add(corner.position);
            corner.uv = corner.uv.or(of(uv));
            corner.normal = of(normal);
            corner.color = own_color.or(of(color));
        }
        model.polygon(&mut corners, material, Smoothing::Angle)?;
    }
    Ok(model)
}

/// How the numbers of a file are written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Order {
    Text,
    Little,
    Big,
}

/// The type of a number.
#[derive(Clone, Copy)]
struct Kind {
    size: usize,
    signed: bool,
    float: bool,
}

impl Kind {
    fn of(name: &[u8]) -> Option<Self> {
        let (size, signed, float) = match name {
            b"char" | b"int8" => (1, true, false),
            b"uchar" | b"uint8" => (1, false, false),
            b"short" | b"int16" => (2, true, false),
            b"ushort" | b"uint16" => (2, false, false),
            b"int" | b"int32" => (4, true, false),
            b"uint" | b"uint32" => (4, false, false),
            b"float" | b"float32" => (4, true, true),
            b"double" | b"float64" => (8, true, true),
            _ => return None,
        };
        Some(Self {
            size,
            signed,
            float,
        })
    }

    /// Converts a component of a color to a byte. Full brightness is 1 for a fraction, and the largest value of the
    /// type for an integer.
    fn color(self, value: f64) -> u8 {
        let bits = i32::try_from(8 * self.size - usize::from(self.signed)).unwrap_or(8);
        byte(if self.float {
            value
        } else {
            value / (f64::from(bits).exp2() - 1.0)
        })
    }
}

struct Property {
    name: String,
    /// The type of a list's length; `None` if the property is no list.
    count: Option<Kind>,
    kind: Kind,
}

struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

/// The faces that have been read. The faces are kept until all vertices are read.
#[derive(Default)]
struct Faces {
    corners: Vec<Corner>,
    /// For each face, the end of its corners in `corners`.
    ends: Vec<usize>,
    colors: Vec<Option<u32>>,
    /// The index of each face color in the model's list of colors.
    places: HashMap<[u8; 3], u32>,
    /// The indices of the first vertex's texture coordinate, normal and color in the model's lists.
    attributes: [Option<u32>; 3],
}

impl Faces {
    /// Adds a face, with texture coordinates and a color of its own if it has them.
    fn face(
        &mut self,
        model: &mut Model,
        indices: &[f64],
        uvs: &[f64],
        color: Option<[u8; 3]>,
    ) -> Result<(), String> {
        let color = color.map(|color| merge(&mut model.colors, &mut self.places, color, color));
        let color = color.transpose()?;
        let mut corners: Vec<Corner> = indices.iter().map(|&index| corner(index)).collect();
        if uvs.len() == 2 * corners.len() {
            for (corner, uv) in corners.iter_mut().zip(uvs.chunks_exact(2)) {
                corner.uv = Some(next(&model.uvs)?);
                model.uvs.push([uv[0], 1.0 - uv[1]]);
            }
        }
        self.push(corners, color);
        Ok(())
    }

    fn push(&mut self, corners: impl IntoIterator<Item = Corner>, color: Option<u32>) {
        self.corners.extend(corners);
        self.ends.push(self.corners.len());
        self.colors.push(color);
    }
}

/// A corner at a vertex. An index that is not a whole number becomes the index of a vertex that does not exist.
fn corner(index: f64) -> Corner {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked
    let position = if index.fract() == 0.0 && (0.0..4e9).contains(&index) {
        index as u32
    } else {
        u32::MAX
    };
    Corner {
        position,
        ..Corner::default()
    }
}

struct File<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    order: Order,
}

impl<'a> File<'a> {
    /// The next line without its end; `None` at the end of the file.
    fn line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        self.line += 1;
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let line = &rest[..end.unwrap_or(rest.len())];
        let crlf = end.is_some_and(|end| rest[end..].starts_with(b"\r\n"));
        self.at += line.len() + usize::from(end.is_some()) + usize::from(crlf);
        Some(line)
    }

    /// Reads the header: the elements and their properties.
    fn header(&mut self, model: &mut Model, folder: Folder<'_>) -> Result<Vec<Element>, String> {
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let line = self.line().ok_or("its header has no line 'end_header'")?;
            let words: Vec<&[u8]> =
                words(line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line)).collect();
            let text = |word: &[u8]| String::from_utf8_lossy(word).into_owned();
            let kind = |word: &[u8]| {
                Kind::of(word)
                    .ok_or_else(|| format!("line {}: {} is not a type", self.line, quote(word)))
            };
            match words.as_slice() {
                [b"end_header"] => return Ok(elements),
                [b"format", format, ..] => {
                    let order = match *format {
                        b"ascii" => Some(Order::Text),
                        b"binary_little_endian" => Some(Order::Little),
                        b"binary_big_endian" => Some(Order::Big),
                        _ => None,
                    };
                    let (line, name) = (self.line, quote(format));
                    self.order =
                        order.ok_or_else(|| format!("line {line}: there is no format {name}"))?;
                }
                [b"comment", b"TextureFile", name @ ..]
                    if !name.is_empty() && model.images.is_empty() =>
                {
                    let file = folder.beside(&text(&name.join(&b' ')));
                    model.images.push(Image::File(file));
                    model.materials.push(Material {
                        texture: Some(0),
                        ..Material::new(String::new())
                    });
                }
                [b"element", name, count] => {
                    let count = parse(count).ok_or_else(|| {
                        format!("line {}: the number of elements is missing", self.line)
                    })?;
                    elements.push(Element {
                        name: text(name),
                        count,
                        properties: Vec::new(),
                    });
                }
                [b"property", list @ .., values, name] if matches!(list, [] | [b"list", _]) => {
                    let property = Property {
                        name: text(name),
                        count: list.get(1).map(|count| kind(count)).transpose()?,
                        kind: kind(values)?,
                    };
                    let element = elements.last_mut();
                    let element = element.ok_or("a property comes before its element")?;
                    element.properties.push(property);
                }
                [] | [b"ply" | b"comment" | b"obj_info", ..] => {}
                [_, ..] => {
                    let note = "a line of the header that is not of PLY is left out";
                    model.notes.add(note);
                }
            }
        }
    }

    /// Reads the next number. In a text file, the number is the next word of `words`.
    fn number(
        &mut self,
        kind: Kind,
        words: &mut dyn Iterator<Item = &'a [u8]>,
    ) -> Result<f64, String> {
        if self.order == Order::Text {
            let word = words.next().ok_or("a number is missing")?;
            return number(word);
        }
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let bytes = rest.get(..kind.size).ok_or("the file ends here")?;
        self.at += kind.size;
        let mut low_first = [0; 8];
        low_first[..kind.size].copy_from_slice(bytes);
        if self.order == Order::Big {
            low_first[..kind.size].reverse();
        }
        let bits = u64::from_le_bytes(low_first);
        let unused = 64 - 8 * kind.size;
        #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)]
        // All values have at most 32 bits, except doubles.
        Ok(match (kind.float, kind.size) {
            (true, 4) => f32::from_bits(bits as u32).into(),
            (true, _) => f64::from_bits(bits),
            _ if kind.signed => ((bits << unused).cast_signed() >> unused) as f64,
            _ => bits as f64,
        })
    }

    /// Reads one element: for each property, the list of its values.
    fn row(&mut self, element: &Element, row: &mut [Vec<f64>]) -> Result<(), String> {
        let mut line: &[u8] = b"";
        while self.order == Order::Text && line.trim_ascii().is_empty() {
            line = self.line().ok_or("the file ends here")?;
        }
        let mut words = words(line);
        for (property, values) in element.properties.iter().zip(row) {
            values.clear();
            let mut value = |kind| {
                self.number(kind, &mut words)
                    .map_err(|problem| format!("'{}': {problem}", property.name))
            };
            let count = property.count.map_or(Ok(1.0), &mut value)?;
            for _ in 0..corner(count).position {
                values.push(value(property.kind)?);
            }
        }
        Ok(())
    }

    /// Reads all elements of one kind.
    fn element(
        &mut self,
        element: &Element,
        model: &mut Model,
        faces: &mut Faces,
        folder: Folder<'_>,
    ) -> Result<(), String> {
        let find = |names: &&[&str]| {
            let mut properties = element.properties.iter();
            properties.position(|property| names.contains(&property.name.as_str()))
        };
        let fields = |names: &[&[&str]]| names.iter().map(find).collect::<Option<Vec<usize>>>();
        let position = fields(&[&["x"], &["y"], &["z"]]);
        let normal = fields(&[&["nx"], &["ny"], &["nz"]]);
        let uv = fields(&[
            &["s", "u", "texture_u", "s0"],
            &["t", "v", "texture_v", "t0"],
        ]);
        let color = fields(&[
            &["red", "r", "diffuse_red"],
            &["green", "g", "diffuse_green"],
            &["blue", "b", "diffuse_blue"],
        ]);
        let [indices, uvs] = [
            &["vertex_indices", "vertex_index"],
            &["texcoord", "texcoords"],
        ]
        .map(|names| find(&&names[..]));
        match element.name.as_str() {
            "vertex" if position.is_none() => {
                return Err("its vertices have no properties x, y and z".into());
            }
            "vertex" => {
                faces.attributes = [
                    uv.as_ref().map(|_| next(&model.uvs)).transpose()?,
                    normal.as_ref().map(|_| next(&model.normals)).transpose()?,
                    color.as_ref().map(|_| next(&model.colors)).transpose()?,
                ];
            }
            "face" | "tristrips" if indices.is_none() => {
                return Err("its faces have no property vertex_indices".into());
            }
            "face" | "tristrips" => {}
            other => model.notes.left_out(format!("elements '{other}'")),
        }
        let mut row: Vec<Vec<f64>> = vec![Vec::new(); element.properties.len()];
        for at in 0..element.count {
            if element.properties.is_empty() && self.order != Order::Text {
                break;
            }
            let start = self.at;
            self.row(element, &mut row)
                .map_err(|problem| match self.order {
                    Order::Text => format!("line {}: {problem}", self.line),
                    _ => format!(
                        "byte {start}, '{}' {at} of {}: {problem}",
                        element.name, element.count
                    ),
                })?;
            let list = |property: Option<usize>| {
                property.map_or(&[][..], |property| row[property].as_slice())
            };
            let value = |field: usize| row[field].first().copied().unwrap_or(0.0);
            let three = |fields: &Vec<usize>| [0, 1, 2].map(|axis| value(fields[axis]));
            let bytes = |fields: &Vec<usize>| {
                [0, 1, 2].map(|at| element.properties[fields[at]].kind.color(value(fields[at])))
            };
            match element.name.as_str() {
                "vertex" => {
                    model.positions.extend(position.as_ref().map(three));
                    model.normals.extend(normal.as_ref().map(three));
                    model.colors.extend(color.as_ref().map(bytes));
                    // In the file, v points up.
                    model
                        .uvs
                        .extend(uv.as_ref().map(|uv| [value(uv[0]), 1.0 - value(uv[1])]));
                }
                "face" => faces.face(model, list(indices), list(uvs), color.as_ref().map(bytes))?,
                "tristrips" => {
                    for strip in list(indices).split(|&index| index < 0.0) {
                        for (at, triangle) in strip.windows(3).enumerate() {
                            let [a, b, c] = [triangle[at % 2], triangle[1 - at % 2], triangle[2]];
                            faces.push([a, b, c].map(corner), None);
                        }
                    }
                }
                _ => {}
            }
            folder.progress(at, self.at);
        }
        Ok(())
    }
}
