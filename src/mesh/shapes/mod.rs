//! Generated shapes: meshes that need no file.

mod surface;
#[cfg(test)]
mod tests;
mod writer;

use core::ops::Bound::{Excluded, Included, Unbounded};

use super::{Buffers, Counts, Index, Mesh};
use crate::error::{Error, check_count, check_range, ok};
use crate::math::Vec3;
use crate::num::Scalar;
use surface::{Profile, Row, Surface, row_count};
use writer::MeshWriter;

/// A generated shape. [`shape!`](crate::shape) turns a shape into a mesh in flash, and [`build`](Self::build) turns it
/// into a mesh in the caller's memory.
///
#[cfg_attr(doc, doc = page_picture!("shapes", "A box, a sphere, a torus, a square; a cylinder, a cone, a disc, a vase from a lathe"))]
/// | constructor | shape |
/// |---|---|
/// | [`cuboid`](Self::cuboid) | a box |
/// | [`sphere`](Self::sphere), [`torus`](Self::torus), [`cylinder`](Self::cylinder), [`cone`](Self::cone) | closed bodies around the y axis |
/// | [`plane`](Self::plane), [`disc`](Self::disc) | surfaces that face up |
/// | [`lathe`](Self::lathe) | a surface of revolution: a profile of yours, turned around the y axis |
///
/// All shapes except a lathe are centered on the origin. Shapes have positions, unit normals, texture coordinates from
/// 0 to 1, and edges, which form a wireframe without the diagonals of quads. Triangles are counter-clockwise as seen
/// from outside. Where texture coordinates or normals change abruptly, positions are stored more than once, except in a
/// cuboid. To resize a shape, scale it with a [`Transform`](crate::Transform).
///
/// ```
/// use fixel::mesh::{Buffers, Shape};
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(32, 32));
/// assert_eq!((BALL.positions().len(), BALL.faces().len()), (33 * 33, 1984));
///
/// // The same at run time, here without attributes.
/// let mut positions = [Vec3::ZERO; 33 * 33];
/// let mut faces = [[0; 3]; 1984];
/// let ball = Shape::sphere(32, 32)?.build(Buffers::new(&mut positions, &mut faces))?;
/// assert_eq!(ball.positions(), BALL.positions());
/// # Ok::<(), Error>(())
/// ```
#[cfg_attr(doc, doc = include_str!("../../guide/tables.html"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shape<'p> {
    surface: Surface<'p>,
    /// The size of the grid that is bent to the surface; 0 for a cuboid, which is not a grid. The profile of a lathe has
    /// the rows.
    columns: u32,
    rows: u32,
}

const fn parts(of: &'static str, given: u32, min: usize) -> Result<(), Error> {
    check_count(of, given as usize, [min, Shape::MAX_PARTS as usize])
}

/// The profiles of the shapes that are made on a lathe.
const CYLINDER: &Profile = &[(Scalar::ONE, Scalar::ONE), (Scalar::ONE, DOWN)];
const CONE: &Profile = &[
    (Scalar::ZERO, Scalar::ONE),
    (Scalar::ZERO, Scalar::ONE),
    (Scalar::ONE, DOWN),
];
const DOWN: Scalar = Scalar::from_bits(-Scalar::ONE.to_bits());

