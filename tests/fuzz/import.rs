//! Reads models and pictures from arbitrary bytes, and converts them as programs do.

use std::io;
use std::path::{Path, PathBuf};

use fixel_assets::vector::{Vector, length, unit};
use fixel_assets::{Corner, Files, Lists, Model, Options, Picture};

/// The endings of model files. The last one lets the reader find the format by the contents.
const ENDINGS: [&str; 6] = ["obj", "stl", "ply", "gltf", "glb", "model"];

/// Scales for the lists of a mesh.
const SCALES: [f64; 8] = [1.0, -1.0, 0.01, 1e-9, -1000.0, 65_536.0, 1e12, 1e300];

/// The largest coordinate that the reader of models accepts.
const FAR: f64 = 1e30;

/// A model's file. All files that it names exist, and have the same bytes.
struct Bytes<'a>(&'a [u8]);

impl Files for Bytes<'_> {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Ok(self.0.to_vec())
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        Some(path.into())
    }
}

/// Reads a model, and converts it into the lists of a mesh. The first four bytes select the ending of the file's name,
/// and options; the others are the file.
///
/// # Panics
///
/// Panics if an invariant does not hold.
pub fn model(bytes: &[u8]) {
    let Some((&[ending, scale, flags, crease], bytes)) = bytes.split_first_chunk() else {
        return;
    };
    let ending = ENDINGS[usize::from(ending) % ENDINGS.len()];
    let path = format!("a.{ending}");
    let mut model = match fixel_assets::read(Path::new(&path), &Bytes(bytes)) {
        Ok(model) => model,
        Err(problem) => return check_message(&problem),
    };
    model.notes.iter().for_each(|note| check_message(&note));
    check_model(&model);
    let has = |bit: u8| flags & 1 << bit > 0;
    if has(0) {
        model.turn_normals();
        check_model(&model);
    }
    if has(1) {
        model.complete();
        check_model(&model);
        check_completed(&model);
    }
    let runs = model.runs();
    let ends = runs.iter().flat_map(|run| run.faces);
    assert!(ends.eq(joints(&runs, model.triangles.len())), "{runs:?}");
    let name = |names: &[String]| names.first().filter(|_| has(2)).cloned();
    let materials: Vec<_> = model.materials.iter().map(|one| one.name.clone()).collect();
    let options = Options {
        center: has(3),
        scale: SCALES[usize::from(scale) % SCALES.len()],
        z_up: has(4),
        part: name(&materials).filter(|_| has(5)),
        object: name(&model.objects).filter(|_| has(6)),
        file_order: has(7),
        ..Options::default()
    };
    if let Some(note) = model.merging(options.scale) {
        check_message(&note);
    }
    match model.lists(&options) {
        Ok(lists) => check_lists(&lists, crease.into()),
        Err(problem) => assert!(!problem.contains("NaN"), "{problem}"),
    }
}

/// The ends of runs that follow each other and cover all faces.
fn joints(runs: &[fixel_assets::Run], faces: usize) -> impl Iterator<Item = usize> {
    let starts: Vec<usize> = runs.iter().map(|run| run.faces[0]).collect();
    let ends = starts.iter().skip(1).copied().chain([faces]);
    let pairs: Vec<_> = starts.iter().copied().zip(ends).collect();
    pairs.into_iter().flat_map(|(start, end)| [start, end])
}

/// Checks that a message or note is one line of limited length: reader's errors and notes quote the file.
fn check_message(message: &str) {
    assert!(!message.contains(char::is_control), "{message:?}");
    // There are at most 32 names of at most 40 characters in a note, and escapes can make a character 10 long.
    assert!(message.len() < 20_000, "{message:?}");
}

