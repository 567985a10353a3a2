//! A mesh's attributes: the data that a vertex has besides its position.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;

use super::mesh::check;
use super::{Index, Indices, Mesh};
use crate::error::{check_length, ok};
use crate::{Error, Vec2, Vec3};

/// The values of one attribute. Without `faces` of its own, it is indexed like the positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Attribute<'a, T> {
    pub(super) values: &'a [T],
    pub(super) faces: Option<&'a [[Index; 3]]>,
}

impl<'a, T> Attribute<'a, T> {
    pub(super) const NONE: Self = Self::of_positions(&[]);

    /// The attribute with a value for each position.
    pub(super) const fn of_positions(values: &'a [T]) -> Self {
        Self {
            values,
            faces: None,
        }
    }

    /// The attribute of lists that are known to fit the mesh. Without `faces`, values belong to the positions.
    pub(super) const fn of_lists((values, faces): (&'a [T], &'a [[Index; 3]])) -> Self {
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
}

impl<T: Copy> Attribute<'_, T> {
    /// The value at `corner` (0, 1 or 2) of a primitive.
    #[inline]
    pub(super) fn at(&self, indices: Indices, corner: usize) -> Option<T> {
        let indices = match self.faces {
            None => indices.corners,
            Some(faces) => *faces.get(indices.face()?)?,
        };
        self.values.get(usize::from(*indices.get(corner)?)).copied()
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

    /// Whether there are texture coordinates.
    #[must_use]
    pub const fn has_uvs(&self) -> bool {
        !self.uvs.values.is_empty()
    }

    /// Whether there are normals.
    #[must_use]
    pub const fn has_normals(&self) -> bool {
        !self.normals.values.is_empty()
    }

    /// Whether there are colors.
    #[must_use]
    pub const fn has_colors(&self) -> bool {
        !self.colors.values.is_empty()
    }

    const fn attribute<T>(
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
        Ok(Attribute { values, faces })
    }
}
