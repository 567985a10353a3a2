//! The stages of a draw call, in order.
//!
//! ```text
//! mesh ─▶ vertex ─▶ assemble ─▶ raster ─▶ blit ─▶ canvas
//! ```
//!
//! Vertices are projected once and kept for neighboring triangles ([`vertex`](super::vertex), [`VertexCache`]).
//! Triangles are culled and clipped ([`assemble`]). The rest becomes spans of pixels ([`raster`]), which become
//! colors ([`Blitter`]).

use super::Drawn;
use super::assemble::{self, Assembly};
use super::cache::VertexCache;
use super::call::{Call, Shared};
use super::clip::ClippedPolygon;
use crate::mesh::{Index, Indices, Primitive};
use crate::raster::{self, Blitter, ClippedVertex, Polygon, Rasterizer, ScreenVertex, Triangle};
use crate::view::ProjectionKind;

/// Runs all triangles of a mesh through the vertex and assembly stages; `to` draws them or keeps them in a list.
#[inline]
pub(super) fn triangles<K: ProjectionKind>(call: &Call<'_, K>, to: &mut impl Assembly) {
    // Before the faces are found: this takes fewer registers on Cortex-M0+.
    let mut vertices = VertexCache::new();
    triangles_from(call, (0, call.shared.mesh.faces()), &mut vertices, to);
}

/// Runs triangles, the first of which has the index `first`, with the caller's cache.
#[inline]
fn triangles_from<K: ProjectionKind>(
    call: &Call<'_, K>,
    (first, faces): (usize, &[[Index; 3]]),
    vertices: &mut VertexCache,
    to: &mut impl Assembly,
) {
    for (face, indices) in (first..).zip(faces) {
        assemble::triangle(call, vertices, (face, indices), to);
    }
}

/// Runs edges through the vertex and assembly stages. `ends_of` returns the positions of an edge, or nothing if it is
/// not to be drawn; `each` receives the two ends of its part that is inside all planes, and whether it was clipped.
#[inline]
pub(super) fn each_edge<K: ProjectionKind, E>(
    call: &Call<'_, K>,
    edges: &[E],
    ends_of: impl Fn(&Call<'_, K>, &mut VertexCache, usize, &E) -> Option<[Index; 2]>,
    mut each: impl FnMut([Index; 2], [&ClippedVertex; 2], bool),
) {
    let mut vertices = VertexCache::new();
    for (at, edge) in edges.iter().enumerate() {
        let Some(indices) = ends_of(call, &mut vertices, at, edge) else {
            continue;
        };
        let mut line = ClippedPolygon::new();
        let is_clipped = assemble::edge(call, &mut vertices, indices, &mut line);
        if let [from, to] = &*line {
            each(indices, [from, to], is_clipped);
        }
    }
}

/// Draws edges, each by `line`.
#[inline]
pub(super) fn lines<K: ProjectionKind, E>(
    call: &Call<'_, K>,
    blitter: &mut dyn Blitter,
    edges: &[E],
    ends_of: impl Fn(&Call<'_, K>, &mut VertexCache, usize, &E) -> Option<[Index; 2]>,
    line: impl Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]),
) -> Drawn {
    let mut draw = Draw::new(blitter, &call.shared);
    draw.drawn.submitted = edges.len() as u32;
    each_edge(call, edges, ends_of, |indices, ends, is_clipped| {
        draw.edge(indices, is_clipped, |raster| line(raster, ends));
    });
    draw.drawn()
}

/// Draws all edges of a mesh as lines.
#[inline(never)]
pub(super) fn edges<K: ProjectionKind>(
    call: &Call<'_, K>,
    line: impl Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]),
    blitter: &mut dyn Blitter,
) -> Drawn {
    let edges = call.shared.mesh.edges();
    lines(call, blitter, edges, |_, _, _, &edge| Some(edge), line)
}

