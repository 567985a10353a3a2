//! A mesh's attributes: the data that a vertex has besides its position.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;

use super::mesh::check;
use super::quantized::{Small, Values};
use super::{Index, Indices, Mesh};
use crate::error::{check_length, ok};
use crate::{Error, Vec2, Vec3};

/// The values of one attribute. Without `faces` of its own, it is indexed like the positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Attribute<'a, T: Copy> {
    pub(super) values: Values<'a, T>,
    pub(super) faces: Option<&'a [[Index; 3]]>,
}

impl<'a, T: Copy> Attribute<'a, T> {
    pub(super) const NONE: Self = Self::of_lists((&[], &[]));

    /// The attribute of lists that are known to fit the mesh. Without `faces`, values belong to the positions.
    pub(super) const fn of_lists((values, faces): (&'a [T], &'a [[Index; 3]])) -> Self {
        Self::of((Values::Full(values), faces))
    }

    /// The same for values that may have fewer bits.
    pub(super) const fn of((values, faces): (Values<'a, T>, &'a [[Index; 3]])) -> Self {
        let faces = if faces.is_empty() { None } else { Some(faces) };
        Self { values, faces }
    }

    /// The attribute of a range of the faces, which must not reach beyond their end.
    pub(super) fn part(&self, range: &Range<usize>) -> Self {
        Self {
            values: self.values,
            faces: self.faces.and_then(|faces| faces.get(range.clone())),
        }
    }

    /// The index of the value at `corner` (0, 1 or 2) of a primitive.
    #[inline]
    fn index(&self, indices: Indices, corner: usize) -> Option<usize> {
        let indices = match self.faces {
            None => indices.corners,
            Some(faces) => *faces.get(indices.face()?)?,
        };
        Some(usize::from(*indices.get(corner)?))
    }

    /// The value at a corner of a primitive.
    #[inline]
    pub(super) fn at(&self, indices: Indices, corner: usize) -> Option<T> {
        self.values.get(self.index(indices, corner)?)
    }

    /// The same for an attribute that always has full precision, which takes less code.
    #[inline]
    pub(super) fn full_at(&self, indices: Indices, corner: usize) -> Option<T> {
        match self.values {
            Values::Full(values) => values.get(self.index(indices, corner)?).copied(),
            Values::Small(_) => None,
        }
    }
}

/// Adds, removes and finds attributes.
impl<'a> Mesh<'a> {
    /// Adds texture coordinates: one per position, or, with `faces`, any number and three indices per triangle.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if the number of values is not the number of positions or, with `faces`, if `faces` does not
    /// have one entry per triangle; [`Error::Index`] if an entry names a value that does not exist.
    pub const fn with_uvs(
        self,
        values: &'a [Vec2],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Self, Error> {
        let uvs = ok!(self.attribute(values, faces));
        Ok(Self { uvs, ..self })
    }

    /// Adds normals in model space, of any length: one per position, or, with `faces`, any number and three indices
    /// per triangle.
    ///
    /// # Errors
    ///
    /// As for [`with_uvs`](Self::with_uvs).
    pub const fn with_normals(
        self,
        values: &'a [Vec3],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Self, Error> {
        let normals = ok!(self.attribute(values, faces));
        Ok(Self { normals, ..self })
    }

    /// Adds colors: one per position, or, with `faces`, any number and three indices per triangle.
    ///
    /// # Errors
    ///
    /// As for [`with_uvs`](Self::with_uvs).
    pub const fn with_colors(
        self,
        values: &'a [Rgb888],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Self, Error> {
        let colors = ok!(self.attribute(values, faces));
        Ok(Self { colors, ..self })
    }

    /// The mesh without its texture coordinates; see [`without_edges`](Self::without_edges).
    #[must_use]
    pub const fn without_uvs(self) -> Self {
        let uvs = Attribute::NONE;
        Self { uvs, ..self }
    }

    /// The mesh without its normals; see [`without_edges`](Self::without_edges). Light then falls on flat faces.
    #[must_use]
    pub const fn without_normals(self) -> Self {
        let normals = Attribute::NONE;
        Self { normals, ..self }
    }

    /// The mesh without its colors; see [`without_edges`](Self::without_edges).
    #[must_use]
    pub const fn without_colors(self) -> Self {
        let colors = Attribute::NONE;
        Self { colors, ..self }
    }

    /// The mesh with attributes in fewer bits. The lists are known to fit it; those of faces may be empty.
    pub(super) const fn with_small(
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

    /// Whether there are texture coordinates.
    #[must_use]
    pub const fn has_uvs(&self) -> bool {
        self.uvs.values.len() > 0
    }

    /// Whether there are normals.
    #[must_use]
    pub const fn has_normals(&self) -> bool {
        self.normals.values.len() > 0
    }

    /// Whether there are colors.
    #[must_use]
    pub const fn has_colors(&self) -> bool {
        self.colors.values.len() > 0
    }

    const fn attribute<T: Copy>(
        &self,
        values: &'a [T],
        faces: Option<&'a [[Index; 3]]>,
    ) -> Result<Attribute<'a, T>, Error> {
        let (given, needed) = match faces {
            None => (values.len(), self.positions.len()),
            Some(faces) => (faces.len(), self.faces.len()),
        };
        ok!(check_length(given, needed));
        if let Some(faces) = faces {
            ok!(check(faces, values.len(), Some(Self::NO_VALUE)));
        }
        let values = Values::Full(values);
        Ok(Attribute { values, faces })
    }
}
