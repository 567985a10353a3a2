//! Materials, and the images that they name.

use std::path::PathBuf;

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name, which may be empty.
    pub name: String,
    /// The color of the surface where no texture is drawn.
    pub color: [u8; 3],
    /// The color by which a texture's texels are multiplied.
    pub tint: [u8; 3],
    /// Index of an image of the model.
    pub texture: Option<u32>,
    /// Light that the surface sends out by itself, added to what it reflects.
    pub emission: [u8; 3],
    /// From 0, which is invisible, to 1.
    pub opacity: f64,
    /// What the alpha channel of the texture means.
    pub alpha: Alpha,
    /// Whether faces are seen from behind.
    pub two_sided: bool,
    /// Whether the texture continues its border along u and v, and does not repeat.
    pub clamp: [bool; 2],
}

/// What the alpha channel of a texture means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Alpha {
    /// Nothing: the texture is opaque.
    Ignored,
    /// Texels below this alpha are holes; the others are opaque.
    Cut(u8),
    /// The texels' opacity.
    Blended,
}

impl Material {
    /// A white material, seen from both sides, whose texture would be opaque.
    #[must_use]
    pub const fn new(name: String) -> Self {
        Self {
            name,
            color: [255; 3],
            tint: [255; 3],
            texture: None,
            emission: [0; 3],
            opacity: 1.0,
            alpha: Alpha::Ignored,
            two_sided: true,
            clamp: [false; 2],
        }
    }
}

/// A picture that a model names or contains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    /// Its path.
    File(PathBuf),
    /// Its name, and the file.
    Bytes(String, Vec<u8>),
}

impl Image {
    /// The file that contains the picture, unless the model's own file does.
    #[must_use]
    pub fn file(&self) -> Option<PathBuf> {
        match self {
            Self::File(path) => Some(path.clone()),
            Self::Bytes(..) => None,
        }
    }
}
