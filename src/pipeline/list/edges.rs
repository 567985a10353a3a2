//! Edges prepared once for all bands of a frame.

use core::ops::Range;

use embedded_graphics::geometry::Size;
use heapless::{Vec, VecView};

use super::{Needed, PreparedCall, Slot, VertexWriter, vertex};
use crate::Error;
use crate::canvas::{DepthTest, Replace, TestAndWrite, check_size};
use crate::mesh::{Index, Mesh, Outline};
use crate::pipeline::cache::VertexCache;
use crate::pipeline::call::Call;
use crate::pipeline::line_style::DrawLine;
use crate::pipeline::options::PixelOptions;
use crate::pipeline::run::Draw;
use crate::pipeline::{DrawOptions, Drawn, outline, run};
use crate::raster::{Barycentric, Blitter, ClippedVertex, Hairline};
use crate::span::{Mode, Newton};
use crate::view::{AsMvp, Perspective, ProjectionKind};

/// Memory for the edges of a frame that is drawn in bands, like a [`TriangleList`](super::TriangleList) for triangles.
///
/// [`prepare`](Self::prepare) takes the edges of a mesh, [`prepare_outline`](Self::prepare_outline) the edges of an
/// [`Outline`] that are to be drawn, and [`prepare_scene`](Self::prepare_scene) the edges of several objects. The list
/// needs room for the visible edges (14 bytes each) and for their vertices (16 bytes each): at most two for each edge,
/// and four for a clipped one. It uses at most [`MAX_VERTICES`](Self::MAX_VERTICES).
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
///
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let projection = Projection::perspective(deg!(60), (2, 1), fx!(1), fx!(10))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -3)) * Transform::rotate_y(deg!(20));
///
/// let mut list: EdgeList<12, 24> = EdgeList::new(); // on a microcontroller, a static
/// let edges = list.prepare(&DrawOptions::new(), (24, 12), &BOX, &mvp)?;
///
/// let mut display = MockDisplay::new();
/// let mut color = [BinaryColor::Off; 24 * 4];
/// for first_row in [0, 4, 8] {
///     let mut band = Canvas::band(&mut color, 24, 12, first_row)?;
///     band.clear(BinaryColor::Off);
///     band.draw_prepared_edges(&edges, &Flat::new(BinaryColor::On))?; // nothing is transformed here
///     band.show(&mut display)?;
/// }
///
/// // The same picture, drawn at once.
/// let mut color = [BinaryColor::Off; 24 * 12];
/// let mut frame = Canvas::new(&mut color, 24, 12)?;
/// frame.draw_edges(&DrawOptions::new(), &BOX, &mvp, &Flat::new(BinaryColor::On));
/// let mut whole = MockDisplay::new();
/// frame.show(&mut whole)?;
/// display.assert_eq(&whole);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct EdgeList<const EDGES: usize, const VERTICES: usize> {
    pub(super) edges: Vec<Edge, EDGES>,
    pub(super) vertices: Vec<Slot, VERTICES>,
}

/// A visible edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// The mesh's positions at its ends.
    indices: [Index; 2],
    /// The rows that it passes, which may be above or below the frame: the first, and the one after the last.
    rows: [i16; 2],
    ends: Ends,
}

/// The numbers of an edge's ends in the list of vertices, counted from 1.
#[derive(Clone, Copy, Debug)]
enum Ends {
    /// An edge that is inside all planes: its two vertices.
    Whole([u16; 2]),
    /// A clipped edge: the first of its two ends, each a vertex and its barycentric weights.
    Clipped(u16),
}

/// A mesh's edges, ready to be drawn to every band of a frame.
///
/// [`EdgeList`] returns it, and [`Canvas::draw_prepared_edges`](crate::Canvas::draw_prepared_edges) draws it. It can be
/// shared with another core that draws other bands of the same frame.
#[derive(Clone, Copy, Debug)]
pub struct PreparedEdges<
    'a,
    K = Perspective,
    M = Newton,
    Z = TestAndWrite,
    B = Replace,
    L = Hairline,
> {
    pub(in crate::pipeline) call: PreparedCall<'a, K>,
    /// How many edges there were to choose from.
    pub(super) submitted: u32,
    pub(super) edges: &'a [Edge],
    pub(super) vertices: &'a [Slot],
    pub(in crate::pipeline) pixels: PixelOptions<M, Z, B>,
    pub(in crate::pipeline) line: L,
}

