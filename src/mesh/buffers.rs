//! Memory for generated meshes.

use super::{Counts, Index, Mesh, Positions};
use crate::error::{Error, check_count, ok};
use crate::math::{Vec2, Vec3};

/// Memory for a shape that is built at run time: one slice per list, each at least as long as [`Counts`] says.
///
/// Edges, texture coordinates and normals are optional: if you give an empty slice, the mesh lacks this list.
///
/// ```
/// use fixel::mesh::{Buffers, Shape};
/// use fixel::prelude::*;
/// let (mut positions, mut faces, mut normals) = ([Vec3::ZERO; 8], [[0; 3]; 12], [Vec3::ZERO; 6]);
/// let buffers = Buffers { normals: &mut normals, ..Buffers::new(&mut positions, &mut faces) };
/// let cube = Shape::cuboid(vec3!(1, 1, 1))?.build(buffers)?;
/// assert!(cube.has_normals() && !cube.has_uvs());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct Buffers<'a> {
    /// Memory for positions.
    pub positions: &'a mut [Vec3],
    /// Memory for triangles.
    pub faces: &'a mut [[Index; 3]],
    /// Memory for edges.
    pub edges: &'a mut [[Index; 2]],
    /// Memory for texture coordinates.
    pub uvs: &'a mut [Vec2],
    /// Memory for normals.
    pub normals: &'a mut [Vec3],
}

impl<'a> Buffers<'a> {
    /// Buffers for a mesh that has only positions and triangles.
    #[must_use]
    pub const fn new(positions: &'a mut [Vec3], faces: &'a mut [[Index; 3]]) -> Self {
        Self {
            positions,
            faces,
            edges: &mut [],
            uvs: &mut [],
            normals: &mut [],
        }
    }

    /// Returns `counts`, but with 0 for each optional list that has an empty slice; an error if any other slice is too
    /// short.
    pub(super) const fn wanted(&self, counts: Counts) -> Result<Counts, Error> {
        const fn if_any(values: usize, faces: usize) -> usize {
            if values > 0 { faces } else { 0 }
        }
        ok!(check_count(
            "positions",
            counts.positions,
            [0, self.positions.len()]
        ));
        ok!(check_count("faces", counts.faces, [0, self.faces.len()]));
        let uvs = ok!(optional("texture coordinates", counts.uvs, self.uvs.len()));
        let normals = ok!(optional("normals", counts.normals, self.normals.len()));
        Ok(Counts {
            edges: ok!(optional("edges", counts.edges, self.edges.len())),
            uvs,
            uv_faces: if_any(uvs, counts.uv_faces),
            normals,
            normal_faces: if_any(normals, counts.normal_faces),
            ..counts
        })
    }

    /// Makes a mesh of the first elements of each slice, and of the triangles as indices of texture coordinates and of
    /// normals; `counts` has their numbers.
    pub(super) const fn mesh(
        self,
        counts: Counts,
        [uv_faces, normal_faces]: [&'a [[Index; 3]]; 2],
    ) -> Result<Mesh<'a>, Error> {
        ok!(check_count(
            "positions",
            counts.positions,
            [0, Mesh::MAX_POSITIONS]
        ));
        Ok(Mesh::of_lists(
            Positions::long(first(self.positions, counts.positions)),
            (
                first(self.faces, counts.faces),
                first(self.edges, counts.edges),
            ),
            (
                first(self.uvs, counts.uvs),
                first(uv_faces, counts.uv_faces),
            ),
            (
                first(self.normals, counts.normals),
                first(normal_faces, counts.normal_faces),
            ),
            (&[], &[]),
        ))
    }
}

/// The number of elements to write to an optional list: `needed`, or 0 if the caller gives no room. An error if there
/// is less room than needed.
const fn optional(of: &'static str, needed: usize, room: usize) -> Result<usize, Error> {
    if room == 0 {
        return Ok(0);
    }
    ok!(check_count(of, needed, [0, room]));
    Ok(needed)
}

/// The first `count` elements of a list, or all elements if the list is shorter.
const fn first<T>(list: &[T], count: usize) -> &[T] {
    match list.split_at_checked(count) {
        Some((first, _)) => first,
        None => list,
    }
}

/// The first `needed` elements of a list, or an error if the list is shorter.
pub(super) const fn room<'l, T>(
    of: &'static str,
    list: &'l mut [T],
    needed: usize,
) -> Result<&'l mut [T], Error> {
    ok!(check_count(of, needed, [0, list.len()]));
    Ok(list.split_at_mut(needed).0)
}
