//! Poses of a mesh, and the meshes between two poses.

use super::attribute::{Attribute, Values};
use super::buffers::room;
use super::{Index, Mesh, Positions};
use crate::error::{Error, check_length, ok};
use crate::math::Vec3;
use crate::message;
use crate::num::Scalar;
use crate::num::wide::product;

/// Two poses of one mesh that can be blended: their positions, and their normals if both poses have normals.
///
/// Each pose is a mesh, and both meshes need the same faces. Texture coordinates, colors and edges come from the first
/// mesh. If keyframes are a `static`, the compiler checks them. Flash then holds the whole first mesh, but only the
/// positions and normals of the second mesh.
///
/// An animation of many poses is an array of `Keyframes`, with one element for each step from a pose to the next: at a
/// time of 3.25 steps, call `STEPS[3].blend(fx!(0.25), …)`.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::mesh::Keyframes;
/// use fixel::prelude::*;
/// use fixel::Window;
/// static FACES: [[u16; 3]; 1] = [[0, 1, 2]];
/// static DOWN: [Vec3; 3] = [vec3!(-4, -2, 0), vec3!(4, -2, 0), vec3!(0, 0, 0)];
/// static UP: [Vec3; 3] = [vec3!(-4, -2, 0), vec3!(4, -2, 0), vec3!(0, 4, 0)];
/// const LOW: Mesh = Mesh::checked(Mesh::new(&DOWN, &FACES));
/// const HIGH: Mesh = Mesh::checked(Mesh::new(&UP, &FACES));
/// static JUMP: Keyframes = Keyframes::checked(Keyframes::new(&LOW, &HIGH));
///
/// let projection = Projection::orthographic(Window::centered(fx!(8), fx!(4)), fx!(-1), fx!(1))?;
/// let mut positions = [Vec3::ZERO; 3]; // your memory, used again for every frame
/// let mesh = JUMP.blend(fx!(0.5), &mut positions, &mut [])?;
/// let mut pixels = [BinaryColor::Off; 32];
/// let mut canvas = Canvas::new(&mut pixels, 8, 4)?;
/// canvas.draw(&mesh, &projection, &Flat::new(BinaryColor::On));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "...#....",
///     "..###...",
///     ".#####..",
///     "#######.",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Keyframes<'a> {
    first: Mesh<'a>,
    /// The positions of the second mesh.
    positions: Positions<'a>,
    /// The normals of the second mesh; empty if either mesh has no normals.
    normals: Values<'a, Vec3>,
}

/// Checks that two lists of faces are equal.
const fn same(first: &[[Index; 3]], second: &[[Index; 3]]) -> Result<(), Error> {
    ok!(check_length("faces", second.len(), first.len()));
    let mut at = 0;
    while at < first.len() {
        let ([a, b, c], [x, y, z]) = (first[at], second[at]);
        if a != x || b != y || c != z {
            return Err(Error::FacesDiffer { at });
        }
        at += 1;
    }
    Ok(())
}

/// A mesh's triangles as indices of normals. Without faces of their own, normals are indexed like the positions.
const fn normal_faces<'a>(mesh: &Mesh<'a>) -> &'a [[Index; 3]] {
    match mesh.normals.faces {
        Some(faces) => faces,
        None => mesh.faces(),
    }
}

/// The result of [`Vec3::lerp`]. For `t` from 0 to 1, the computation is shorter, because nothing saturates.
#[inline]
fn between(from: Vec3, to: Vec3, t: Scalar) -> Vec3 {
    let rest = (1 << 16) - i64::from(t.to_bits());
    let (Ok(rest @ 0..=0x1_0000), t_bits) = (i32::try_from(rest), t.to_bits()) else {
        return from.lerp(to, t);
    };
    let ([x, y, z], [u, v, w]) = (from.to_bits(), to.to_bits());
    // The two weights add up to 2^16, so the result lies between `a` and `b` and fits into 32 bits.
    let mix = |a: i32, b: i32| ((product(a, rest) + product(b, t_bits) + (1 << 15)) >> 16) as i32;
    Vec3::from_bits([mix(x, u), mix(y, v), mix(z, w)])
}

