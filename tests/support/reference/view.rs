//! The transform of a position in space to a position on the screen.

use super::linear::{Matrix, Vec3, Vec4, apply, apply_point, multiply};
use super::projection::Projection;

/// The part of the canvas that the picture fills, in whole pixels, with y down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// Column of the left edge.
    pub x: i32,
    /// Row of the top edge.
    pub y: i32,
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
}

impl Viewport {
    /// A viewport with its upper left corner at the canvas's origin.
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            x: 0,
            y: 0,
            width,
            height,
        }
    }

    /// Converts normalized device coordinates, from −1 to 1, to pixels: x from the left, y from the top.
    pub fn screen(&self, ndc: [f64; 2]) -> [f64; 2] {
        [
            f64::from(self.x) + (0.5 + ndc[0] / 2.) * f64::from(self.width),
            f64::from(self.y) + (0.5 - ndc[1] / 2.) * f64::from(self.height),
        ]
    }
}

/// A position in clip space and on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Position in clip space.
    pub clip: Vec4,
    /// The position in pixels, with y down. The position has no meaning if w ≤ 0.
    pub screen: [f64; 2],
    /// Homogeneous w: the distance in perspective, 1 for parallel rays.
    pub w: f64,
    /// The distance ahead of the eye.
    pub distance: f64,
}

/// All transforms between a mesh and the screen.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The transform from model space to eye space: camera · model.
    pub eye: Matrix,
    /// The transform from eye space to clip space.
    pub projection: Projection,
    /// The transform from clip space to the screen.
    pub viewport: Viewport,
}

impl View {
    /// The matrix from model space to clip space.
    pub fn matrix(&self) -> Matrix {
        multiply(&self.projection.matrix, &self.eye)
    }

    /// A position of the mesh in clip space. The position is transformed to eye space first.
    pub fn clip(&self, position: Vec3) -> Vec4 {
        apply(&self.projection.matrix, apply_point(&self.eye, position))
    }

    /// A point of clip space on the screen.
    pub fn on_screen(&self, clip: Vec4) -> Projected {
        let [x, y, _, w] = clip;
        Projected {
            clip,
            screen: self.viewport.screen([x / w, y / w]),
            w,
            distance: self.projection.distance(clip),
        }
    }

    /// A position of the mesh on the screen.
    pub fn project(&self, position: Vec3) -> Projected {
        self.on_screen(self.clip(position))
    }
}

/// Converts pixels to units of 1/256 pixel, rounded to nearest, halves toward +∞. The result saturates.
pub fn snap(screen: [f64; 2]) -> [i32; 2] {
    screen.map(|x| (x * 256. + 0.5).floor() as i32)
}

/// Converts units of 1/256 pixel to pixels, exactly.
pub fn unsnap([x, y]: [i32; 2]) -> [f64; 2] {
    [f64::from(x) / 256., f64::from(y) / 256.]
}
