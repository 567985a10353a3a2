//! Reads Wavefront OBJ of any size, in the dialect of the crate's own reader (`fixel::mesh::obj`).

use std::collections::HashMap;
use std::ops::Range;

use super::files::Folder;
use super::mtl;
use super::text::{Statements, after_keyword, number, quote, words};
use super::{Corner, Model, Smoothing, next};

/// Reads OBJ text, and the materials that it names from `folder`.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut reader = Reader::default();
    let mut statements = Statements::new(bytes);
    while let Some((line, statement)) = statements.next() {
        reader.line = line;
        reader
            .statement(&statement)
            .map_err(|problem| format!("line {line}: {problem}"))?;
        folder.progress(line, statements.read());
    }
    reader.finish(folder, bytes)
}

/// What a corner's indices name.
const KINDS: [&str; 3] = ["position", "texture coordinate", "normal"];

/// The largest number of corners of a face. A face with more is a mistake that would fill the memory.
const MOST_CORNERS: usize = 1_000_000;

/// A polygon: its corners, and its material as an index in the list of names.
struct Polygon {
    corners: Range<usize>,
    material: Option<u32>,
}

#[derive(Default)]
struct Reader {
    line: usize,
    model: Model,
    corners: Vec<Corner>,
    polygons: Vec<Polygon>,
    /// The greatest index of each kind, and its line. An index may name an element that comes later.
    greatest: [Option<(u32, usize)>; 3],
    libraries: Vec<String>,
    /// The names of materials, in the order of their first use.
    names: Vec<String>,
    places: HashMap<String, u32>,
    material: Option<u32>,
}

impl Reader {
    fn statement(&mut self, statement: &[u8]) -> Result<(), String> {
        let mut words = words(statement);
        match words.next() {
            Some(b"v") => {
                let numbers = numbers(words, 3, 7)?;
                let at = |at: usize| numbers[at].1;
                // Three more numbers are a color; one more number is a weight.
                if numbers.len() >= 6 {
                    self.model
                        .colors
                        .resize(self.model.positions.len(), [255; 3]);
                    self.model.colors.push([at(3), at(4), at(5)].map(mtl::byte));
                }
                self.model.positions.push([at(0), at(1), at(2)]);
            }
            Some(b"vt") => {
                let numbers = numbers(words, 1, 2)?;
                let (u, v) = (numbers[0], numbers.get(1).copied().unwrap_or((b"0", 0.0)));
                // In OBJ files, v points up. Here it points down, as an image's rows do.
                self.model.uvs.push([u.1, 1.0 - v.1]);
            }
            Some(b"vn") => {
                let numbers = numbers(words, 3, 3)?;
                let normal = [numbers[0].1, numbers[1].1, numbers[2].1];
                self.model.normals.push(normal);
            }
            Some(b"f") => {
                let start = self.corners.len();
                for word in words {
                    if self.corners.len() - start == MOST_CORNERS {
                        return Err(format!("a face has more than {MOST_CORNERS} corners"));
                    }
                    let corner = self.corner(word)?;
                    self.corners.push(corner);
                }
                let corners = start..self.corners.len();
                if corners.len() < 3 {
                    return Err("a face needs at least 3 corners".into());
                }
                let material = self.material;
                self.polygons.push(Polygon { corners, material });
            }
            Some(b"l") => {
                let mut before = None;
                for word in words {
                    let Corner { position, .. } = self.corner(word)?;
                    if let Some(before) = before.replace(position) {
                        self.model.edge(before, position);
                    }
                }
            }
            Some(b"usemtl") => {
                let name = String::from_utf8_lossy(after_keyword(statement)).into_owned();
                let new = next(&self.names)?;
                let place = *self.places.entry(name.clone()).or_insert(new);
                if place == new {
                    self.names.push(name);
                }
                self.material = Some(place);
            }
            Some(b"mtllib") => {
                let name = String::from_utf8_lossy(after_keyword(statement)).into_owned();
                self.libraries.push(name);
            }
            _ => {}
        }
        Ok(())
    }

    /// A corner: indices of its position, texture coordinate and normal, of which the last two may be missing.
    fn corner(&mut self, word: &[u8]) -> Result<Corner, String> {
        let mut indices = [None; 3];
        let mut parts = word.split(|&byte| byte == b'/');
        for (kind, place) in indices.iter_mut().enumerate() {
            match parts.next() {
                Some(b"") => {}
                Some(part) => *place = Some(self.index(kind, part)?),
                None => break,
            }
        }
        let [Some(position), uv, normal] = indices else {
            return Err(format!("{} names no position", quote(word)));
        };
        if parts.next().is_some() {
            return Err(format!("{} has more than 3 indices", quote(word)));
        }
        Ok(Corner {
            position,
            uv,
            normal,
            color: None,
        })
    }

