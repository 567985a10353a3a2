//! The edges of a mesh, their faces, and the angles between the faces.

use std::collections::HashMap;

use super::linear::{Vec3, cross, dot, length, subtract};

/// An edge between two positions, with the faces on both sides.
#[derive(Clone, Debug)]
pub struct Edge {
    /// The positions of the ends.
    pub ends: [Vec3; 2],
    /// The indices of the faces beside the edge: two faces, or one face at a border.
    pub faces: Vec<usize>,
    /// The angle between the normals of the two faces, in radians; `None` at a border.
    pub angle: Option<f64>,
}

/// Twice the area of a triangle in space, as a vector along its normal.
pub fn normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    cross(subtract(b, a), subtract(c, a))
}

/// The angle between two vectors, in radians.
pub fn angle(a: Vec3, b: Vec3) -> f64 {
    length(cross(a, b)).atan2(dot(a, b))
}

/// The edges of triangles with area. Two faces share an edge if they run along it in opposite directions.
pub fn edges(triangles: &[[Vec3; 3]]) -> Vec<Edge> {
    let bits = |place: Vec3| place.map(|x| (x + 0.).to_bits());
    let mut open: HashMap<_, Vec<usize>> = HashMap::new();
    let mut edges: Vec<Edge> = Vec::new();
    for (face, &triangle) in triangles.iter().enumerate() {
        if length(normal(triangle)) == 0. {
            continue;
        }
        let [a, b, c] = triangle;
        for [from, to] in [[a, b], [b, c], [c, a]] {
            if let Some(at) = open.get_mut(&(bits(to), bits(from))).and_then(Vec::pop) {
                let edge = &mut edges[at];
                edge.angle = Some(angle(normal(triangles[edge.faces[0]]), normal(triangle)));
                edge.faces.push(face);
                continue;
            }
            open.entry((bits(from), bits(to)))
                .or_default()
                .push(edges.len());
            edges.push(Edge {
                ends: [from, to],
                faces: vec![face],
                angle: None,
            });
        }
    }
    edges
}

/// Whether an edge of an outline is drawn. `sides` are the sides that its two faces show to the eye: 1 for the front,
/// −1 for the back, 0 for an edge-on face or no face. Faces that show a side in `culled` are not drawn.
pub fn is_drawn(sides: [i32; 2], is_crease: bool, culled: &[i32]) -> bool {
    let visible = sides
        .iter()
        .any(|side| *side != 0 && !culled.contains(side));
    visible && (is_crease || sides[0] != sides[1])
}
