//! For the tests of fragments: a mesh taken to the point where a rasterizer would take over.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use super::{Fragment, Sample};
use crate::geometry::Element;
use crate::linear::Transform;
use crate::{Face, Mesh, Vertex};

/// The identity.
pub(super) const IDENTITY: Transform = scale([1 << 29; 3]);

/// A scale along the axes, 2^29 being 1.
pub(super) const fn scale([x, y, z]: [i32; 3]) -> Transform {
    Transform {
        linear: [[x, 0, 0], [0, y, 0], [0, 0, z]],
        linear_exp: 29,
        translation: [0; 3],
        translation_exp: 29,
    }
}

/// The fragment and the varyings of a mesh's triangle.
pub(super) fn face<F: Fragment<N>, const N: usize>(
    fragment: F,
    model: &Transform,
    mesh: &Mesh<'_>,
    index: usize,
) -> (F, [[i32; N]; 3]) {
    let fragment = fragment.begin(model);
    let face = Face {
        mesh,
        view: &Transform::IDENTITY,
        element: Element {
            face: Some(index),
            indices: mesh.faces()[index],
        },
    };
    let mut corners = [0, 1, 2].map(|corner| {
        fragment.varyings(&Vertex {
            face: &face,
            corner,
        })
    });
    (fragment.face(&mut corners, &face), corners)
}

/// The varyings of an edge's ends.
pub(super) fn edge<F: Fragment<N>, const N: usize>(
    fragment: F,
    mesh: &Mesh<'_>,
    index: usize,
) -> [[i32; N]; 2] {
    let [a, b] = mesh.edges()[index];
    let face = Face {
        mesh,
        view: &Transform::IDENTITY,
        element: Element {
            face: None,
            indices: [a, b, b],
        },
    };
    [0, 1].map(|corner| {
        fragment.varyings(&Vertex {
            face: &face,
            corner,
        })
    })
}

/// A pixel of the frame, at mid-depth.
pub(super) const fn sample(x: i32, y: i32) -> Sample {
    Sample {
        point: Point::new(x, y),
        depth: 0x8000,
    }
}

/// The colour at (0, 0); also shows that the number of varyings follows from the fragment.
pub(super) fn shade<F: Fragment<N, Color = C>, C: PixelColor, const N: usize>(
    fragment: &F,
    varyings: [i32; N],
) -> C {
    fragment.shade(&sample(0, 0), varyings).unwrap()
}

/// How many varyings follow from a fragment's type alone, as where it is drawn.
pub(super) fn count<F: Fragment<N>, const N: usize>(_: &F) -> usize {
    N
}
