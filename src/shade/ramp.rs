//! The position of a number in a range, as a share of the range.

use crate::num::reciprocal;

/// A range of numbers. The reciprocal of its length is stored, so that no later step divides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Ramp {
    /// The reciprocal of the length, scaled to the range from 2³⁰ to 2³¹.
    inverse: u32,
    /// The right shift that turns a distance times `inverse` into a share of the length.
    down: u32,
}

impl Ramp {
    /// A range of this length, which must be above 0 and have at most 32 bits. Shares of the length have `bits`
    /// fraction bits.
    pub(super) const fn new(length: i64, bits: u32) -> Self {
        // The length is shifted to 32 bits, and then loses the lowest bit, because the reciprocal takes 31 bits.
        let up = length.leading_zeros() - 32;
        let number = (length.cast_unsigned() << up >> 1) as u32;
        Self {
            inverse: reciprocal(number),
            down: 62 - bits - up,
        }
    }

    /// Converts a distance, of 32 bits and a sign, to a share of the length.
    pub(super) fn share(self, distance: i64) -> i64 {
        // The product is below 2^32 · 2^31.
        (distance * i64::from(self.inverse)) >> self.down
    }
}
