//! Finds the faces whose backs nobody sees, because they are on closed surfaces.

use std::collections::HashMap;

use fixel_assets::vector::{cross, dot, sub};
use fixel_assets::{Material, Model};

/// Makes faces of two-sided materials one-sided if they belong to a closed surface without holes whose fronts are outside.
/// Seen from outside, such a surface hides its backs, and to leave them out takes half of the time. Then puts the faces
/// of each material together, so that it is one part.
///
/// Two faces are on the same surface if they share an edge. A surface is closed if each of its edges is passed as often
/// in one direction as in the other.
pub fn cull(model: &mut Model, has_holes: impl Fn(&Material) -> bool) {
    let mut points = HashMap::new();
    let mut edges: HashMap<[usize; 2], (usize, i32)> = HashMap::new();
    // For each face, another face of the same surface, or the face itself.
    let mut links: Vec<usize> = (0..model.triangles.len()).collect();
    let root = |links: &mut Vec<usize>, mut at: usize| {
        while links[at] != at {
            links[at] = links[links[at]];
            at = links[at];
        }
        at
    };
    for (at, triangle) in model.triangles.iter().enumerate() {
        let corners = triangle.corners.map(|corner| {
            let point = model.positions[corner.position as usize].map(|x| (x + 0.0).to_bits());
            let new = points.len();
            *points.entry(point).or_insert(new)
        });
        for side in 0..3 {
            let [from, to] = [corners[side], corners[(side + 1) % 3]];
            let edge = edges.entry([from.min(to), from.max(to)]);
            let (other, balance) = edge.or_insert((at, 0));
            *balance += from.cmp(&to) as i32;
            let [other, own] = [*other, at].map(|face| root(&mut links, face));
            links[own] = other;
        }
    }
    // Six times the volume of each surface; `None` if its backs can be seen.
    let middle = model.middle();
    let mut volumes = vec![Some(0.0); links.len()];
    for (face, balance) in edges.into_values() {
        if balance != 0 {
            volumes[root(&mut links, face)] = None;
        }
    }
    for (at, triangle) in model.triangles.iter().enumerate() {
        let [a, b, c] = triangle
            .corners
            .map(|corner| model.positions[corner.position as usize]);
        let [a, b, c] = [a, b, c].map(|at| sub(at, middle));
        let material = triangle.material.map(|at| &model.materials[at as usize]);
        let volume = &mut volumes[root(&mut links, at)];
        let sum = volume.map(|sum| sum + dot(a, cross(b, c)));
        *volume = sum.filter(|_| !material.is_some_and(&has_holes));
    }
    let mut fronts = HashMap::new();
    for at in 0..links.len() {
        let surface = root(&mut links, at);
        if volumes[surface].is_none_or(|volume| volume <= 0.0) {
            continue;
        }
        let triangle = &mut model.triangles[at];
        let old = triangle.material;
        let material = old.map(|at| &model.materials[at as usize]);
        let mut material = material.map_or_else(|| Material::new(String::new()), Material::clone);
        if material.two_sided {
            triangle.material = *fronts.entry(old).or_insert_with(|| {
                material.two_sided = false;
                model.materials.push(material);
                u32::try_from(model.materials.len() - 1).ok()
            });
        }
    }
    (model.triangles).sort_by_key(|triangle| triangle.material);
}
