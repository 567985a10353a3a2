//! Where generated and imported meshes are written.

use embedded_graphics::pixelcolor::Rgb888;

use super::indexed::{Index, Mesh};
use super::positions::Positions;
use crate::{Error, Vec2, Vec3};

/// How many elements a mesh has, list by list: the room that it needs in [`Buffers`].
///
/// ```
/// use fixel::mesh::Shape;
/// let cube = Shape::cuboid(fixel::vec3!(1, 1, 1))?.counts();
/// assert_eq!((cube.positions, cube.faces, cube.edges), (24, 12, 12));
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counts {
    /// Positions.
    pub positions: usize,
    /// Triangles.
    pub faces: usize,
    /// Edges; for OBJ text an upper bound, as edges that occur twice are not yet found.
    pub edges: usize,
    /// Texture coordinates.
    pub uvs: usize,
    /// Triangles in texture coordinates; 0 if these are indexed like the positions.
    pub uv_faces: usize,
    /// Normals.
    pub normals: usize,
    /// Triangles in normals; 0 if these are indexed like the positions.
    pub normal_faces: usize,
    /// Colors.
    pub colors: usize,
}

impl Counts {
    /// No elements.
    pub(super) const ZERO: Self = Self {
        positions: 0,
        faces: 0,
        edges: 0,
        uvs: 0,
        uv_faces: 0,
        normals: 0,
        normal_faces: 0,
        colors: 0,
    };
}

/// Memory for a mesh made at run time: one slice per list, at least as long as its [`Counts`] say.
///
/// An attribute, or the edges, for which there is an empty slice is left out.
///
/// ```
/// use fixel::mesh::{Buffers, Shape};
/// use fixel::prelude::*;
/// let (mut positions, mut faces, mut normals) = ([Vec3::ZERO; 24], [[0; 3]; 12], [Vec3::ZERO; 24]);
/// let buffers = Buffers { normals: &mut normals, ..Buffers::new(&mut positions, &mut faces) };
/// let cube = Shape::cuboid(vec3!(1, 1, 1))?.build(buffers)?;
/// assert!(cube.has_normals() && !cube.has_uvs());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct Buffers<'a> {
    /// For positions.
    pub positions: &'a mut [Vec3],
    /// For triangles.
    pub faces: &'a mut [[Index; 3]],
    /// For edges.
    pub edges: &'a mut [[Index; 2]],
    /// For texture coordinates.
    pub uvs: &'a mut [Vec2],
    /// For triangles in texture coordinates.
    pub uv_faces: &'a mut [[Index; 3]],
    /// For normals.
    pub normals: &'a mut [Vec3],
    /// For triangles in normals.
    pub normal_faces: &'a mut [[Index; 3]],
    /// For colors.
    pub colors: &'a mut [Rgb888],
}

impl<'a> Buffers<'a> {
    /// Room for positions and triangles, none for edges and attributes.
    #[must_use]
    pub const fn new(positions: &'a mut [Vec3], faces: &'a mut [[Index; 3]]) -> Self {
        Self {
            positions,
            faces,
            edges: &mut [],
            uvs: &mut [],
            uv_faces: &mut [],
            normals: &mut [],
            normal_faces: &mut [],
            colors: &mut [],
        }
    }

    /// What of `counts` is wanted, which is what there are slices for.
    pub(super) const fn wanted(&self, counts: Counts) -> Result<Counts, Error> {
        let mut wanted = counts;
        if self.edges.is_empty() {
            wanted.edges = 0;
        }
        if self.uvs.is_empty() {
            wanted.uvs = 0;
            wanted.uv_faces = 0;
        }
        if self.normals.is_empty() {
            wanted.normals = 0;
            wanted.normal_faces = 0;
        }
        if self.colors.is_empty() {
            wanted.colors = 0;
        }
        let room = [
            (wanted.positions, self.positions.len()),
            (wanted.faces, self.faces.len()),
            (wanted.edges, self.edges.len()),
            (wanted.uvs, self.uvs.len()),
            (wanted.uv_faces, self.uv_faces.len()),
            (wanted.normals, self.normals.len()),
            (wanted.normal_faces, self.normal_faces.len()),
            (wanted.colors, self.colors.len()),
        ];
        let mut list = 0;
        while list < room.len() {
            let (given, max) = room[list];
            if given > max {
                return Err(Error::TooMany { given, max });
            }
            list += 1;
        }
        Ok(wanted)
    }

    /// The mesh of the first so many elements of each list.
    pub(super) const fn mesh(self, counts: Counts) -> Result<Mesh<'a>, Error> {
        Lists {
            positions: Positions::long(first(self.positions, counts.positions)),
            faces: self.faces,
            edges: self.edges,
            uvs: self.uvs,
            uv_faces: self.uv_faces,
            normals: self.normals,
            normal_faces: self.normal_faces,
            colors: self.colors,
        }
        .mesh(counts)
    }
}

/// The lists of a mesh, filled.
#[derive(Clone, Copy)]
struct Lists<'a> {
    positions: Positions<'a>,
    faces: &'a [[Index; 3]],
    edges: &'a [[Index; 2]],
    uvs: &'a [Vec2],
    uv_faces: &'a [[Index; 3]],
    normals: &'a [Vec3],
    normal_faces: &'a [[Index; 3]],
    colors: &'a [Rgb888],
}

/// The first elements of a list; all of them if there are not so many.
const fn first<T>(list: &[T], count: usize) -> &[T] {
    match list.split_at_checked(count) {
        Some((first, _)) => first,
        None => list,
    }
}