    fn index(&mut self, kind: usize, part: &[u8]) -> Result<u32, String> {
        let seen = match kind {
            0 => self.model.positions.len(),
            1 => self.model.uvs.len(),
            _ => self.model.normals.len(),
        };
        let index: i64 = std::str::from_utf8(part)
            .ok()
            .and_then(|part| part.parse().ok())
            .ok_or_else(|| format!("{} is not an index", quote(part)))?;
        let from_0 = if index > 0 {
            index - 1
        } else {
            seen.cast_signed() as i64 + index
        };
        let Some(from_0) = u32::try_from(from_0).ok().filter(|_| index != 0) else {
            return Err(missing(kind, index, seen));
        };
        if self.greatest[kind].is_none_or(|(greatest, _)| greatest < from_0) {
            self.greatest[kind] = Some((from_0, self.line));
        }
        Ok(from_0)
    }

    fn finish(mut self, folder: Folder<'_>, bytes: &[u8]) -> Result<Model, String> {
        let model = &mut self.model;
        let lists = [model.positions.len(), model.uvs.len(), model.normals.len()];
        for (kind, len) in lists.into_iter().enumerate() {
            if let Some((index, line)) =
                self.greatest[kind].filter(|&(index, _)| index as usize >= len)
            {
                return Err(format!(
                    "line {line}: {}",
                    missing(kind, i64::from(index) + 1, len)
                ));
            }
        }
        if self.polygons.is_empty() && bytes.contains(&0) {
            return Err("it has no faces, and is not text: an OBJ file must be text".into());
        }
        for library in &self.libraries {
            read_library(model, library, folder)?;
        }
        let materials = self.materials();
        let model = &mut self.model;
        let is_colored = !model.colors.is_empty();
        if is_colored {
            model.colors.resize(model.positions.len(), [255; 3]);
        }
        for Polygon { corners, material } in self.polygons {
            let corners = &mut self.corners[corners];
            for corner in corners.iter_mut() {
                corner.color = is_colored.then_some(corner.position);
            }
            // A texture needs coordinates at all three corners.
            if corners.iter().any(|corner| corner.uv.is_none()) {
                for corner in corners.iter_mut() {
                    corner.uv = None;
                }
            }
            let material = material.and_then(|name| materials[name as usize]);
            model.polygon(corners, material, Smoothing::Angle)?;
        }
        Ok(self.model)
    }

    /// Returns the material for each name that faces use, and notes names that no library defines.
    fn materials(&mut self) -> Vec<Option<u32>> {
        let model = &mut self.model;
        let mut places = HashMap::new();
        for (place, material) in (0..).zip(&model.materials) {
            places.entry(material.name.as_str()).or_insert(place);
        }
        let found: Vec<Option<u32>> = self
            .names
            .iter()
            .map(|name| places.get(name.as_str()).copied())
            .collect();
        // If there is no library at all, because its file is missing, one note is enough.
        if !model.materials.is_empty() {
            for (name, _) in self
                .names
                .iter()
                .zip(&found)
                .filter(|(_, found)| found.is_none())
            {
                model.notes.add(format!(
                    "material {} is not defined: its faces are white",
                    quote(name.as_bytes())
                ));
            }
        }
        found
    }
}

/// Reads the materials that `mtllib` names: a file, or several. A missing file is only noted.
fn read_library(model: &mut Model, names: &str, folder: Folder<'_>) -> Result<(), String> {
    let whole = folder.beside(names);
    let files = if folder.files.has(&whole) {
        vec![whole]
    } else {
        names
            .split_whitespace()
            .map(|name| folder.beside(name))
            .collect()
    };
    for file in files {
        model.files.push(file.clone());
        match folder.files.read(&file) {
            Ok(text) => mtl::read(model, &text, folder)
                .map_err(|problem| format!("materials {}: {problem}", file.display()))?,
            Err(error) => model
                .notes
                .add(format!("cannot read materials {}: {error}", file.display())),
        }
    }
    Ok(())
}

/// Says that an index names nothing.
fn missing(kind: usize, index: i64, len: usize) -> String {
    let kind = KINDS[kind];
    match index {
        0 => format!("{kind} 0 does not exist: indices count from 1"),
        _ => format!("{kind} {index} does not exist: there are {len}"),
    }
}

/// The words of a statement as numbers: at least `least` of them, and at most `most`. Further ones are ignored.
fn numbers<'a>(
    words: impl Iterator<Item = &'a [u8]>,
    least: usize,
    most: usize,
) -> Result<Vec<(&'a [u8], f64)>, String> {
    let numbers: Vec<_> = words
        .take(most)
        .map(|word| Ok((word, number(word)?)))
        .collect::<Result<_, String>>()?;
    if numbers.len() < least {
        return Err(format!(
            "it needs {least} numbers, and has {}",
            numbers.len()
        ));
    }
    Ok(numbers)
}
