//! The texture: a picture that the model names, or one that was dropped.

use std::fmt::Write;
use std::path::Path;

use fixel_assets::{Image, Model, Picture};

use crate::{Dropped, quoted};

/// The most texels along a side of a texture.
const SIDE: u32 = 512;

/// A picture as a texture.
pub struct Texture {
    /// Its file.
    pub name: String,
    /// Its pixels.
    pub picture: Picture,
    /// How `include_texture!` is called.
    call: String,
}

impl Texture {
    /// Resamples a picture to sides that a texture can have. `call` names it for `include_texture!`.
    fn new(name: &str, mut picture: Picture, mut call: String) -> Self {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0 to 9
        let near = |side: u32| 1 << f64::from(side.clamp(1, SIDE)).log2().round() as u32;
        let size = [near(picture.width), near(picture.height)];
        if size != [picture.width, picture.height] {
            picture = picture.resampled(size[0], size[1]);
            let _ = write!(call, ", size = \"{}x{}\"", size[0], size[1]);
        }
        Self {
            name: name.into(),
            picture,
            call,
        }
    }

    /// Its pixels and its call, and its size.
    pub fn bytes(self) -> (Vec<u8>, Vec<u8>) {
        let Picture {
            width,
            height,
            pixels,
            ..
        } = self.picture;
        let mut bytes: Vec<u8> = pixels.into_iter().flatten().collect();
        bytes.extend(self.call.into_bytes());
        (bytes, [width, height].map(u32::to_le_bytes).concat())
    }
}

/// The first picture among these files.
///
/// # Errors
///
/// None of them is a picture.
pub fn dropped<'a>(files: impl Iterator<Item = &'a (String, &'a [u8])>) -> Result<Texture, String> {
    let mut found = Err("there is no file".into());
    for (name, contents) in files {
        found = found.or_else(|_: String| match Picture::decode(contents) {
            Ok(picture) => Ok(Texture::new(name, picture, quoted(name))),
            Err(problem) => Err(format!(
                "{name}: it is neither a model (.obj, .stl, .ply, .gltf, .glb) nor a picture for its texture: {problem}"
            )),
        });
    }
    found
}

/// The first picture of the model's faces that can be read. Without one, a picture that was dropped with the model.
pub fn of_model(
    name: &str,
    model: &mut Model,
    files: &Dropped,
    notes: &mut Vec<String>,
) -> Option<Texture> {
    let mut used = Vec::new();
    for run in model.runs() {
        let material = run.material.and_then(|at| model.materials.get(at as usize));
        let texture = material.and_then(|material| material.texture);
        used.extend(texture.filter(|at| !used.contains(at)));
    }
    let mut found: Option<Texture> = None;
    for at in used {
        match (&found, of_image(name, model, at, files)) {
            (Some(found), Ok(other)) => notes.push(format!(
                "the page draws one texture, {}, and not {}",
                found.name, other.name
            )),
            (None, Ok(texture)) => found = Some(texture),
            (_, Err(problem)) => notes.push(problem),
        }
    }
    let is_other = |(other, _): &&(String, &[u8])| {
        other != name && !model.files.iter().any(|file| file == Path::new(other))
    };
    found.or_else(|| dropped(files.0.iter().filter(is_other)).ok())
}

/// A picture that a model names or contains.
fn of_image(name: &str, model: &mut Model, at: u32, files: &Dropped) -> Result<Texture, String> {
    let inside = format!("{}, image = {at}", quoted(name));
    let (title, call) = match model.images.get(at as usize) {
        // The file is dropped without its folder, and found by its name.
        Some(Image::File(path)) => {
            let name = files.named(path).map(|(name, _)| name.clone());
            let name = name.unwrap_or_else(|| path.display().to_string());
            (name.clone(), quoted(&name))
        }
        Some(Image::Bytes(image, _)) => (format!("image {at} {image}"), inside),
        _ => (format!("image {at}"), inside),
    };
    let picture = model.picture(at, files)?;
    Ok(Texture::new(title.trim_end(), picture, call))
}