impl<'a> Keyframes<'a> {
    /// Makes a pair of poses.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if the meshes differ in how many positions, faces or normals they have. [`Error::FacesDiffer`]
    /// if a face has different position indices in the two meshes, or different normal indices although both meshes
    /// have normals. If the normals of two files do not match, drop them with [`Mesh::without_normals`].
    pub const fn new(first: &Mesh<'a>, second: &Mesh<'a>) -> Result<Self, Error> {
        let positions = second.positions();
        ok!(check_length(
            "positions",
            positions.len(),
            first.positions().len()
        ));
        ok!(same(first.faces(), second.faces()));
        let mut frames = Self {
            first: *first,
            positions,
            normals: Values::Full(&[]),
        };
        if first.has_normals() && second.has_normals() {
            frames.normals = second.normals.values;
            ok!(check_length(
                "normals",
                frames.normals.len(),
                first.normals.values.len()
            ));
            ok!(same(normal_faces(first), normal_faces(second)));
        }
        Ok(frames)
    }

    /// Unwraps keyframes in a `const` or `static`, where an error stops compilation.
    ///
    /// # Panics
    ///
    /// If `result` is an error. Call `checked` only at compile time.
    #[must_use]
    pub const fn checked(result: Result<Self, Error>) -> Self {
        message::checked(result, "keyframes")
    }

