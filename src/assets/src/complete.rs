//! Adds the normals and texture coordinates that a model lacks.

use std::collections::HashMap;

use super::{Corner, Model, Smoothing, Triangle};
use crate::vector::{Vector, add, cross, dot, largest, length, sub};

/// Cosine of the largest angle, 60 degrees, between faces that are shaded as one surface.
const CREASE: f64 = 0.5;

/// Around a point with more faces than this, faces of similar direction are merged before all pairs are compared.
const FEW: usize = 64;

/// A normal's direction, rounded to steps of 1/8. Normals within about 7 degrees of each other have the same direction.
fn direction(normal: Vector) -> [i8; 3] {
    let length = length(normal);
    normal.map(|x| {
        #[allow(clippy::cast_possible_truncation)] // −8 to 8; 0 if there is no direction
        let step = (x / length * 8.0).round() as i8;
        step
    })
}

/// `faces` are the normals of the faces around a point. For each face, returns the sum of the normals of all faces that
/// are at most 60 degrees from it.
///
/// All pairs of faces are compared. If there are more than [`FEW`] faces, faces of similar direction are first merged
/// into groups, and pairs of groups are compared. There are at most a few hundred directions, so the time is linear in
/// the number of faces.
fn smooth(faces: &[Vector]) -> Vec<Vector> {
    let mut groups: Vec<Vector> = Vec::new();
    let mut places: HashMap<[i8; 3], usize> = HashMap::new();
    let group_of: Vec<usize> = faces
        .iter()
        .map(|face| {
            let new = groups.len();
            let group = if faces.len() <= FEW {
                new
            } else {
                *places.entry(direction(*face)).or_insert(new)
            };
            if group == new {
                groups.push([0.0; 3]);
            }
            groups[group] = add(groups[group], *face);
            group
        })
        .collect();
    let is_near = |a: Vector, b: Vector| dot(a, b) >= CREASE * length(a) * length(b);
    let sum = |group: &Vector| {
        let near = groups.iter().filter(|other| is_near(**other, *group));
        near.fold([0.0; 3], |sum, &other| add(sum, other))
    };
    let sums: Vec<Vector> = groups.iter().map(sum).collect();
    group_of.into_iter().map(|group| sums[group]).collect()
}

impl Model {
    /// Adds normals and texture coordinates where they are missing.
    pub fn complete(&mut self) {
        let has_uvs =
            |triangle: &Triangle| triangle.corners.iter().all(|corner| corner.uv.is_some());
        self.had_uvs = self.triangles.iter().all(has_uvs);
        self.make_normals();
        self.make_uvs();
    }

    /// A vector along the normal of a triangle, with twice the triangle's area as its length.
    fn area_normal(&self, triangle: &Triangle) -> [f64; 3] {
        let [a, b, c] = triangle
            .corners
            .map(|corner| self.positions[corner.position as usize]);
        cross(sub(b, a), sub(c, a))
    }

    /// Computes normals for the corners that have none: the mean of the normals of the faces around the point, weighted
    /// by area. For a face without a smoothing group, only the faces at most 60 degrees from it count, so that the
    /// edges of a box stay sharp.
    pub fn make_normals(&mut self) {
        let lacks = |corner: &Corner| corner.normal.is_none();
        if !self
            .triangles
            .iter()
            .any(|triangle| triangle.corners.iter().any(lacks))
        {
            return;
        }
        // Points are compared by position, not by index: models often repeat a point along a seam of their texture.
        let mut places: HashMap<[u64; 3], usize> = HashMap::new();
        let place_of: Vec<usize> = self
            .positions
            .iter()
            .map(|position| {
                let new = places.len();
                *places
                    .entry(position.map(|x| (x + 0.0).to_bits()))
                    .or_insert(new)
            })
            .collect();
        // The corners at each position. A corner's number is three times the index of its triangle, plus 0, 1 or 2 for
        // its place in the triangle.
        let mut around: Vec<Vec<usize>> = vec![Vec::new(); places.len()];
        for (at, triangle) in self.triangles.iter().enumerate() {
            for (which, corner) in triangle.corners.iter().enumerate() {
                around[place_of[corner.position as usize]].push(3 * at + which);
            }
        }
        let mut made: HashMap<[u64; 3], u32> = HashMap::new();
        for corners in around {
            let is_lacking = |&at: &usize| lacks(&self.triangles[at / 3].corners[at % 3]);
            if !corners.iter().any(is_lacking) {
                continue;
            }
            let faces: Vec<[f64; 3]> = corners
                .iter()
                .map(|at| self.area_normal(&self.triangles[at / 3]))
                .collect();
            let mut sums = smooth(&faces);
            let smoothing = |place: usize| self.triangles[corners[place] / 3].smoothing;
            let mut groups = HashMap::new();
            for (place, &face) in faces.iter().enumerate() {
                if let Smoothing::Group(group) = smoothing(place) {
                    let sum = groups.entry(group).or_insert([0.0; 3]);
                    *sum = add(*sum, face);
                }
            }
            for (place, sum) in sums.iter_mut().enumerate() {
                *sum = match smoothing(place) {
                    Smoothing::Angle => continue,
                    Smoothing::Flat => faces[place],
                    Smoothing::Group(group) => groups[&group],
                };
            }
            for (at, sum) in corners.into_iter().zip(sums) {
                let corner = &mut self.triangles[at / 3].corners[at % 3];
                if corner.normal.is_some() {
                    continue;
                }
                let size = length(sum);
                let normal = if size > 0.0 {
                    sum.map(|x| x / size)
                } else {
                    [0.0, 0.0, 1.0]
                };
                corner.normal = Some(*made.entry(normal.map(f64::to_bits)).or_insert_with(|| {
                    self.normals.push(normal);
                    last(&self.normals)
                }));
            }
        }
    }

    /// Computes texture coordinates for the triangles that have none. Each triangle is projected to the side of the
    /// model's bounding box that it faces most.
    pub fn make_uvs(&mut self) {
        // Positions that no face uses do not count, because they can be far away, or not numbers.
        let [lows, highs] = self.bounds();
        let scale = 1.0 / largest(sub(highs, lows));
        let mut made: HashMap<(u32, usize, bool), u32> = HashMap::new();
        for at in 0..self.triangles.len() {
            if self.triangles[at].corners[0].uv.is_some() {
                continue;
            }
            let normal = self.area_normal(&self.triangles[at]);
            let side = (0..3)
                .max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))
                .unwrap_or(2);
            let back = normal[side] < 0.0;
            for which in 0..3 {
                let index = self.triangles[at].corners[which].position;
                let p = self.positions[index as usize];
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
                    last(&self.uvs)
                });
                self.triangles[at].corners[which].uv = Some(uv);
            }
        }
    }
}

/// The index of the last element of a list. The list has at most three elements for each triangle of a file in memory.
#[allow(clippy::cast_possible_truncation)]
fn last<T>(list: &[T]) -> u32 {
    list.len().saturating_sub(1) as u32
}
