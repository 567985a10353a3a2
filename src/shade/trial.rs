//! For the tests of shaders: a mesh taken to the point where a rasterizer would take over.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use super::{Fragment, Shader};
use crate::math::Transform;
use crate::mesh::Element;
use crate::{Corner, Face, Mesh};

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

/// The shader and the varyings of a mesh's triangle.
pub(super) fn face<F: Shader<N>, const N: usize>(
    shader: F,
    model: &Transform,
    mesh: &Mesh<'_>,
    index: usize,
) -> (F, [[i32; N]; 3]) {
    let shader = shader.begin(model);
    let face = Face {
        mesh,
        view: &Transform::IDENTITY,
        element: Element {
            face: Some(index),
            indices: mesh.faces()[index],
        },
    };
    let mut corners = [0, 1, 2].map(|corner| {
        shader.varyings(&Corner {
            face: &face,
            corner,
        })
    });
    (shader.face(&mut corners, &face), corners)
}

/// The varyings of an edge's ends.
pub(super) fn edge<F: Shader<N>, const N: usize>(
    shader: F,
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
        shader.varyings(&Corner {
            face: &face,
            corner,
        })
    })
}

/// A pixel of the frame, at mid-depth.
pub(super) const fn sample(x: i32, y: i32) -> Fragment {
    Fragment {
        point: Point::new(x, y),
        depth: 0x8000,
    }
}

/// The colour at (0, 0); also shows that the number of varyings follows from the shader.
pub(super) fn shade<F: Shader<N, Color = C>, C: PixelColor, const N: usize>(
    shader: &F,
    varyings: [i32; N],
) -> C {
    shader.shade(&sample(0, 0), varyings).unwrap()
}

/// How many varyings follow from a shader's type alone, as where it is drawn.
pub(super) fn count<F: Shader<N>, const N: usize>(_: &F) -> usize {
    N
}
