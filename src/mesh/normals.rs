//! Computed normals, for meshes that have none, such as meshes made at run time.

use super::buffers::room;
use super::{Index, Mesh};
use crate::error::Error;
use crate::math::{Direction, Vec3};
use crate::num::rsqrt::unit;

/// Fraction bits of an angle in radians. The sum at one position saturates at 512 radians.
const FRACTION: u32 = 22;

/// A triangle's normal of length one, in units of 2⁻³⁰, and the angles at its corners; `None` for a triangle without
/// area.
fn measured(corners: [Vec3; 3]) -> Option<(Direction, [i32; 3])> {
    let [a, b, c] = corners;
    let sides = [a.way_to(b), b.way_to(c), c.way_to(a)];
    // Components of sides have up to 32 bits and a sign. All components are cut to 31 bits and a sign, so that a
    // difference of two products fits into 64 bits.
    let size = sides
        .as_flattened()
        .iter()
        .fold(0, |all, x| all | x.unsigned_abs());
    let down = u32::from(size >= 1 << 31);
    let [[x, y, z], [u, v, w], _] = sides.map(|side| side.map(|x| x >> down));
    let cross = |a: i64, b: i64, c: i64, d: i64| (a * b).saturating_sub(c * d);
    let normal = unit([cross(y, w, z, v), cross(z, u, x, w), cross(x, v, y, u)])?;
    let [ab, bc, ca] = [unit(sides[0])?, unit(sides[1])?, unit(sides[2])?];
    Some((
        Direction::from_bits(normal),
        [angle(ca, ab), angle(ab, bc), angle(bc, ca)],
    ))
}

/// The angle between −`a` and `b`, both of length one in units of 2⁻³⁰. The error is below 2⁻¹³ of the angle plus 2⁻²²
/// radians.
///
/// A chord of length s on the unit circle spans an angle of 2 asin(s/2). Up to 90 degrees, this angle is computed as s
/// · P(s²/4), with a polynomial P. Above 90 degrees, the chord to the opposite point gives the rest of the half turn.
/// P(q) approximates asin(√q)/√q: the polynomial is interpolated at the Chebyshev nodes of 0..1/2, with an error of at
/// most 2⁻¹⁶.
fn angle(a: [i32; 3], b: [i32; 3]) -> i32 {
    const P: [u32; 5] = [65_536, 10_893, 5_365, 640, 6_202];
    /// π.
    const HALF_TURN: i32 = 13_176_795;
    let [a, b] = [Vec3::from_bits(a), Vec3::from_bits(b)];
    let is_acute = Direction::from_bits(a.to_bits())
        .dot(Direction::from_bits(b.to_bits()))
        .to_bits()
        <= 0;
    // The shorter of the chords to a point and to the opposite point is at most √2.
    let chord = a
        .distance(if is_acute { -b } else { b })
        .to_bits()
        .cast_unsigned();
    let short = (chord >> 15).min(46_341);
    let q = (short * short) >> 16;
    let [p0, p1, p2, p3, p4] = P;
    // Horner's rule. Terms have 16 fraction bits and stay below 2; q is at most 1/2.
    let times_q = |term: u32| (q * term) >> 16;
    let p = p0 + times_q(p1 + times_q(p2 + times_q(p3 + times_q(p4))));
    let angle = ((u64::from(chord) * u64::from(p)) >> (46 - FRACTION)) as i32;
    if is_acute { angle } else { HALF_TURN - angle }
}

/// A normal, weighted by an angle.
fn weighted(normal: Direction, angle: i32) -> Vec3 {
    Vec3::from_bits(
        normal
            .to_bits()
            .map(|x| ((i64::from(x) * i64::from(angle) + (1 << 29)) >> 30) as i32),
    )
}

impl<'a> Mesh<'a> {
    /// Adds computed normals, one per position, so that light changes smoothly across all edges.
    ///
    /// A normal is the mean of the normals of the triangles around its position. Each triangle is weighted with its
    /// angle at the position, so it does not matter how polygons were cut into triangles. The normal has length one.
    /// Its direction is accurate to 2⁻¹² radians, if the triangles do not face away from one another and their angles
    /// at the position are at least 0.1 degrees. Angles are rounded down to multiples of 2⁻²² radians, so a triangle
    /// does not count if its angle at the position is below about 2⁻²² radians. If no triangle counts, or if the
    /// weighted normals add up to zero, the position gets the zero vector.
    ///
    /// The computation takes time in proportion to the number of triangles. For a mesh that changes its shape, call
    /// this function in each frame. For a file, the option `normals` of [`include_mesh!`](crate::include_mesh) computes
    /// normals on the host, and keeps sharp edges sharp.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let positions = [
    ///     vec3!(-1, 0, 1), vec3!(0, 1, 1), vec3!(1, 0, 1),
    ///     vec3!(-1, 0, -1), vec3!(0, 1, -1), vec3!(1, 0, -1),
    /// ];
    /// let roof = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]];
    /// let mut normals = [Vec3::ZERO; 6]; // your memory
    /// let mesh = Mesh::new(&positions, &roof)?.with_smooth_normals(&mut normals)?;
    /// assert!(mesh.has_normals());
    /// assert_eq!(normals[1], Vec3::Y); // along the ridge
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if `normals` has fewer elements than the mesh has positions.
    pub fn with_smooth_normals(self, normals: &'a mut [Vec3]) -> Result<Self, Error> {
        let normals = room("normals", normals, self.positions().len())?;
        normals.fill(Vec3::ZERO);
        for face in self.faces() {
            let Some((normal, angles)) = self.measured(*face) else {
                continue;
            };
            for (&index, angle) in face.iter().zip(angles) {
                if let Some(sum) = normals.get_mut(usize::from(index)) {
                    *sum += weighted(normal, angle);
                }
            }
        }
        for normal in &mut *normals {
            *normal = normal.normalized().unwrap_or_default();
        }
        self.with_normals(normals, None)
    }

