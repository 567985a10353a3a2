//! The position of a number in a range.

use crate::num::reciprocal;

/// A range of numbers, whose length is prepared for division.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Ramp {
    /// The reciprocal of the length, 2³⁰ to 2³¹.
    inverse: u32,
    /// Right shift of a distance times `inverse` to a share of the length.
    down: u32,
}

impl Ramp {
    /// A range of this length, above 0 and of at most 32 bits, whose shares have `bits` fraction bits.
    pub(super) const fn new(length: i64, bits: u32) -> Self {
        // The length is shifted to 32 bits, and loses the last one.
        let up = length.leading_zeros() - 32;
        let number = (length.cast_unsigned() << up >> 1) as u32;
        Self {
            inverse: reciprocal(number),
            down: 62 - bits - up,
        }
    }

    /// A distance of 32 bits and a sign as a share of the length.
    pub(super) fn share(self, distance: i64) -> i64 {
        // Below 2^32 · 2^31.
        (distance * i64::from(self.inverse)) >> self.down
    }
}
