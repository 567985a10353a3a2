//! Runs of faces with one material.

use super::name::Name;
use super::reader::Reader;
use crate::Error;
use crate::error::ok;

/// A statement that matters to parts.
pub(super) enum Statement {
    /// A polygon, with the number of triangles that it becomes.
    Face(usize),
    /// `usemtl`: the following faces have this material.
    Material(Name),
    /// The end of the text.
    End,
}

/// A run of faces with one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    pub(super) start: usize,
    pub(super) end: usize,
    /// The material's name; empty for faces before the first `usemtl`.
    pub(super) name: Name,
}

impl Run {
    pub(super) const NONE: Self = Self {
        start: 0,
        end: 0,
        name: Name::EMPTY,
    };
}

/// An upper bound for the runs in a text of `bytes` bytes: `usemtl`, a blank, a name and a line's end take 9 bytes.
#[must_use]
pub const fn room(bytes: usize) -> usize {
    bytes / 9 + 2
}

/// The runs of a text, in a list with room for any text of its length, and how many there are.
pub(super) const fn runs<const N: usize>(text: &[u8]) -> Result<([Run; N], usize), Error> {
    let mut runs = [Run::NONE; N];
    let (mut count, mut faces) = (0, 0);
    let mut name = Name::EMPTY;
    let mut reader = Reader::new(text, [0; 3]);
    loop {
        match ok!(reader.part_statement()) {
            Statement::Face(triangles) => {
                if count == 0 || !runs[count - 1].name.is(text, name, text) {
                    runs[count] = Run {
                        start: faces,
                        end: faces,
                        name,
                    };
                    count += 1;
                }
                faces += triangles;
                runs[count - 1].end = faces;
            }
            Statement::Material(next) => name = next,
            Statement::End => return Ok((runs, count)),
        }
    }
}

impl Reader<'_> {
    /// Reads the next statement that matters to parts. Mistakes in faces are left to the reader of the mesh.
    pub(super) const fn part_statement(&mut self) -> Result<Statement, Error> {
        while self.begins() {
            if self.keyword(b"f") {
                return Ok(Statement::Face(self.count_words().saturating_sub(2)));
            }
            if self.keyword(b"usemtl") {
                let name = ok!(self.name("usemtl needs the name of a material"));
                return Ok(Statement::Material(name));
            }
            self.skip(false);
        }
        Ok(Statement::End)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::String;
    use std::vec::Vec;

    /// The runs of a text: where they start and end, and the names of their materials.
    fn found(text: &str) -> Result<Vec<(usize, usize, String)>, Error> {
        let (runs, count) = runs::<99>(text.as_bytes())?;
        assert!(count <= room(text.len()));
        let name = |name: Name| String::from(&text[name.start..name.end]);
        Ok(runs[..count]
            .iter()
            .map(|run| (run.start, run.end, name(run.name)))
            .collect())
    }

    #[test]
    fn a_run_ends_where_the_material_changes() {
        let text = "f 1 2 3 4\nusemtl a b \t# c\nf 1 2 3 \\\n 4 5\nf 1/1 2/2 3//3\nusemtl c\r\nusemtl a b\nf 1 2 3\n\
            usemtl d#e\nv 0 0 0\nf 1 2 3\nusemtl f";
        let expected = [(0, 2, ""), (2, 7, "a b"), (7, 8, "d#e")];
        let expected = expected.map(|(start, end, name)| (start, end, String::from(name)));
        assert_eq!(found(text).unwrap(), expected);
        assert_eq!(found("").unwrap(), []);
    }

    #[test]
    fn a_material_needs_a_name() {
        let error = found("f 1 2 3\nusemtl # none").unwrap_err();
        let line = "line 2: usemtl needs the name of a material";
        assert_eq!(std::string::ToString::to_string(&error), line);
    }

    #[test]
    fn the_most_runs_fit() {
        let text = "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3";
        assert_eq!(found(text).unwrap().len(), 4);
    }
}
