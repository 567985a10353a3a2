//! The corners of sprites.

use super::linear::{Matrix, Vec3, cross, direction, length, normalized, point};

/// A sprite: a rectangle that turns toward the eye.
#[derive(Clone, Copy, Debug)]
pub struct Sprite {
    pub position: Vec3,
    /// Width and height, in units of the world or in pixels.
    pub size: [f64; 2],
    /// How long a unit is in eye space, along the horizontal and the vertical sides of an upright sprite.
    pub unit: [f64; 2],
    /// The angle by which the sprite is turned about its anchor, counter-clockwise in its plane, in radians.
    pub angle: f64,
    /// The place in the sprite that is at the position: a fraction of the width from the left, and a fraction of the
    /// height from the top.
    pub anchor: [f64; 2],
    /// The direction of the vertical sides in model space; `None` if they are vertical in the picture.
    pub axis: Option<Vec3>,
}

impl Sprite {
    /// The unit vectors along the horizontal and the vertical sides, in eye space.
    pub fn sides(&self, eye: &Matrix) -> [Vec3; 2] {
        match self.axis {
            None => [[1., 0., 0.], [0., 1., 0.]],
            Some(axis) => {
                let up = normalized(direction(eye, axis));
                let right = cross(up, [0., 0., 1.]);
                let right = if length(right) == 0. {
                    [1., 0., 0.]
                } else {
                    normalized(right)
                };
                [right, up]
            }
        }
    }

    /// The corners in eye space: bottom left, bottom right, top left, top right.
    pub fn corners(&self, eye: &Matrix) -> [Vec3; 4] {
        let (middle, [right, up]) = (point(eye, self.position), self.sides(eye));
        [[0., 1.], [1., 1.], [0., 0.], [1., 0.]].map(|[u, v]: [f64; 2]| {
            let x = (u - self.anchor[0]) * self.size[0];
            let y = (self.anchor[1] - v) * self.size[1];
            let (sin, cos) = self.angle.sin_cos();
            let along = [
                (x * cos - y * sin) * self.unit[0],
                (x * sin + y * cos) * self.unit[1],
            ];
            std::array::from_fn(|i| middle[i] + along[0] * right[i] + along[1] * up[i])
        })
    }
}
