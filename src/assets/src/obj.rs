//! Reads Wavefront OBJ of any size.

use std::collections::HashSet;
use std::ops::Range;

use super::files::Folder;
use super::mtl::{self, Materials};
use super::text::{after_keyword, numbers, parse, quote, statements, words};
use super::{Corner, Model, Smoothing};

/// Reads OBJ text, and the materials that it names from `folder`.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut reader = Reader::default();
    let mut statements = statements(bytes, |line, read| folder.progress(line, read));
    let result = statements.try_for_each(|(line, statement)| {
        let read = reader.statement(&statement, folder);
        read.map_err(|problem| format!("line {line}: {problem}"))
    });
    if bytes.contains(&0) && (result.is_err() || reader.polygons.is_empty()) {
        return Err("it is not text: an OBJ file must be text".into());
    }
    result.and_then(|()| reader.finish())
}

/// The largest number of corners of a face. A face with more is a mistake that would fill the memory.
const MOST_CORNERS: usize = 1_000_000;

/// The color of positions without one: white, whatever the range of the others.
const NO_COLOR: [f64; 3] = [f64::INFINITY; 3];

/// A polygon: its corners, and how it looks.
struct Polygon {
    corners: Range<usize>,
    material: Option<u32>,
    smoothing: Smoothing,
}

#[derive(Default)]
struct Reader {
    model: Model,
    materials: Materials,
    libraries: HashSet<Vec<u8>>,
    /// For each position up to the last with a color.
    colors: Vec<[f64; 3]>,
    corners: Vec<Corner>,
    polygons: Vec<Polygon>,
    material: Option<u32>,
    smoothing: Smoothing,
}

impl Reader {
    fn statement(&mut self, statement: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let mut words = words(statement).take_while(|word| !word.starts_with(b"#"));
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        let value = after_keyword(statement);
        let model = &mut self.model;
        match keyword {
            b"v" => {
                let ([x, y, z, r, g, b, _], count) = numbers(words, 3, &mut model.notes)
                    .map_err(|problem| format!("{problem}: {}", quote(statement)))?;
                // Three more numbers are a color; one more number is a weight.
                if count >= 6 {
                    self.colors.resize(model.positions.len(), NO_COLOR);
                    self.colors.push([r, g, b]);
                }
                model.positions.push([x, y, z]);
            }
            b"vt" | b"vn" => {
                let least = if keyword == b"vt" { 1 } else { 3 };
                // What cannot be read is kept as NaN, because faces count it.
                let read = numbers(words, least, &mut model.notes);
                let [x, y, z, ..] = read.map_or([f64::NAN; 7], |(numbers, _)| numbers);
                if keyword == b"vn" {
                    model.normals.push([x, y, z]);
                } else {
                    // In OBJ files, v points up. Here it points down, as an image's rows do.
                    model.uvs.push([x, 1.0 - y]);
                }
            }
            b"f" | b"fo" => {
                let start = self.corners.len();
                for word in words {
                    if self.corners.len() - start == MOST_CORNERS {
                        return Err(format!("a face has more than {MOST_CORNERS} corners"));
                    }
                    self.corners.push(corner(model, word));
                }
                self.polygons.push(Polygon {
                    corners: start..self.corners.len(),
                    material: self.material,
                    smoothing: self.smoothing,
                });
            }
            b"l" => {
                let ends: Vec<u32> = words.map(|word| corner(model, word).position).collect();
                for ends in ends.windows(2) {
                    if ends.iter().all(|&at| model.is_usable(at) == Some(true)) {
                        model.edge(ends[0], ends[1]);
                    } else {
                        model.notes.add("a line is left out: an end is missing");
                    }
                }
            }
            b"s" => {
                self.smoothing = match words.next().unwrap_or_default() {
                    b"off" | b"0" => Smoothing::Flat,
                    b"on" => Smoothing::Group(1),
                    group => parse(group).map_or(self.smoothing, Smoothing::Group),
                };
            }
            b"usemtl" if value.is_empty() => self.material = None,
            b"usemtl" => self.material = Some(self.materials.named(model, value)?),
            b"mtllib" => {
                if self.libraries.insert(value.to_vec()) {
                    self.library(&String::from_utf8_lossy(value), folder)?;
                }
            }
            b"g" | b"o" => {}
            _ => model.notes.left_out(quote(keyword)),
        }
        Ok(())
    }

