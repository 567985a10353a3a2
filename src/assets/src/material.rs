//! Materials, and the images that they name.

use std::collections::HashMap;
use std::path::PathBuf;

use super::{Model, Triangle, next};

/// A transform of texture coordinates: `[[a, b, c], [d, e, f]]` moves (u, v) to (a u + b v + c, d u + e v + f).
pub type Affine = [[f64; 3]; 2];

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

impl Model {
    /// Transforms the texture coordinates of the faces of some materials. `transforms` has the material's index, and
    /// the transform in the model's coordinates, whose v points down.
    pub(crate) fn transform_uvs(
        &mut self,
        transforms: &HashMap<u32, Affine>,
    ) -> Result<(), String> {
        if transforms.is_empty() {
            return Ok(());
        }
        let old = std::mem::take(&mut self.uvs);
        let mut moved = HashMap::new();
        for at in 0..self.triangles.len() {
            let Triangle {
                mut corners,
                material,
                ..
            } = self.triangles[at];
            let transform = material
                .and_then(|at| transforms.get_key_value(&at))
                .unzip();
            for uv in corners.iter_mut().filter_map(|corner| corner.uv.as_mut()) {
                let new = next(&self.uvs)?;
                let from = old[*uv as usize];
                *uv = *moved.entry((transform.0, *uv)).or_insert_with(|| {
                    let moved =
                        |affine: &Affine| affine.map(|[a, b, c]| a * from[0] + b * from[1] + c);
                    self.uvs.push(transform.1.map_or(from, moved));
                    new
                });
            }
            self.fix_uvs(&mut corners)?;
            self.triangles[at].corners = corners;
        }
        Ok(())
    }
}