impl<const EDGES: usize, const VERTICES: usize> Default for EdgeList<EDGES, VERTICES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const EDGES: usize, const VERTICES: usize> EdgeList<EDGES, VERTICES> {
    /// The most vertices that a list can use, however long it is: 16-bit numbers count them from 1.
    pub const MAX_VERTICES: usize = u16::MAX as usize;

    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            edges: Vec::new(),
            vertices: Vec::new(),
        }
    }

    /// Transforms and clips a mesh's edges for a `frame` of this many columns and rows, as
    /// [`Canvas::draw_edges`](crate::Canvas::draw_edges) would for each of its bands. The previous contents of the list
    /// are dropped.
    ///
    /// # Errors
    ///
    /// [`Error::Full`], with the length that is needed, if the list is too short for the visible edges; [`Error::Size`]
    /// if a side of the frame is 0 or above [`MAX_SIZE`](crate::canvas::MAX_SIZE).
    pub fn prepare<'a, M: Mode, Z: DepthTest, B: Copy, L: Copy, V: AsMvp>(
        &'a mut self,
        options: &DrawOptions<M, Z, B, L>,
        frame: impl Into<Size>,
        mesh: &'a Mesh<'a>,
        mvp: &V,
    ) -> Result<PreparedEdges<'a, V::Kind, M, Z, B, L>, Error> {
        let all = |_: &Call<'_, _>, _: &mut VertexCache, _, &edge: &_| Some(edge);
        let edges = (mesh.edges(), all);
        self.prepare_chosen(options, frame.into(), (mesh, mvp), edges)
    }

    /// Prepares the edges of an outline that [`Canvas::draw_outline`](crate::Canvas::draw_outline) would draw.
    ///
    /// # Errors
    ///
    /// As for [`prepare`](Self::prepare).
    pub fn prepare_outline<'a, M: Mode, Z: DepthTest, B: Copy, L: Copy, V: AsMvp>(
        &'a mut self,
        options: &DrawOptions<M, Z, B, L>,
        frame: impl Into<Size>,
        mesh: &'a Mesh<'a>,
        outline: &Outline<'_>,
        mvp: &V,
    ) -> Result<PreparedEdges<'a, V::Kind, M, Z, B, L>, Error> {
        let edges = (outline.edges(), outline::ends_of(outline));
        self.prepare_chosen(options, frame.into(), (mesh, mvp), edges)
    }

    /// Prepares some edges.
    #[inline]
    fn prepare_chosen<'a, M: Mode, Z: DepthTest, B: Copy, L: Copy, V: AsMvp, E>(
        &'a mut self,
        options: &DrawOptions<M, Z, B, L>,
        frame: Size,
        (mesh, mvp): (&'a Mesh<'a>, &V),
        (edges, ends_of): (
            &[E],
            impl Fn(&Call<'_, V::Kind>, &mut VertexCache, usize, &E) -> Option<[Index; 2]>,
        ),
    ) -> Result<PreparedEdges<'a, V::Kind, M, Z, B, L>, Error> {
        check_size(frame.width, frame.height)?;
        self.edges.clear();
        self.vertices.clear();
        let screen = options.screen(frame);
        let call = Call::new(&screen, &(0..frame.height), mesh, mvp);
        let mut needed = Needed::default();
        let (list, vertices) = (&mut self.edges, &mut self.vertices);
        add(
            &call,
            (edges, ends_of),
            (list.as_mut_view(), vertices.as_mut_view()),
            &mut needed,
        );
        needed.check::<EDGES, VERTICES>("edges")?;
        Ok(PreparedEdges {
            call: PreparedCall::new(screen, mesh, mvp, call.projector.depth_shift()),
            submitted: edges.len() as u32,
            edges: &self.edges,
            vertices: &self.vertices,
            pixels: options.pixels,
            line: options.line,
        })
    }
}

