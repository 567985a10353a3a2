//! The measured scenes: 320x240 pixels, focal length 200, near 0.25, far 100.
//!
//! The attributes are u and v. v points down, as in stored textures.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_8, PI, TAU};

use super::linear::{Matrix, Vec3, multiply, product, rotate_x, rotate_y, translate};
use super::projection::focal;
use super::raster::Mesh;
use super::view::{View, Viewport};

/// The numbers of columns and rows of the picture.
pub const SIZE: (u32, u32) = (320, 240);
/// The number of poses of the cube and of the sphere.
pub const POSES: u32 = 8;

/// A mesh that owns its lists, with texture coordinates.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    /// Positions in model space.
    pub positions: Vec<Vec3>,
    /// Triangles, front faces counter-clockwise.
    pub faces: Vec<[usize; 3]>,
    /// u and v of each triangle's corners.
    pub uvs: Vec<[[f64; 2]; 3]>,
}

impl Shape {
    /// The shape as a mesh of the model.
    pub fn mesh(&self) -> Mesh<'_, 2> {
        Mesh {
            positions: &self.positions,
            faces: &self.faces,
            attributes: &self.uvs,
        }
    }

    /// Adds a quad as two triangles, with the corners 0 1 2 and 0 2 3.
    fn quad(&mut self, corners: [Vec3; 4], uvs: [[f64; 2]; 4]) {
        let first = self.positions.len();
        self.positions.extend(corners);
        for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
            self.faces.push([first + a, first + b, first + c]);
            self.uvs.push([uvs[a], uvs[b], uvs[c]]);
        }
    }
}

/// The view of a scene, for a transform from model space to eye space.
pub fn view(eye: Matrix) -> View {
    View {
        eye,
        projection: focal(200., SIZE, 0.25, 100.),
        viewport: Viewport::new(SIZE.0, SIZE.1),
    }
}

/// The floor and its view.
pub fn floor() -> (Shape, View) {
    let mut shape = Shape::default();
    shape.quad(
        [
            [-10., 0., -1.],
            [10., 0., -1.],
            [10., 0., -20.],
            [-10., 0., -20.],
        ],
        [[0., 1.], [1., 1.], [1., 0.], [0., 0.]],
    );
    let eye = multiply(&rotate_x(0.2_f64.atan()), &translate([0., -1., 0.]));
    (shape, view(eye))
}

/// The cube and its view in pose 0 to 7; each face has its own four vertices.
pub fn cube(pose: u32) -> (Shape, View) {
    let mut shape = Shape::default();
    for axis in 0..3 {
        for sign in [-1., 1.] {
            // u points along the next axis, and is mirrored on faces of negative sign. v points along the third axis.
            let corner = |u: f64, v: f64| {
                let mut p = [0.; 3];
                p[axis] = sign;
                p[(axis + 1) % 3] = u * sign;
                p[(axis + 2) % 3] = v;
                p
            };
            shape.quad(
                [
                    corner(-1., -1.),
                    corner(1., -1.),
                    corner(1., 1.),
                    corner(-1., 1.),
                ],
                [[0., 1.], [1., 1.], [1., 0.], [0., 0.]],
            );
        }
    }
    let k = f64::from(pose);
    let eye = product(&[
        translate([0., 0., -3.133_832_458]),
        rotate_x(0.3 + k * FRAC_PI_8),
        rotate_y(0.4 + k * FRAC_PI_4),
    ]);
    (shape, view(eye))
}

/// The sphere and its view in pose 0 to 7. The sphere has 33 rows of 33 vertices each, from the pole at +y down. The
/// last column of vertices coincides with the first column.
pub fn sphere(pose: u32) -> (Shape, View) {
    const PARTS: usize = 32;
    let mut shape = Shape::default();
    let uv = |[row, column]: [usize; 2]| [column, row].map(|i| i as f64 / PARTS as f64);
    for row in 0..=PARTS {
        for column in 0..=PARTS {
            let [u, v] = uv([row, column]);
            let ((sin, cos), (sin_u, cos_u)) = ((v * PI).sin_cos(), (u * TAU).sin_cos());
            shape.positions.push([sin * cos_u, cos, -sin * sin_u]);
        }
    }
    for row in 0..PARTS {
        for column in 0..PARTS {
            let quad = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[r, c]| [row + r, column + c]);
            // At a pole, one side of the quad is a point, so one of the quad's triangles has no area and is left out.
            let triangles = [(row + 1 < PARTS, [0, 1, 2]), (row > 0, [0, 2, 3])];
            for (_, corners) in triangles.into_iter().filter(|(there, _)| *there) {
                let corners = corners.map(|i| quad[i]);
                shape.faces.push(corners.map(|[r, c]| r * (PARTS + 1) + c));
                shape.uvs.push(corners.map(uv));
            }
        }
    }
    let k = f64::from(pose);
    let eye = product(&[
        translate([0., 0., -2.256_239_223_7]),
        rotate_x(0.35 + 0.3 * k),
        rotate_y(0.2 + k * FRAC_PI_4),
    ]);
    (shape, view(eye))
}
