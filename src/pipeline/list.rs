//! Lists that are prepared once for all bands of a frame: the code that lists of triangles and lists of edges share.
//!
//! [`triangles`] and [`edges`] hold a list of each kind, for one mesh; [`scene`] and [`edge_scene`] fill such a list
//! with several objects. [`painter`] sorts triangles from back to front.

mod edge_scene;
mod edges;
mod painter;
mod scene;
mod triangles;

pub use edge_scene::PreparedEdgeScene;
pub use edges::{EdgeList, PreparedEdges};
pub use scene::{Object, PreparedScene};
pub use triangles::{Prepared, TriangleList};

use core::marker::PhantomData;
use core::ops::Range;

use heapless::VecView;

use super::cache;
use super::call::{Screen, Shared};
use crate::Error;
use crate::math::Transform;
use crate::mesh::{Index, Mesh, Placement};
use crate::raster::{Barycentric, ClippedVertex, DepthShift, ScreenVertex};
use crate::view::{AsMvp, ProjectionKind};

/// A vertex on the screen, or the barycentric weights of the vertex before it.
///
/// It has fields of its own instead of a [`ScreenVertex`], so that the tag fits in between them.
#[derive(Clone, Copy, Debug)]
enum Slot {
    Vertex {
        screen: [i32; 2],
        q: u32,
        exponent: u8,
    },
    Barycentric(Barycentric),
}

impl From<ScreenVertex> for Slot {
    fn from(vertex: ScreenVertex) -> Self {
        Self::Vertex {
            screen: vertex.screen,
            q: vertex.q,
            exponent: vertex.exponent,
        }
    }
}

impl Slot {
    #[inline]
    fn vertex(self) -> Option<ScreenVertex> {
        match self {
            Self::Vertex {
                screen,
                q,
                exponent,
            } => Some(ScreenVertex {
                screen,
                q,
                exponent,
                ..ScreenVertex::UNSET
            }),
            Self::Barycentric(_) => None,
        }
    }
}

/// The part of a draw call's mesh, transforms and options that is still needed once its primitives are in a list.
#[derive(Clone, Copy, Debug)]
pub(super) struct PreparedCall<'a, K> {
    mesh: &'a Mesh<'a>,
    model: Transform,
    model_view: Transform,
    kind: PhantomData<K>,
    pub(super) screen: Screen,
    pub(super) depth_shift: DepthShift,
}

impl<'a, K: ProjectionKind> PreparedCall<'a, K> {
    #[inline]
    fn new<V: AsMvp<Kind = K>>(
        screen: Screen,
        mesh: &'a Mesh<'a>,
        mvp: &V,
        depth_shift: DepthShift,
    ) -> Self {
        Self {
            mesh,
            model: *mvp.model_of(),
            model_view: mvp.model_view_of(),
            kind: PhantomData,
            screen,
            depth_shift,
        }
    }

    /// The data shared by the primitives that meet `rows`.
    #[inline]
    fn shared(&self, rows: &Range<u32>) -> Shared<'_> {
        Shared {
            mesh: self.mesh,
            placement: Placement::new(&self.model, self.model_view),
            cull: self.screen.cull,
            scissor: self.screen.scissor(rows),
        }
    }
}

/// How many elements a list must have room for.
#[derive(Clone, Copy, Debug, Default)]
struct Needed {
    elements: usize,
    vertices: usize,
}

impl Needed {
    /// An error unless a list of this length, of this kind of element, has room.
    #[inline]
    fn check<const ELEMENTS: usize, const VERTICES: usize>(
        &self,
        of: &'static str,
    ) -> Result<(), Error> {
        let most = TriangleList::<ELEMENTS, VERTICES>::MAX_VERTICES;
        for (of, needed, room) in [
            (of, self.elements, ELEMENTS),
            ("vertices", self.vertices, VERTICES.min(most)),
        ] {
            if needed > room {
                return Err(Error::Full { of, needed, room });
            }
        }
        Ok(())
    }
}

/// The vertices of a list that is being filled. Once it is full, they are only counted.
struct VertexWriter<'l> {
    slots: &'l mut VecView<Slot>,
    needed: usize,
    /// Recently added positions, each with its vertex's number in the list, counted from 1; 0 means none.
    numbers: [(Index, u16); cache::SIZE],
}

impl<'l> VertexWriter<'l> {
    /// Continues a list that has needed `needed` vertices.
    #[inline]
    fn new(slots: &'l mut VecView<Slot>, needed: usize) -> Self {
        Self {
            slots,
            needed,
            numbers: [(0, 0); cache::SIZE],
        }
    }

    /// Adds a vertex and returns its number, which is wrong if there is no room.
    fn add(&mut self, slot: Slot) -> u16 {
        self.needed += 1;
        let _ = self.slots.push(slot);
        self.needed as u16
    }

    /// Adds a corner that clipping made, and returns its vertex's number; the weights follow.
    fn add_clipped(&mut self, corner: &ClippedVertex) -> u16 {
        let number = self.add(corner.vertex.into());
        self.add(Slot::Barycentric(corner.barycentric));
        number
    }

    /// The number of a vertex; it is added unless it was added recently.
    fn number(&mut self, vertex: &ScreenVertex) -> u16 {
        let slot = usize::from(vertex.index) % cache::SIZE;
        let (index, number) = self.numbers[slot];
        if number != 0 && index == vertex.index {
            return number;
        }
        let number = self.add((*vertex).into());
        self.numbers[slot] = (vertex.index, number);
        number
    }
}

/// The vertex of this number.
#[inline]
fn vertex(slots: &[Slot], number: u16) -> Option<ScreenVertex> {
    let slot = slots.get(usize::from(number).wrapping_sub(1))?;
    slot.vertex()
}
