//! Converts a model from files of a modeling program to words for flash.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::Path;

use bytemuck::NoUninit;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::mesh::flash::{UvGrid, normal_of_8};
use fixel::{Vec2, Vec3};
use fixel_assets::vector::{length, sub};
use fixel_assets::{Alpha, Files, Format, INVISIBLE, Material, Model, Options, Picture};

use crate::header::{self, HEADER, HOLES, Header, MAGIC, NO_TEXTURE, TWO_SIDED, UNLIT, VERSION};
use crate::{Board, HOLE, Module, PartRecord, Problem, TextureRecord, count, sides};

/// The most texels along a side of a texture. This is the least power of two that is not below the 240 rows of a panel.
const SIDE: u32 = 256;
/// The most positions of a mesh.
const MOST: usize = 1 << 16;
/// What a user can do about too many values.
const REMEDY: &str = "save it with fewer triangles";
/// The least opacity of a texel that is drawn, where the file has no other.
const HALF: u8 = 128;
/// The radius of a written model. The radius is less than 1, so that an `i16` can hold a coordinate with 15 fraction
/// bits.
const RADIUS: f64 = 1.0 - 1.0 / 16384.0;

/// Reads the model `name`, and returns its words for a board and a module. Appends to `notes` what was changed or left
/// out. If no picture of the model can be used, all parts get the picture `spare`, if there is one.
///
/// # Errors
///
/// The importer's errors, or the model is too large for flash.
pub fn write(
    name: &str,
    files: &dyn Files,
    spare: Option<&Picture>,
    board: Board,
    module: Module,
    notes: &mut Vec<String>,
) -> Result<Vec<u32>, String> {
    let path = Path::new(name);
    let of_model = |problem| format!("model {name}: {problem}");
    count::check(path, files).map_err(of_model)?;
    let mut model = fixel_assets::read(path, files).map_err(of_model)?;
    // Normals of a model that is far too large would take long.
    let corners = model.triangles.iter().flat_map(|triangle| triangle.corners);
    let used: HashSet<u32> = corners.map(|corner| corner.position).collect();
    if used.len() > MOST {
        let count = used.len();
        return Err(of_model(format!(
            "it has {count} positions: a mesh can have at most {MOST}; {REMEDY}"
        )));
    }
    // Faces of opacity 0 are not drawn.
    let materials = &model.materials;
    let is_hidden = |at: u32| materials[at as usize].opacity <= 0.0;
    (model.triangles).retain(|it| !it.material.is_some_and(is_hidden));
    let mut skins = Skins::new(&mut model, files);
    let scale = fitting(&model);
    let z_up = Format::of(path) == Some(Format::Stl);
    sides::check(&model, scale, z_up).map_err(of_model)?;
    let has_holes = |material: &Material| skins.has_holes(material);
    sides::cull(&mut model, has_holes, scale, z_up).map_err(|error| of_model(error.to_string()))?;
    model.complete();
    // Each material becomes one part.
    (model.triangles).sort_by_key(|triangle| triangle.material);
    // Lines could reach beyond the faces.
    model.edges.clear();
    if model.has_lines {
        model.notes.left_out("lines");
    }
    let options = Options {
        center: true,
        scale,
        z_up,
        remedy: REMEDY,
        ..Options::default()
    };
    let lists = model.lists(&options).map_err(of_model)?;
    let parts = parts(&mut model, &mut skins, spare);
    let pictures = skins.pictures;
    notes.extend(model.notes.iter().chain(model.far.clone()));

    let (positions, fraction) = lists.quantized_positions();
    let normals = lists.normals.iter();
    let normals: Vec<_> = normals
        .map(|&bits| normal_of_8(Vec3::from_bits(bits)))
        .collect();
    let mut corners = [[0; 2]; 2];
    let mut uvs = Vec::new();
    let mut uv_faces = lists.uv_faces;
    if pictures.is_empty() {
        uv_faces.clear();
    } else {
        let axis = |axis: usize| lists.uvs.iter().map(move |uv| uv[axis]);
        corners[0] = [0, 1].map(|at| axis(at).min().unwrap_or(0));
        corners[1] = [0, 1].map(|at| axis(at).max().unwrap_or(0));
        let grid = UvGrid::around(&corners.map(Vec2::from_bits), u16::MAX);
        let all = lists.uvs.iter();
        uvs = all.map(|&uv| grid.nearest(Vec2::from_bits(uv))).collect();
    }

    let mut side = SIDE;
    loop {
        let (textures, texels) = textures(&pictures, side);
        let mut words = vec![0; HEADER];
        let header = Header {
            magic: MAGIC,
            version: VERSION,
            module,
            fraction,
            uv_corners: corners,
            positions: list(&mut words, &positions),
            faces: list(&mut words, &lists.faces),
            normals: list(&mut words, &normals),
            normal_faces: list(&mut words, &lists.normal_faces),
            uvs: list(&mut words, &uvs),
            uv_faces: list(&mut words, &uv_faces),
            colors: list(&mut words, &lists.colors),
            color_faces: list(&mut words, &lists.color_faces),
            parts: list(&mut words, &parts),
            textures: list(&mut words, &textures),
            texels: list(&mut words, &texels),
            ..Header::default()
        };
        if words.len() <= board.words() {
            for ((_, [old_width, old_height]), [width, height, _]) in pictures.iter().zip(&textures)
            {
                if old_width.max(old_height) > &side {
                    notes.push(format!(
                        "a texture of {old_width}x{old_height} texels is shrunk to {width}x{height}"
                    ));
                }
            }
            return Ok(sealed(words, header));
        }
        if pictures.is_empty() || side == 1 {
            return Err(of_model(format!(
                "it takes {} bytes of flash: {} fit",
                4 * words.len(),
                4 * board.words()
            )));
        }
        side /= 2;
    }
}

