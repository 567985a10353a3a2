//! Reads Wavefront OBJ files of any size.

use std::collections::HashSet;
use std::path::PathBuf;

use super::files::Folder;
use super::mtl::{self, Materials};
use super::sniff::contents;
use super::text::{first_word, numbers, parse, quote, statements, words};
use super::{Corner, Model, Smoothing, next};

/// Reads OBJ text and, from `folder`, the material files that the text names.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut reader = Reader::default();
    reader.model.bytes = bytes.len();
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

/// The largest number of corners of a face. A face with more corners is a mistake that would fill the memory.
const MOST_CORNERS: usize = 1_000_000;

/// The largest number of files of materials.
const MOST_LIBRARIES: usize = 64;

/// A polygon, with the material, the smoothing and the object that were set at its line.
struct Polygon {
    corners: Vec<Corner>,
    material: Option<u32>,
    smoothing: Smoothing,
    object: Option<u32>,
}

#[derive(Default)]
struct Reader {
    model: Model,
    materials: Materials,
    libraries: HashSet<Vec<u8>>,
    /// A color for each position, up to the last position with a color in the file.
    colors: Vec<[f64; 3]>,
    polygons: Vec<Polygon>,
    material: Option<u32>,
    smoothing: Smoothing,
}

impl Reader {
    fn statement(&mut self, statement: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let (keyword, value) = first_word(statement).unwrap_or_default();
        let model = &mut self.model;
        match keyword {
            b"v" => {
                let numbers = numbers(value, &mut model.notes);
                let [Some(x), Some(y), Some(z), r, g, b, _] = numbers else {
                    let line = quote(statement);
                    return Err(format!("{line} is not a position: it needs 3 numbers"));
                };
                // Three more numbers are a color; one more number is a weight. Positions without a color get infinity,
                // which becomes white in every range of colors.
                if let (Some(r), Some(g), Some(b)) = (r, g, b) {
                    self.colors
                        .resize(model.positions.len(), [f64::INFINITY; 3]);
                    self.colors.push([r, g, b]);
                }
                model.positions.push([x, y, z]);
            }
            // A value that cannot be read is kept as NaN, because the indices of faces count it.
            b"vt" => {
                let [u, v, ..] = numbers(value, &mut model.notes);
                // In OBJ files, v points up. In a `Model`, v points down, like the rows of an image.
                let uv = [u.unwrap_or(f64::NAN), 1.0 - v.unwrap_or(0.0)];
                model.uvs.push(uv);
            }
            b"vn" => {
                let [x, y, z, ..] = numbers(value, &mut model.notes);
                let normal = [x, y, z].map(|x| x.unwrap_or(f64::NAN));
                model.normals.push(normal);
            }
            b"f" | b"fo" => {
                let corners = words(value).map(|word| corner(model, word));
                let corners: Vec<_> = corners.take(MOST_CORNERS + 1).collect();
                if corners.len() > MOST_CORNERS {
                    return Err(format!("a face has more than {MOST_CORNERS} corners"));
                }
                self.polygons.push(Polygon {
                    corners,
                    material: self.material,
                    smoothing: self.smoothing,
                    object: model.object,
                });
            }
            b"l" => {
                model.has_lines = true;
                let position = |word: &[u8]| corner(model, word).position;
                let ends: Vec<u32> = words(value).map(position).collect();
                for ends in ends.windows(2) {
                    if ends.iter().all(|&at| model.is_usable(at) == Some(true)) {
                        model.edge(ends[0], ends[1]);
                    } else {
                        model.notes.add("a line is left out: an end is missing");
                    }
                }
            }
            b"s" => match words(value).next().map(|word| (word, parse(word))) {
                Some((b"off", _) | (_, Some(0))) => self.smoothing = Smoothing::Flat,
                Some((_, Some(group))) => self.smoothing = Smoothing::Group(group),
                _ => (model.notes).add("a smoothing group is skipped: it is not a number"),
            },
            b"usemtl" if value.is_empty() && !self.materials.has(value) => self.material = None,
            b"usemtl" => self.material = Some(self.materials.named(model, value)?),
            b"mtllib" if !self.libraries.insert(value.to_vec()) => {}
            b"mtllib" if self.libraries.len() > MOST_LIBRARIES => {
                return Err(format!("it names over {MOST_LIBRARIES} files of materials"));
            }
            b"mtllib" => self.library(&String::from_utf8_lossy(value), folder)?,
            b"g" | b"o" if !value.is_empty() => {
                model.begin_object(&String::from_utf8_lossy(value));
            }
            b"g" | b"o" | b"" => {}
            b"p" => model.notes.left_out("points"),
            _ => model.notes.left_out(quote(keyword)),
        }
        Ok(())
    }

