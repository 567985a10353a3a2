//! Materials, and the pictures that they name.

use std::collections::HashMap;
use std::path::PathBuf;

use super::{Model, next};

/// A transform of texture coordinates. `[[a, b, c], [d, e, f]]` moves (u, v) to (a u + b v + c, d u + e v + f).
pub type Affine = [[f64; 3]; 2];

/// The transform that changes nothing.
const IDENTITY: Affine = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The material's name, which may be empty.
    pub name: String,
    /// The color of the surface where no texture is drawn.
    pub color: [u8; 3],
    /// The color by which a texture's texels are multiplied.
    pub tint: [u8; 3],
    /// Index of the texture in the model's list of images.
    pub texture: Option<u32>,
    /// The light that the surface itself sends out. This light is added to the light that the surface reflects.
    pub emission: [u8; 3],
    /// The opacity, from 0 (invisible) to 1.
    pub opacity: f64,
    /// What the alpha channel of the texture means.
    pub alpha: Alpha,
    /// Whether faces are visible from behind.
    pub two_sided: bool,
    /// For u and for v: true if coordinates beyond the texture show its border, false if the texture repeats.
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
    /// Makes a white, two-sided material that ignores the alpha channel of its texture.
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
    /// The path of the picture's file.
    File(PathBuf),
    /// The picture's name in the model, and the bytes of a picture file.
    Bytes(String, Vec<u8>),
}

impl Image {
    /// The file that contains the picture; `None` if the model's own file contains it.
    #[must_use]
    pub fn file(&self) -> Option<PathBuf> {
        match self {
            Self::File(path) => Some(path.clone()),
            Self::Bytes(..) => None,
        }
    }
}

impl Model {
    /// Transforms the texture coordinates of the faces of some materials. `transforms` maps a material's index to a
    /// transform of texture coordinates as the model stores them: v points down.
    pub(crate) fn transform_uvs(
        &mut self,
        transforms: &HashMap<u32, Affine>,
    ) -> Result<(), String> {
        if transforms.values().all(|affine| *affine == IDENTITY) {
            return Ok(());
        }
        let old = std::mem::take(&mut self.uvs);
        let mut moved = HashMap::new();
        for at in 0..self.triangles.len() {
            let mut corners = self.triangles[at].corners;
            let material = self.triangles[at].material;
            let affine = material.and_then(|at| transforms.get(&at));
            let affine = *affine.unwrap_or(&IDENTITY);
            // Materials without a transform share coordinates.
            let group = material.filter(|_| affine != IDENTITY);
            for uv in corners.iter_mut().filter_map(|corner| corner.uv.as_mut()) {
                let new = next(&self.uvs)?;
                let [u, v] = old[*uv as usize];
                *uv = *moved.entry((group, *uv)).or_insert_with(|| {
                    self.uvs.push(affine.map(|[a, b, c]| a * u + b * v + c));
                    new
                });
            }
            self.fix_uvs(&mut corners)?;
            self.triangles[at].corners = corners;
        }
        Ok(())
    }
}
