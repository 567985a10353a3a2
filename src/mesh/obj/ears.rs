//! Triangles for concave polygons.

use super::reader::Reader;
use crate::Vec3;
use crate::mesh::Index;
use crate::mesh::flash::Room;

/// Cuts again each polygon whose fan of triangles leaves the polygon; `room` holds the fans of all polygons in `text`.
///
/// A fan is right if all its triangles turn in the same direction as the polygon: their signed areas add up to the
/// polygon's, so no two of them overlap. Otherwise ears are cut off: corners whose triangle contains no other corner.
/// This works for every polygon whose outline does not cross itself; other polygons keep their fan.
///
/// The direction of a turn is computed exactly, in the polygon's projection along the axis nearest to its normal.
pub(super) const fn cut<const N: usize>(text: &[u8], room: &mut Room<N>) {
    let mut ears = Ears {
        corners: [[0; 3]; N],
        points: [[0; 2]; N],
        ring: [0; N],
        triangles: [[0; 3]; N],
    };
    let mut reader = Reader::new(text, [0; 3]);
    let mut at = 0;
    while reader.begins() {
        if !reader.keyword(b"f") {
            reader.skip(false);
            continue;
        }
        let triangles = reader.count_words() - 2;
        if triangles > 1 {
            ears.polygon(room, at, triangles);
        }
        at += triangles;
    }
}

/// A polygon's Newell normal: the sum of the cross products of its successive corners, twice its area in length.
///
/// Each component is computed as Σ (aᵢ − aᵢ₊₁)(bᵢ + bᵢ₊₁) for the other two axes.
const fn normal<const N: usize>(
    positions: &[Vec3; N],
    corners: &[[Index; 3]; N],
    count: usize,
) -> [i128; 3] {
    let mut normal = [0; 3];
    let mut before = count - 1;
    let mut at = 0;
    while at < count {
        let p = positions[corners[before][0] as usize].to_bits();
        let q = positions[corners[at][0] as usize].to_bits();
        let mut axis = 0;
        while axis < 3 {
            let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
            normal[axis] += (p[a] as i128 - q[a] as i128) * (p[b] as i128 + q[b] as i128);
            axis += 1;
        }
        before = at;
        at += 1;
    }
    normal
}

/// A polygon and its triangles.
struct Ears<const N: usize> {
    /// Indices of each corner's position, texture coordinate and normal.
    corners: [[Index; 3]; N],
    /// The corners in two dimensions, in which the polygon is counter-clockwise.
    points: [[i64; 2]; N],
    /// The corners that have not been cut off.
    ring: [usize; N],
    /// The triangles, as corners.
    triangles: [[usize; 3]; N],
}

impl<const N: usize> Ears<N> {
    /// Cuts the polygon whose fan of `triangles` triangles starts at face `at`, if the fan is wrong.
    const fn polygon(&mut self, room: &mut Room<N>, at: usize, triangles: usize) {
        let mut corner = 0;
        while corner < triangles + 2 {
            // The first two corners are those of the first triangle, each other is the last of its own.
            let (face, place) = match corner {
                0 | 1 => (at, corner),
                _ => (at + corner - 2, 2),
            };
            self.corners[corner] = [
                room.faces[face][place],
                room.uv_faces[face][place],
                room.normal_faces[face][place],
            ];
            corner += 1;
        }
        if !self.project(&room.positions, triangles + 2)
            || self.fan(triangles)
            || !self.cut(triangles)
        {
            return;
        }
        let mut triangle = 0;
        while triangle < triangles {
            let [a, b, c] = self.triangles[triangle];
            let [a, b, c] = [self.corners[a], self.corners[b], self.corners[c]];
            room.faces[at + triangle] = [a[0], b[0], c[0]];
            room.uv_faces[at + triangle] = [a[1], b[1], c[1]];
            room.normal_faces[at + triangle] = [a[2], b[2], c[2]];
            triangle += 1;
        }
    }

    /// Projects the corners along an axis; `false` for a polygon without area.
    const fn project(&mut self, positions: &[Vec3; N], count: usize) -> bool {
        let normal = normal(positions, &self.corners, count);
        let mut axis = 0;
        if normal[1].unsigned_abs() > normal[axis].unsigned_abs() {
            axis = 1;
        }
        if normal[2].unsigned_abs() > normal[axis].unsigned_abs() {
            axis = 2;
        }
        let mut corner = 0;
        while corner < count {
            let point = positions[self.corners[corner][0] as usize].to_bits();
            let (a, b) = (point[(axis + 1) % 3] as i64, point[(axis + 2) % 3] as i64);
            self.points[corner] = if normal[axis] > 0 { [a, b] } else { [b, a] };
            corner += 1;
        }
        normal[axis] != 0
    }