/// Adds the visible ones of some edges to a list. Once it is full, they are only counted.
#[inline]
pub(super) fn add<K: ProjectionKind, E>(
    call: &Call<'_, K>,
    (edges, ends_of): (
        &[E],
        impl Fn(&Call<'_, K>, &mut VertexCache, usize, &E) -> Option<[Index; 2]>,
    ),
    (list, vertices): (&mut VecView<Edge>, &mut VecView<Slot>),
    needed: &mut Needed,
) {
    let mut vertices = VertexWriter::new(vertices, needed.vertices);
    run::each_edge(call, edges, ends_of, |indices, ends, is_clipped| {
        needed.elements += 1;
        // If there is no room, the list will not be used.
        let _ = list.push(Edge {
            indices,
            rows: rows_of(ends.map(|end| end.vertex.screen[1])),
            ends: if is_clipped {
                let [first, _] = ends.map(|end| vertices.add_clipped(end));
                Ends::Clipped(first)
            } else {
                Ends::Whole(ends.map(|end| vertices.number(&end.vertex)))
            },
        });
    });
    needed.vertices = vertices.needed;
}

impl Edge {
    /// The number of its first vertex, by which its object is found.
    pub(super) const fn first(&self) -> u16 {
        match self.ends {
            Ends::Whole([first, _]) | Ends::Clipped(first) => first,
        }
    }
}

/// The rows that an edge passes between two places in units of 1/256 row. They lie within the guard band, whose center
/// is at most 6144 rows from the frame's top.
fn rows_of([a, b]: [i32; 2]) -> [i16; 2] {
    [(a.min(b) >> 8) as i16, ((a.max(b) >> 8) + 1) as i16]
}

impl<'a, K, M, Z, B, L> PreparedEdges<'a, K, M, Z, B, L> {
    /// The same edges, with another way to blend their colors with those on the canvas.
    #[must_use]
    pub fn with_blending<A>(self, blending: A) -> PreparedEdges<'a, K, M, Z, A, L> {
        PreparedEdges {
            call: self.call,
            submitted: self.submitted,
            edges: self.edges,
            vertices: self.vertices,
            pixels: PixelOptions {
                mode: self.pixels.mode,
                depth: self.pixels.depth,
                blending,
            },
            line: self.line,
        }
    }

    /// The same edges, drawn with another style of lines.
    ///
    /// ```
    /// use fixel::{prelude::*, canvas::Replace};
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(60), (2, 1), fx!(1), fx!(10))?;
    /// let mvp = projection * Transform::translate(vec3!(0, 0, -3));
    /// let mut list: EdgeList<12, 24> = EdgeList::new();
    /// let thin = list.prepare(&DrawOptions::new(), (24, 12), &BOX, &mvp)?;
    /// let wide = thin.with_line(LineWidth::new(fx!(3))?);
    /// assert_eq!(wide.line().pixels(), 3);
    /// assert_eq!(wide.blending(), Replace);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn with_line<N>(self, line: N) -> PreparedEdges<'a, K, M, Z, B, N> {
        PreparedEdges {
            call: self.call,
            submitted: self.submitted,
            edges: self.edges,
            vertices: self.vertices,
            pixels: self.pixels,
            line,
        }
    }

    /// Returns how colors are blended with those on the canvas.
    #[must_use]
    pub const fn blending(&self) -> B
    where
        B: Copy,
    {
        self.pixels.blending
    }

    /// Returns how lines are drawn.
    #[must_use]
    pub const fn line(&self) -> L
    where
        L: Copy,
    {
        self.line
    }
}

impl<K: ProjectionKind, M, Z, B, L> PreparedEdges<'_, K, M, Z, B, L> {
    /// Draws the edges that are within `reach` of `rows`, a band of the frame, each by `line`.
    #[inline(never)]
    pub(in crate::pipeline) fn draw(
        &self,
        line: DrawLine<'_>,
        reach: i32,
        rows: &Range<u32>,
        blitter: &mut dyn Blitter,
    ) -> Drawn {
        let shared = self.call.shared(rows);
        let (mut draw, rows) = (Draw::new(blitter, &shared), &shared.scissor.rows);
        draw.drawn.submitted = self.submitted;
        for edge in self.edges {
            let [start, end] = edge.rows.map(i32::from);
            if (start - reach).max(rows.start) >= (end + reach).min(rows.end) {
                continue;
            }
            let Some([from, to]) = self.ends(edge.ends) else {
                continue;
            };
            let is_clipped = matches!(edge.ends, Ends::Clipped(_));
            let ends = [&from, &to];
            draw.edge(edge.indices, is_clipped, |raster| line(raster, ends));
        }
        draw.drawn()
    }

    fn ends(&self, ends: Ends) -> Option<[ClippedVertex; 2]> {
        let whole = |number: u16, barycentric: Barycentric| {
            Some(ClippedVertex {
                vertex: vertex(self.vertices, number)?,
                barycentric,
            })
        };
        match ends {
            Ends::Whole([a, b]) => {
                let [first, second, _] = Barycentric::CORNERS;
                Some([whole(a, first)?, whole(b, second)?])
            }
            Ends::Clipped(first) => {
                let clipped = |number: u16| match self.vertices.get(usize::from(number)) {
                    Some(&Slot::Barycentric(barycentric)) => whole(number, barycentric),
                    _ => None,
                };
                Some([clipped(first)?, clipped(first.wrapping_add(2))?])
            }
        }
    }
}
