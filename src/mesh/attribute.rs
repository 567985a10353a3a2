//! A mesh's attributes: the data that a vertex has besides its position.

use core::ops::Range;

use super::indexed::{Element, Index};

/// The values of one attribute. Without `faces` of its own, it is indexed like the positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Attribute<'a, T> {
    pub(super) values: &'a [T],
    pub(super) faces: Option<&'a [[Index; 3]]>,
}

impl<T> Attribute<'_, T> {
    pub(super) const NONE: Self = Self {
        values: &[],
        faces: None,
    };

    /// The attribute of a range of the faces, which must not reach beyond their end.
    pub(super) fn part(&self, range: &Range<usize>) -> Self {
        Self {
            values: self.values,
            faces: self.faces.and_then(|faces| faces.get(range.clone())),
        }
    }
}

impl<T: Copy> Attribute<'_, T> {
    /// The value at `corner` (0, 1 or 2) of an element.
    #[inline]
    pub(super) fn at(&self, element: Element, corner: usize) -> Option<T> {
        let indices = match self.faces {
            None => element.indices,
            Some(faces) => *faces.get(element.face?)?,
        };
        self.values.get(usize::from(*indices.get(corner)?)).copied()
    }
}
