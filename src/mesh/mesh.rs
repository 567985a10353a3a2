//! The mesh: borrowed slices, usually in flash, checked once.

use embedded_graphics::pixelcolor::Rgb888;

use super::attribute::Attribute;
use super::buffers::Counts;
use super::positions::Positions;
use crate::error::{check_count, ok};
use crate::{Error, Vec2, Vec3, message};

/// An index into a mesh's positions or attributes. A triangle is stored as three indices, and an edge as two.
///
/// ```
/// use fixel::{Index, Mesh, Vec3};
/// let last: Index = 65_535;
/// assert!(Mesh::new(&[Vec3::ZERO; 65_536], &[[last, 0, 1]]).is_ok());
/// ```
pub type Index = u16;

/// A triangle mesh that borrows slices of the caller: positions and faces, and optionally texture coordinates, normals,
/// colors and edges.
///
#[cfg_attr(doc, doc = diagram!("winding"))]
/// Texture coordinates, normals and colors are attributes. An attribute uses the indices of the positions, unless the
/// attribute has `faces` (three indices per triangle) of its own. With its own `faces`, a position may have a different
/// value in each triangle, as in an OBJ file; a corner without a value has the index [`NO_VALUE`](Self::NO_VALUE). The
/// corners of a front face run counter-clockwise as seen by the viewer.
///
/// The constructors check every index; for a `static`, this happens at compile time:
///
/// ```
/// use fixel::prelude::*;
/// static TRIANGLE: Mesh = Mesh::checked(Mesh::new(
///     &[vec3!(0, 0, 0), vec3!(1, 0, 0), vec3!(0, 1, 0)],
///     &[[0, 1, 2]],
/// ));
/// assert_eq!(TRIANGLE.faces().len(), 1);
/// assert!(Mesh::new(&[Vec3::ZERO], &[[0, 0, 1]]).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Mesh<'a> {
    pub(super) positions: Positions<'a>,
    pub(super) faces: &'a [[Index; 3]],
    /// If this mesh is a part of a mesh, the index of the part's first face in the whole mesh; otherwise 0.
    pub(super) first_face: usize,
    pub(super) edges: &'a [[Index; 2]],
    pub(super) uvs: Attribute<'a, Vec2>,
    pub(super) normals: Attribute<'a, Vec3>,
    pub(super) colors: Attribute<'a, Rgb888>,
}

/// Checks that every index of `lists` is below `len` or equal to `exception`.
pub(super) const fn check<const K: usize>(
    lists: &[[Index; K]],
    len: usize,
    exception: Option<Index>,
) -> Result<(), Error> {
    // The loop uses a pattern, because at compile time, a call of `len` takes as long as several comparisons.
    let mut rest = lists;
    while let [list, others @ ..] = rest {
        let mut corner = 0;
        while corner < K {
            let index = list[corner];
            if index as usize >= len && !matches!(exception, Some(except) if index == except) {
                return Err(Error::Index {
                    at: lists.len() - rest.len(),
                    index: index as u32,
                    len,
                });
            }
            corner += 1;
        }
        rest = others;
    }
    Ok(())
}

impl<'a> Mesh<'a> {
    /// The index that marks, in the `faces` of an attribute, a corner without a value. The corner then gets the texture
    /// coordinate (0, 0), the normal of its triangle, or white.
    ///
    /// Exception: in a list of 65,536 values, this index is valid, and means the last value.
    pub const NO_VALUE: Index = Index::MAX;

    /// The largest number of positions that an [`Index`] can address.
    ///
    /// ```
    /// use fixel::{Error, Mesh, Vec3};
    /// let positions = vec![Vec3::ZERO; Mesh::MAX_POSITIONS + 1];
    /// let error = Mesh::new(&positions, &[]).unwrap_err();
    /// assert!(matches!(error, Error::TooMany { given: 65_537, max: Mesh::MAX_POSITIONS, .. }));
    /// ```
    pub const MAX_POSITIONS: usize = Index::MAX as usize + 1;

    /// A mesh of positions and the triangles between them.
    ///
    /// # Errors
    ///
    /// [`Error::Index`] if a face names a position that does not exist; [`Error::TooMany`] if there are more than
    /// [`MAX_POSITIONS`](Self::MAX_POSITIONS) positions.
    pub const fn new(positions: &'a [Vec3], faces: &'a [[Index; 3]]) -> Result<Self, Error> {
        Self::of(Positions::long(positions), faces)
    }