/// Returns the words of a model, for another module.
///
/// # Errors
///
/// The words are not a model.
pub fn with_module(words: &[u32], module: Module) -> Result<Vec<u32>, Problem> {
    let (header, lists) = header::read(words)?;
    let mut words = vec![0; HEADER];
    words.extend(lists);
    Ok(sealed(words, Header { module, ..*header }))
}

/// Completes the header with the length and the checksum, and writes the header into the first words.
fn sealed(mut words: Vec<u32>, mut header: Header) -> Vec<u32> {
    header.length = u32::try_from(4 * words.len()).unwrap_or(u32::MAX);
    words[..HEADER].copy_from_slice(bytemuck::cast_slice(&[header]));
    header.checksum = header::checksum(&words);
    words[..HEADER].copy_from_slice(bytemuck::cast_slice(&[header]));
    words
}

/// Appends a list to the words, and returns the number of the list's elements.
fn list<T: NoUninit>(words: &mut Vec<u32>, list: &[T]) -> u32 {
    let bytes: &[u8] = bytemuck::cast_slice(list);
    words.extend(bytes.chunks(4).map(|chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        u32::from_le_bytes(word)
    }));
    u32::try_from(list.len()).unwrap_or(u32::MAX)
}

/// The scale that makes the model's radius `RADIUS`, about the middle of the model's box.
fn fitting(model: &Model) -> f64 {
    let middle = model.middle();
    let corners = model.triangles.iter().flat_map(|triangle| triangle.corners);
    let used = corners.map(|corner| model.positions[corner.position as usize]);
    let distances = used.map(|at| length(sub(at, middle)));
    let radius = distances.fold(0.0, f64::max);
    if radius > 0.0 { RADIUS / radius } else { 1.0 }
}

/// The key of a picture: the index of its image, its tint, and what its alpha means.
type Key = (u32, [u8; 3], Alpha);

/// The pictures of a model's materials, each with the size that it has in its file.
struct Skins {
    places: HashMap<Key, Option<u32>>,
    pictures: Vec<(Picture, [u32; 2])>,
}

impl Skins {
    /// Reads the pictures that faces use, each multiplied by its material's tint. Notes those that cannot be read.
    fn new(model: &mut Model, files: &dyn Files) -> Self {
        let (places, pictures) = Default::default();
        let mut skins = Self { places, pictures };
        let used: BTreeSet<_> = model
            .triangles
            .iter()
            .filter_map(|it| it.material)
            .collect();
        for material in used {
            let material = model.materials[material as usize].clone();
            let Some(key) = key(&material).filter(|key| !skins.places.contains_key(key)) else {
                continue;
            };
            let picture = model.texture(&material, files);
            let place = picture.map(|picture| skins.add(model, &picture));
            skins.places.insert(key, place);
        }
        skins
    }

