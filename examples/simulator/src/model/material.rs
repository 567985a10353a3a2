//! Materials, and the images that they name.

use std::path::PathBuf;

/// A material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Material {
    pub name: String,
    /// The color of the surface; if there is a texture, its texels are multiplied by this color.
    pub color: [u8; 3],
    /// Index of an image of the model.
    pub texture: Option<u32>,
}

impl Material {
    /// Makes a white material.
    pub fn new(name: String) -> Self {
        Self {
            name,
            color: [255; 3],
            texture: None,
        }
    }
}

/// A picture that a model names or contains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    File(PathBuf),
    /// Its name, and the file.
    #[cfg_attr(not(feature = "gltf"), allow(dead_code))]
    Bytes(String, Vec<u8>),
}

impl Image {
    /// The file that contains the picture, unless the model's own file does.
    pub fn file(&self) -> Option<PathBuf> {
        match self {
            Self::File(path) => Some(path.clone()),
            Self::Bytes(..) => None,
        }
    }
}
