//! The position of a number in a range.

use crate::Scalar;
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
    /// The range from `low` to `high`, whose shares have `bits` fraction bits; `None` if `high` is not above `low`.
    pub(super) const fn new(low: Scalar, high: Scalar, bits: u32) -> Option<Self> {
        let range = high.to_bits() as i64 - low.to_bits() as i64;
        if range <= 0 {
            return None;
        }
        // The range may take 32 bits. It is shifted to 32, and loses the last one.
        let up = range.leading_zeros() - 32;
        let number = (range.cast_unsigned() << up >> 1) as u32;
        Some(Self {
            inverse: reciprocal(number),
            down: 62 - bits - up,
        })
    }

    /// A distance of 32 bits and a sign as a share of the length.
    pub(super) fn share(self, distance: i64) -> i64 {
        // Below 2^32 · 2^31.
        (distance * i64::from(self.inverse)) >> self.down
    }
}
