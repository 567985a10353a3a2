//! Indices of positions and attributes, and the indices of a primitive.

use crate::error::Error;

/// An index into a mesh's positions or attributes. A triangle is stored as three indices, and an edge as two.
///
/// ```
/// use fixel::{Index, Mesh, Vec3};
/// let last: Index = 65_535;
/// assert!(Mesh::new(&[Vec3::ZERO; 65_536], &[[last, 0, 1]]).is_ok());
/// ```
pub type Index = u16;

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

/// The indices of a primitive's data in its mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Indices {
    pub(crate) element: Element,
    /// The indices of the primitive's three positions. An edge repeats its second position; a point repeats its
    /// position twice.
    pub(crate) corners: [Index; 3],
}

/// A triangle with its number among the mesh's faces, an edge with its number among the edges of the mesh or of an
/// outline, or a point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Element {
    Face(usize),
    Edge(usize),
    Point,
}

impl Indices {
    #[inline]
    pub(crate) const fn of_face(face: usize, corners: [Index; 3]) -> Self {
        let element = Element::Face(face);
        Self { element, corners }
    }

    #[inline]
    pub(crate) const fn of_edge(edge: usize, [a, b]: [Index; 2]) -> Self {
        let (element, corners) = (Element::Edge(edge), [a, b, b]);
        Self { element, corners }
    }

    #[inline]
    pub(crate) const fn of_point(index: Index) -> Self {
        let (element, corners) = (Element::Point, [index; 3]);
        Self { element, corners }
    }

    /// The number of the triangle among the faces, or of the edge among the edges; 0 for a point.
    #[inline]
    pub(crate) const fn number(&self) -> usize {
        match self.element {
            Element::Face(number) | Element::Edge(number) => number,
            Element::Point => 0,
        }
    }

    /// The number of the triangle among the faces. An edge or a point has no such number, so it has no value in
    /// attributes with faces of their own.
    #[inline]
    pub(super) const fn face(&self) -> Option<usize> {
        match self.element {
            Element::Face(face) => Some(face),
            Element::Edge(_) | Element::Point => None,
        }
    }
}
