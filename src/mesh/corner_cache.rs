//! A cache of what a shader computed at corners.

use core::cell::Cell;

/// The slots for corners with one number. Corners with more numbers have fewer slots.
const SLOTS: usize = 128;

/// What an effect of a shader, such as light, computed at recent corners of a mesh: kept because neighboring triangles
/// share corners. The cache takes 1 KB of stack.
///
/// The slots of consecutive indices are 75/64 apart. If they were 1 apart, vertices of neighboring rows would push each
/// other out of the slot in a grid with as many vertices in a row as there are slots, and be computed up to five times.
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
        let slot = (key.wrapping_mul(1200) >> 10) as usize % (SLOTS / stride).max(1);
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
