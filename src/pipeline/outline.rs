//! Outlines, which choose among the edges of a mesh.

use super::assemble;
use super::cache::VertexCache;
use super::call::Call;
use super::line_style::DrawLine;
use super::{Drawn, run};
use crate::mesh::{Index, Outline};
use crate::raster::Blitter;
use crate::view::ProjectionKind;

/// Draws the creases, silhouettes and borders of an outline of which at least one face is not culled.
#[inline(never)]
pub(super) fn outline<K: ProjectionKind>(
    call: &Call<'_, K>,
    outline: &Outline<'_>,
    line: DrawLine<'_>,
    blitter: &mut dyn Blitter,
) -> Drawn {
    run::lines(call, blitter, outline.edges(), ends_of(outline), line)
}

/// Chooses the edges of an outline that are drawn, and returns their ends.
#[inline]
pub(super) fn ends_of<K: ProjectionKind>(
    outline: &Outline<'_>,
) -> impl Fn(&Call<'_, K>, &mut VertexCache, usize, &[Index; 4]) -> Option<[Index; 2]> {
    |call, vertices, at, &edge| {
        let [a, b, ..] = edge;
        is_drawn(call, vertices, edge, at < outline.creases()).then_some([a, b])
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
    // A border has no second face. It counts as a face without area.
    let right = if d == a {
        0
    } else {
        assemble::area(call, vertices, [b, a, d])
    };
    let is_silhouette = left.signum() != right.signum();
    (is_crease || is_silhouette) && !(cull.leaves_out(left) && cull.leaves_out(right))
}
