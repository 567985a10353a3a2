//! Checks OBJ text: arbitrary bytes, or plausible text with mistakes.

use arbitrary::{Result, Unstructured};
use fixel::mesh::{Buffers, Counts, obj};
use fixel::prelude::*;

use crate::owned::Owned;

/// Reads the text that these bytes encode, and checks all invariants of the result.
///
/// # Panics
///
/// Panics if an invariant does not hold.
pub fn check(bytes: &[u8]) {
    match bytes.split_first() {
        // The bytes are the text.
        Some((b'=', text)) => check_text(text),
        // The bytes select statements.
        _ => {
            if let Ok(text) = text(&mut Unstructured::new(bytes)) {
                check_text(&text);
            }
        }
    }
}

impl Owned {
    /// Checks that every index is in range, and that edges are sorted and distinct.
    fn check(&self) {
        let below = |index: u16, list: usize| usize::from(index) < list;
        let or_none = |index: u16, list: usize| index == Mesh::NO_VALUE || below(index, list);
        let all = |faces: &[[u16; 3]], is: &dyn Fn(u16) -> bool| {
            faces.as_flattened().iter().all(|&index| is(index))
        };
        let positions = self.positions.len();
        assert!(all(&self.faces, &|index| below(index, positions)));
        assert!(all(&self.uv_faces, &|index| or_none(index, self.uvs.len())));
        let normals = self.normals.len();
        assert!(all(&self.normal_faces, &|index| or_none(index, normals)));
        assert!(
            self.edges
                .iter()
                .all(|[a, b]| a < b && below(*b, positions))
        );
        assert!(self.edges.is_sorted_by(|a, b| a < b), "{:?}", self.edges);
    }
}

/// Room for the elements of any text: a blank, or the backslash that joins two lines, comes before each number and each
/// corner.
fn room(text: &[u8]) -> Counts {
    let most = 1 + text.iter().filter(|byte| b" \t\\".contains(byte)).count();
    Counts {
        positions: most,
        faces: most,
        edges: most,
        uvs: most,
        uv_faces: most,
        normals: most,
        normal_faces: most,
        colors: most,
    }
}

/// Counts and reads a text, and checks both results.
fn check_text(text: &[u8]) {
    let counted = obj::count(text);
    let room = room(text);
    // Reading does not depend on the room, if there is enough.
    let read = Owned::read(text, room);
    match (&counted, &read) {
        (Ok(counts), Ok(mesh)) => {
            mesh.check();
            let edges = mesh.counts.edges;
            assert!(edges <= counts.edges && counts.edges <= room.edges);
            assert_eq!(Counts { edges, ..*counts }, mesh.counts);
            assert_eq!(&Owned::read(text, *counts), &read);
            check_parts(text, mesh);
        }
        (Err(error), Err(other)) => {
            assert_eq!(error, other);
            let Error::Obj { line, problem, .. } = *error else {
                panic!("{error} is not an error about OBJ text");
            };
            let lines = lines(text);
            assert!((1..=lines).contains(&line), "line {line} of {lines}");
            let said = error.to_string();
            assert!(said.contains(&format!("line {line}")) && said.contains(problem));
        }
        _ => panic!("counted: {counted:?}, read: {read:?}"),
    }
    check_line_ends(text, &read);
}

/// Checks that lists that the caller does not supply stay empty, and that the others do not change.
fn check_parts(text: &[u8], mesh: &Owned) {
    let (mut positions, mut faces) = (mesh.positions.clone(), mesh.faces.clone());
    positions.fill(Vec3::X);
    faces.fill([7; 3]);
    let plain = obj::parse(text, Buffers::new(&mut positions, &mut faces)).unwrap();
    assert!(plain.positions().iter().eq(mesh.positions.iter().copied()));
    assert_eq!(plain.faces(), mesh.faces);
    assert!(plain.edges().is_empty());
    assert!(!plain.has_uvs() && !plain.has_normals() && !plain.has_colors());
    if let Some(short) = positions.len().checked_sub(1) {
        let buffers = Buffers::new(&mut positions[..short], &mut faces);
        let error = obj::parse(text, buffers).unwrap_err();
        assert!(matches!(error, Error::TooMany { max, .. } if max == short));
    }
}

/// Checks that the kind of line end does not change the result.
fn check_line_ends(text: &[u8], read: &Result<Owned, Error>) {
    if text.contains(&b'\r') {
        return;
    }
    for end in [&b"\r\n"[..], b"\r"] {
        let mut other = Vec::with_capacity(text.len() + 16);
        for &byte in text {
            match byte {
                b'\n' => other.extend(end),
                _ => other.push(byte),
            }
        }
        assert_eq!(&Owned::read(&other, room(&other)), read);
    }
}

