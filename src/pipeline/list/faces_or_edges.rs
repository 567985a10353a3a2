//! Faces and edges in one list.

#![allow(private_interfaces)] // of traits that only this crate calls

use core::cell::Cell;

use super::prepared::Run;
use super::{Filling, Listed};
use crate::canvas::{Blending, DepthTest};
use crate::mesh::{Indices, Mesh};
use crate::pipeline::Drawn;
use crate::pipeline::call::Call;
use crate::pipeline::edges::Edges;
use crate::pipeline::thing::{Target, Thing};
use crate::raster::{Blitter, Coverage};
use crate::sealed::Sealed;
use crate::shade::ShaderFor;
use crate::span::{Plain, Shading};
use crate::view::{AsMvp, ProjectionKind};

/// The faces or the edges of a mesh. Objects of this type let one list hold both faces and edges.
///
/// In a list that is sorted [back to front](crate::DrawList::prepare_back_to_front), the faces hide the edges behind
/// them, so hidden lines are removed without a depth buffer. If a face and its edges are equally far away, the object
/// that comes first in the slice is drawn first, so put the faces before the edges.
///
/// The edges may come from [`Mesh::edges`] or [`Mesh::outline`]. They cannot be anti-aliased.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
/// use fixel::{FacesOrEdges, Object};
///
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// const SIZE: (u32, u32) = (36, 20);
///
/// let view = Projection::perspective(deg!(36), SIZE, fx!(1), fx!(20))?
///     * Camera::look_at(vec3!(4, 4, 7), Vec3::ZERO, Vec3::Y)?;
/// let (faces, edges) = (FacesOrEdges::from(&BOX), BOX.edges(LineStyle::HAIRLINE).into());
/// let [off, on] = [BinaryColor::Off, BinaryColor::On].map(Flat::new);
/// let [far, near] = [vec3!(-1, 0, -1.5), vec3!(1, 0, 1.5)].map(Transform::translate);
/// let mut objects = [
///     Object::new(faces, far, off),
///     Object::new(edges, far, on),
///     Object::new(faces, near, off),
///     Object::new(edges, near, on),
/// ];
/// let mut list: DrawList<60, 60> = DrawList::new();
/// let scene = list.prepare_back_to_front(&DrawOptions::new(), SIZE, &mut objects, &view)?;
///
/// let mut pixels = [BinaryColor::Off; 36 * 20];
/// let mut canvas = Canvas::new(&mut pixels, 36, 20)?;
/// for (shader, part) in scene.parts(&canvas)? {
///     canvas.draw_prepared(&part, shader)?;
/// }
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "....................................",
///     "....................................",
///     "....................................",
///     "................##..................",
///     "..............##..####..............",
///     ".............#####.###..............",
///     ".............#....#..#..............",
///     ".............#..####.#..............",
///     ".............###....#####...........",
///     ".............#.........##...........",
///     "............###.......#.#...........",
///     "............#..###...#..#...........",
///     "............#.....###..#............",
///     "............#.......#..#............",
///     "............#.......#..#............",
///     "............#.......#..#............",
///     "............#.......#..#............",
///     "............##......#.#.............",
///     "..............##....##..............",
///     "................###.##..............",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub enum FacesOrEdges<'m> {
    /// The faces of a mesh.
    Faces(&'m Mesh<'m>),
    /// The result of [`Mesh::edges`] or [`Mesh::outline`].
    Edges(Edges<'m>),
}

impl<'m> From<&'m Mesh<'m>> for FacesOrEdges<'m> {
    fn from(mesh: &'m Mesh<'m>) -> Self {
        Self::Faces(mesh)
    }
}

impl<'m> From<Edges<'m>> for FacesOrEdges<'m> {
    fn from(edges: Edges<'m>) -> Self {
        Self::Edges(edges)
    }
}

impl Sealed for FacesOrEdges<'_> {}

impl<C> Thing<C> for FacesOrEdges<'_> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Plain<S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        match self {
            Self::Faces(mesh) => <&Mesh<'_> as Thing<C>>::draw(mesh, mvp, to),
            Self::Edges(edges) => <Edges<'_> as Thing<C>>::draw(edges, mvp, to),
        }
    }
}

impl Listed for FacesOrEdges<'_> {
    const ELEMENTS: &'static str = "triangles and edges";
    const REACH: i32 = <Edges<'static>>::REACH;

    fn mesh(&self) -> &Mesh<'_> {
        match self {
            Self::Faces(mesh) => mesh,
            Self::Edges(edges) => edges.mesh(),
        }
    }

    fn count(&self) -> usize {
        match self {
            Self::Faces(mesh) => mesh.count(),
            Self::Edges(edges) => edges.count(),
        }
    }

    fn indices(&self, element: usize) -> Option<Indices> {
        match self {
            Self::Faces(mesh) => mesh.indices(element),
            Self::Edges(edges) => edges.indices(element),
        }
    }

    fn fill<K: ProjectionKind>(&self, call: &Call<'_, K>, filling: &mut Filling<'_>) {
        match self {
            Self::Faces(mesh) => mesh.fill(call, filling),
            Self::Edges(edges) => edges.fill(call, filling),
        }
    }

    /// The rows of an edge, which include the rows of a triangle.
    fn rows(least: i32, most: i32) -> [i16; 2] {
        <Edges<'static>>::rows(least, most)
    }

    fn draw_listed(
        &self,
        run: &Run<'_>,
        blitter: &mut dyn Blitter,
        coverage: &Cell<Coverage>,
    ) -> Drawn {
        match self {
            Self::Faces(mesh) => mesh.draw_listed(run, blitter, coverage),
            Self::Edges(edges) => edges.draw_listed(run, blitter, coverage),
        }
    }
}