impl Shape<'static> {
    /// The most slices, stacks, sides, columns, rows or points of a shape. Indices have 16 bits. So a sphere of this
    /// many slices has at most 2 stacks, a plane of this many columns or rows has at most 2 parts in the other
    /// direction, and a torus or a cylinder has at most one slice less.
    pub const MAX_PARTS: u32 = 16_384;

    /// A box from −`corner` to `corner`; the texture fills each of its six sides.
    ///
    /// A side is two triangles. The sides follow each other in the order front (z), right (x), back (−z), left (−x),
    /// top (y), bottom (−y), so [`Mesh::part`] can select each side, to be drawn with its own texture. Scaled by −1
    /// along x, a box becomes a sky box: a viewer inside it sees its sides and its textures the right way round.
    ///
    /// The sides share the box's 8 positions. Texture coordinates and normals belong to sides, so a position or an edge
    /// that is drawn alone has none.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if a component of `corner` is not above 0.
    pub const fn cuboid(corner: Vec3) -> Result<Self, Error> {
        let above_0 = (Excluded(Scalar::ZERO), Unbounded);
        let checks = [
            check_range("half the width of the box", corner.x, above_0),
            check_range("half the height of the box", corner.y, above_0),
            check_range("half the depth of the box", corner.z, above_0),
        ];
        Self::of(Surface::Cuboid(corner), [0; 2], &checks)
    }

    /// A sphere of radius 1 with its poles on the y axis.
    ///
    /// It has `slices` sides around the axis, from +z toward +x, and `stacks` rows from the upper pole to the lower.
    /// The texture wraps around the sphere once.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there are fewer than 3 slices or 2 stacks, or if the (`slices` + 1)(`stacks` + 1) positions
    /// are more than 65,536.
    pub const fn sphere(slices: u32, stacks: u32) -> Result<Self, Error> {
        let checks = [parts("slices", slices, 3), parts("stacks", stacks, 2)];
        Self::of(Surface::Sphere, [slices, stacks], &checks)
    }

    /// A torus around the y axis: a tube of radius `tube` around a circle of radius 1.
    ///
    /// The torus has `slices` sides around the axis and `sides` around the tube. The texture wraps once around the axis
    /// and once around the tube, with its seam on the inside.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there are fewer than 3 slices or sides; [`Error::OutOfRange`] unless 0 < `tube` < 1;
    /// [`Error::Count`] if the (`slices` + 1)(`sides` + 1) positions are more than 65,536.
    pub const fn torus(tube: Scalar, slices: u32, sides: u32) -> Result<Self, Error> {
        let radii = (Excluded(Scalar::ZERO), Excluded(Scalar::ONE));
        let checks = [
            check_range("tube radius", tube, radii),
            parts("slices", slices, 3),
            parts("sides", sides, 3),
        ];
        Self::of(Surface::Torus(tube), [slices, sides], &checks)
    }

    /// A horizontal square from −1 to 1 in x and z that faces up, as a grid of `columns` along x and `rows` along z.
    /// The texture fills the square; the top edge of the texture is at z = −1.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there is no column or no row; [`Error::Count`] if the (`columns` + 1)(`rows` + 1)
    /// positions are more than 65,536.
    pub const fn plane(columns: u32, rows: u32) -> Result<Self, Error> {
        let checks = [parts("columns", columns, 1), parts("rows", rows, 1)];
        Self::of(Surface::Plane, [columns, rows], &checks)
    }

    /// A closed cylinder of radius 1 around the y axis, from y = −1 to y = 1, with `slices` sides.
    ///
    /// The texture wraps around the side once, and each cap shows a disc cut from the texture.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there are fewer than 3 slices; [`Error::Count`] if the 4(`slices` + 1) positions are more
    /// than 65,536.
    pub const fn cylinder(slices: u32) -> Result<Self, Error> {
        let surface = Surface::Lathe(CYLINDER, [Some(Scalar::ONE), Some(DOWN)]);
        Self::of(surface, [slices, 0], &[parts("slices", slices, 3)])
    }

    /// A closed cone around the y axis, with its tip at y = 1 and a base of radius 1 at y = −1, with `slices` sides.
    ///
    /// The texture wraps around the side once, with its upper edge at the tip, and the base shows a disc cut from the
    /// texture.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// static ROOF: Mesh = shape!(cone(12));
    /// assert_eq!(ROOF.faces().len(), 12 + 12); // side, base
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there are fewer than 3 slices; [`Error::Count`] if the 3(`slices` + 1) positions are more
    /// than 65,536.
    pub const fn cone(slices: u32) -> Result<Self, Error> {
        let surface = Surface::Lathe(CONE, [None, Some(DOWN)]);
        Self::of(surface, [slices, 0], &[parts("slices", slices, 3)])
    }

    /// A horizontal disc of radius 1 at y = 0 that faces up, with `slices` sides. It shows a disc cut from the texture:
    /// the part that a [`plane`](Self::plane) shows in this place.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// static COIN: Mesh = shape!(disc(16));
    /// assert_eq!((COIN.positions().len(), COIN.faces().len()), (17, 16));
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there are fewer than 3 slices.
    pub const fn disc(slices: u32) -> Result<Self, Error> {
        let surface = Surface::Lathe(&[], [Some(Scalar::ZERO), None]);
        Self::of(surface, [slices, 0], &[parts("slices", slices, 3)])
    }
}