    fn measured(&self, face: [Index; 3]) -> Option<(Direction, [i32; 3])> {
        measured(face.map(|index| self.position(index)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Scalar, fx, vec3};

    const CORNERS: [Vec3; 8] = [
        vec3!(-1, -1, -1),
        vec3!(1, -1, -1),
        vec3!(-1, 1, -1),
        vec3!(1, 1, -1),
        vec3!(-1, -1, 1),
        vec3!(1, -1, 1),
        vec3!(-1, 1, 1),
        vec3!(1, 1, 1),
    ];

    const SIDES: [[Index; 3]; 12] = [
        [0, 2, 3],
        [0, 3, 1],
        [4, 5, 7],
        [4, 7, 6],
        [0, 1, 5],
        [0, 5, 4],
        [2, 6, 7],
        [2, 7, 3],
        [0, 4, 6],
        [0, 6, 2],
        [1, 3, 7],
        [1, 7, 5],
    ];

    /// The normals point to the corners, no matter how the sides of the box are cut into triangles.
    #[test]
    fn smooth_normals_of_a_box_point_to_its_corners() {
        let mut normals = [Vec3::ZERO; 9];
        let mesh = Mesh::new(&CORNERS, &SIDES).unwrap();
        mesh.with_smooth_normals(&mut normals).unwrap();
        for (normal, corner) in normals.iter().zip(CORNERS) {
            // The errors of the weights are below 2⁻¹³, and cancel for the most part.
            assert!(normal.distance(corner.normalized().unwrap()).to_bits() <= 8);
        }
        assert_eq!(normals[8], Vec3::ZERO);
    }

    /// An angle of 1e-7 radians counts as zero, so there is no normal.
    #[test]
    fn normals_at_sharp_corners_are_accurate() {
        let positions = |(y, z): (i32, i32)| {
            let far = Vec3::from_ints(1000, 0, 0);
            [Vec3::ZERO, far, far + Vec3::from_bits([0, y, z])]
        };
        for micro_degrees in [100_000, 200_000, 1_000_000] {
            // The triangle's width at a distance of 1000 (2^16 · 1000 units).
            let width = f64::from(micro_degrees) / 1e6 * std::f64::consts::PI / 180. * 65_536e3;
            for turn in 0..64 {
                let (sin, cos) = (f64::from(turn) * 0.1).sin_cos();
                let (y, z) = ((cos * width).ceil() as i32, (sin * width).ceil() as i32);
                let mut normals = [Vec3::ZERO; 3];
                Mesh::new(&positions((y, z)), &[[0, 1, 2]])
                    .unwrap()
                    .with_smooth_normals(&mut normals)
                    .unwrap();
                let [_, j, k] = normals[0].to_bits().map(f64::from);
                let (y, z) = (f64::from(y), f64::from(z));
                // The normal is (0, −z, y).
                let sine = (j * y + k * z) / (j.hypot(k) * y.hypot(z));
                assert!(
                    sine.abs() < f64::from(-12).exp2(),
                    "{micro_degrees} {turn}: {sine}"
                );
            }
        }
        let needle = positions((4, 6));
        let mut normals = [Vec3::X; 3];
        let mesh = Mesh::new(&needle, &[[0, 1, 2]]).unwrap();
        mesh.with_smooth_normals(&mut normals).unwrap();
        assert_eq!(normals[0], Vec3::ZERO);
    }

    #[test]
    fn normals_without_room_are_refused() {
        let mesh = Mesh::new(&CORNERS, &SIDES).unwrap();
        let mut few = [Vec3::ZERO; 7];
        let error = mesh.with_smooth_normals(&mut few).unwrap_err();
        assert_eq!(
            error,
            Error::Count {
                of: "normals",
                given: 8,
                min: 0,
                max: 7
            }
        );
    }

    #[test]
    fn extremes_and_triangles_without_area_have_normals_or_none() {
        let (least, most) = (Scalar::MIN, Scalar::MAX);
        let positions = [
            Vec3::new(least, least, most),
            Vec3::new(most, least, least),
            Vec3::new(least, most, least),
            fx!(0) * Vec3::X,
        ];
        let faces = [[0, 1, 2], [3, 3, 0], [3, 3, 3]];
        let mesh = Mesh::new(&positions, &faces).unwrap();
        let mut normals = [Vec3::X; 4];
        mesh.with_smooth_normals(&mut normals).unwrap();
        assert_eq!(Some(normals[0]), vec3!(1, 1, 1).normalized());
        assert_eq!(normals[3], Vec3::ZERO);
    }
}
