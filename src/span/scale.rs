//! Varyings as fractions of a power of two, the form in which they are interpolated.

use crate::num::wide::product;

/// The power of two, 2^bits, by which a varying is divided to become a fraction. `bits` is 1 to 32.
///
/// |varying| · 17/16 < 2^(bits − 1), so the fraction varying · 2^-bits is below 1/2, even after interpolation has
/// added its rounding errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Scale {
    bits: u32,
}

impl Scale {
    /// All bits 0: the scale of a varying before its first triangle.
    pub(crate) const UNSET: Self = Self { bits: 0 };

    /// The scale of all varyings of a triangle that is drawn affinely in a mode that divides.
    pub(crate) const AFFINE: Self = Self { bits: 28 };

    /// The left shift of the varyings of an affine triangle, so that interpolation rounds only fractions of their
    /// units.
    pub(crate) const AFFINE_UP: u32 = 30 - Self::AFFINE.bits;

    /// The greatest magnitude that fits [`AFFINE`](Self::AFFINE), or a little less.
    pub(crate) const MOST_AFFINE: i32 = (1 << (Self::AFFINE.bits - 1)) / 17 * 16;

    /// The scale, of at least `least_bits`, for a varying with the greatest magnitude `most`.
    #[inline]
    fn of(most: u32, least_bits: u32) -> Self {
        let bits = 33 - (most + (most >> 4)).leading_zeros();
        Self {
            bits: bits.max(least_bits).min(32),
        }
    }

    /// The number of bits of the varying, 1 to 32: its magnitude is below 2^(bits − 1).
    #[inline]
    #[must_use]
    pub(crate) const fn bits(self) -> u32 {
        self.bits
    }

    /// The left shift and the right shift, in this order, that turn an interpolant of this scale into an interpolant of
    /// a scale of `bits` bits, if 1/w is shifted left by `up`.
    #[inline]
    pub(crate) const fn to(self, bits: u32, up: u32) -> (u32, u32) {
        let left = up + self.bits;
        (
            left.saturating_sub(bits) & 31,
            bits.saturating_sub(left) & 31,
        )
    }

    /// Turns a fraction in units of 2^-30 back into the varying, rounded down.
    ///
    /// Interpolants have 30 bits, so the left shift for a varying of more bits loses nothing.
    #[inline]
    #[must_use]
    pub(crate) const fn restore(self, fraction: i32) -> i32 {
        let (down, up) = (
            30u32.saturating_sub(self.bits),
            self.bits.saturating_sub(30),
        );
        (fraction >> (down & 31)) << (up & 31)
    }
}

/// The number of bits of the scale with which an interpolant has the same unit as its varying.
pub(crate) const WHOLE: u32 = 30;

/// The weight of a varying that is not divided by w.
pub(crate) const ONE: u32 = 1 << 30;

/// Replaces a varying's values at the corners by varying · weight · 2^-bits, rounded to nearest, and returns the scale
/// 2^bits. Weights are below 2³¹.
#[inline]
pub(crate) fn weigh(values: &mut [i32; 3], weights: &[u32; 3], least_bits: u32) -> Scale {
    let [a, b, c] = values.map(i32::unsigned_abs);
    let scale = Scale::of(a.max(b).max(c), least_bits);
    if scale.bits == 32 {
        leave_room(values, weights);
    }
    if scale.bits == 30 && weights.iter().all(|weight| *weight == ONE) {
        // The products below would return the values themselves.
        return scale;
    }
    for (value, weight) in values.iter_mut().zip(weights) {
        // The value is shifted to fill 32 bits, and multiplied by the weight. The result is the upper half of the
        // product, rounded to nearest.
        let filled = *value << ((32 - scale.bits) & 31);
        let product = product(filled, weight.cast_signed());
        *value = ((product + (1 << 31)) >> 32) as i32;
    }
    scale
}

/// Clamps values of 31 bits, to leave room at the ends of `i32` for rounding. Beyond the ends, a value would wrap
/// around. Rounding adds most at the corner with the least weight.
#[cold]
fn leave_room(values: &mut [i32; 3], weights: &[u32; 3]) {
    let least = weights.iter().copied().fold(1 << 30, u32::min);
    // The error of an interpolant is below 64 units, and such a unit is 2^32 / weight units of the value.
    let room = 1 << 7 << least.leading_zeros().min(20);
    for value in values {
        *value = (*value).clamp(i32::MIN + room, i32::MAX - room);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error of q (1/w) is at most 40 units, and the error of a numerator p is at most 36½ units. Together, these
    /// errors may bring a numerator 56½ units nearer to half of q. Beyond half of q, a numerator wraps around.
    #[test]
    fn numerators_leave_room_for_rounding() {
        for bits in 0..=31 {
            let value = i32::MAX >> (31 - bits);
            for least in [1 << 11, (1 << 11) + 1, 1 << 20, 1 << 30, (1 << 31) - 1] {
                for weight in [least, least | 1 << 30, (1 << 31) - 1] {
                    for values in [[value, 0, 0], [-value, value, value], [!value; 3]] {
                        let weights = [weight, least, weight];
                        let mut weighted = values;
                        weigh(&mut weighted, &weights, 1);
                        for (p, weight) in weighted.into_iter().zip(weights) {
                            assert!(
                                2 * p.unsigned_abs() + 113 <= weight,
                                "{values:?}: {p} of {weight}"
                            );
                        }
                    }
                }
            }
        }
    }
}
