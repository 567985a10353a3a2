//! Outlines, which choose among the edges of a mesh, and lines of a width.

use super::Drawn;
use super::assemble;
use super::cache::VertexCache;
use super::call::Call;
use super::clip::ClippedPolygon;
use crate::mesh::{Element, Index, Outline};
use crate::raster::{self, Blitter, ClippedVertex, LineWidth, Rasterizer};
use crate::view::ProjectionKind;

/// Draws a line between two ends.
pub(super) type DrawLine<'l> = &'l dyn Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]);

/// Draws the creases, silhouettes and borders of an outline that belong to a face that is not culled.
#[inline(never)]
pub(super) fn outline<K: ProjectionKind>(
    call: &Call<'_, K>,
    outline: &Outline<'_>,
    line: DrawLine<'_>,
    blitter: &mut dyn Blitter,
) -> Drawn {
    let mut drawn = Drawn::default();
    let mut raster = Rasterizer::new(blitter, &call.shared.scissor);
    let mut vertices = VertexCache::new();
    for (at, &edge) in outline.edges().iter().enumerate() {
        drawn.submitted += 1;
        if !is_drawn(call, &mut vertices, edge, at < outline.creases()) {
            continue;
        }
        let [a, b, ..] = edge;
        draw(call, &mut vertices, [a, b], line, (&mut raster, &mut drawn));
    }
    drawn.missing = call.shared.placement.missing();
    drawn
}

/// Draws all edges of a mesh as lines of a width.
#[inline(never)]
pub(super) fn wide_edges<K: ProjectionKind>(
    call: &Call<'_, K>,
    width: LineWidth,
    blitter: &mut dyn Blitter,
) -> Drawn {
    let mut drawn = Drawn::default();
    let mut raster = Rasterizer::new(blitter, &call.shared.scissor);
    let mut vertices = VertexCache::new();
    let line = |raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]| {
        raster::wide_line(raster, ends, width);
    };
    for &edge in call.shared.mesh.edges() {
        drawn.submitted += 1;
        draw(call, &mut vertices, edge, &line, (&mut raster, &mut drawn));
    }
    drawn.missing = call.shared.placement.missing();
    drawn
}

/// Draws one edge and counts it.
#[inline(never)]
fn draw<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache,
    [a, b]: [Index; 2],
    line: DrawLine<'_>,
    (raster, drawn): (&mut Rasterizer<'_>, &mut Drawn),
) {
    let mut ends = ClippedPolygon::new();
    let is_clipped = assemble::edge(call, vertices, [a, b], &mut ends);
    if let [from, to] = &*ends {
        raster.start(&call.shared.primitive(Element {
            face: None,
            indices: [a, b, b],
        }));
        line(raster, [from, to]);
        drawn.drawn += 1;
        drawn.clipped += u32::from(is_clipped);
    }
}

/// Whether an edge is drawn, from how its faces are turned.
#[inline]
fn is_drawn<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache,
    [a, b, c, d]: [Index; 4],
    is_crease: bool,
) -> bool {
    let cull = call.shared.cull;
    let left = assemble::area(call, vertices, [a, b, c]);
    // A border has no second face, and that face no area.
    let right = if d == a {
        0
    } else {
        assemble::area(call, vertices, [b, a, d])
    };
    let is_silhouette = left.signum() != right.signum();
    (is_crease || is_silhouette) && !(cull.leaves_out(left) && cull.leaves_out(right))
}
