//! The mesh: borrowed slices, usually in flash, checked once.

use embedded_graphics::pixelcolor::Rgb888;

use super::attribute::{Attribute, Small, Values};
use super::index::{Index, check};
use super::positions::Positions;
use crate::error::{Error, check_count, check_length, ok};
use crate::math::{Vec2, Vec3};
use crate::message;

/// A triangle mesh that borrows your slices: positions and faces, and optionally texture coordinates, normals, colors
/// and edges.
///
#[cfg_attr(doc, doc = include_str!("../guide/diagrams/winding.svg"))]
///
/// Texture coordinates, normals and colors are attributes. An attribute has either one value per position, or its own
/// list of `faces`: three indices per triangle, as in an OBJ file. If an attribute has its own `faces`, a position may
/// have a different value in each triangle. There, the index [`NO_VALUE`](Self::NO_VALUE) marks a corner without a
/// value.
///
/// The corners of a front face run counter-clockwise as seen by the viewer.
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

impl<'a> Mesh<'a> {
    /// The index of a corner without a value, for the `faces` of an attribute. Drawing then uses a default: the texture
    /// coordinate (0, 0), the normal of the triangle, or the color white.
    ///
    /// Exception: in a list of 65,536 values, this index is valid, and means the last value.
    pub const NO_VALUE: Index = Index::MAX;

    /// The largest number of positions of a mesh: an [`Index`] can address no more.
    ///
    /// ```
    /// use fixel::{Error, Mesh, Vec3};
    /// let positions = vec![Vec3::ZERO; Mesh::MAX_POSITIONS + 1];
    /// let error = Mesh::new(&positions, &[]).unwrap_err();
    /// assert!(matches!(error, Error::Count { given: 65_537, max: Mesh::MAX_POSITIONS, .. }));
    /// ```
    pub const MAX_POSITIONS: usize = Index::MAX as usize + 1;

    /// A mesh of positions and triangles. A triangle is an array of three indices: the positions of its corners,
    /// counter-clockwise as seen from outside.
    ///
    /// # Errors
    ///
    /// [`Error::Index`] if a face names a position that does not exist; [`Error::Count`] if there are more than
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
    /// Rounding to 16 bits moves a position by up to half a unit along each axis. Let w be the position's distance from
    /// the eye, and s its slope x/w or y/w in eye space. On the screen, the rounding moves the position by up to √3/2 ·
    /// (1 + s) · u · focal length / w pixels along each axis, where u is the length of a unit, 2^-`fraction`. For a
    /// sphere that fills 320x240 pixels, stored with 14 fraction bits, this bound is 0.008 pixels. Transforming a
    /// 16-bit position takes more instructions than transforming a 32-bit position: 7 more on Cortex-M4, and about 10
    /// more on Cortex-M0+.
    ///
    /// [`shape!`](crate::shape) and [`include_mesh!`](crate::include_mesh) produce such meshes with the argument
    /// `quantized`; [`Mesh::quantized_positions`] converts the positions of any mesh.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// static TRIANGLE: Mesh = Mesh::checked(Mesh::quantized(
    ///     &[[0, 0, 0], [1 << 14, 0, 0], [0, 3 << 13, 0]],
    ///     14,
    ///     &[[0, 1, 2]],
    /// ));
    /// assert_eq!(TRIANGLE.positions().get(2), Some(vec3!(0, 1.5, 0)));
    ///
    /// static BALL: Mesh = shape!(sphere(32, 32), quantized);
    /// assert_eq!(BALL.positions().len(), 33 * 33);
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new); [`Error::Count`] if there are more than 16 fraction bits.
    pub const fn quantized(
        positions: &'a [[i16; 3]],
        fraction: u32,
        faces: &'a [[Index; 3]],
    ) -> Result<Self, Error> {
        let positions = ok!(Positions::quantized(positions, fraction));
        Self::of(positions, faces)
    }

    const fn of(positions: Positions<'a>, faces: &'a [[Index; 3]]) -> Result<Self, Error> {
        ok!(check_count(
            "positions",
            positions.len(),
            [0, Self::MAX_POSITIONS]
        ));
        ok!(check(faces, positions.len(), None));
        Ok(Self::of_lists(
            positions,
            (faces, &[]),
            (&[], &[]),
            (&[], &[]),
            (&[], &[]),
        ))
    }

    /// A mesh of lists that are known to fit each other. The lists are not checked: for a mesh in a `static`, the
    /// checks would take most of the compiler's time. An attribute without faces has one value per position.
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

    /// Unwraps a mesh in a `const` or `static`, where an error stops compilation. The mesh stores the
    /// [box](Self::with_bounds) around its positions.
    ///
    /// # Panics
    ///
    /// If `result` is an error. Call `checked` only at compile time.
    #[must_use]
    pub const fn checked(result: Result<Self, Error>) -> Self {
        let mesh = message::checked(result, "mesh");
        mesh.with_bounds(mesh.bounds())
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
    /// [`shape!`](crate::shape) and [`include_mesh!`](crate::include_mesh) make all lists of a mesh, and every list
    /// that a `static` keeps takes flash. So drop the lists that no draw call reads:
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

    /// The mesh's positions rounded to the nearest 16-bit components, and their number of fraction bits, for
    /// [`quantized`](Self::quantized). The number of fraction bits is the greatest that the largest component permits, at most
    /// 16.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let positions = [vec3!(0, 0, 0), vec3!(1.7, 0, 0), vec3!(0, -1, 0)];
    /// let mesh = Mesh::new(&positions, &[[0, 1, 2]])?;
    /// let (positions, fraction) = mesh.quantized_positions::<3>()?;
    /// assert_eq!((positions[2], fraction), ([0, -1 << 14, 0], 14));
    /// assert!(Mesh::quantized(&positions, fraction, mesh.faces()).is_ok());
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless the mesh has exactly `N` positions.
    pub const fn quantized_positions<const N: usize>(&self) -> Result<([[i16; 3]; N], u32), Error> {
        self.positions.quantized_positions()
    }
}