impl<'p> Shape<'p> {
    /// A surface of revolution: a profile, turned around the y axis in `slices` steps, as on a potter's wheel or a
    /// lathe.
    ///
    /// The profile is a list of points (distance from the axis, height). Imagine a drawing of the right half of the
    /// shape, and list the points of its outside from the top to the bottom. Where the points lead upward, they
    /// describe an inside, for example of a cup. The surface is closed if the first and the last point are on the axis,
    /// or if they are the same.
    ///
    /// The surface is smooth. **A point that is repeated makes an edge there**; on the axis, it makes a tip. The texture
    /// wraps around the axis once, and runs down the profile in proportion to its length.
    ///
    /// ```
    /// use fixel::mesh::Shape;
    /// use fixel::prelude::*;
    ///
    /// /// A pawn: a ball, a collar with an edge above and below, a foot, and a flat bottom.
    /// const PAWN: &[(Scalar, Scalar)] = &[
    ///     (fx!(0), fx!(1)), (fx!(0.3), fx!(0.85)), (fx!(0.35), fx!(0.6)), (fx!(0.2), fx!(0.4)),
    ///     (fx!(0.2), fx!(0.4)), (fx!(0.45), fx!(0.35)),
    ///     (fx!(0.45), fx!(0.35)), (fx!(0.2), fx!(0.3)), (fx!(0.3), fx!(-0.5)), (fx!(0.6), fx!(-1)),
    ///     (fx!(0.6), fx!(-1)), (fx!(0), fx!(-1)),
    /// ];
    /// static MESH: Mesh = shape!(lathe(16, PAWN));
    /// // Two triangles for each slice of a part, none where a point is repeated, and one at each end.
    /// assert_eq!(MESH.faces().len(), 16 * (1 + 2 * 6 + 1));
    ///
    /// // At run time, from a profile in memory.
    /// let bowl = [(fx!(1), fx!(0.5)), (fx!(0.7), fx!(-0.2)), (fx!(0), fx!(-0.5))];
    /// assert_eq!(Shape::lathe(12, &bowl)?.counts().faces, 12 * (2 + 1));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if there are fewer than 3 slices or 2 points; [`Error::OutOfRange`] if a distance from the axis
    /// is below 0; [`Error::Count`] if the (`slices` + 1) positions of each point are more than 65,536 in all.
    pub const fn lathe(slices: u32, profile: &'p [(Scalar, Scalar)]) -> Result<Self, Error> {
        let most = Shape::MAX_PARTS as usize;
        ok!(check_count("points", profile.len(), [2, most]));
        let mut at = 0;
        while at < profile.len() {
            let from_0 = (Included(Scalar::ZERO), Unbounded);
            ok!(check_range("distance from the axis", profile[at].0, from_0));
            at += 1;
        }
        let surface = Surface::Lathe(profile, [None; 2]);
        Self::of(surface, [slices, 0], &[parts("slices", slices, 3)])
    }

    const fn of(
        surface: Surface<'p>,
        [columns, rows]: [u32; 2],
        checks: &[Result<(), Error>],
    ) -> Result<Self, Error> {
        let mut i = 0;
        while i < checks.len() {
            ok!(checks[i]);
            i += 1;
        }
        let shape = Self {
            surface,
            columns,
            rows,
        };
        ok!(check_count(
            "positions",
            shape.counts().positions,
            [0, Mesh::MAX_POSITIONS]
        ));
        Ok(shape)
    }

