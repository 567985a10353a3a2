//! The lengths of a mesh's lists.

use super::{Index, Mesh};

/// How many elements each list of a mesh has. Each slice of [`Buffers`](super::Buffers) needs room for the elements of
/// its list.
///
/// ```
/// use fixel::mesh::Shape;
/// let cube = Shape::cuboid(fixel::vec3!(1, 1, 1))?.counts();
/// assert_eq!((cube.positions, cube.faces, cube.edges), (8, 12, 12));
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counts {
    /// Positions.
    pub positions: usize,
    /// Triangles.
    pub faces: usize,
    /// Edges.
    pub edges: usize,
    /// Texture coordinates.
    pub uvs: usize,
    /// Triangles in the texture coordinates' own list of faces; 0 if texture coordinates have no such list, but one
    /// value per position.
    pub uv_faces: usize,
    /// Normals.
    pub normals: usize,
    /// Triangles in the normals' own list of faces; 0 if normals have no such list, but one value per position.
    pub normal_faces: usize,
    /// Colors.
    pub colors: usize,
}

impl Mesh<'_> {
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
}
