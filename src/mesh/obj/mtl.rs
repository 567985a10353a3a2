//! Materials from MTL text: their colors and the names of their textures.

use embedded_graphics::pixelcolor::Rgb888;

use super::decimal::SCALAR;
use super::reader::{Reader, are_same};
use crate::Error;
use crate::error::ok;
use crate::mesh::Part;

/// Looks for the material with this name: its color and the name of its texture, which is empty if there is none.
/// `None` if the text lacks it. The whole text is checked.
pub(super) const fn find<'t>(
    text: &'t [u8],
    name: &str,
) -> Result<Option<(Rgb888, &'t str)>, Error> {
    const ORPHAN: &str = "a color or a texture comes before the first newmtl";
    let mut found = None;
    let (mut any, mut here) = (false, false);
    let mut reader = Reader::new(text, [0; 3]);
    while reader.begins() {
        if reader.keyword(b"newmtl") {
            any = true;
            here = are_same(
                ok!(reader.name("newmtl needs the name of a material")),
                name,
            );
            if here && found.is_some() {
                return reader.error("a material of this name was defined before");
            }
            if here {
                found = Some((Part::NO_MATERIAL, ""));
            }
        } else if reader.keyword(b"Kd") {
            let new = ok!(reader.color());
            match &mut found {
                _ if !any => return reader.error(ORPHAN),
                Some((color, _)) if here => *color = new,
                _ => {}
            }
        } else if reader.keyword(b"map_Kd") {
            let new = ok!(reader.texture());
            match &mut found {
                _ if !any => return reader.error(ORPHAN),
                Some((_, texture)) if here => *texture = new,
                _ => {}
            }
        } else {
            reader.skip(false);
        }
    }
    Ok(found)
}

impl<'t> Reader<'t> {
    const fn texture(&mut self) -> Result<&'t str, Error> {
        let name = ok!(self.name("map_Kd needs the name of a file"));
        let text = name.as_bytes();
        // Options may come before the file: the last word.
        let mut start = if text[0] == b'-' { text.len() } else { 0 };
        while start > 0 && !matches!(text[start - 1], b' ' | b'\t') {
            start -= 1;
        }
        Ok(name.split_at(start).1)
    }

    const fn color(&mut self) -> Result<Rgb888, Error> {
        let (n, count) = ok!(self.numbers::<3>(SCALAR));
        match count {
            1 => self.rgb([n[0]; 3]),
            3 => self.rgb(n),
            _ => self.error("a color needs 3 numbers, or 1 for gray"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The color of a material and its texture's name.
    fn found<'t>(text: &'t str, name: &str) -> Result<Option<(Rgb888, &'t str)>, Error> {
        find(text.as_bytes(), name)
    }

    const TEXT: &str = "# paint\n\tnewmtl red brick\nKa 9 9 9\nKd 1 0.5 0 # warm\nd 1\n\
        newmtl plain\nnewmtl wood\r\n  Kd .2\n  map_Kd -s 1 1 1 my\\\x6fak.tga\nmap_Ks shine.tga\n\
        newmtl 3\nmap_Kd a b.tga";

    #[test]
    fn a_material_has_its_own_color_and_texture() {
        let of = |name| found(TEXT, name).unwrap();
        assert_eq!(of("red brick"), Some((Rgb888::new(255, 128, 0), "")));
        assert_eq!(of("plain"), Some((Rgb888::new(255, 255, 255), "")));
        assert_eq!(of("wood"), Some((Rgb888::new(51, 51, 51), "my\\oak.tga")));
        assert_eq!(of("3"), Some((Rgb888::new(255, 255, 255), "a b.tga")));
        assert_eq!(of("red"), None);
        assert_eq!(found("", "red"), Ok(None));
    }

    #[test]
    fn mistakes_are_named_with_their_line() {
        for (text, message) in [
            ("newmtl", "line 1: newmtl needs the name of a material"),
            (
                "newmtl a\nKd 1 0",
                "line 2: a color needs 3 numbers, or 1 for gray",
            ),
            (
                "newmtl b\nKd 1 0 1.01",
                "line 2: a color is out of range: it must lie between 0 and 1",
            ),
            (
                "\n\nKd 1",
                "line 3: a color or a texture comes before the first newmtl",
            ),
            (
                "newmtl a\nmap_Kd",
                "line 2: map_Kd needs the name of a file",
            ),
            (
                "newmtl a\nKd red",
                "line 2: a number is malformed: it must be like 1, -0.25 or 2.5e-3",
            ),
            (
                "newmtl a\nnewmtl b\nnewmtl a",
                "line 3: a material of this name was defined before",
            ),
        ] {
            let error = found(text, "a").unwrap_err();
            assert_eq!(std::string::ToString::to_string(&error), message);
        }
        let error = find(b"newmtl \xff", "").unwrap_err();
        assert_eq!(
            std::string::ToString::to_string(&error),
            "line 1: a name must be UTF-8"
        );
    }
}
