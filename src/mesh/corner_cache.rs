//! A cache of what a shader computed at corners.

use core::cell::Cell;

/// The slots for corners with one number. Corners with more numbers have fewer slots.
const SLOTS: usize = 128;

/// What an effect of a shader, such as light, computed at recent corners of a mesh: kept because neighboring triangles
/// share corners. The cache takes 1 KB of stack.
///
/// The slots of consecutive indices are 65/64 apart. If they were 1 apart, vertices of neighboring rows of a grid would
/// push each other out of the slot in rows of 128 or 256, and be computed up to five times. (Now they do in rows of 126
/// or 127.)
#[derive(Clone, Debug)]
pub(crate) struct CornerCache {
    keys: [Cell<u32>; SLOTS],
    numbers: [Cell<i32>; SLOTS],
}

impl CornerCache {
    #[inline]
    pub(crate) const fn new() -> Self {
        // A corner with key 1 always has slot 1, so key 1 marks the other slots as empty, and key 0 marks slot 1. Zeros
        // would be cleared by a routine that stores word by word, so even the numbers are not zero.
        let cache = Self {
            keys: [const { Cell::new(1) }; SLOTS],
            numbers: [const { Cell::new(1) }; SLOTS],
        };
        let [_, second, ..] = &cache.keys;
        second.replace(0);
        cache
    }

    /// Reads the numbers of a corner; otherwise, computes and keeps them. All corners must have as many numbers, at most
    /// eight. Equal corners have equal keys.
    #[inline]
    pub(crate) fn numbers<N: AsRef<[i32]> + AsMut<[i32]>>(
        &self,
        key: u32,
        mut numbers: N,
        compute: impl FnOnce() -> N,
    ) -> N {
        let stride = numbers.as_ref().len().next_power_of_two();
        let slot = (key.wrapping_mul(1040) >> 10) as usize % (SLOTS / stride).max(1);
        let at = slot * stride;
        let kept = self.numbers.get(at..).unwrap_or_default();
        let Some(holds) = self.keys.get(slot) else {
            return compute();
        };
        if holds.get() == key {
            for (number, kept) in numbers.as_mut().iter_mut().zip(kept) {
                *number = kept.get();
            }
            return numbers;
        }
        numbers = compute();
        holds.set(key);
        for (number, kept) in numbers.as_ref().iter().zip(kept) {
            kept.set(*number);
        }
        numbers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How often numbers are computed for the triangles of 32 rows of a grid with this many vertices in a row.
    fn computed(length: u32) -> u32 {
        let (cache, mut computed) = (CornerCache::new(), 0);
        for row in 0..32 {
            for column in 0..length - 1 {
                let at = row * length + column;
                for key in [
                    at,
                    at + length,
                    at + 1,
                    at + 1,
                    at + length,
                    at + length + 1,
                ] {
                    let numbers = cache.numbers(key, [0], || {
                        computed += 1;
                        [key.cast_signed() + 7]
                    });
                    assert_eq!(numbers, [key.cast_signed() + 7]);
                }
            }
        }
        computed
    }

    /// If corners with indices 64 or 128 apart had the same slot, they would be computed up to five times.
    #[test]
    fn no_usual_number_of_vertices_in_a_row_is_a_cliff() {
        for length in (3..=124).chain([128, 129, 256, 257]) {
            let times = if length <= 124 { 1 } else { 2 };
            let computed = computed(length);
            // A twentieth more is allowed, because of the places where slots begin again.
            assert!(
                20 * computed <= 21 * times * 33 * length,
                "{computed} of {} in rows of {length}",
                33 * length
            );
        }
    }
}
