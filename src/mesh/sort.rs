//! A radix sort for the compiler, where a step costs a microsecond: it takes linear time. It also removes duplicates
//! from a list of edges.

use super::Index;

/// Up to this many entries, insertion sort is faster than distribution.
const FEW: usize = 24;

/// Sorts the entries from `start` to before `end` by their first two numbers. These keys (the first number, then the
/// second) agree in all bits above `shift` + 8, so a sort starts with a shift of 24.
///
/// This is an American flag sort: the next eight bits distribute the entries in place into 256 buckets, and each bucket
/// is sorted.
pub(super) const fn sort<const N: usize>(
    entries: &mut [[Index; N]],
    start: usize,
    end: usize,
    shift: u32,
) {
    if end - start <= FEW {
        insertion(entries, start, end);
        return;
    }
    // The first number is the upper half of the key; within a number, the upper byte comes first.
    let (part, low) = ((shift < 16) as usize, shift % 16);
    let mut counts = [0; 256];
    let mut at = start;
    while at < end {
        counts[(entries[at][part] >> low) as usize & 0xFF] += 1;
        at += 1;
    }
    // For each bucket, where the next entry goes and where the bucket ends.
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
            // Puts an entry into its bucket and picks up the one it displaces, until one belongs in this bucket.
            let mut entry = entries[next[bucket]];
            loop {
                let home = (entry[part] >> low) as usize & 0xFF;
                let place = next[home];
                next[home] = place + 1;
                if home == bucket {
                    entries[place] = entry;
                    break;
                }
                let other = entries[place];
                entries[place] = entry;
                entry = other;
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
                entries,
                ends[bucket] - counts[bucket],
                ends[bucket],
                shift - 8,
            );
        }
        bucket += 1;
    }
}

/// Sorts the entries from `start` to before `end` by insertion.
const fn insertion<const N: usize>(entries: &mut [[Index; N]], start: usize, end: usize) {
    let mut at = start + 1;
    while at < end {
        let entry = entries[at];
        let key = (entry[0] as u32) << 16 | entry[1] as u32;
        let mut place = at;
        while place > start {
            let before = entries[place - 1];
            if (before[0] as u32) << 16 | before[1] as u32 <= key {
                break;
            }
            entries[place] = before;
            place -= 1;
        }
        entries[place] = entry;
        at += 1;
    }
}

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
