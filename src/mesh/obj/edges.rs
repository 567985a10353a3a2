//! Each edge once.

use crate::mesh::Index;

/// Below so many edges, insertion sorts faster than distribution.
const FEW: usize = 24;

/// Sorts the edges in place and moves each different one to the front; their number.
///
/// Time is linear but for a logarithm's worth; it matters as this runs while compiling, where a
/// step costs a microsecond.
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

/// Sorts the edges from `start` to before `end`, which agree in the bits above `shift` + 8 of their
/// keys: distributes them by the next eight bits, in place ("American flag sort"), and sorts each share.
const fn sort(edges: &mut [[Index; 2]], start: usize, end: usize, shift: u32) {
    if end - start <= FEW {
        insertion(edges, start, end);
        return;
    }
    // The upper bytes first; of each pair, the first index.
    let (part, low) = ((shift < 16) as usize, shift % 16);
    let mut counts = [0; 256];
    let mut at = start;
    while at < end {
        counts[(edges[at][part] >> low) as usize & 0xFF] += 1;
        at += 1;
    }
    // Where each share is to be filled next, and where it ends.
    let mut next = [start; 256];
    let mut ends = [start; 256];
    let mut sum = start;
    let mut share = 0;
    while share < 256 {
        next[share] = sum;
        sum += counts[share];
        ends[share] = sum;
        share += 1;
    }
    share = 0;
    while share < 256 {
        while next[share] < ends[share] {
            // Carries an edge to its share, takes up the one that is there, until one belongs here.
            let mut edge = edges[next[share]];
            loop {
                let home = (edge[part] >> low) as usize & 0xFF;
                let place = next[home];
                next[home] = place + 1;
                if home == share {
                    edges[place] = edge;
                    break;
                }
                let other = edges[place];
                edges[place] = edge;
                edge = other;
            }
        }
        share += 1;
    }
    if shift == 0 {
        return;
    }
    share = 0;
    while share < 256 {
        if counts[share] > 1 {
            sort(edges, ends[share] - counts[share], ends[share], shift - 8);
        }
        share += 1;
    }
}

/// Sorts the edges from `start` to before `end`.
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
