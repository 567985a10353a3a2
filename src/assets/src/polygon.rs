//! Adds polygons to a model: replaces values that cannot be used, and cuts the polygons into triangles.

use std::fmt;

use earcut::{Earcut, deviation};

use crate::vector::{Vector, sub, unit};
use crate::{Corner, Model, Smoothing, Triangle, next};

/// The largest coordinate that is used. The square of this coordinate fits f64.
const MOST: f64 = 1e30;

/// Texture coordinates beyond this limit are moved near 0 by whole repeats, because the mesh's format ends at 2048.
const FAR: f64 = 1024.0;

/// All polygons of a model that are cut may take this many steps, which is a second: a polygon of 23,000 corners.
const STEPS: usize = 1 << 29;

impl Model {
    /// Adds a polygon as triangles, and its outline. A polygon with fewer than 3 corners, or with a position that is
    /// missing or not a number, is left out. Texture coordinates far from 0 are moved near 0. If a texture coordinate
    /// is missing or not a number, all texture coordinates of the polygon are left out. A normal without direction is
    /// replaced. Each repair is noted.
    ///
    /// # Errors
    ///
    /// The model has more elements than can be counted.
    pub(crate) fn polygon(
        &mut self,
        corners: &mut [Corner],
        material: Option<u32>,
        smoothing: Smoothing,
    ) -> Result<(), String> {
        if corners.len() < 3 {
            self.notes.add("a face of fewer than 3 corners is left out");
            return Ok(());
        }
        let problem = |corner: &Corner| match self.is_usable(corner.position) {
            Some(true) => None,
            Some(false) => Some("a coordinate of a corner is not a number from -1e30 to 1e30"),
            None => Some("it names a vertex that does not exist"),
        };
        if let Some(problem) = corners.iter().find_map(problem) {
            self.notes.add(format!("a face is left out: {problem}"));
            return Ok(());
        }
        self.check(self.triangles.len() + corners.len() - 2, "triangles")?;
        self.fix_uvs(corners)?;
        self.fix_normals(corners)?;
        let colors = self.colors.len();
        for corner in &mut *corners {
            corner.color = corner.color.filter(|&at| (at as usize) < colors);
        }
        let triangles = self.ears.triangles(&self.positions, corners);
        self.triangles
            .extend(triangles.iter().map(|triangle| Triangle {
                corners: triangle.map(|at| corners[at]),
                material,
                object: self.object,
                smoothing,
            }));
        for (at, corner) in corners.iter().enumerate() {
            self.edge(corner.position, corners[(at + 1) % corners.len()].position);
        }
        Ok(())
    }

    /// Whether a position can be drawn; `None` if it does not exist.
    pub(crate) fn is_usable(&self, position: u32) -> Option<bool> {
        let position = self.positions.get(position as usize)?;
        Some(position.iter().all(|x| x.abs() <= MOST))
    }

    /// Moves texture coordinates near 0. If the texture coordinates of a corner are missing, not numbers, or too large,
    /// the texture coordinates of all corners are removed.
    pub(crate) fn fix_uvs(&mut self, corners: &mut [Corner]) -> Result<(), String> {
        if corners.iter().all(|corner| corner.uv.is_none()) {
            return Ok(());
        }
        let uvs = corners.iter().map(|corner| {
            let uv = *self.uvs.get(corner.uv? as usize)?;
            uv.iter().all(|x| x.abs() <= MOST).then_some(uv)
        });
        let uvs: Option<Vec<[f64; 2]>> = uvs.collect();
        let low = |uvs: &[[f64; 2]], axis: usize| {
            let all = uvs.iter().map(|uv| uv[axis]);
            all.fold(f64::MAX, f64::min).floor()
        };
        let Some(uvs) = uvs else {
            self.notes
                .add("a face's texture coordinates are left out: not every corner has them");
            for corner in &mut *corners {
                corner.uv = None;
            }
            return Ok(());
        };
        if uvs.iter().flatten().all(|x| x.abs() <= FAR) {
            return Ok(());
        }
        self.notes
            .add("a face's texture coordinates beyond 1024 are brought near 0 by whole repeats");
        let low = [low(&uvs, 0), low(&uvs, 1)];
        for (corner, uv) in corners.iter_mut().zip(uvs) {
            corner.uv = Some(next(&self.uvs)?);
            self.uvs
                .push([0, 1].map(|axis| (uv[axis] - low[axis]).min(FAR)));
        }
        Ok(())
    }

