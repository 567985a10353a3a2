//! Removes duplicate edges.

use crate::mesh::Index;

/// Up to this many edges, insertion sort is faster than distribution.
const FEW: usize = 24;

/// Sorts the edges in place, moves one of each to the front and returns how many there are.
///
/// A radix sort takes linear time. It matters because this runs in the compiler, where a step costs a microsecond.
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

/// Sorts the edges from `start` to before `end`. Their keys (first index, then second) agree in all bits above
/// `shift` + 8.
///
/// An American flag sort: the next eight bits distribute the edges in place into 256 buckets, and each bucket is
/// sorted.
const fn sort(edges: &mut [[Index; 2]], start: usize, end: usize, shift: u32) {
    if end - start <= FEW {
        insertion(edges, start, end);
        return;
    }
    // The first index is the upper half of the key; within an index, the upper byte comes first.
    let (part, low) = ((shift < 16) as usize, shift % 16);
    let mut counts = [0; 256];
    let mut at = start;
    while at < end {
        counts[(edges[at][part] >> low) as usize & 0xFF] += 1;
        at += 1;
    }
    // For each bucket, where the next edge goes and where the bucket ends.
    let mut next = [start; 256];
    let mut ends = [start; 256];
    let mut sum = start;
    let mut bucket = 0;
    while bucket < 256 {
        next[bucket] = sum;
        sum += counts[bucket];
        ends[bucket] = sum;
        bucket += 1;
    }
    bucket = 0;
    while bucket < 256 {
        while next[bucket] < ends[bucket] {
            // Puts an edge into its bucket and picks up the one it displaces, until one belongs in this bucket.
            let mut edge = edges[next[bucket]];
            loop {
                let home = (edge[part] >> low) as usize & 0xFF;
                let place = next[home];
                next[home] = place + 1;
                if home == bucket {
                    edges[place] = edge;
                    break;
                }
                let other = edges[place];
                edges[place] = edge;
                edge = other;
            }
        }
        bucket += 1;
    }
    if shift == 0 {
        return;
    }
    bucket = 0;
    while bucket < 256 {
        if counts[bucket] > 1 {
            sort(
                edges,
                ends[bucket] - counts[bucket],
                ends[bucket],
                shift - 8,
            );
        }
        bucket += 1;
    }
}

/// Sorts the edges from `start` to before `end` by insertion.
const fn insertion(edges: &mut [[Index; 2]], start: usize, end: usize) {
    let mut at = start + 1;
    while at < end {
        let edge = edges[at];
        let key = (edge[0] as u32) << 16 | edge[1] as u32;
        let mut place = at;
        while place > start {
            let before = edges[place - 1];
            if (before[0] as u32) << 16 | before[1] as u32 <= key {
                break;
            }
            edges[place] = before;
            place -= 1;
        }
        edges[place] = edge;
        at += 1;
    }
}
