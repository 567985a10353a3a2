//! Reads STL files, both text and binary.

use std::collections::HashMap;

use super::files::Folder;
use super::sniff::is_binary_stl;
use super::text::{first_word, line_end, number};
use super::{Corner, Model, Smoothing, merge};

/// Reads an STL file. The file's normals are ignored, because they are zero or follow from the corners.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut reader = Reader::default();
    reader.model.bytes = bytes.len();
    // The header of a binary file may also begin with "solid".
    if is_binary_stl(bytes) || bytes.iter().take(1024).any(|&byte| byte == 0) {
        reader.binary(bytes, folder)?;
    } else {
        reader.text(bytes.trim_ascii_end(), folder)?;
    }
    Ok(reader.model)
}

/// Collects separate triangles in a model. The maps give the indices of positions and colors that the model has
/// already.
#[derive(Default)]
struct Reader {
    model: Model,
    positions: HashMap<[u64; 3], u32>,
    colors: HashMap<[u8; 3], u32>,
}

impl Reader {
    fn text(&mut self, text: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let (first, mut rest) = first_word(text).unwrap_or_default();
        if !first.to_ascii_lowercase().ends_with(b"solid") {
            return Err("it is text, and does not begin with 'solid'".into());
        }
        let (mut is_name, mut numbers, mut missing) = (true, Vec::new(), 0);
        while !rest.is_empty() {
            let (word, after) = first_word(rest).unwrap_or_default();
            let read = text.len() - rest.len();
            rest = after;
            let is = |keyword: &str| word.eq_ignore_ascii_case(keyword.as_bytes());
            // The name of a solid can contain any words, even `vertex`.
            is_name = is("solid") || is("endsolid") || (is_name && !is("facet"));
            if missing > 0 {
                numbers.push(number(word).map_err(|problem| {
                    let end = line_end(text);
                    let line = text[..read].split(|&byte| byte == end).count();
                    format!("line {line}: {problem}")
                })?);
                missing -= 1;
            } else if is("vertex") && !is_name {
                missing = 3;
            }
            let is_end =
                is("outer") || is("endloop") || is("facet") || is("endfacet") || is("endsolid");
            if (is_end || rest.is_empty()) && (missing > 0 || !numbers.is_empty()) {
                self.facet(&numbers, None)?;
                numbers.clear();
                missing = 0;
                folder.progress(self.model.triangles.len(), read);
            }
        }
        Ok(())
    }

    fn binary(&mut self, bytes: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let Some((header, rest)) = bytes.split_first_chunk::<84>() else {
            return Err(format!("it has {} bytes: a header takes 84", bytes.len()));
        };
        let [.., a, b, c, d] = *header;
        let promised = u32::from_le_bytes([a, b, c, d]) as usize;
        let (triangles, left) = rest.as_chunks::<50>();
        let has = triangles.len();
        // Programs that do not know the number of triangles beforehand write 0. Any bytes can follow the triangles.
        let is_right = promised > 0 && !left.is_empty();
        let count = if is_right { has.min(promised) } else { has };
        if promised != count {
            let note = format!("its header promises {promised} triangles: {count} are read");
            self.model.notes.add(note);
        }
        // Some programs write the color of the whole object to the header.
        let mark = header.windows(6).position(|at| at == b"COLOR=");
        let object = mark.and_then(|at| header.get(at + 6..)?.first_chunk::<3>());
        // Triangles without a color of their own have the object's. Some programs mark none, and write 0 to all.
        let is_blank = triangles[..count]
            .iter()
            .all(|triangle| triangle[48..] == [0, 0]);
        let is_marked = |triangle: &[u8; 50]| triangle[49] & 0x80 > 0;
        let is_colored = object.is_some() || triangles[..count].iter().any(is_marked);
        for (at, triangle) in triangles[..count].iter().enumerate() {
            let bits = u16::from_le_bytes([triangle[48], triangle[49]]);
            let rgb = |shifts: [u32; 3]| shifts.map(|at| ((bits >> at & 31) * 33 / 4) as u8);
            let color = match (object, is_marked(triangle)) {
                (None, true) => rgb([10, 5, 0]),
                (Some(_), false) if !is_blank => rgb([0, 5, 10]),
                _ => *object.unwrap_or(&[255; 3]),
            };
            let colors = &mut self.model.colors;
            let color = is_colored.then(|| merge(colors, &mut self.colors, color, color));
            let color = color.transpose()?;
            let numbers = triangle.as_chunks::<4>().0.iter();
            let numbers: Vec<_> = numbers.map(|&x| f32::from_le_bytes(x).into()).collect();
            self.facet(&numbers[3..], color)?;
            folder.progress(at, 84 + 50 * at);
        }
        Ok(())
    }

    /// Adds a triangle, given by the coordinates of its corners.
    fn facet(&mut self, numbers: &[f64], color: Option<u32>) -> Result<(), String> {
        let mut corners = Vec::new();
        for position in numbers.as_chunks::<3>().0 {
            // −0 and 0 are the same position.
            let position = position.map(|x| x + 0.0);
            let (list, key) = (&mut self.model.positions, position.map(f64::to_bits));
            let position = merge(list, &mut self.positions, key, position)?;
            let mut corner = Corner::default();
            (corner.position, corner.color) = (position, color);
            corners.push(corner);
        }
        self.model.polygon(&mut corners, None, Smoothing::Angle)
    }
}
