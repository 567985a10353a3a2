//! Helpers for tests of shaders: they run a shader without the rasterizer.

use embedded_graphics::geometry::Point;

use super::{ColorOf, Fragment, Lanes, Output, Shader, Varyings};
use crate::Mesh;
use crate::math::Transform;
use crate::mesh::{Indices, Placement};

/// The identity transform.
pub(super) const IDENTITY: Transform = scale([1 << 29; 3]);

/// A scale along the axes, in units of 2^-29.
pub(super) const fn scale([x, y, z]: [i32; 3]) -> Transform {
    Transform {
        linear: [[x, 0, 0], [0, y, 0], [0, 0, z]],
        linear_exp: 29,
        translation: [0; 3],
        translation_exp: 29,
        is_mirror: x ^ y ^ z < 0,
    }
}

/// Returns the shader, and its varyings at the corners of a triangle of a mesh.
pub(super) fn face<S: Shader>(
    shader: S,
    model: &Transform,
    mesh: &Mesh<'_>,
    index: usize,
) -> (S, [S::Varyings; 3]) {
    let placement = Placement::new(mesh, model, Transform::IDENTITY);
    let face = Indices::of_face(index, mesh.faces()[index]);
    (shader, shader.varyings(&placement.primitive(face, 0)))
}

/// The varyings at the ends of an edge.
pub(super) fn edge<S: Shader>(shader: S, mesh: &Mesh<'_>, index: usize) -> [S::Varyings; 2] {
    let placement = Placement::new(mesh, &IDENTITY, Transform::IDENTITY);
    let edge = Indices::of_edge(index, mesh.edge_indices()[index]);
    let [start, end, _] = shader.varyings(&placement.primitive(edge, 0));
    [start, end]
}

/// A pixel of the frame, at mid-depth.
pub(super) const fn fragment(x: i32, y: i32) -> Fragment {
    Fragment {
        point: Point::new(x, y),
        depth: 0x8000,
    }
}

/// The color of the pixel at (0, 0).
pub(super) fn shade<S: Shader>(shader: &S, varyings: S::Varyings) -> ColorOf<S> {
    let at = fragment(0, 0);
    shader.shade(&at, varyings).unwrap().finish(at.point)
}

/// How many numbers a shader interpolates.
pub(super) fn count<S: Shader>(_: &S) -> usize {
    <S::Varyings as Varyings>::Lanes::COUNT
}
