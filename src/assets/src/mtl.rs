//! Reads MTL files, which describe the materials of OBJ files.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::PathBuf;

use super::files::Folder;
use super::material::{Affine, GLOW_ELSEWHERE};
use super::text::{first_word, number, numbers, quote, statements};
use super::{Alpha, Image, Material, Model, Notes, merge, next};

/// Words that get no note, because most files have them: ambient light, highlights and refraction.
const UNUSED: &str = " Ka Ks Ni Ns Tf Tr illum sharpness map_aat";

/// The state of a reader of MTL text, besides the model's list of materials.
#[derive(Default)]
pub struct Materials {
    places: HashMap<String, u32>,
    /// Indices of the materials that a library has defined.
    pub defined: HashSet<u32>,
    /// Transforms of texture coordinates, by the index of the material.
    pub transforms: HashMap<u32, Affine>,
}

impl Materials {
    /// Whether there is a material with this name.
    pub fn has(&self, name: &[u8]) -> bool {
        self.places.contains_key(&*String::from_utf8_lossy(name))
    }

    /// The index of the material with this name. If there is no such material yet, a white material is added.
    pub fn named(&mut self, model: &mut Model, name: &[u8]) -> Result<u32, String> {
        let name = String::from_utf8_lossy(name).into_owned();
        let material = Material::new(name.clone());
        merge(&mut model.materials, &mut self.places, name, material)
    }

    /// Sets the texture of the material at `place`.
    fn texture(
        &mut self,
        material: &mut Material,
        place: u32,
        images: &mut Vec<Image>,
        (file, transform, clamp): Map,
    ) {
        material.texture = next(images).ok();
        images.push(Image::File(file));
        (material.alpha, material.clamp) = (Alpha::Cut(128), [clamp; 2]);
        self.transforms.insert(place, transform);
    }

    /// Adds the materials of MTL text to a model.
    ///
    /// A material's color does not tint its texture, because programs write arbitrary colors next to a texture.
    pub fn add(&mut self, model: &mut Model, mtl: &[u8], folder: Folder<'_>) -> Result<(), String> {
        let mut skipped = "a line before the first newmtl is skipped";
        let (mut current, mut has_d, mut masks) = (None, false, Vec::new());
        // The last texture of each kind counts.
        let (mut ambient, mut glows) = (BTreeMap::new(), BTreeMap::new());
        // Materials that state the transparency 1 and no opacity.
        let mut clear = HashSet::new();
        for (_, line) in statements(mtl, |_, _| ()) {
            let (keyword, value) = first_word(&line).unwrap_or_default();
            if keyword == b"newmtl" {
                let place = self.named(model, value)?;
                (current, has_d) = (self.defined.insert(place).then_some(place), false);
                skipped = "a line of a second material of the same name is skipped";
                continue;
            }
            let Some(place) = current else {
                model.notes.add(skipped);
                continue;
            };
            let (material, notes) = (&mut model.materials[place as usize], &mut model.notes);
            let mut define = || -> Option<()> {
                match keyword {
                    b"Kd" => material.color = color(value, notes)?,
                    b"Ke" => material.emission = color(value, notes)?,
                    b"d" => {
                        (material.opacity, has_d) = (fraction(value, notes)?, true);
                        clear.remove(&place);
                    }
                    b"Tr" if !has_d => {
                        material.opacity = 1.0 - fraction(value, notes)?;
                        if material.opacity == 0.0 {
                            clear.insert(place);
                        }
                    }
                    b"map_d" => masks.push((place, map(value, notes, folder)?.0)),
                    b"map_Kd" => {
                        self.texture(
                            material,
                            place,
                            &mut model.images,
                            map(value, notes, folder)?,
                        );
                    }
                    b"map_Ka" => drop(ambient.insert(place, map(value, notes, folder)?)),
                    b"map_Ke" => drop(glows.insert(place, map(value, notes, folder)?)),
                    _ if UNUSED.split(' ').any(|word| word.as_bytes() == keyword) => {}
                    _ => notes.left_out(quote(keyword)),
                }
                Some(())
            };
            if define().is_none() {
                notes.add(format!("{} of a material cannot be read", quote(keyword)));
            }
        }
        // Programs disagree about the meaning of Tr.
        if !clear.is_empty() {
            model.notes.add("Tr 1 without d is read as opaque");
        }
        for place in clear {
            model.materials[place as usize].opacity = 1.0;
        }
        for (place, map) in ambient {
            let material = &mut model.materials[place as usize];
            if material.texture.is_none() {
                self.texture(material, place, &mut model.images, map);
            }
        }
        // An alpha channel is used only if it is in the texture's own file.
        for (place, file) in masks {
            let texture = model.materials[place as usize].texture;
            if texture.map(|at| &model.images[at as usize]) != Some(&Image::File(file)) {
                model.notes.left_out(quote(b"map_d"));
            }
        }
        for (place, (file, transform, clamp)) in glows {
            let mut material = model.materials[place as usize].clone();
            if material.texture.is_none() {
                material.clamp = [clamp; 2];
            }
            let own = *self.transforms.entry(place).or_insert(transform);
            if own == transform && material.clamp == [clamp; 2] {
                let glow = next(&model.images)?;
                model.images.push(Image::File(file));
                // Some programs write no emission, or black, beside a texture of it.
                if material.emission == [0; 3] {
                    material.emission = [255; 3];
                }
                let light = material.emission.map(|x| f64::from(x) / 255.0);
                model.glow(&mut material, glow, light);
            } else {
                model.notes.left_out(GLOW_ELSEWHERE);
                material.emission = [0; 3];
            }
            model.materials[place as usize] = material;
        }
        Ok(())
    }
}