    /// Reads the materials that `mtllib` names: a file, or several. A missing file is only noted.
    fn library(&mut self, names: &str, folder: Folder<'_>) -> Result<(), String> {
        let mut files: Vec<_> = names
            .split_whitespace()
            .map(|name| folder.beside(name))
            .collect();
        let whole = folder.beside(names);
        if folder.files.has(&whole) || !files.iter().any(|file| folder.files.has(file)) {
            files = vec![whole];
        }
        let model = &mut self.model;
        for file in files {
            match folder.files.read(&file) {
                Ok(text) => self.materials.read(model, &text, folder)?,
                Err(error) => model
                    .notes
                    .add(format!("cannot read materials {}: {error}", file.display())),
            }
            model.files.push(file);
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Model, String> {
        let model = &mut self.model;
        let is_colored = !self.colors.is_empty();
        if is_colored {
            self.colors.resize(model.positions.len(), NO_COLOR);
        }
        let finite = self.colors.iter().flatten().filter(|x| x.is_finite());
        // Some programs write 1.0001 for 1.
        let scale = if finite.fold(0.0, |most: f64, &x| most.max(x)) > 1.5 {
            255.0
        } else {
            1.0
        };
        let bytes = |color: [f64; 3]| color.map(|x| mtl::byte(x / scale));
        model.colors = self.colors.into_iter().map(bytes).collect();

        let (uvs, normals) = (model.uvs.len(), model.normals.len());
        let exists = |index: u32, len: usize| {
            if (index as usize) < len {
                index
            } else {
                u32::MAX
            }
        };
        for polygon in self.polygons {
            let corners = &mut self.corners[polygon.corners];
            for corner in &mut *corners {
                corner.color = is_colored.then_some(corner.position);
                // Repairs will make these lists longer.
                corner.uv = corner.uv.map(|at| exists(at, uvs));
                corner.normal = corner.normal.map(|at| exists(at, normals));
            }
            model.polygon(corners, polygon.material, polygon.smoothing)?;
        }
        if let Some(&first) = self.materials.undefined.first() {
            let name = quote(model.materials[first as usize].name.as_bytes());
            model.notes.add(match self.materials.undefined.len() {
                1 => format!("material {name} is not defined: it is white"),
                count => format!("{count} materials are not defined, {name} first: they are white"),
            });
        }
        model.transform_uvs(&self.materials.transforms)?;
        Ok(self.model)
    }
}

/// A corner: indices of its position, texture coordinate and normal. What cannot be read is missing: it has the largest
/// index.
fn corner(model: &Model, word: &[u8]) -> Corner {
    let lens = [model.positions.len(), model.uvs.len(), model.normals.len()];
    let mut indices = [None; 3];
    let mut parts = word.split(|&byte| byte == b'/');
    for ((index, len), part) in indices.iter_mut().zip(lens).zip(&mut parts) {
        *index = (!part.is_empty()).then(|| self::index(part, len));
    }
    let [position, uv, normal] = indices;
    Corner {
        position: position
            .filter(|_| parts.next().is_none())
            .unwrap_or(u32::MAX),
        uv,
        normal,
        color: None,
    }
}

/// An index from 0. In the file, indices count from 1, or backwards from the last of the `len` elements so far.
fn index(part: &[u8], len: usize) -> u32 {
    let from_0 = match parse::<i64>(part) {
        Some(index) if index > 0 => index - 1,
        Some(index) if index < 0 => len.cast_signed() as i64 + index,
        _ => -1,
    };
    u32::try_from(from_0).unwrap_or(u32::MAX)
}
