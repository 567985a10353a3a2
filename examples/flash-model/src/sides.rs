//! Finds the faces whose backs nobody sees, and refuses faces that cover each other too often.

use std::collections::{HashMap, HashSet};

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::FaceColors;
use fixel_assets::vector::{cross, dot, sub};
use fixel_assets::{Material, Model};

use crate::layers;

/// The numbers of the rows and columns of the pictures in which backs are looked for.
const SIDE: u32 = 240;
/// The number of these pictures, and the time between two of them: a turn of 10 seconds.
const VIEWS: u64 = 40;
const STEP_MS: u64 = 250;
/// The most layers of faces: a Pico then draws a frame in about two seconds.
const MOST_LAYERS: u64 = 50;
/// The most triangles of a mesh whose triangles share no corner.
const MOST: usize = 65_535 / 3;

/// Makes faces of two-sided materials one-sided if their backs cannot be seen. The turning model is then drawn in half
/// of the time, because most files call all surfaces two-sided.
///
/// A back can be seen if a picture shows it, or the back of a face that shares a corner and a surface with it: between two
/// pictures, slightly more is seen. Two faces are on the same surface if they share an edge.
pub fn cull(
    model: &mut Model,
    has_holes: impl Fn(&Material) -> bool,
    scale: f64,
    z_up: bool,
) -> Result<(), Error> {
    let mut surfaces = Surfaces::new(model);
    let backs = surfaces.open(model);
    let of = |model: &Model, at: usize| {
        let material = model.triangles[at].material;
        let material = material.map(|at| &model.materials[at as usize]);
        let is_two_sided = material.is_none_or(|material| material.two_sided);
        (is_two_sided, material.is_some_and(&has_holes))
    };
    // A surface with holes keeps its backs, and hides nothing: nobody looks through its holes here.
    let (mut fronts, mut candidates, mut whole) = (Vec::new(), Vec::new(), HashSet::new());
    for at in 0..model.triangles.len() {
        let surface = surfaces.of(at);
        let (is_two_sided, has_holes) = of(model, at);
        if has_holes {
            whole.insert(surface);
        } else {
            fronts.push(at);
        }
        if is_two_sided && backs.contains(&surface) {
            candidates.push(at);
        }
    }
    let mut seen = HashSet::new();
    for at in visible(model, &fronts, &candidates, scale, z_up)? {
        let surface = surfaces.of(at);
        seen.extend(corners(model, at).map(|corner| (surface, corner)));
    }
    let mut twins = HashMap::new();
    for at in 0..model.triangles.len() {
        let surface = surfaces.of(at);
        let mut own = corners(model, at).into_iter();
        let is_seen = own.any(|corner| seen.contains(&(surface, corner)));
        if !of(model, at).0 || is_seen || whole.contains(&surface) {
            continue;
        }
        let old = model.triangles[at].material;
        let new = twins.entry(old).or_insert_with(|| {
            let material = old.map(|at| model.materials[at as usize].clone());
            let mut twin = material.unwrap_or_else(|| Material::new(String::new()));
            twin.two_sided = false;
            model.materials.push(twin);
            u32::try_from(model.materials.len() - 1).ok()
        });
        model.triangles[at].material = *new;
    }
    Ok(())
}

/// The surfaces of a model.
struct Surfaces {
    /// For each face, another face of the same surface, or the face itself.
    links: Vec<usize>,
    /// For each edge, one of its faces, and how much more often it is passed in one direction than in the other.
    edges: HashMap<[usize; 2], (usize, i32)>,
}

impl Surfaces {
    fn new(model: &Model) -> Self {
        let mut surfaces = Self {
            links: (0..model.triangles.len()).collect(),
            edges: HashMap::new(),
        };
        let mut points = HashMap::new();
        for at in 0..model.triangles.len() {
            let corners = corners(model, at).map(|point| {
                let new = points.len();
                *points.entry(point).or_insert(new)
            });
            for side in 0..3 {
                let [from, to] = [corners[side], corners[(side + 1) % 3]];
                let edge = (surfaces.edges).entry([from.min(to), from.max(to)]);
                let (other, balance) = edge.or_insert((at, 0));
                *balance += from.cmp(&to) as i32;
                let other = *other;
                let [other, own] = [other, at].map(|face| surfaces.of(face));
                surfaces.links[own] = other;
            }
        }
        surfaces
    }

    /// The surface of a face.
    fn of(&mut self, mut face: usize) -> usize {
        while self.links[face] != face {
            self.links[face] = self.links[self.links[face]];
            face = self.links[face];
        }
        face
    }