    /// The number of elements of the mesh, for which [`build`](Self::build) needs room.
    #[must_use]
    pub const fn counts(self) -> Counts {
        // The factors are below 2^15, so products fit into 32 bits.
        let Self { columns, rows, .. } = self;
        let grid = (columns + 1) * (rows + 1);
        let [uv_faces, normal_faces] = surface::own_faces(&self);
        let (positions, faces, edges) = match self.surface {
            Surface::Cuboid(_) => (8, 12, 12),
            Surface::Sphere => (grid, 2 * columns * (rows - 1), columns * (2 * rows - 1)),
            Surface::Torus(_) => (grid, 2 * columns * rows, 2 * columns * rows),
            Surface::Plane => (
                grid,
                2 * columns * rows,
                2 * columns * rows + columns + rows,
            ),
            Surface::Lathe(_, discs) => {
                let discs = discs[0].is_some() as u32 + discs[1].is_some() as u32;
                let count = row_count(&self);
                let rims = if count == 0 { discs } else { 0 };
                let (mut faces, mut edges) = (discs * columns, rims * columns);
                let mut row = 0;
                while row < count {
                    let row_has = Row::of(&self, row);
                    let [lower, upper] = row_has.triangles;
                    faces += columns * (lower as u32 + upper as u32);
                    edges += columns * (row_has.has_edge as u32 + row_has.has_edge_down as u32);
                    row += 1;
                }
                ((count + discs) * (columns + 1), faces, edges)
            }
        };
        let positions = positions as usize;
        let [uvs, normals] = match self.surface {
            Surface::Cuboid(_) => [4, 6],
            _ => [positions; 2],
        };
        Counts {
            positions,
            faces: faces as usize,
            edges: edges as usize,
            uvs,
            uv_faces: uv_faces.len(),
            normals,
            normal_faces: normal_faces.len(),
            colors: 0,
        }
    }

    /// Builds the mesh in the caller's memory. The mesh lacks each optional list for which `buffers` has an empty
    /// slice.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] if the slice for positions or for faces is shorter than [`counts`](Self::counts) says, or
    /// if another slice is shorter but not empty.
    pub const fn build(self, buffers: Buffers<'_>) -> Result<Mesh<'_>, Error> {
        let mut writer = ok!(MeshWriter::new(buffers, self.counts()));
        surface::write(&mut writer, &self);
        writer
            .buffers
            .mesh(writer.counts, surface::own_faces(&self))
    }

    /// The triangles as indices of texture coordinates and of normals; empty if both have the indices of the positions.
    #[doc(hidden)]
    #[must_use]
    pub const fn own_faces(self) -> [&'static [[Index; 3]]; 2] {
        surface::own_faces(&self)
    }
}

/// A mesh of a [`Shape`](crate::mesh::Shape), built at compile time and stored in flash.
///
/// The argument is a constructor of `Shape` with constant arguments: [`cuboid`](crate::mesh::Shape::cuboid) (from half
/// of its size), [`sphere`](crate::mesh::Shape::sphere), [`torus`](crate::mesh::Shape::torus),
/// [`plane`](crate::mesh::Shape::plane), [`cylinder`](crate::mesh::Shape::cylinder),
/// [`cone`](crate::mesh::Shape::cone), [`disc`](crate::mesh::Shape::disc) or [`lathe`](crate::mesh::Shape::lathe).
/// Arguments that the constructor refuses do not compile.
///
/// ```
/// use fixel::prelude::*;
/// static CRATE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// static RING: Mesh = shape!(torus(fx!(0.25), 24, 12));
/// assert!(CRATE.has_uvs() && RING.has_normals());
/// ```
///
/// A second argument, `quantized`, stores 16-bit positions, which take half the flash; see
/// [`Mesh::quantized`](crate::Mesh::quantized). With `quantized_8`, [attributes take less
/// flash](crate::mesh#less-flash), too.
///
/// ```
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(16, 12), quantized); // steps of 2^-14
/// assert_eq!(BALL.positions().get(0), Some(vec3!(0, 1, 0)));
/// ```
/// ```compile_fail
/// static TWO_SIDED: fixel::Mesh = fixel::shape!(cylinder(2));
/// ```
#[macro_export]
macro_rules! shape {
    ($name:ident($($argument:expr),* $(,)?) $(, $format:ident)? $(,)?) => {{
        const SHAPE: $crate::mesh::Shape<'static> = $crate::mesh::flash::checked(
            $crate::mesh::Shape::$name($($argument),*),
            ::core::stringify!($name($($argument),*)),
        );
        const COUNTS: $crate::mesh::Counts = SHAPE.counts();
        #[allow(long_running_const_eval)]
        // The constant is a reference, because each use of a constant copies its value.
        const ROOM: &$crate::mesh::flash::Room<{ COUNTS.positions + COUNTS.faces + COUNTS.edges }> = &{
            let mut room = $crate::mesh::flash::Room::EMPTY;
            let _ = $crate::Mesh::checked(SHAPE.build(room.buffers()));
            room
        };
        $crate::__mesh!(ROOM, COUNTS, SHAPE.own_faces() $(, $format)?)
    }};
}
