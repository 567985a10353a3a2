//! Adds the normals and texture coordinates that a model lacks.

use std::collections::HashMap;

use super::load::{Corner, Model};

impl Model {
    /// The normal of a triangle; its length is twice the triangle's area.
    fn area_normal(&self, triangle: &[Corner; 3]) -> [f64; 3] {
        let [a, b, c] = triangle.map(|corner| self.positions[corner.position]);
        let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ]
    }

    /// Computes normals for the corners that have none: the mean of the faces around the point, weighted by area.
    /// Only faces within 60 degrees count, so that the edges of a box stay sharp.
    pub fn make_normals(&mut self) {
        const CREASE: f64 = 0.5; // cosine of 60 degrees
        let faces: Vec<[f64; 3]> = self
            .triangles
            .iter()
            .map(|triangle| self.area_normal(triangle))
            .collect();
        // Points are compared by position, not by index: models often repeat a point along a seam of their texture.
        let place = |position: [f64; 3]| position.map(f64::to_bits);
        let mut around: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
        for (at, triangle) in self.triangles.iter().enumerate() {
            for corner in triangle {
                around
                    .entry(place(self.positions[corner.position]))
                    .or_default()
                    .push(at);
            }
        }
        let mut made: HashMap<[u64; 3], usize> = HashMap::new();
        for (at, face) in faces.iter().enumerate() {
            for which in 0..3 {
                let corner = self.triangles[at][which];
                if corner.normal.is_some() {
                    continue;
                }
                let length = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
                let mut sum = [0.0; 3];
                for &other in &around[&place(self.positions[corner.position])] {
                    let normal = &faces[other];
                    let dot: f64 = (0..3).map(|i| normal[i] * face[i]).sum();
                    if dot >= CREASE * length(normal) * length(face) {
                        sum = [0, 1, 2].map(|i| sum[i] + normal[i]);
                    }
                }
                let size = length(&sum);
                let normal = if size > 0.0 {
                    sum.map(|x| x / size)
                } else {
                    [0.0, 0.0, 1.0]
                };
                let index = *made.entry(normal.map(f64::to_bits)).or_insert_with(|| {
                    self.normals.push(normal);
                    self.normals.len() - 1
                });
                self.triangles[at][which].normal = Some(index);
            }
        }
    }

    /// Computes texture coordinates for the triangles that have none: the model is put in a box, and each triangle
    /// takes the coordinates on the side of the box that it faces most.
    pub fn make_uvs(&mut self) {
        let low = |axis: usize| {
            self.positions
                .iter()
                .map(|p| p[axis])
                .fold(f64::MAX, f64::min)
        };
        let high = |axis: usize| {
            self.positions
                .iter()
                .map(|p| p[axis])
                .fold(f64::MIN, f64::max)
        };
        let lows = [low(0), low(1), low(2)];
        let highs = [high(0), high(1), high(2)];
        let size = (0..3)
            .map(|axis| highs[axis] - lows[axis])
            .fold(0.0, f64::max);
        let scale = if size > 0.0 { 1.0 / size } else { 1.0 };
        let mut made: HashMap<(usize, usize, bool), usize> = HashMap::new();
        for at in 0..self.triangles.len() {
            if self.triangles[at][0].uv.is_some() {
                continue;
            }
            let normal = self.area_normal(&self.triangles[at]);
            let side = (0..3)
                .max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))
                .unwrap_or(2);
            let back = normal[side] < 0.0;
            for which in 0..3 {
                let index = self.triangles[at][which].position;
                let p = self.positions[index];
                let from_low = |axis: usize| (p[axis] - lows[axis]) * scale;
                let from_high = |axis: usize| (highs[axis] - p[axis]) * scale;
                let uv = match (side, back) {
                    (0, false) => [from_high(2), from_high(1)],
                    (0, true) => [from_low(2), from_high(1)],
                    (1, false) => [from_low(0), from_low(2)],
                    (1, true) => [from_low(0), from_high(2)],
                    (_, false) => [from_low(0), from_high(1)],
                    (_, true) => [from_high(0), from_high(1)],
                };
                let uv = *made.entry((index, side, back)).or_insert_with(|| {
                    self.uvs.push(uv);
                    self.uvs.len() - 1
                });
                self.triangles[at][which].uv = Some(uv);
            }
        }
    }
}