    /// Reads the materials that `mtllib` names: one file or several files. A missing file only causes a note.
    fn library(&mut self, names: &str, folder: Folder<'_>) -> Result<(), String> {
        let parts = names.split_whitespace().take(MOST_LIBRARIES);
        let parts = parts.map(|name| folder.beside(name));
        let mut files: Vec<_> = parts.collect();
        let whole = folder.beside(names);
        let is_found = |file: &PathBuf| folder.files.find(file).is_some();
        if is_found(&whole) || !files.iter().any(is_found) {
            files = vec![whole];
        }
        let model = &mut self.model;
        for file in files {
            let name = file.display();
            let folder = Folder {
                own: file.parent(),
                ..folder
            };
            match contents(folder.files.read(&file)) {
                Ok(text) => self.materials.add(model, &text, folder)?,
                Err(error) => (model.notes).add(format!("cannot read materials {name}: {error}")),
            }
            model.files.push(file);
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Model, String> {
        let model = &mut self.model;
        if !self.colors.is_empty() {
            (self.colors).resize(model.positions.len(), [f64::INFINITY; 3]);
        }
        let mut all = self.colors.iter().flatten();
        // Colors with a value of 1.5 or more are bytes. A value slightly above 1 is a fraction, because some programs
        // write 1.0001 for 1.
        let is_byte = all.any(|x| (1.5..f64::INFINITY).contains(x));
        let scale = if is_byte { 255.0 } else { 1.0 };
        let bytes = |color: [f64; 3]| color.map(|x| mtl::byte(x / scale));
        model.colors = self.colors.into_iter().map(bytes).collect();

        // Repairs add to these lists. So the lengths before the repairs decide which indices have no element.
        let (uvs, normals) = (next(&model.uvs)?, next(&model.normals)?);
        let known = |at: u32, count: u32| if at < count { at } else { u32::MAX };
        for mut polygon in self.polygons {
            model.object = polygon.object;
            for corner in &mut polygon.corners {
                corner.uv = corner.uv.map(|at| known(at, uvs));
                corner.normal = corner.normal.map(|at| known(at, normals));
            }
            model.polygon(&mut polygon.corners, polygon.material, polygon.smoothing)?;
        }
        let is_undefined = |(at, _): &(u32, _)| !self.materials.defined.contains(at);
        let mut undefined = (0..).zip(&model.materials).filter(is_undefined);
        if let Some((_, first)) = undefined.next() {
            let (count, name) = (undefined.count() + 1, quote(first.name.as_bytes()));
            let note = format!("undefined materials are white: {count}, the first is {name}");
            model.notes.add(note);
        }
        model.transform_uvs(&self.materials.transforms)?;
        Ok(self.model)
    }
}

/// A corner: indices of its position, texture coordinate and normal. An index that cannot be read becomes the largest
/// `u32`, which counts as missing.
fn corner(model: &Model, word: &[u8]) -> Corner {
    let mut corner = Corner::default();
    for (at, part) in word.split(|&byte| byte == b'/').enumerate() {
        match at {
            0 => corner.position = index(part, model.positions.len()),
            _ if part.is_empty() => {}
            1 => corner.uv = Some(index(part, model.uvs.len())),
            2 => corner.normal = Some(index(part, model.normals.len())),
            _ => corner.position = u32::MAX,
        }
    }
    // Colors, if the file has any, have the same indices as positions.
    corner.color = Some(corner.position);
    corner
}

/// Converts an index of the file to an index that counts from 0. In the file, indices count from 1, or backwards from
/// the last of the `len` elements so far.
fn index(part: &[u8], len: usize) -> u32 {
    let (index, len) = (parse(part).unwrap_or(0), len.cast_signed() as i64);
    let from_0 = index + if index < 0 { len } else { -1 };
    u32::try_from(from_0).unwrap_or(u32::MAX)
}