    /// Adds a picture, and returns its index. Its texels become holes or opaque.
    fn add(&mut self, model: &mut Model, picture: &Picture) -> u32 {
        let is_translucent = |pixel: &[u8; 4]| !matches!(pixel[3], 0 | 255);
        if picture.pixels.iter().any(is_translucent) {
            let note = "translucent texels are drawn opaque, and as holes below half opacity";
            model.notes.add(note);
        }
        let mut small = shrunk(picture, SIDE);
        if small.cut(Alpha::Cut(HALF)) {
            model.notes.add(INVISIBLE);
        }
        self.pictures.push((small, [picture.width, picture.height]));
        u32::try_from(self.pictures.len() - 1).unwrap_or(NO_TEXTURE)
    }

    /// The index of a material's picture; `None` if it has none.
    fn of(&self, material: &Material) -> Option<u32> {
        *self.places.get(&key(material)?)?
    }

    fn has_holes(&self, material: &Material) -> bool {
        let place = self.of(material);
        let picture = place.and_then(|at| self.pictures.get(at as usize));
        picture.is_some_and(|(picture, _)| picture.has_alpha())
    }
}

/// The key of a material's picture, if it has one.
fn key(material: &Material) -> Option<Key> {
    Some((material.texture?, material.tint, material.alpha))
}

/// Returns the parts. If the model has no picture, all parts get the picture `spare`, if there is one.
fn parts(model: &mut Model, skins: &mut Skins, spare: Option<&Picture>) -> Vec<PartRecord> {
    let plain = Material::new(String::new());
    let spare = spare.filter(|_| skins.pictures.is_empty());
    let spare = spare.map(|spare| skins.add(model, spare));
    let mut parts = Vec::new();
    for run in model.runs() {
        let material = run.material.and_then(|at| model.materials.get(at as usize));
        let material = material.unwrap_or(&plain);
        let texture = skins.of(material).or(spare).unwrap_or(NO_TEXTURE);
        let picture = skins.pictures.get(texture as usize);
        let finish = [
            (material.two_sided, TWO_SIDED),
            (material.unlit, UNLIT),
            (
                picture.is_some_and(|(picture, _)| picture.has_alpha()),
                HOLES,
            ),
        ];
        let finish = finish.into_iter().filter(|(is, _)| *is);
        let finish = finish.map(|(_, bit)| bit).sum();
        let [color, emission] = [material.color, material.emission]
            .map(|[red, green, blue]| u32::from_be_bytes([0, red, green, blue]));
        let [start, end] = run.faces.map(|at| u32::try_from(at).unwrap_or(u32::MAX));
        parts.push([start, end, color, texture, emission, finish]);
        if material.opacity < 1.0 {
            model.notes.add("translucent materials are drawn opaque");
        }
    }
    parts
}

/// A picture with sides of powers of two, of at most `most` texels.
fn shrunk(picture: &Picture, most: u32) -> Picture {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // log2 is 0 to 8
    let near = |side: u32| 1 << f64::from(side.clamp(1, most)).log2().round() as u32;
    picture.resampled(near(picture.width), near(picture.height))
}

/// Converts pictures to textures with sides of at most `most` texels.
fn textures(pictures: &[(Picture, [u32; 2])], most: u32) -> (Vec<TextureRecord>, Vec<u16>) {
    let mut texels = Vec::new();
    let textures = pictures.iter().map(|(picture, _)| {
        let first = u32::try_from(texels.len()).unwrap_or(u32::MAX);
        let (small, has_holes) = (shrunk(picture, most), picture.has_alpha());
        texels.extend(small.pixels.iter().map(|&[red, green, blue, alpha]| {
            let texel = match Rgb565::from(Rgb888::new(red, green, blue)) {
                _ if alpha < HALF => HOLE,
                // The nearest color that is no hole.
                HOLE if has_holes => Rgb565::new(31, 1, 31),
                color => color,
            };
            RawU16::from(texel).into_inner()
        }));
        [small.width, small.height, first]
    });
    (textures.collect(), texels)
}