    /// The surfaces whose backs can face outward: those with a border, and those with a negative volume.
    fn open(&mut self, model: &Model) -> HashSet<usize> {
        let borders = self.edges.values().filter(|(_, balance)| *balance != 0);
        let borders: Vec<usize> = borders.map(|(face, _)| *face).collect();
        let mut open: HashSet<usize> = borders.into_iter().map(|face| self.of(face)).collect();
        let middle = model.middle();
        let mut volumes: HashMap<usize, f64> = HashMap::new();
        for (at, triangle) in model.triangles.iter().enumerate() {
            let [a, b, c] = triangle
                .corners
                .map(|corner| sub(model.positions[corner.position as usize], middle));
            *volumes.entry(self.of(at)).or_default() += dot(a, cross(b, c));
        }
        open.extend(volumes.iter().filter(|it| *it.1 <= 0.0).map(|it| it.0));
        open
    }
}

/// Refuses a model whose faces cover the picture so often that to draw them would take long.
///
/// # Errors
///
/// The message says how often, and how often they may.
pub fn check(model: &Model, scale: f64, z_up: bool) -> Result<(), String> {
    let layers = layers(model, scale, z_up).map_err(|error| error.to_string())?;
    layers::check(layers, MOST_LAYERS, "")
}

/// Returns how often the faces cover the picture, at most, while the model turns.
fn layers(model: &Model, scale: f64, z_up: bool) -> Result<u64, Error> {
    let all: Vec<usize> = (0..model.triangles.len()).collect();
    let (places, corners) = (places(model, &all, scale, z_up)?, separate());
    let meshes = places.chunks(3 * MOST);
    let meshes = meshes.map(|places| Mesh::new(places, &corners[..places.len() / 3]));
    let meshes: Vec<Mesh<'_>> = meshes.collect::<Result<_, _>>()?;
    let mut most = 0;
    for time in (0..VIEWS).step_by(10) {
        let mvp = crate::view((SIDE, SIDE))? * crate::turn(time * STEP_MS);
        most = most.max(layers::count(&meshes, &mvp, (SIDE, SIDE))?);
    }
    Ok(most)
}

/// The places of a face's corners, of which equal ones are one key.
fn corners(model: &Model, face: usize) -> [[u64; 3]; 3] {
    model.triangles[face].corners.map(|corner| {
        let place = model.positions[corner.position as usize];
        place.map(|x| (x + 0.0).to_bits())
    })
}

/// The positions of the corners of some faces, as a board draws them.
fn places(model: &Model, faces: &[usize], scale: f64, z_up: bool) -> Result<Vec<Vec3>, Error> {
    let middle = model.middle();
    let corners = faces.iter().flat_map(|&face| model.triangles[face].corners);
    let places = corners.map(|corner| {
        let [x, y, z] = sub(model.positions[corner.position as usize], middle);
        let turned = if z_up { [x, z, -y] } else { [x, y, z] };
        Vec3::try_from(turned.map(|x| x * scale))
    });
    places.collect()
}

/// The faces of a mesh whose triangles share no corner.
fn separate() -> Vec<[u16; 3]> {
    let firsts = (0..=u16::MAX).step_by(3).take(MOST);
    firsts.map(|at| [at, at + 1, at + 2]).collect()
}

/// Returns those of the faces `backs` whose backs are seen before the fronts of the faces `fronts`, while the model turns
/// on a panel.
fn visible(
    model: &Model,
    fronts: &[usize],
    backs: &[usize],
    scale: f64,
    z_up: bool,
) -> Result<HashSet<usize>, Error> {
    let mut seen = HashSet::new();
    if backs.is_empty() {
        return Ok(seen);
    }
    let front_places = places(model, fronts, scale, z_up)?;
    let back_places = places(model, backs, scale, z_up)?;
    let corners = separate();
    let mut pixels = vec![Rgb888::BLACK; (SIDE * SIDE) as usize];
    let mut depths = vec![0; pixels.len()];
    for time in 0..VIEWS {
        let mvp = crate::view((SIDE, SIDE))? * crate::turn(time * STEP_MS);
        let mut canvas = Canvas::new(&mut pixels, SIDE, SIDE)?.with_depth(&mut depths)?;
        canvas.clear(Rgb888::BLACK);
        for places in front_places.chunks(3 * MOST) {
            let mesh = Mesh::new(places, &corners[..places.len() / 3])?;
            canvas.draw(&mesh, &mvp, &Flat::new(Rgb888::BLACK));
        }
        // The number of a face, counted from 1, is its color.
        for (first, places) in (1..).step_by(MOST).zip(back_places.chunks(3 * MOST)) {
            let mesh = Mesh::new(places, &corners[..places.len() / 3])?;
            let color = |face: u32| {
                let [_, red, green, blue] = face.to_be_bytes();
                Rgb888::new(red, green, blue)
            };
            let colors: Vec<Rgb888> = (first..).take(places.len() / 3).map(color).collect();
            let options = DrawOptions::new().with_cull(Cull::Front);
            canvas.draw_with(&options, &mesh, &mvp, &FaceColors::new(&colors));
        }
        let numbers = pixels.iter().map(|color| {
            let number = u32::from_be_bytes([0, color.r(), color.g(), color.b()]);
            number as usize
        });
        seen.extend(numbers.filter_map(|number| backs.get(number.checked_sub(1)?)));
    }
    Ok(seen)
}
