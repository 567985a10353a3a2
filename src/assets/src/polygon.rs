//! Triangulates polygons.

use earcut::{Earcut, deviation};

use super::Corner;
use crate::vector::sub;

/// Cuts polygons into triangles.
#[derive(Default)]
pub struct Ears {
    earcut: Option<Earcut<f64>>,
    points: Vec<[f64; 2]>,
    indices: Vec<u32>,
    triangles: Vec<[usize; 3]>,
}

impl Ears {
    /// Returns the triangles of a polygon, as indices of its `corners`. They form the fan around its first corner or,
    /// if the fan leaves a concave polygon, lie within the polygon, as in `include_mesh!`. Outlines that cross
    /// themselves keep the fan.
    pub fn triangles(&mut self, positions: &[[f64; 3]], corners: &[Corner]) -> &[[usize; 3]] {
        self.triangles.clear();
        self.triangles
            .extend((2..corners.len()).map(|at| [0, at - 1, at]));
        if corners.len() > 3 && self.project(positions, corners) && !self.fan_is_right() {
            self.cut();
        }
        &self.triangles
    }

    /// Projects the corners along the axis nearest to the polygon's normal, so that the polygon is counter-clockwise;
    /// `false` for a polygon without area.
    fn project(&mut self, positions: &[[f64; 3]], corners: &[Corner]) -> bool {
        let point = |corner: &Corner| positions[corner.position as usize];
        // Newell's normal, relative to the first corner, so that a polygon far from the origin loses no digits.
        let origin = point(&corners[0]);
        let relative = |corner: &Corner| sub(point(corner), origin);
        let mut normal = [0.0; 3];
        for (at, corner) in corners.iter().enumerate() {
            let (p, q) = (
                relative(corner),
                relative(&corners[(at + 1) % corners.len()]),
            );
            for (axis, sum) in normal.iter_mut().enumerate() {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                *sum += (p[a] - q[a]) * (p[b] + q[b]);
            }
        }
        let axis = (0..3)
            .max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))
            .unwrap_or(2);
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        self.points.clear();
        self.points.extend(corners.iter().map(|corner| {
            let p = relative(corner);
            if normal[axis] > 0.0 {
                [p[a], p[b]]
            } else {
                [p[b], p[a]]
            }
        }));
        normal[axis] != 0.0
    }

    /// Twice the area of a triangle; positive if it is counter-clockwise.
    fn area(&self, triangle: [usize; 3]) -> f64 {
        let [a, b, c] = triangle.map(|at| self.points[at]);
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    /// Whether all triangles of the fan turn in the same direction as the polygon. Then their areas add up to the
    /// polygon's, so no two of them overlap.
    fn fan_is_right(&self) -> bool {
        self.triangles
            .iter()
            .all(|&triangle| self.area(triangle) >= 0.0)
    }

    /// Replaces the fan by triangles within the polygon, if they cover it.
    fn cut(&mut self) {
        let earcut = self.earcut.get_or_insert_with(Earcut::new);
        earcut.earcut(self.points.iter().copied(), &[], &mut self.indices);
        // Rounding causes a far smaller deviation; an outline that crosses itself causes a far larger one.
        if deviation(self.points.iter().copied(), &[], &self.indices) > 1e-6 {
            return;
        }
        let cut: Vec<[usize; 3]> = self
            .indices
            .chunks_exact(3)
            .map(|triangle| {
                let [a, b, c] = [0, 1, 2].map(|at| triangle[at] as usize);
                if self.area([a, b, c]) < 0.0 {
                    [a, c, b]
                } else {
                    [a, b, c]
                }
            })
            .collect();
        self.triangles = cut;
    }
}