/// Checks that everything that a model names exists and can be drawn.
fn check_model(model: &Model) {
    assert!(!model.triangles.is_empty());
    let has = |list: usize, at: Option<u32>| at.is_none_or(|at| (at as usize) < list);
    for triangle in &model.triangles {
        assert!(has(model.materials.len(), triangle.material));
        assert!(has(model.objects.len(), triangle.object));
        let uvs = triangle.corners.map(|corner| corner.uv.is_some());
        assert!(
            uvs == [uvs[0]; 3],
            "all corners have texture coordinates, or none"
        );
        for corner in &triangle.corners {
            check_corner(model, corner);
        }
    }
    for &[a, b] in &model.edges {
        assert!(a < b);
        for at in [a, b] {
            assert!(position(model, at).iter().all(|x| x.abs() <= FAR));
        }
    }
    assert!(model.edges.is_sorted());
    for material in &model.materials {
        assert!(has(model.images.len(), material.texture));
        assert!((0.0..=1.0).contains(&material.opacity), "{material:?}");
    }
    // The middle of the box is used to center the model.
    assert!(model.middle().iter().all(|x| x.abs() <= FAR));
}

fn position(model: &Model, at: u32) -> Vector {
    model.positions[at as usize]
}

fn check_corner(model: &Model, corner: &Corner) {
    let position = position(model, corner.position);
    assert!(position.iter().all(|x| x.abs() <= FAR), "{position:?}");
    if let Some(at) = corner.uv {
        let uv = model.uvs[at as usize];
        assert!(uv.iter().all(|x| x.abs() <= 1024.0), "{uv:?}");
    }
    if let Some(at) = corner.normal {
        let normal = model.normals[at as usize];
        assert!(normal.iter().all(|x| x.abs() <= FAR) && unit(normal).is_some());
    }
    if let Some(at) = corner.color {
        let _ = model.colors[at as usize];
    }
}

/// Checks that all corners have a normal and texture coordinates. Computed normals have length 1.
fn check_completed(model: &Model) {
    for corner in model
        .triangles
        .iter()
        .flat_map(|triangle| &triangle.corners)
    {
        let normal = corner.normal.map(|at| model.normals[at as usize]);
        assert!(length(normal.expect("a normal")).is_finite());
        assert!(corner.uv.is_some());
    }
}

/// Checks that all indices are in range, and that each edge of the outline has its faces.
fn check_lists(lists: &Lists, crease: f64) {
    let check = |indices: &[[u16; 3]], count: usize, may_lack: bool| {
        assert!(indices.is_empty() || indices.len() == lists.faces.len());
        for &at in indices.as_flattened() {
            assert!(usize::from(at) < count || (may_lack && at == u16::MAX));
        }
    };
    check(&lists.faces, lists.positions.len(), false);
    check(&lists.uv_faces, lists.uvs.len(), true);
    check(&lists.normal_faces, lists.normals.len(), true);
    check(&lists.color_faces, lists.colors.len(), true);
    let count = lists.positions.len();
    assert!(
        lists
            .edges
            .as_flattened()
            .iter()
            .all(|&at| usize::from(at) < count)
    );
    let (edges, creases) = lists.outline(crease);
    assert!(creases <= edges.len() && edges.len() <= 3 * lists.faces.len());
    assert!(
        edges
            .as_flattened()
            .iter()
            .all(|&at| usize::from(at) < count)
    );
    let (short, fraction) = lists.quantized_positions();
    assert!(short.len() == count && fraction <= 16);
}

/// Decodes a picture, and converts it.
///
/// # Panics
///
/// Panics if an invariant does not hold.
pub fn picture(bytes: &[u8]) {
    let picture = match Picture::decode(bytes) {
        Ok(picture) => picture,
        Err(problem) => return assert!(!problem.is_empty()),
    };
    let (width, height) = (picture.width as usize, picture.height as usize);
    assert!(width * height > 0 && picture.pixels.len() == width * height);
    // Large pictures are slow: any lossless WebP may have 4096x4096 pixels.
    if width * height <= 1 << 12 {
        if let Some((indices, colors)) = picture.palette() {
            let color = |&at: &u8| colors[usize::from(at)];
            assert!(indices.iter().map(color).eq(picture.pixels.iter().copied()));
        }
        let resampled = picture.resampled(3, 5);
        assert_eq!(resampled.pixels.len(), 15);
        assert!(picture.has_alpha() || !resampled.has_alpha());
    }
}
