//! Runs of faces with one material.

use super::reader::{Reader, are_same};
use crate::Error;
use crate::error::ok;
use crate::mesh::Part;

/// An upper bound for the runs in a text of `bytes` bytes: `usemtl`, a blank, a name and a line's end take 9 bytes.
#[must_use]
pub const fn room(bytes: usize) -> usize {
    bytes / 9 + 2
}

/// The runs of a text, in a list with room for any text of its length, and how many there are. They have the names of
/// their materials, which are empty before the first `usemtl`, but neither color nor texture. Mistakes in faces are
/// left to the reader of the mesh.
pub(super) const fn runs<const N: usize>(text: &[u8]) -> Result<([Part<'_>; N], usize), Error> {
    let mut runs = [Part::new(0..0, Part::NO_MATERIAL); N];
    let (mut count, mut faces) = (0, 0);
    let mut name = "";
    let mut reader = Reader::new(text, [0; 3]);
    while reader.begins() {
        if reader.keyword(b"f") {
            if count == 0 || !are_same(runs[count - 1].material, name) {
                runs[count] = Part::new(faces..faces, Part::NO_MATERIAL).with_material(name);
                count += 1;
            }
            faces += reader.count_words().saturating_sub(2);
            runs[count - 1].end = faces;
        } else if reader.keyword(b"usemtl") {
            name = ok!(reader.name("usemtl needs the name of a material"));
        } else {
            reader.skip(false);
        }
    }
    if count == 0 {
        return reader.error("the file has no faces: it must be an OBJ file, and not in UTF-16");
    }
    Ok((runs, count))
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
        let found = runs[..count].iter();
        Ok(found
            .map(|run| (run.start, run.end, String::from(run.material)))
            .collect())
    }

    #[test]
    fn a_run_ends_where_the_material_changes() {
        let text = "f 1 2 3 4\nusemtl a b \t# c\nf 1 2 3 \\\n 4 5\nf 1/1 2/2 3//3\nusemtl c\r\nusemtl a b\nf 1 2 3\n\
            usemtl d#e\nv 0 0 0\nf 1 2 3\nusemtl f";
        let expected = [(0, 2, ""), (2, 7, "a b"), (7, 8, "d#e")];
        let expected = expected.map(|(start, end, name)| (start, end, String::from(name)));
        assert_eq!(found(text).unwrap(), expected);
    }

    #[test]
    fn a_text_without_faces_is_refused() {
        let error = found("v 0 0 0\nusemtl a").unwrap_err();
        let line = "line 2: the file has no faces: it must be an OBJ file, and not in UTF-16";
        assert_eq!(std::string::ToString::to_string(&error), line);
    }

    #[test]
    fn a_material_needs_a_name() {
        let error = found("f 1 2 3\nusemtl # none").unwrap_err();
        let line = "line 2: usemtl needs the name of a material";
        assert_eq!(std::string::ToString::to_string(&error), line);
    }

    /// The reader of the mesh counts as many faces, so that parts name the same ones.
    #[test]
    fn comments_do_not_move_parts() {
        let text = "v 0 0 0\nusemtl a # b \\\nf 1 1 1\no c # d \\\nf 1 1 1\nusemtl e\nf 1 1 1";
        let counts = super::super::count(text.as_bytes()).unwrap();
        let runs = found(text).unwrap();
        assert_eq!(runs, [(0, 2, String::from("a")), (2, 3, String::from("e"))]);
        assert_eq!(counts.faces, 3);
    }

    #[test]
    fn a_name_stays_on_its_line() {
        let error = found("usemtl a\\\nf 1 2 3\nf 1 2 3").unwrap_err();
        let line = "line 1: a name must not continue on the next line";
        assert_eq!(std::string::ToString::to_string(&error), line);
    }

    #[test]
    fn the_most_runs_fit() {
        let text = "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3";
        assert_eq!(found(text).unwrap().len(), 4);
    }
}
