//! Removes duplicate edges.

use crate::mesh::Index;
use crate::mesh::sort::sort;

/// Sorts the edges in place, moves one of each to the front, and returns how many different ones there are.
///
/// It takes linear time, which matters because it runs in the compiler.
pub(super) const fn unique(edges: &mut [[Index; 2]]) -> usize {
    sort(edges, 0, edges.len(), 24);
    let mut kept = 0;
    let mut at = 0;
    while at < edges.len() {
        let edge = edges[at];
        if kept == 0 || edges[kept - 1][0] != edge[0] || edges[kept - 1][1] != edge[1] {
            edges[kept] = edge;
            kept += 1;
        }
        at += 1;
    }
    kept
}
