//! Finds the outline of a mesh: its edges with their two faces.

use std::collections::{HashMap, VecDeque};

use crate::Lists;
use crate::vector::{cross, dot, length};

/// Faces with normals at most this many radians apart form no crease.
const FLAT: f64 = 1.0 / 1024.0;

impl Lists {
    /// Returns the edges of the mesh's outline, and the number of creases: see [`outline`].
    #[must_use]
    pub fn outline(&self, crease: f64) -> (Vec<[u16; 4]>, usize) {
        outline(&self.positions, &self.faces, crease)
    }
}

/// Returns the edges of the outline of faces, and the number of creases. Positions are in any fixed-point format. The
/// creases come first, in the order of their faces; the other edges follow, in the order of their faces.
/// `fixel::mesh::Outline::build` finds the same edges.
///
/// An edge a, b, c, d runs from a to b; its faces are a b c and b a d. A border has one face, and its d equals a. An
/// edge is a crease if the normals of its faces are more than `crease` degrees apart.
#[must_use]
pub fn outline<I: Copy + PartialEq + Into<u32>>(
    positions: &[[i32; 3]],
    faces: &[[I; 3]],
    crease: f64,
) -> (Vec<[I; 4]>, usize) {
    let at = |index: I| positions[index.into() as usize];
    // The products are exact: a component has 33 bits, and a product 67.
    let direction = |a: I, b: I| {
        let (a, b) = (at(a), at(b));
        [0, 1, 2].map(|i| i128::from(b[i]) - i128::from(a[i]))
    };
    let normal = |[a, b, c]: [I; 3]| {
        let ([px, py, pz], [qx, qy, qz]) = (direction(a, b), direction(a, c));
        #[allow(clippy::cast_precision_loss)] // of the last bits
        let normal = [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx].map(|x| x as f64);
        normal
    };
    // Faces without area do not count.
    let has_area = |&&face: &&[I; 3]| length(normal(face)) > 0.0;
    let sides = faces
        .iter()
        .filter(has_area)
        .flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let mut edges: Vec<[I; 4]> = Vec::new();
    // The indices of the edges that still lack their second face, by the positions of their ends.
    let mut open: HashMap<[[i32; 3]; 2], VecDeque<usize>> = HashMap::new();
    for [a, b, c] in sides {
        if let Some(edge) = open.get_mut(&[at(b), at(a)]).and_then(VecDeque::pop_front) {
            edges[edge][3] = c;
        } else {
            open.entry([at(a), at(b)])
                .or_default()
                .push_back(edges.len());
            edges.push([a, b, c, a]);
        }
    }
    let is_crease = |&[a, b, c, d]: &[I; 4]| {
        let (n, m) = (normal([a, b, c]), normal([b, a, d]));
        let angle = length(cross(n, m)).atan2(dot(n, m));
        d != a && angle > crease.to_radians().max(FLAT)
    };
    let (mut creases, others): (Vec<_>, Vec<_>) = edges.iter().partition(|edge| is_crease(edge));
    let count = creases.len();
    creases.extend(others);
    (creases, count)
}