/// The number of lines, which end in LF, CR or both. The last line may be empty.
fn lines(text: &[u8]) -> usize {
    let ends = (0..text.len()).filter(|&at| match text[at] {
        b'\n' => at == 0 || text[at - 1] != b'\r',
        byte => byte == b'\r',
    });
    1 + ends.count()
}

/// Text of statements, most of which make sense.
fn text(u: &mut Unstructured<'_>) -> Result<Vec<u8>> {
    let mut text = Vec::new();
    while !u.is_empty() && text.len() < 4096 {
        match u.int_in_range(0..=9)? {
            0..=2 => words(u, &mut text, "v", [3, 3, 6, 4, 7], number)?,
            3 => words(u, &mut text, "vt", [2, 2, 1, 3, 3], number)?,
            4 => words(u, &mut text, "vn", [3, 3, 3, 3, 2], number)?,
            5..=7 => words(u, &mut text, "f", [3, 3, 4, 6, 2], corner)?,
            8 => words(u, &mut text, "l", [2, 2, 3, 6, 1], corner)?,
            _ => {
                let other = [
                    "# v",
                    "usemtl \\",
                    "s off",
                    "vp 1",
                    "g",
                    "\u{feff}",
                    "p 1",
                    "",
                ];
                text.extend_from_slice(u.choose(&other)?.as_bytes());
            }
        }
        let ends = ["\n", "\n", "\n", "\r\n", "\r", " # \\\n", " \n\n"];
        text.extend_from_slice(u.choose(&ends)?.as_bytes());
    }
    Ok(text)
}

/// Adds a statement with some of these words.
fn words(
    u: &mut Unstructured<'_>,
    text: &mut Vec<u8>,
    name: &str,
    counts: [u8; 5],
    word: impl Fn(&mut Unstructured<'_>, &mut Vec<u8>) -> Result<()>,
) -> Result<()> {
    text.extend_from_slice(name.as_bytes());
    for _ in 0..*u.choose(&counts)? {
        let blank: &&str = u.choose(&[" ", " ", " ", " ", "\t", "  ", " \\\n", "\\\r\n"])?;
        text.extend_from_slice(blank.as_bytes());
        word(u, text)?;
    }
    Ok(())
}

/// Adds a number in one of many spellings.
fn number(u: &mut Unstructured<'_>, text: &mut Vec<u8>) -> Result<()> {
    let value = match u.int_in_range(0..=8)? {
        0 => (*u.choose(&[
            "",
            "+",
            "-",
            ".",
            "-.5",
            "5.",
            "1e",
            "1e+",
            "nan",
            "1_0",
            "32767.99999",
            "-32768",
            "32768",
            "-2048",
            "2049",
            "1e-400",
            "0e99999999999",
            "0x1",
            "1.5.2",
            "65536e-1",
        ])?)
        .to_string(),
        1 => format!("{}e{}", u.arbitrary::<i32>()?, u.int_in_range(-12..=6)?),
        2 => format!("{:e}", f32::from_bits(u.arbitrary()?)),
        3 => f64::from(u.arbitrary::<f32>()?).to_string(),
        // A multiple of half a unit, where rounding is decided.
        4 => (f64::from(u.arbitrary::<i32>()?) / 131_072.).to_string(),
        5 | 6 => (f64::from(u.arbitrary::<u8>()?) / 255.).to_string(),
        _ => u.arbitrary::<i8>()?.to_string(),
    };
    text.extend_from_slice(value.as_bytes());
    Ok(())
}

/// Adds a corner of a face.
fn corner(u: &mut Unstructured<'_>, text: &mut Vec<u8>) -> Result<()> {
    let mut index = || -> Result<i32> {
        Ok(match u.arbitrary::<u8>()? {
            255 => u.arbitrary()?,
            254 => 65_536,
            253 => 0,
            byte => [1, 2, 3, 4, 5, 6, -1, -2][usize::from(byte % 8)],
        })
    };
    let (a, b, c) = (index()?, index()?, index()?);
    let word = match u.int_in_range(0..=9)? {
        0 => format!("{a}/{b}"),
        1 => format!("{a}//{c}"),
        2 => format!("{a}/"),
        3 => format!("{a}//"),
        4 => format!("{a}/{b}/{c}/1"),
        5 | 6 => a.to_string(),
        _ => format!("{a}/{b}/{c}"),
    };
    text.extend_from_slice(word.as_bytes());
    Ok(())
}
