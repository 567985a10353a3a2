//! Reads MTL, the materials of OBJ files.

use super::files::Folder;
use super::text::{Statements, after_keyword, number, words};
use super::{Image, Material, Model, next};

/// Adds the materials of MTL text to a model.
///
/// A material's color does not tint its texture, because programs write arbitrary colors next to a texture.
pub fn read(model: &mut Model, bytes: &[u8], folder: Folder<'_>) -> Result<(), String> {
    let first = model.materials.len();
    for (line, statement) in Statements::new(bytes) {
        let Some(keyword) = words(&statement).next() else {
            continue;
        };
        let value = after_keyword(&statement);
        let at_line = |problem: &str| format!("line {line}: {problem}");
        if keyword == b"newmtl" {
            let name = String::from_utf8_lossy(value).into_owned();
            model.materials.push(Material::new(name));
            continue;
        }
        if keyword != b"Kd" && keyword != b"map_Kd" {
            continue;
        }
        if model.materials.len() == first {
            return Err(at_line(
                "a color or a texture comes before the first newmtl",
            ));
        }
        let image = next(&model.images)?;
        let Some(material) = model.materials.last_mut() else {
            continue;
        };
        if keyword == b"Kd" {
            let color = color(value).map_err(|problem| at_line(&problem))?;
            material.color = color;
        } else {
            let name = texture(value).ok_or_else(|| at_line("map_Kd needs the name of a file"))?;
            material.texture = Some(image);
            model.images.push(Image::File(folder.beside(&name)));
        }
    }
    Ok(())
}

fn color(value: &[u8]) -> Result<[u8; 3], String> {
    let numbers: Vec<f64> = words(value).map(number).collect::<Result<_, _>>()?;
    match numbers[..] {
        [gray] => Ok([byte(gray); 3]),
        [r, g, b, ..] => Ok([r, g, b].map(byte)),
        _ => Err("a color needs 3 numbers, or 1 for gray".into()),
    }
}

/// Converts a component of a color from 0 to 1.
pub fn byte(component: f64) -> u8 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
    let byte = (component * 255.0).round() as u8;
    byte
}

/// How many values follow an option of a texture.
fn values(option: &[u8]) -> usize {
    match option {
        b"-mm" => 2,
        b"-o" | b"-s" | b"-t" => 3,
        _ => 1,
    }
}

/// Returns a texture's file name, which follows the options and may contain blanks.
fn texture(value: &[u8]) -> Option<String> {
    let mut rest = value;
    while rest.starts_with(b"-") {
        let option = words(rest).next()?;
        for at in 0..=values(option) {
            // -o, -s and -t take one to three numbers.
            if at > 1 && words(rest).next().is_some_and(|word| number(word).is_err()) {
                break;
            }
            rest = after_keyword(rest);
        }
    }
    (!rest.is_empty()).then(|| String::from_utf8_lossy(rest).into_owned())
}