    /// The mesh between the two poses, in the caller's memory: the first pose at `t` = 0, the second at `t` = 1; other
    /// values of `t` extrapolate.
    ///
    /// Each component of a blended position or normal is rounded once to the nearest 2⁻¹⁶, halves up, and saturates. At
    /// `t` = 0 and `t` = 1, every component is exact. The blend of two unit normals may be shorter than 1. fixel's
    /// lights are not affected, because they use only the directions of normals. If you pass no room for normals
    /// (`&mut []`), or if only one pose has them, the mesh has no normals, and lighting uses the normals of its
    /// triangles.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if a slice is shorter than the corresponding list of the first mesh; an empty slice for
    /// normals is accepted.
    pub fn blend<'m>(
        &self,
        t: Scalar,
        positions: &'m mut [Vec3],
        normals: &'m mut [Vec3],
    ) -> Result<Mesh<'m>, Error>
    where
        'a: 'm,
    {
        let all = self.first.positions();
        let positions = room("positions", positions, all.len())?;
        for ((to, a), b) in positions
            .iter_mut()
            .zip(all.iter())
            .zip(self.positions.iter())
        {
            *to = between(a, b, t);
        }
        let mut blended: Mesh<'m> = self.first.without_normals();
        if !normals.is_empty() && self.normals.len() > 0 {
            let normals = room("normals", normals, self.normals.len())?;
            let Attribute { values, faces } = self.first.normals;
            for ((to, a), b) in normals
                .iter_mut()
                .zip(values.iter())
                .zip(self.normals.iter())
            {
                *to = between(a, b, t);
            }
            let values = Values::Full(normals);
            blended.normals = Attribute { values, faces };
        }
        Ok(Mesh {
            positions: Positions::long(positions),
            ..blended
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use crate::{fx, vec3};
    use rand::Rng;

    const FACES: [[Index; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
    const CORNERS: [Vec3; 4] = [
        vec3!(0, 0, 0),
        vec3!(1, 0, 0),
        vec3!(1, 1, 0),
        vec3!(0, 1, 0),
    ];

    #[test]
    fn ends_are_exact_and_short_positions_blend_with_long_ones() {
        let far = [vec3!(-32768, 32767, 0.1); 4];
        let (first, second) = (
            Mesh::quantized(&[[1, -2, 3]; 4], 16, &FACES).unwrap(),
            Mesh::new(&far, &FACES).unwrap(),
        );
        let frames = Keyframes::new(&first, &second).unwrap();
        let mut positions = [Vec3::X; 5];
        let mesh = frames.blend(fx!(0), &mut positions, &mut []).unwrap();
        assert_eq!(mesh, first);
        let mesh = frames.blend(fx!(1), &mut positions, &mut []).unwrap();
        assert_eq!(mesh, second);
    }

    #[test]
    fn a_time_between_two_poses_blends_as_lerp_does() {
        cases(1 << 12, |random| {
            let [a, b] =
                [[0; 3]; 2].map(|zero: [i32; 3]| Vec3::from_bits(zero.map(|_| random.random())));
            for t in [
                random.random_range(0..=1 << 16),
                random.random(),
                0,
                1 << 16,
                (1 << 16) + 1,
                -1,
            ] {
                let t = Scalar::from_bits(t);
                assert_eq!(between(a, b, t), a.lerp(b, t), "{t}");
            }
        });
    }

    #[test]
    fn normals_blend_only_if_both_meshes_have_them() {
        let plain = Mesh::new(&CORNERS, &FACES).unwrap();
        let (up, ahead) = ([Vec3::Y; 2], [Vec3::Z; 2]);
        let own = [[0, 0, 1], [1, 0, Mesh::NO_VALUE]];
        let first = plain.with_normals(&up, Some(&own)).unwrap();
        let second = plain.with_normals(&ahead, Some(&own)).unwrap();
        let (mut positions, mut normals) = ([Vec3::ZERO; 4], [Vec3::ZERO; 2]);

        let frames = Keyframes::new(&first, &second).unwrap();
        let mesh = frames
            .blend(fx!(0.25), &mut positions, &mut normals)
            .unwrap();
        let halfway = [vec3!(0, 0.75, 0.25); 2];
        assert_eq!(mesh, plain.with_normals(&halfway, Some(&own)).unwrap());
        assert_eq!(
            frames.blend(fx!(0.25), &mut positions, &mut []).unwrap(),
            plain
        );

        let frames = Keyframes::new(&first, &plain).unwrap();
        assert_eq!(
            frames.blend(fx!(0), &mut positions, &mut normals).unwrap(),
            plain
        );
    }

    #[test]
    fn meshes_that_differ_are_refused_as_keyframes() {
        let first = Mesh::new(&CORNERS, &FACES).unwrap();
        let refused = |second: Mesh<'_>| Keyframes::new(&first, &second).unwrap_err();
        assert_eq!(
            refused(Mesh::new(&CORNERS[..3], &FACES[..1]).unwrap()),
            Error::Count {
                of: "positions",
                given: 3,
                min: 4,
                max: 4
            }
        );
        assert_eq!(
            refused(Mesh::new(&CORNERS, &FACES[..1]).unwrap()),
            Error::Count {
                of: "faces",
                given: 1,
                min: 2,
                max: 2
            }
        );
        let other = [FACES[0], [0, 3, 2]];
        let second = Mesh::new(&CORNERS, &other).unwrap();
        assert_eq!(refused(second), Error::FacesDiffer { at: 1 });

        let normals = [Vec3::Y; 4];
        let smooth = first.with_normals(&normals, None).unwrap();
        let own = [FACES[0], [0, 2, 2]];
        let flat = first.with_normals(&normals, Some(&own)).unwrap();
        let error = Keyframes::new(&smooth, &flat).unwrap_err();
        assert_eq!(error, Error::FacesDiffer { at: 1 });
        assert!(Keyframes::new(&smooth, &flat.without_normals()).is_ok());

        let frames = Keyframes::new(&smooth, &smooth).unwrap();
        let mut few = [Vec3::ZERO; 3];
        let full = |of| Error::Count {
            of,
            given: 4,
            min: 0,
            max: 3,
        };
        assert_eq!(
            frames.blend(fx!(0), &mut few, &mut []).unwrap_err(),
            full("positions")
        );
        let mut enough = [Vec3::ZERO; 4];
        assert_eq!(
            frames.blend(fx!(0), &mut enough, &mut few).unwrap_err(),
            full("normals")
        );
    }
}
