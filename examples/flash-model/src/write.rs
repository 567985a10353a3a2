//! Converts a model from files of a modeling program to words for flash.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use bytemuck::NoUninit;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::mesh::flash::{UvGrid, normal_of_8};
use fixel::{Vec2, Vec3};
use fixel_assets::vector::{length, sub};
use fixel_assets::{Alpha, Files, Format, Material, Model, Options, Picture};

use crate::header::{self, HEADER, Header, MAGIC, NO_TEXTURE, VERSION};
use crate::{Board, Module, PartRecord, Problem, TextureRecord};

/// The most texels along a side of a texture. This is the least power of two that is not below the 240 rows of a panel.
const SIDE: u32 = 256;
/// The most positions of a mesh.
const MOST: usize = 1 << 16;
/// What a user can do about too many values.
const REMEDY: &str = "save it with fewer triangles";
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
    model.complete();
    // Lines could reach beyond the faces.
    model.edges.clear();
    if model.has_lines {
        model.notes.left_out("lines");
    }
    let options = Options {
        center: true,
        scale: fitting(&model),
        z_up: Format::of(path) == Some(Format::Stl),
        remedy: REMEDY,
        ..Options::default()
    };
    let lists = model.lists(&options).map_err(of_model)?;
    let (parts, pictures) = parts(&mut model, files, spare);
    notes.extend(model.notes.iter());

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
            for (picture, [width, height, _]) in pictures.iter().zip(&textures) {
                let old = [picture.width, picture.height];
                if old.iter().any(|&old| old > side) {
                    let [old_width, old_height] = old;
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

/// Returns the parts, and the pictures that the parts use, each multiplied by its material's tint.
fn parts(
    model: &mut Model,
    files: &dyn Files,
    spare: Option<&Picture>,
) -> (Vec<PartRecord>, Vec<Picture>) {
    let plain = Material::new(String::new());
    let mut pictures = Vec::new();
    let mut places = HashMap::new();
    let mut parts = Vec::new();
    let mut is_simple = true;
    for run in model.runs() {
        let material = run.material.and_then(|at| model.materials.get(at as usize));
        let material = material.unwrap_or(&plain).clone();
        let texture = material.texture.and_then(|image| {
            let key = (image, material.tint, material.alpha);
            *places.entry(key).or_insert_with(|| {
                pictures.push(model.texture(&material, files)?);
                u32::try_from(pictures.len() - 1).ok()
            })
        });
        let picture = texture.and_then(|at: u32| pictures.get(at as usize));
        let has_holes = material.alpha != Alpha::Ignored && picture.is_some_and(Picture::has_alpha);
        is_simple &= material.emission == [0; 3] && material.opacity >= 1.0 && !has_holes;
        let [red, green, blue] = material.color;
        let color = u32::from_be_bytes([0, red, green, blue]);
        let [start, end] = run.faces.map(|at| u32::try_from(at).unwrap_or(u32::MAX));
        parts.push([start, end, color, texture.unwrap_or(NO_TEXTURE)]);
    }
    if !is_simple {
        model
            .notes
            .add("all materials are opaque, and none sends out light");
    }
    if let (true, Some(spare)) = (pictures.is_empty(), spare) {
        pictures.push(spare.clone());
        for part in &mut parts {
            part[3] = 0;
        }
    }
    (parts, pictures)
}

/// Converts pictures to textures with sides of at most `most` texels.
fn textures(pictures: &[Picture], most: u32) -> (Vec<TextureRecord>, Vec<u16>) {
    let mut texels = Vec::new();
    let textures = pictures.iter().map(|picture| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // log2 is 0 to 8
        let near = |side: u32| 1 << f64::from(side.clamp(1, most)).log2().round() as u32;
        let [width, height] = [picture.width, picture.height].map(near);
        let first = u32::try_from(texels.len()).unwrap_or(u32::MAX);
        let resampled;
        let picture = if [width, height] == [picture.width, picture.height] {
            picture
        } else {
            resampled = picture.resampled(width, height);
            &resampled
        };
        texels.extend(picture.pixels.iter().map(|&[red, green, blue, _]| {
            RawU16::from(Rgb565::from(Rgb888::new(red, green, blue))).into_inner()
        }));
        [width, height, first]
    });
    (textures.collect(), texels)
}