    /// Replaces normals without direction by the normal of the polygon.
    fn fix_normals(&mut self, corners: &mut [Corner]) -> Result<(), String> {
        let mut own = None;
        for at in 0..corners.len() {
            let Some(index) = corners[at].normal else {
                continue;
            };
            let normal = self.normals.get(index as usize);
            if normal.is_some_and(|&normal| {
                normal.iter().all(|x| x.abs() <= MOST) && unit(normal).is_some()
            }) {
                continue;
            }
            self.notes
                .add("a normal is replaced by that of its face: it is missing or has no direction");
            let replaced = if let Some(own) = own {
                own
            } else {
                let new = next(&self.normals)?;
                let direction = unit(newell(&self.positions, corners));
                self.normals.push(direction.unwrap_or([0.0, 0.0, 1.0]));
                *own.insert(new)
            };
            corners[at].normal = Some(replaced);
        }
        Ok(())
    }
}

/// Newell's normal of a polygon. Positions are relative to the first corner, so that a polygon far from the origin
/// loses no digits.
fn newell(positions: &[Vector], corners: &[Corner]) -> Vector {
    let origin = positions[corners[0].position as usize];
    let relative = |corner: &Corner| sub(positions[corner.position as usize], origin);
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
    normal
}

/// Cuts polygons into triangles.
#[derive(Default)]
pub struct Ears {
    earcut: Option<Earcut<f64>>,
    points: Vec<[f64; 2]>,
    indices: Vec<u32>,
    triangles: Vec<[usize; 3]>,
    /// How many steps have been taken at most to cut polygons.
    steps: usize,
}

impl fmt::Debug for Ears {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Ears")
    }
}

impl Ears {
    /// Returns the triangles of a polygon, as indices of its `corners`. The triangles form a fan around the first
    /// corner. Exception: if a part of the fan would lie outside a concave polygon, the polygon is cut into triangles
    /// that lie within it, as in `include_mesh!`. A polygon with an outline that crosses itself keeps the fan.
    pub fn triangles(&mut self, positions: &[[f64; 3]], corners: &[Corner]) -> &[[usize; 3]] {
        self.triangles.clear();
        self.triangles
            .extend((2..corners.len()).map(|at| [0, at - 1, at]));
        if corners.len() > 3 && self.project(positions, corners) && !self.fan_is_right() {
            self.cut();
        }
        &self.triangles
    }

    /// Projects the corners along the axis nearest to the polygon's normal. The projected polygon is counter-clockwise.
    /// Returns `false` for a polygon without area.
    fn project(&mut self, positions: &[[f64; 3]], corners: &[Corner]) -> bool {
        let origin = positions[corners[0].position as usize];
        let normal = newell(positions, corners);
        let axis = (0..3)
            .max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))
            .unwrap_or(2);
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        self.points.clear();
        self.points.extend(corners.iter().map(|corner| {
            let p = sub(positions[corner.position as usize], origin);
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

    /// Whether all triangles of the fan turn in the same direction as the polygon. If they do, the triangles' areas add
    /// up to the polygon's area, so no two triangles overlap.
    fn fan_is_right(&self) -> bool {
        self.triangles
            .iter()
            .all(|&triangle| self.area(triangle) >= 0.0)
    }

    /// Replaces the fan by triangles within the polygon, if such triangles cover the whole polygon, and are found in
    /// fewer than [`STEPS`] steps. In the worst case, each corner is compared with each other.
    fn cut(&mut self) {
        self.steps += self.points.len() * self.points.len();
        if self.steps > STEPS {
            return;
        }
        let earcut = self.earcut.get_or_insert_with(Earcut::new);
        earcut.earcut(self.points.iter().copied(), &[], &mut self.indices);
        // The deviation is the difference between the triangles' total area and the polygon's area, relative to the
        // polygon's. Rounding keeps it far below 1e-6; an outline that crosses itself makes it far greater.
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
