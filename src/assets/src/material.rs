//! Materials, and the pictures that they name.

use std::collections::{BTreeSet, HashMap};
use std::path::PathBuf;

use super::{Files, Model, Picture, next};

/// All textures of a model may have this many pixels, or 16 for each byte of their files: see `check` in picture.rs.
const PIXELS: usize = 1 << 26;

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
    /// Whether light does not change the surface: it has its own colors.
    pub unlit: bool,
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

/// What a note says of a texture that would hide all of its faces.
pub const INVISIBLE: &str = "a texture without a visible texel is drawn opaque";

/// What a note calls emission that cannot be in one picture with its surface.
pub(crate) const GLOW_ELSEWHERE: &str = "emission with other texture coordinates than the surface";

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
            unlit: false,
        }
    }
}

/// A picture that a model names or contains.
#[derive(Clone, Debug, PartialEq)]
pub enum Image {
    /// The path of the picture's file.
    File(PathBuf),
    /// The picture's name in the model, and the bytes of a picture file.
    Bytes(String, Vec<u8>),
    /// A surface and the light that it sends out, in one picture.
    Glowing {
        /// Index of the picture of the surface; `None` if the surface has one color.
        base: Option<u32>,
        /// The color by which this picture is multiplied, or the color of the surface.
        tint: [u8; 3],
        /// Index of the picture of the light.
        glow: u32,
        /// The factors by which this picture's red, green and blue are multiplied.
        light: [f64; 3],
    },
}

impl Image {
    /// The file that contains the picture; `None` if the model's own file contains it.
    #[must_use]
    pub fn file(&self) -> Option<PathBuf> {
        match self {
            Self::File(path) => Some(path.clone()),
            Self::Bytes(..) | Self::Glowing { .. } => None,
        }
    }
}

/// The product of two colors, whose channels are fractions from 0 to 1.
#[must_use]
pub fn times(a: [u8; 3], b: [u8; 3]) -> [u8; 3] {
    [0, 1, 2].map(|at| {
        let product = u16::from(a[at]) * u16::from(b[at]);
        #[allow(clippy::cast_possible_truncation)] // at most 255
        let rounded = ((product + 127) / 255) as u8;
        rounded
    })
}

impl Model {
    /// The picture with the index `at` in the list of images.
    ///
    /// # Errors
    ///
    /// The picture does not exist, or cannot be read. The message names it.
    pub fn picture(&mut self, at: u32, files: &dyn Files) -> Result<Picture, String> {
        let (name, bytes) = match self.images.get(at as usize) {
            None => return Err(format!("there is no texture {at}")),
            Some(Image::File(path)) => (path.display().to_string(), files.read(path)),
            Some(Image::Bytes(name, bytes)) => (name.clone(), Ok(bytes.clone())),
            Some(&Image::Glowing {
                base,
                tint,
                glow,
                light,
            }) => {
                let mut picture = match base {
                    Some(base) => self.picture(base, files)?,
                    None => Picture {
                        width: 1,
                        height: 1,
                        pixels: vec![[255; 4]],
                        table: None,
                    },
                };
                picture.tint(tint);
                match self.picture(glow, files) {
                    Ok(glow) => picture.add(&glow, light),
                    Err(problem) => self.notes.add(format!("{problem}; its faces do not glow")),
                }
                return Ok(picture);
            }
        };
        let bytes = bytes.map_err(|error| error.to_string());
        let picture = bytes.and_then(|bytes| {
            let picture = Picture::decode(&bytes)?;
            // Many materials can share a picture, and each may need another tint of it.
            let [read, most] = &mut self.pixels;
            if self.decoded.insert(at) {
                *most += 16 * bytes.len();
            }
            *read += picture.pixels.len();
            if *read > PIXELS.max(*most) {
                return Err(format!(
                    "with it, the textures have {read} pixels: too many"
                ));
            }
            Ok(picture)
        });
        picture.map_err(|problem| format!("cannot read texture {name}: {problem}"))
    }

    /// The picture for the faces of a material: the texels are multiplied by the material's tint, and their alpha is
    /// their opacity. `None` if the material has no picture, or a picture that cannot be read, which is noted.
    pub fn texture(&mut self, material: &Material, files: &dyn Files) -> Option<Picture> {
        match self.picture(material.texture?, files) {
            Ok(mut picture) => {
                picture.tint(material.tint);
                if picture.cut(material.alpha) {
                    self.notes.add(INVISIBLE);
                }
                Some(picture)
            }
            Err(problem) => {
                self.notes
                    .add(format!("{problem}; its faces have one color"));
                None
            }
        }
    }

    /// Notes the textures whose files cannot be found, for programs that read these files later.
    pub fn find_textures(&mut self, files: &dyn Files) {
        let textures = self
            .materials
            .iter()
            .filter_map(|material| material.texture);
        let pictures = textures.flat_map(|at| match self.images[at as usize] {
            Image::Glowing { base, glow, .. } => [base, Some(glow)],
            _ => [Some(at), None],
        });
        for at in pictures.flatten() {
            let file = self.images[at as usize].file();
            if let Some(path) = file.filter(|path| files.find(path).is_none()) {
                let note = format!("cannot find texture {}", path.display());
                self.notes.add(note);
            }
        }
    }

    /// Makes the picture `glow`, multiplied by `light`, the light that a material's surface sends out.
    pub(crate) fn glow(&mut self, material: &mut Material, glow: u32, light: [f64; 3]) {
        let base = material.texture;
        let image = Image::Glowing {
            base,
            tint: base.map_or(material.color, |_| material.tint),
            glow,
            light,
        };
        // Materials that share a picture mostly follow each other. A file can have too many to compare them all.
        let mut last = (0..self.images.len()).rev().take(1024);
        let known = last.find(|&at| self.images[at] == image);
        if known.is_none() {
            self.images.push(image);
        }
        material.texture = u32::try_from(known.unwrap_or(self.images.len() - 1)).ok();
        (material.tint, material.emission) = ([255; 3], [0; 3]);
    }

    /// Makes all faces opaque if all are invisible, because some programs write the opacity 0 for opaque. Notes what
    /// stays invisible.
    pub(crate) fn show(&mut self) {
        let used: BTreeSet<Option<u32>> = self.triangles.iter().map(|it| it.material).collect();
        let is_hidden = |at: &u32| self.materials[*at as usize].opacity <= 0.0;
        let hidden: Vec<u32> = used.iter().flatten().copied().filter(is_hidden).collect();
        if hidden.len() < used.len() {
            let note = "a material has the opacity 0: its faces are invisible";
            for _ in hidden {
                self.notes.add(note);
            }
            return;
        }
        for at in hidden {
            self.materials[at as usize].opacity = 1.0;
        }
        let note = "all faces have the opacity 0: they are drawn opaque";
        self.notes.add(note);
    }

    /// Transforms the texture coordinates of the faces of some materials. `changes` maps a material's index to a
    /// transform of texture coordinates as the model stores them: v points down.
    pub(crate) fn transform_uvs(&mut self, changes: &HashMap<u32, Affine>) -> Result<(), String> {
        if changes.values().all(|affine| *affine == IDENTITY) {
            return Ok(());
        }
        let old = std::mem::take(&mut self.uvs);
        let mut moved = HashMap::new();
        for at in 0..self.triangles.len() {
            let mut corners = self.triangles[at].corners;
            let material = self.triangles[at].material;
            let affine = material.and_then(|at| changes.get(&at));
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
