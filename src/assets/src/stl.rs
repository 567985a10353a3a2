//! Reads STL, text and binary.

use std::collections::HashMap;

use super::files::Folder;
use super::sniff::is_binary_stl;
use super::text::{line_end, numbers, words};
use super::{Corner, Model, Smoothing, merge};

/// Reads an STL file. Its normals are ignored, because they only repeat those of the triangles, or are zero.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let mut reader = Reader::default();
    let text = bytes
        .strip_prefix(b"\xef\xbb\xbf")
        .unwrap_or(bytes)
        .trim_ascii_start();
    let is_solid = text
        .get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    // The header of a binary file may also begin with "solid".
    if is_solid && !is_binary_stl(bytes) && !bytes.iter().take(1024).any(|&byte| byte == 0) {
        reader.text(text, folder)?;
    } else {
        reader.binary(bytes, folder)?;
    }
    Ok(reader.model)
}

/// A model made of separate triangles.
#[derive(Default)]
struct Reader {
    model: Model,
    positions: HashMap<[u64; 3], u32>,
    colors: HashMap<[u8; 3], u32>,
}

impl Reader {
    fn text(&mut self, text: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let (mut words, end) = (words(text), line_end(text));
        let (mut corners, mut is_name) = (Vec::new(), false);
        while let Some(word) = words.next() {
            let is = |keyword: &str| word.eq_ignore_ascii_case(keyword.as_bytes());
            // A name may have any words.
            is_name = is("solid") || is("endsolid") || (is_name && !is("facet"));
            let read = word.as_ptr().addr() - text.as_ptr().addr();
            if is("vertex") && !is_name {
                let ([x, y, z, ..], _) = numbers(words.by_ref().take(3), 3, &mut self.model.notes)
                    .map_err(|problem| {
                        let line = text[..read].split(|&byte| byte == end).count();
                        format!("line {line}: {problem}")
                    })?;
                corners.push(self.corner([x, y, z], None)?);
            }
            let is_end = is("facet") || is("endfacet");
            if corners.len() == 3 || (is_end && !corners.is_empty()) {
                self.model.polygon(&mut corners, None, Smoothing::Angle)?;
                corners.clear();
                folder.progress(self.model.triangles.len(), read);
            }
        }
        if !corners.is_empty() {
            self.model.polygon(&mut corners, None, Smoothing::Angle)?;
        }
        Ok(())
    }

    fn binary(&mut self, bytes: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let len = bytes.len();
        let Some((header, rest)) = bytes.split_first_chunk::<84>() else {
            return Err(format!(
                "it is neither text that begins with 'solid' nor binary: a header takes 84 bytes, and it has {len}"
            ));
        };
        let is_text = |byte: &u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
        if header.iter().all(is_text) {
            return Err("it is text, and does not begin with 'solid'".into());
        }
        let [.., a, b, c, d] = *header;
        let promised = u32::from_le_bytes([a, b, c, d]) as usize;
        let (triangles, left) = rest.as_chunks::<50>();
        let has = triangles.len();
        // Programs that do not know the number beforehand write 0. Any bytes may follow the triangles.
        let is_wrong = promised == 0 || left.is_empty();
        let count = if is_wrong { has } else { has.min(promised) };
        if has == 0 && promised > 0 {
            return Err(format!(
                "byte {len}: it ends within triangle 1 of {promised}"
            ));
        }
        if promised != has {
            self.model.notes.add(format!(
                "its header promises {promised} triangles, and there is room for {has}: {count} are read"
            ));
        }
        // A program writes the color of the whole object to the header.
        let mark = header.windows(6).position(|at| at == b"COLOR=");
        let object = mark.and_then(|at| header.get(at + 6..)?.first_chunk::<3>());
        let is_marked = |triangle: &[u8; 50]| triangle[49] & 0x80 > 0;
        let is_colored = object.is_some() || triangles[..count].iter().any(is_marked);
        for (at, triangle) in triangles[..count].iter().enumerate() {
            let bits = u16::from_le_bytes([triangle[48], triangle[49]]);
            let component = |shift: u32| ((bits >> shift & 31) * 255 / 31) as u8;
            let color = match (object, is_marked(triangle)) {
                (None, false) => [255; 3],
                (None, true) => [10, 5, 0].map(component),
                (Some(_), false) => [0, 5, 10].map(component),
                (Some(object), true) => *object,
            };
            let mut corners = [Corner::default(); 3];
            // After the normal.
            let numbers = &triangle.as_chunks::<4>().0[3..];
            for (corner, numbers) in corners.iter_mut().zip(numbers.as_chunks::<3>().0) {
                let position = numbers.map(|bytes| f32::from_le_bytes(bytes).into());
                *corner = self.corner(position, is_colored.then_some(color))?;
            }
            self.model.polygon(&mut corners, None, Smoothing::Angle)?;
            folder.progress(at, 84 + 50 * at);
        }
        Ok(())
    }

    /// A corner, with its position and color in the model's lists.
    fn corner(&mut self, position: [f64; 3], color: Option<[u8; 3]>) -> Result<Corner, String> {
        let model = &mut self.model;
        // −0 and 0 are the same position.
        let position = position.map(|x| x + 0.0);
        let key = position.map(f64::to_bits);
        let mut corner = Corner {
            position: merge(&mut model.positions, &mut self.positions, key, position)?,
            ..Corner::default()
        };
        if let Some(color) = color {
            corner.color = Some(merge(&mut model.colors, &mut self.colors, color, color)?);
        }
        Ok(corner)
    }
}