/// The value of a texture statement: the file, the transform of coordinates, and whether the texture is clamped.
type Map = (PathBuf, Affine, bool);

/// Reads a color: three components, or one component for a gray.
fn color(value: &[u8], notes: &mut Notes) -> Option<[u8; 3]> {
    match numbers(value, notes) {
        [Some(gray), None, ..] => Some([byte(gray); 3]),
        [Some(r), Some(g), Some(b), ..] => Some([r, g, b].map(byte)),
        _ => None,
    }
}

/// Reads a number, and clamps it to the range from 0 to 1.
fn fraction(value: &[u8], notes: &mut Notes) -> Option<f64> {
    let [x, ..] = numbers(value.strip_prefix(b"-halo").unwrap_or(value), notes);
    x.filter(|x| !x.is_nan()).map(|x| x.clamp(0.0, 1.0))
}

/// Converts a component of a color, from 0 to 1, to a byte.
pub fn byte(component: f64) -> u8 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
    let byte = (component * 255.0).round() as u8;
    byte
}

/// Reads the value of a texture statement: options with any number of values each, and then the name of a file. The
/// name can contain blanks. Returns the path of the file, the transform of coordinates, and whether the texture is
/// clamped along both axes.
fn map(value: &[u8], notes: &mut Notes, folder: Folder<'_>) -> Option<Map> {
    let (mut rest, mut changes, mut clamp) = (value, [[1.0; 2], [0.0; 2]], false);
    let (mut option, mut count) = (b"".as_slice(), 0);
    while let Some((word, after)) = first_word(rest) {
        let number = number(word);
        let is_switch = matches!(word, b"on" | b"off");
        if word.starts_with(b"-") && number.is_err() {
            (option, count) = (word, 0);
        } else {
            match (option, number) {
                (b"", _) => break,
                (b"-s", Ok(x)) if count < 2 => changes[0][count] = x,
                (b"-o", Ok(x)) if count < 2 => changes[1][count] = x,
                (b"-clamp", _) if is_switch => clamp = word == b"on",
                (b"-mm" | b"-t", Ok(_)) => notes.left_out(quote(option)),
                (b"-imfchan" | b"-texres" | b"-type", _) if count == 0 => {}
                (_, number) if !is_switch && number.is_err() => break,
                _ => {}
            }
            count += 1;
        }
        rest = after;
    }
    let name = String::from_utf8_lossy(rest);
    // In the file, v points up.
    let [[a, b], [u, v]] = changes;
    let transform = [[a, 0.0, u], [0.0, b, 1.0 - b - v]];
    (!rest.is_empty()).then(|| (folder.beside(&name), transform, clamp))
}