    /// Twice the area of a triangle of corners; positive if it is counter-clockwise.
    const fn area(&self, [a, b, c]: [usize; 3]) -> i128 {
        let ([ax, ay], [bx, by], [cx, cy]) = (self.points[a], self.points[b], self.points[c]);
        (bx - ax) as i128 * (cy - ay) as i128 - (by - ay) as i128 * (cx - ax) as i128
    }

    /// Whether the fan around the first corner is right.
    const fn fan(&self, triangles: usize) -> bool {
        let mut corner = 1;
        while corner <= triangles {
            if self.area([0, corner, corner + 1]) < 0 {
                return false;
            }
            corner += 1;
        }
        true
    }

    /// Cuts off ears until a triangle is left; `false` if no ear is found before.
    const fn cut(&mut self, triangles: usize) -> bool {
        let mut left = triangles + 2;
        let mut corner = 0;
        while corner < left {
            self.ring[corner] = corner;
            corner += 1;
        }
        let mut done = 0;
        let (mut at, mut tried) = (0, 0);
        while left > 3 {
            let ear = [
                self.ring[(at + left - 1) % left],
                self.ring[at],
                self.ring[(at + 1) % left],
            ];
            // Corners on a straight side are cut off only when there is no other ear.
            let is_ear = match self.area(ear) {
                0 => tried >= left,
                1.. => !self.holds_corner(ear, left),
                _ => false,
            };
            if is_ear {
                self.triangles[done] = ear;
                done += 1;
                left -= 1;
                let mut corner = at;
                while corner < left {
                    self.ring[corner] = self.ring[corner + 1];
                    corner += 1;
                }
                tried = 0;
            } else if tried == 2 * left {
                return false;
            } else {
                tried += 1;
            }
            // After an ear, this skips a corner, so that not all triangles meet in one.
            at = (at + 1) % left;
        }
        let last = [self.ring[0], self.ring[1], self.ring[2]];
        self.triangles[done] = last;
        self.area(last) >= 0
    }