/// Adds, removes and finds attributes.
impl<'a> Mesh<'a> {
    /// Adds texture coordinates: one per position, or any number if `faces` gives three indices per triangle.
    ///
    /// # Errors
    ///
    /// Without `faces`: [`Error::Count`] unless there is one value per position. With `faces`: [`Error::Count`]
    /// unless `faces` has one element per triangle; [`Error::Index`] if an index names a value that does not exist.
    pub const fn with_uvs(
        self,
        values: &'a [Vec2],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Self, Error> {
        let uvs = ok!(self.attribute(values, faces));
        Ok(Self { uvs, ..self })
    }

    /// Adds normals: one per position, or any number if `faces` gives three indices per triangle. A normal is a
    /// direction in model space; the vector may have any length.
    ///
    /// # Errors
    ///
    /// The same as for [`with_uvs`](Self::with_uvs).
    pub const fn with_normals(
        self,
        values: &'a [Vec3],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Self, Error> {
        let normals = ok!(self.attribute(values, faces));
        Ok(Self { normals, ..self })
    }

    /// Adds colors: one per position, or any number if `faces` gives three indices per triangle.
    ///
    /// # Errors
    ///
    /// The same as for [`with_uvs`](Self::with_uvs).
    pub const fn with_colors(
        self,
        values: &'a [Rgb888],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Self, Error> {
        let colors = ok!(self.attribute(values, faces));
        Ok(Self { colors, ..self })
    }

    /// The mesh without its texture coordinates. [`without_edges`](Self::without_edges) says how this saves flash.
    #[must_use]
    pub const fn without_uvs(self) -> Self {
        let uvs = Attribute::NONE;
        Self { uvs, ..self }
    }

    /// The mesh without its normals. [`without_edges`](Self::without_edges) says how this saves flash. Lighting then
    /// uses the normals of the triangles.
    #[must_use]
    pub const fn without_normals(self) -> Self {
        let normals = Attribute::NONE;
        Self { normals, ..self }
    }

    /// The mesh without its colors. [`without_edges`](Self::without_edges) says how this saves flash.
    #[must_use]
    pub const fn without_colors(self) -> Self {
        let colors = Attribute::NONE;
        Self { colors, ..self }
    }

    /// The mesh with normals of 8 bits, and texture coordinates of 8 or 16 bits. The lists are not checked, so they
    /// must fit the mesh. An attribute with an empty list of faces has one value per position.
    #[doc(hidden)]
    #[must_use]
    pub const fn with_quantized_attributes(
        self,
        (normals, normal_faces): (&'a Small<'a, Vec3>, &'a [[Index; 3]]),
        (uvs, uv_faces): (&'a Small<'a, Vec2>, &'a [[Index; 3]]),
    ) -> Self {
        Self {
            normals: Attribute::of((Values::small(normals), normal_faces)),
            uvs: Attribute::of((Values::small(uvs), uv_faces)),
            ..self
        }
    }

    /// Whether the mesh has texture coordinates.
    #[must_use]
    pub const fn has_uvs(&self) -> bool {
        self.uvs.values.len() > 0
    }

    /// Whether the mesh has normals.
    #[must_use]
    pub const fn has_normals(&self) -> bool {
        self.normals.values.len() > 0
    }

    /// Whether the mesh has colors.
    #[must_use]
    pub const fn has_colors(&self) -> bool {
        self.colors.values.len() > 0
    }

    const fn attribute<T: Copy>(
        &self,
        values: &'a [T],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Attribute<'a, T>, Error> {
        let (of, given, needed) = match faces {
            None => ("values", values.len(), self.positions.len()),
            Some(faces) => ("faces", faces.len(), self.faces.len()),
        };
        ok!(check_length(of, given, needed));
        if let Some(faces) = faces {
            ok!(check(faces, values.len(), Some(Self::NO_VALUE)));
        }
        let values = Values::Full(values);
        Ok(Attribute { values, faces })
    }
}