    /// A mesh of 16-bit positions, in units of 2^-`fraction`, and the triangles between them.
    ///
    /// These positions take half the flash of positions in [`Scalar`](crate::Scalar)s. They draw the same pixels, bit
    /// for bit, as 32-bit positions with the same values. With 14 fraction bits, for example, 16-bit positions range
    /// from −2 to almost 2 in steps of 1/16384.
    ///
    /// Rounding to these units moves a position by up to half a unit along each axis. On the screen, the rounding moves
    /// the position by up to √3/2 · (1 + s) units times focal length / w, where s is the slope x/w or y/w at which the
    /// position is seen. For a sphere that fills 320x240 pixels, stored with 14 fraction bits, this bound is 0.008
    /// pixels. Transforming a 16-bit position takes more instructions than transforming a 32-bit position: 7 more on
    /// Cortex-M4, and about 10 more on Cortex-M0+.
    ///
    /// [`shape!`](crate::shape) and [`include_mesh!`](crate::include_mesh) produce such meshes with the argument
    /// `short`; [`Mesh::shortened`] converts the positions of any mesh.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// static TRIANGLE: Mesh = Mesh::checked(Mesh::short(
    ///     &[[0, 0, 0], [1 << 14, 0, 0], [0, 3 << 13, 0]],
    ///     14,
    ///     &[[0, 1, 2]],
    /// ));
    /// assert_eq!(TRIANGLE.positions().get(2), Some(vec3!(0, 1.5, 0)));
    ///
    /// static BALL: Mesh = shape!(sphere(32, 32), short);
    /// assert_eq!(BALL.positions().len(), 33 * 33);
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new); [`Error::Parts`] if there are more than 16 fraction bits.
    pub const fn short(
        positions: &'a [[i16; 3]],
        fraction: u32,
        faces: &'a [[Index; 3]],
    ) -> Result<Self, Error> {
        let positions = ok!(Positions::short(positions, fraction));
        Self::of(positions, faces)
    }

    const fn of(positions: Positions<'a>, faces: &'a [[Index; 3]]) -> Result<Self, Error> {
        ok!(check_count(positions.len(), Self::MAX_POSITIONS));
        ok!(check(faces, positions.len(), None));
        Ok(Self::of_lists(
            positions,
            (faces, &[]),
            (&[], &[]),
            (&[], &[]),
            (&[], &[]),
        ))
    }

    /// A mesh of lists that are known to fit each other. To check them again would take most of the compiler's time. An
    /// attribute without faces has one value per position.
    #[doc(hidden)]
    #[must_use]
    pub const fn of_lists(
        positions: Positions<'a>,
        (faces, edges): (&'a [[Index; 3]], &'a [[Index; 2]]),
        uvs: (&'a [Vec2], &'a [[Index; 3]]),
        normals: (&'a [Vec3], &'a [[Index; 3]]),
        colors: (&'a [Rgb888], &'a [[Index; 3]]),
    ) -> Self {
        Self {
            positions,
            faces,
            first_face: 0,
            edges,
            uvs: Attribute::of_lists(uvs),
            normals: Attribute::of_lists(normals),
            colors: Attribute::of_lists(colors),
        }
    }

    /// Unwraps a mesh in a `const` or `static`, where an error stops compilation.
    ///
    /// # Panics
    ///
    /// If `result` is an error. Call `checked` only at compile time.
    #[must_use]
    pub const fn checked(result: Result<Self, Error>) -> Self {
        message::checked(result, "mesh")
    }

    /// Adds edges, so that [`edges`](Self::edges) can draw them.
    ///
    /// # Errors
    ///
    /// [`Error::Index`] if an edge names a position that does not exist.
    pub const fn with_edges(self, edges: &'a [[Index; 2]]) -> Result<Self, Error> {
        ok!(check(edges, self.positions.len(), None));
        Ok(Self { edges, ..self })
    }

    /// The mesh without its edges. A `static` that holds the result uses no flash for edges.
    ///
    /// [`shape!`](crate::shape) and [`include_mesh!`](crate::include_mesh) make all lists, and every list that a
    /// `static` keeps takes flash. So drop the lists that no draw call reads:
    ///
    /// ```
    /// use fixel::prelude::*;
    /// static BALL: Mesh = shape!(sphere(16, 12)).without_edges().without_uvs();
    /// assert!(BALL.edge_indices().is_empty() && !BALL.has_uvs() && BALL.has_normals());
    /// ```
    #[must_use]
    pub const fn without_edges(self) -> Self {
        Self { edges: &[], ..self }
    }

    /// How many elements each list has.
    #[must_use]
    pub const fn counts(&self) -> Counts {
        const fn own(faces: Option<&[[Index; 3]]>) -> usize {
            match faces {
                Some(faces) => faces.len(),
                None => 0,
            }
        }
        Counts {
            positions: self.positions.len(),
            faces: self.faces.len(),
            edges: self.edges.len(),
            uvs: self.uvs.values.len(),
            uv_faces: own(self.uvs.faces),
            normals: self.normals.values.len(),
            normal_faces: own(self.normals.faces),
            colors: self.colors.values.len(),
        }
    }

    /// The positions, in model space.
    #[must_use]
    pub const fn positions(&self) -> Positions<'a> {
        self.positions
    }

    /// The triangles, as indices of positions.
    #[must_use]
    pub const fn faces(&self) -> &'a [[Index; 3]] {
        self.faces
    }

    /// The edges, as indices of positions; [`edges`](Self::edges) draws them.
    #[must_use]
    pub const fn edge_indices(&self) -> &'a [[Index; 2]] {
        self.edges
    }

    /// The position at `index`; the origin if the index is out of range, which cannot happen with a checked list.
    #[inline]
    pub(crate) fn position(&self, index: Index) -> Vec3 {
        self.positions.at(index)
    }
}