    /// Whether another corner that is left lies within or on a triangle. A corner at the same point as one of the
    /// triangle's does not count: an outline may touch itself, as one around a hole does.
    const fn holds_corner(&self, [a, b, c]: [usize; 3], left: usize) -> bool {
        const fn same([ax, ay]: [i64; 2], [bx, by]: [i64; 2]) -> bool {
            ax == bx && ay == by
        }
        let mut at = 0;
        while at < left {
            let p = self.ring[at];
            let point = self.points[p];
            let is_corner = same(point, self.points[a])
                || same(point, self.points[b])
                || same(point, self.points[c]);
            if !is_corner
                && self.area([a, b, p]) >= 0
                && self.area([b, c, p]) >= 0
                && self.area([c, a, p]) >= 0
            {
                return true;
            }
            at += 1;
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::obj::import;
    use crate::random::{cases, list};
    use rand::Rng;
    use std::fmt::Write;
    use std::string::String;
    use std::vec::Vec;

    const ROOM: usize = 512;

    /// OBJ text of one polygon, whose points may be seen along any axis, from either side.
    fn text(points: &[[i32; 2]], axis: usize, mirrored: bool) -> String {
        let mut text = String::new();
        for &[x, y] in points {
            let [x, y] = if mirrored { [-x, y] } else { [x, y] };
            let mut p = [f64::from(x), f64::from(y), f64::from(x - y) / 4.];
            p.rotate_right(axis);
            let _ = writeln!(text, "v {} {} {}", p[0], p[1], p[2]);
        }
        text += "f";
        for corner in 1..=points.len() {
            let _ = write!(text, " {corner}");
        }
        text
    }

    fn twice_area([a, b, c]: [[i32; 2]; 3]) -> i32 {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    /// The triangles of a polygon.
    fn faces(points: &[[i32; 2]], axis: usize, mirrored: bool) -> Vec<[Index; 3]> {
        let text = text(points, axis, mirrored);
        assert!(import::room(text.as_bytes()) <= ROOM);
        let (room, counts) = import::read::<ROOM>(text.as_bytes(), "polygon");
        room.faces[..counts.faces].to_vec()
    }

    /// Whether all triangles turn the same way and add up to the polygon: then they cover it, each point once.
    fn are_right(points: &[[i32; 2]], faces: &[[Index; 3]]) -> bool {
        let areas = faces
            .iter()
            .map(|face| twice_area(face.map(|i| points[usize::from(i)])));
        let fan = (2..points.len()).map(|i| twice_area([points[0], points[i - 1], points[i]]));
        let total: i32 = fan.sum();
        let sign = total.signum();
        faces.len() == points.len() - 2
            && areas.clone().all(|area| area * sign >= 0)
            && areas.sum::<i32>() == total
    }

    #[test]
    fn concave_polygons_are_covered() {
        // An L, an arrow, a comb, a spiral, and a square with a hole whose outline touches itself.
        let polygons: [&[[i32; 2]]; 6] = [
            &[[0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]],
            &[[0, 0], [2, 1], [4, 0], [2, 4]],
            &[
                [0, 0],
                [9, 0],
                [9, 9],
                [8, 1],
                [6, 9],
                [5, 1],
                [3, 9],
                [2, 1],
                [0, 9],
            ],
            &[
                [0, 0],
                [6, 0],
                [6, 6],
                [1, 6],
                [1, 2],
                [4, 2],
                [4, 4],
                [3, 4],
                [3, 3],
                [2, 3],
                [2, 5],
                [5, 5],
                [5, 1],
                [0, 1],
            ],
            &[
                [0, 0],
                [6, 0],
                [6, 6],
                [0, 6],
                [0, 0],
                [2, 2],
                [2, 4],
                [4, 4],
                [4, 2],
                [2, 2],
            ],
            // Corners on straight sides.
            &[
                [0, 0],
                [1, 0],
                [2, 0],
                [4, 0],
                [4, 4],
                [3, 2],
                [2, 2],
                [1, 2],
                [0, 4],
                [0, 2],
            ],
        ];
        for points in polygons {
            for start in 0..points.len() {
                let mut points = points.to_vec();
                points.rotate_left(start);
                for axis in 0..3 {
                    for mirrored in [false, true] {
                        let faces = faces(&points, axis, mirrored);
                        assert!(are_right(&points, &faces), "{points:?} {faces:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn convex_and_crossed_polygons_keep_their_fan() {
        let fan = |count: u16| (2..count).map(|i| [0, i - 1, i]).collect::<Vec<_>>();
        let hexagon = [[2, 0], [4, 0], [5, 2], [4, 4], [2, 4], [1, 2]];
        assert_eq!(faces(&hexagon, 0, false), fan(6));
        // A side with corners on it, and an arrow seen from its notch.
        assert_eq!(
            faces(&[[0, 0], [1, 0], [2, 0], [2, 2], [0, 2]], 1, true),
            fan(5)
        );
        assert_eq!(faces(&[[2, 1], [4, 0], [2, 4], [0, 0]], 2, false), fan(4));
        // A bow tie, a line and a point.
        assert_eq!(faces(&[[0, 0], [3, 0], [0, 2], [3, 3]], 0, false), fan(4));
        assert_eq!(faces(&[[0, 0], [2, 2], [1, 1], [3, 3]], 0, false), fan(4));
        assert_eq!(faces(&[[1, 1]; 5], 0, false), fan(5));
    }

    #[test]
    fn attributes_follow_their_corners() {
        let text = b"v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nvt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\nvn 0 0 1\nvn 0 0 2\n\
            f 3 4 1\nf 1/4//1 2/3 3/2/1 4/1/2";
        let text = String::from_utf8_lossy(text).replace("1/4//1", "1/4/1");
        let (room, counts) = import::read::<ROOM>(text.as_bytes(), "polygon");
        let none = crate::Mesh::NO_VALUE;
        assert_eq!(counts.faces, 3);
        assert_eq!(room.faces[..3], [[2, 3, 0], [3, 0, 1], [1, 2, 3]]);
        assert_eq!(room.uv_faces[1..3], [[0, 3, 2], [2, 1, 0]]);
        assert_eq!(room.normal_faces[1..3], [[1, 0, none], [none, 0, 1]]);
    }

    /// Around a middle that all corners see, polygons are concave and do not cross themselves.
    #[test]
    fn stars_are_covered() {
        cases(256, |random| {
            let distances = list(random, 3..12, |random| random.random_range(20..400_u32));
            let start = random.random_range(0..12_usize);
            let axis = random.random_range(0..3_usize);
            let mirrored = random.random::<bool>();
            let count = distances.len();
            let mut points = Vec::new();
            for (i, &distance) in distances.iter().enumerate() {
                #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
                let point = {
                    let angle = i as f64 / count as f64 * std::f64::consts::TAU;
                    [angle.cos(), angle.sin()].map(|x| (x * f64::from(distance)).round() as i32)
                };
                points.push(point);
            }
            points.rotate_left(start % count);
            let faces = faces(&points, axis, mirrored);
            assert!(are_right(&points, &faces), "{points:?} {faces:?}");
        });
    }
}