/// The list of triangles of an attribute, if it has its own.
const fn own(list: &[[Index; 3]], count: usize) -> Option<&[[Index; 3]]> {
    if count == 0 {
        None
    } else {
        Some(first(list, count))
    }
}

impl<'a> Lists<'a> {
    const fn mesh(self, counts: Counts) -> Result<Mesh<'a>, Error> {
        let mut mesh = Mesh::of(self.positions, first(self.faces, counts.faces));
        if let Ok(plain) = mesh {
            mesh = plain.with_edges(first(self.edges, counts.edges));
        }
        if let (Ok(plain), true) = (mesh, counts.uvs > 0) {
            let values = first(self.uvs, counts.uvs);
            mesh = plain.with_uvs(values, own(self.uv_faces, counts.uv_faces));
        }
        if let (Ok(plain), true) = (mesh, counts.normals > 0) {
            let values = first(self.normals, counts.normals);
            mesh = plain.with_normals(values, own(self.normal_faces, counts.normal_faces));
        }
        if let (Ok(plain), true) = (mesh, counts.colors > 0) {
            mesh = plain.with_colors(first(self.colors, counts.colors), None);
        }
        mesh
    }
}

/// The lists of a mesh in arrays of just the right lengths, for a `static`; made by
/// [`include_obj!`](crate::include_obj) and [`shape!`](crate::shape).
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Arrays<
    const P: usize,
    const F: usize,
    const E: usize,
    const U: usize,
    const UF: usize,
    const N: usize,
    const NF: usize,
    const C: usize,
> {
    positions: [Vec3; P],
    faces: [[Index; 3]; F],
    edges: [[Index; 2]; E],
    uvs: [Vec2; U],
    uv_faces: [[Index; 3]; UF],
    normals: [Vec3; N],
    normal_faces: [[Index; 3]; NF],
    colors: [Rgb888; C],
}

impl<
    const P: usize,
    const F: usize,
    const E: usize,
    const U: usize,
    const UF: usize,
    const N: usize,
    const NF: usize,
    const C: usize,
> Arrays<P, F, E, U, UF, N, NF, C>
{
    pub const ZERO: Self = Self {
        positions: [Vec3::ZERO; P],
        faces: [[0; 3]; F],
        edges: [[0; 2]; E],
        uvs: [Vec2::from_bits([0; 2]); U],
        uv_faces: [[0; 3]; UF],
        normals: [Vec3::ZERO; N],
        normal_faces: [[0; 3]; NF],
        colors: [Rgb888::new(0, 0, 0); C],
    };

    /// Everything as room to fill.
    #[must_use]
    pub const fn buffers(&mut self) -> Buffers<'_> {
        Buffers {
            positions: &mut self.positions,
            faces: &mut self.faces,
            edges: &mut self.edges,
            uvs: &mut self.uvs,
            uv_faces: &mut self.uv_faces,
            normals: &mut self.normals,
            normal_faces: &mut self.normal_faces,
            colors: &mut self.colors,
        }
    }

    /// The first elements of each list, as many as the result has.
    ///
    /// # Panics
    ///
    /// If that is more than there are.
    #[must_use]
    pub const fn trim<
        const P2: usize,
        const F2: usize,
        const E2: usize,
        const U2: usize,
        const UF2: usize,
        const N2: usize,
        const NF2: usize,
        const C2: usize,
    >(
        &self,
    ) -> Arrays<P2, F2, E2, U2, UF2, N2, NF2, C2> {
        const fn chunk<T: Copy, const N: usize>(list: &[T]) -> [T; N] {
            *list.first_chunk().expect("a list is longer than its text")
        }
        Arrays {
            positions: chunk(&self.positions),
            faces: chunk(&self.faces),
            edges: chunk(&self.edges),
            uvs: chunk(&self.uvs),
            uv_faces: chunk(&self.uv_faces),
            normals: chunk(&self.normals),
            normal_faces: chunk(&self.normal_faces),
            colors: chunk(&self.colors),
        }
    }

    /// The positions in 16 bits each, and their fraction bits.
    #[must_use]
    pub const fn shortened(&self) -> ([[i16; 3]; P], u32) {
        match self.mesh().shortened() {
            Ok(short) => short,
            // There are as many as there are.
            Err(_) => ([[0; 3]; P], 0),
        }
    }

    /// The mesh of all elements.
    #[must_use]
    pub const fn mesh(&self) -> Mesh<'_> {
        self.mesh_of(Positions::long(&self.positions))
    }

    /// The mesh of all elements but positions, and of these in units of 2^-`fraction`.
    ///
    /// # Panics
    ///
    /// If there are not as many as the other lists need, or more than 16 fraction bits.
    #[must_use]
    pub const fn short_mesh<'a>(&'a self, positions: &'a [[i16; 3]], fraction: u32) -> Mesh<'a> {
        match Positions::short(positions, fraction) {
            Ok(positions) => self.mesh_of(positions),
            Err(error) => Mesh::checked(Err(error)),
        }
    }

    const fn mesh_of<'a>(&'a self, positions: Positions<'a>) -> Mesh<'a> {
        let counts = Counts {
            positions: positions.len(),
            faces: F,
            edges: E,
            uvs: U,
            uv_faces: UF,
            normals: N,
            normal_faces: NF,
            colors: C,
        };
        let lists = Lists {
            positions,
            faces: &self.faces,
            edges: &self.edges,
            uvs: &self.uvs,
            uv_faces: &self.uv_faces,
            normals: &self.normals,
            normal_faces: &self.normal_faces,
            colors: &self.colors,
        };
        Mesh::checked(lists.mesh(counts))
    }
}
