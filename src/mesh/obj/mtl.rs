//! Materials from MTL text: their colors and the names of their textures.

use embedded_graphics::pixelcolor::Rgb888;

use super::decimal::SCALAR;
use super::name::Name;
use super::reader::{Reader, component};
use crate::Error;
use crate::error::ok;
use crate::mesh::Part;

/// A material of an MTL text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Material {
    pub(super) color: Rgb888,
    /// Empty if there is none.
    pub(super) texture: Name,
}

impl Material {
    pub(super) const DEFAULT: Self = Self {
        color: Part::NO_MATERIAL,
        texture: Name::EMPTY,
    };
}

/// A statement that matters to a material.
pub(super) enum Statement {
    New(Name),
    Color(Rgb888),
    Texture(Name),
    End,
}

/// Looks for the material with the `name` that stands in `names`; `None` if the text lacks it. The whole text is
/// checked.
pub(super) const fn find(text: &[u8], name: Name, names: &[u8]) -> Result<Option<Material>, Error> {
    let mut found: Option<Material> = None;
    let (mut any, mut here) = (false, false);
    let mut reader = Reader::new(text, [0; 3]);
    loop {
        let (color, texture) = match ok!(reader.material_statement()) {
            Statement::New(new) => {
                any = true;
                here = new.is(text, name, names);
                if here && found.is_some() {
                    return reader.error("a material of this name was defined before");
                }
                if here {
                    found = Some(Material::DEFAULT);
                }
                continue;
            }
            Statement::Color(color) => (Some(color), None),
            Statement::Texture(texture) => (None, Some(texture)),
            Statement::End => return Ok(found),
        };
        if !any {
            return reader.error("a color or a texture comes before the first newmtl");
        }
        if let (Some(material), true) = (&mut found, here) {
            if let Some(color) = color {
                material.color = color;
            }
            if let Some(texture) = texture {
                material.texture = texture;
            }
        }
    }
}

impl Reader<'_> {
    /// Reads the next statement that matters to a material.
    const fn material_statement(&mut self) -> Result<Statement, Error> {
        while self.begins() {
            if self.keyword(b"newmtl") {
                let name = ok!(self.name("newmtl needs the name of a material"));
                return Ok(Statement::New(name));
            }
            if self.keyword(b"Kd") {
                return Ok(Statement::Color(ok!(self.color())));
            }
            if self.keyword(b"map_Kd") {
                return Ok(Statement::Texture(ok!(self.texture())));
            }
            self.skip(false);
        }
        Ok(Statement::End)
    }

    const fn texture(&mut self) -> Result<Name, Error> {
        let name = ok!(self.name("map_Kd needs the name of a file"));
        // Options may come before the file.
        if self.text()[name.start] == b'-' {
            return Ok(name.last_word(self.text()));
        }
        Ok(name)
    }

    const fn color(&mut self) -> Result<Rgb888, Error> {
        let (n, count) = ok!(self.numbers::<3>(SCALAR));
        let [r, g, b] = match count {
            1 => [n[0]; 3],
            3 => n,
            _ => return self.error("a color needs 3 numbers, or 1 for gray"),
        };
        match (component(r), component(g), component(b)) {
            (Some(r), Some(g), Some(b)) => Ok(Rgb888::new(r, g, b)),
            _ => self.error("a color is out of range: it must lie between 0 and 1"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The color of a material and its texture's name.
    fn found<'t>(text: &'t str, name: &str) -> Result<Option<(Rgb888, &'t str)>, Error> {
        let all = Name {
            start: 0,
            end: name.len(),
        };
        let found = find(text.as_bytes(), all, name.as_bytes())?;
        Ok(found.map(|it| (it.color, &text[it.texture.start..it.texture.end])))
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
        let error = find(b"newmtl \xff", Name::EMPTY, b"").unwrap_err();
        assert_eq!(
            std::string::ToString::to_string(&error),
            "line 1: a name must be UTF-8"
        );
    }
}