/// Draws all positions of a mesh that are inside all planes, each by `point`.
#[inline]
pub(super) fn each_point<K: ProjectionKind>(
    call: &Call<'_, K>,
    blitter: &mut dyn Blitter,
    point: impl Fn(&mut Rasterizer<'_>, &ScreenVertex),
) -> Drawn {
    let count = call.shared.mesh.positions().len() as u32;
    let mut draw = Draw::new(blitter, &call.shared);
    draw.drawn.submitted = count;
    for index in 0..count {
        // A mesh has at most 65,536 positions.
        let index = index as Index;
        let mut at = ScreenVertex::UNSET;
        call.projector.project(index, &mut at);
        if at.outcode == 0 {
            draw.edge([index; 2], false, |raster| point(raster, &at));
        }
    }
    draw.drawn()
}

/// Draws all positions of a mesh as points.
#[inline(never)]
pub(super) fn points<K: ProjectionKind>(call: &Call<'_, K>, blitter: &mut dyn Blitter) -> Drawn {
    each_point(call, blitter, raster::point)
}

/// Draws all triangles of a mesh, in code that exists once for all shaders and canvases.
#[inline(never)]
pub(super) fn draw<K: ProjectionKind>(call: &Call<'_, K>, blitter: &mut dyn Blitter) -> Drawn {
    let mut draw = Draw::new(blitter, &call.shared);
    triangles(call, &mut draw);
    draw.drawn()
}

/// Whether one plane goes through the varyings of both triangles of a rectangle.
pub(super) type IsPlane<'p> = &'p dyn Fn([&Primitive<'_>; 2]) -> bool;

/// Draws quads: the triangles of a mesh in pairs, the first of which has the index `first`. The cache must hold no
/// vertices of other meshes. If quads are upright rectangles on the screen, each at one depth, `is_plane` tells which
/// of them to draw as one primitive.
#[inline(never)]
pub(super) fn quads<K: ProjectionKind>(
    call: &Call<'_, K>,
    first: usize,
    vertices: &mut VertexCache,
    is_plane: Option<IsPlane<'_>>,
    blitter: &mut dyn Blitter,
) -> Drawn {
    let mut draw = Draw::new(blitter, &call.shared);
    let pairs = call.shared.mesh.faces().chunks_exact(2);
    for (at, pair) in (first..).step_by(2).zip(pairs) {
        let is_done =
            is_plane.is_some_and(|is_plane| rectangle(call, (at, pair), is_plane, &mut draw));
        if !is_done {
            triangles_from(call, (at, pair), vertices, &mut draw);
        }
    }
    draw.drawn()
}

/// Draws two triangles that are an upright rectangle at one depth, from the first corner of the first one to the last
/// corner of the second one; returns whether it is done.
#[inline]
fn rectangle<K: ProjectionKind>(
    call: &Call<'_, K>,
    (first, faces): (usize, &[[Index; 3]]),
    is_plane: IsPlane<'_>,
    draw: &mut Draw<'_>,
) -> bool {
    let &[one, other] = faces else {
        return false;
    };
    let ([a, ..], [.., d]) = (one, other);
    let [mut from, mut to] = [ScreenVertex::UNSET; 2];
    call.projector.project(a, &mut from);
    call.projector.project(d, &mut to);
    // The other two corners have the coordinates of these.
    if from.outcode | to.outcode != 0 {
        return from.outcode & to.outcode != 0;
    }
    let ([left, bottom], [right, top]) = (from.screen, to.screen);
    let corner = |screen| ScreenVertex { screen, ..from };
    let (b, c) = (corner([right, bottom]), corner([left, top]));
    let area = raster::area(&[from.screen, b.screen, c.screen]);
    let Some(half) = &Triangle::new([&from, &b, &c], None, area, &call.shared.scissor) else {
        return true;
    };
    let shared = &call.shared;
    let (one, other) = (
        Indices::of_face(first, one),
        Indices::of_face(first + 1, other),
    );
    let is_plane = is_plane([&shared.primitive(one), &shared.primitive(other)]);
    if is_plane {
        draw.start(one);
        draw.raster.rectangle(half);
        draw.drawn.drawn += 2;
    }
    is_plane
}

/// Draws assembled triangles.
pub(super) struct Draw<'d> {
    raster: Rasterizer<'d>,
    shared: &'d Shared<'d>,
    pub(super) drawn: Drawn,
}

impl<'d> Draw<'d> {
    #[inline]
    pub(super) fn new(blitter: &'d mut dyn Blitter, shared: &'d Shared<'d>) -> Self {
        Self {
            raster: Rasterizer::new(blitter, &shared.scissor),
            shared,
            drawn: Drawn {
                submitted: shared.mesh.faces().len() as u32,
                ..Drawn::default()
            },
        }
    }

    /// The result of the draw call.
    #[inline]
    pub(super) fn drawn(self) -> Drawn {
        Drawn {
            missing: self.shared.placement.missing(),
            ..self.drawn
        }
    }

    #[inline]
    fn start(&mut self, indices: Indices) {
        self.raster
            .blitter
            .primitive(&self.shared.primitive(indices));
    }

    /// Draws an edge, or a point if both ends are the same, by `line`.
    #[inline]
    pub(super) fn edge(
        &mut self,
        ends: [Index; 2],
        is_clipped: bool,
        line: impl FnOnce(&mut Rasterizer<'d>),
    ) {
        self.start(Indices::of_edge(ends));
        line(&mut self.raster);
        self.drawn.drawn += 1;
        self.drawn.clipped += u32::from(is_clipped);
    }
}

impl Assembly for Draw<'_> {
    #[inline]
    fn whole(&mut self, indices: Indices, corners: [&ScreenVertex; 3], area: i64) {
        // By reference: moved, it would be copied.
        if let Some(triangle) = &Triangle::new(corners, None, area, &self.shared.scissor) {
            self.start(indices);
            self.raster.triangle(triangle, None);
            self.drawn.drawn += 1;
        }
    }

    #[inline(never)]
    fn clipped(&mut self, indices: Indices, polygon: &[ClippedVertex]) {
        if let Some(polygon) = Polygon::new(polygon, self.shared.cull) {
            self.start(indices);
            let drawn = u32::from(polygon.draw(&mut self.raster));
            self.drawn.drawn += drawn;
            self.drawn.clipped += drawn;
        }
    }
}
