//! Length and direction of vectors: an integer reciprocal square root.

use super::block;

/// The reciprocal square root of `value / 2^32`, `value` being at least 2^30, in units of 2^-30.
///
/// Between 2^30 and 2^31; the relative error is at most 2^-29.
fn reciprocal_root(value: u32) -> u32 {
    debug_assert!(value >= 1 << 30);
    let x = u64::from(value);
    // A line through 1/√x on [1/4, 1], within 11 %.
    let mut y = (2_359_296_000 - ((x * 1_374_389_535) >> 32)).min(1 << 31);
    // Each Newton step y ← y·(3 − x·y²)/2 takes a relative error e to 3e²/2: 1e-1, 2e-2, 5e-4, 4e-7, 2e-13.
    for _ in 0..4 {
        let squared = (y * y) >> 30;
        let product = (x * squared) >> 32;
        y = (y * ((3 << 30) - product) + (1 << 30)) >> 31;
    }
    #[allow(clippy::cast_possible_truncation)] // at most 2^31
    {
        y.clamp(1 << 30, 1 << 31) as u32
    }
}

/// The vector of length one in the direction of `vector`, in units of 2^-30; `None` for no direction.
///
/// Each component is within 2^-28 of its value.
pub(crate) fn unit(vector: [i64; 3]) -> Option<[i32; 3]> {
    let (m, _) = block::normalise(vector, 0);
    let squared = m
        .iter()
        .map(|m| u64::from(m.unsigned_abs()).pow(2))
        .sum::<u64>();
    if squared == 0 {
        return None;
    }
    // An even shift, so that its root is one of whole bits: between 2^62 and 2^64.
    let up = squared.leading_zeros() & !1;
    #[allow(clippy::cast_possible_truncation)] // the upper half
    let root = i64::from(reciprocal_root(((squared << up) >> 32) as u32));
    // m / √squared = m · (root / 2^30) / 2^((64 − up) / 2), in units of 2^-30.
    #[allow(clippy::cast_possible_wrap)] // at most 32
    let down = (32 - up / 2) as i32;
    #[allow(clippy::cast_possible_truncation)] // at most 1 + 2^-28
    Some(m.map(|m| block::shift(i64::from(m) * root, -down) as i32))
}

/// The cross product of two triples of at most 31 bits.
pub(crate) fn cross(a: [i32; 3], b: [i32; 3]) -> [i64; 3] {
    let [a, b] = [a, b].map(|v| v.map(i64::from));
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
