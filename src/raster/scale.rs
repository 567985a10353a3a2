//! Attributes as fractions of a power of two, which is how they are interpolated.

use crate::num::wide::product;

/// The power of two between an attribute and a fraction of it: 2^bits, 1 to 32 bits.
///
/// |attribute| · 17/16 < 2^(bits − 1), so the fraction attribute · 2^-bits is below half, and stays so
/// with what interpolation rounds.
///
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    bits: u32,
}

impl Scale {
    /// That of an attribute that is 0 everywhere.
    pub(crate) const ONE: Self = Self { bits: 1 };

    /// That of all attributes of a triangle that is [affine](Steps::is_affine) in a mode that divides.
    pub(crate) const AFFINE: Self = Self { bits: 28 };

    /// By how much such a triangle's interpolants are shifted up, so that rounding is of their fractions.
    pub(crate) const AFFINE_UP: u32 = 30 - Self::AFFINE.bits;

    /// The greatest magnitude for which that is enough, or a little less.
    pub(crate) const MOST_AFFINE: i32 = (1 << (Self::AFFINE.bits - 1)) / 17 * 16;

    /// That of an attribute of this greatest magnitude, of so many bits at least.
    #[inline]
    fn of(most: u32, least_bits: u32) -> Self {
        let bits = 33 - (most + (most >> 4)).leading_zeros();
        Self {
            bits: bits.max(least_bits).min(32),
        }
    }

    /// Bits of the attribute, 1 to 32: its magnitude is below 2^(bits − 1).
    #[inline]
    #[must_use]
    pub(crate) const fn bits(self) -> u32 {
        self.bits
    }

    /// By how much an interpolant is shifted left, and then right, to be one of so many `bits` of a 1/w
    /// that is shifted `up`.
    #[inline]
    pub(crate) const fn to(self, bits: u32, up: u32) -> (u32, u32) {
        let left = up + self.bits;
        (
            left.saturating_sub(bits) & 31,
            bits.saturating_sub(left) & 31,
        )
    }

    /// The attribute of a fraction in units of 2^-30, rounded down.
    ///
    /// Interpolants have 30 bits, so nothing is lost where an attribute of more is shifted up again.
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

/// Makes the values of an attribute at the corners those of attribute · weight · 2^-bits, where weights
/// are below 2³¹; gives the scale of the result.
#[inline]
pub(crate) fn weigh(values: &mut [i32; 3], weights: [u32; 3], least_bits: u32) -> Scale {
    let [a, b, c] = values.map(i32::unsigned_abs);
    let scale = Scale::of(a.max(b).max(c), least_bits);
    if scale.bits == 32 {
        draw_in(values, weights);
    }
    for (value, weight) in values.iter_mut().zip(weights) {
        // The value shifted to fill 32 bits times the weight, and the upper half of that to the nearest.
        let filled = *value << ((32 - scale.bits) & 31);
        let product = product(filled, weight.cast_signed());
        *value = ((product + (1 << 31)) >> 32) as i32;
    }
    scale
}

/// Draws values of 31 bits in from the ends of `i32`, by what rounding may add to them where the
/// weight is least: a step more would wrap around.
#[cold]
fn draw_in(values: &mut [i32; 3], weights: [u32; 3]) {
    let least = weights.into_iter().fold(1 << 30, u32::min);
    // An interpolant is off by less than 64 units, each of them 2^32 / weight of the value.
    let room = 1 << 7 << least.leading_zeros().min(20);
    for value in values {
        *value = (*value).clamp(i32::MIN + room, i32::MAX - room);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An interpolant is off by 40 units at most, a numerator by 36½: together they may take a
    /// numerator 56½ units nearer to half of the interpolant, beyond which it wraps.
    #[test]
    fn numerators_leave_room_for_rounding() {
        for bits in 0..=31 {
            let value = i32::MAX >> (31 - bits);
            for least in [1 << 11, (1 << 11) + 1, 1 << 20, 1 << 30, (1 << 31) - 1] {
                for weight in [least, least | 1 << 30, (1 << 31) - 1] {
                    for values in [[value, 0, 0], [-value, value, value], [!value; 3]] {
                        let weights = [weight, least, weight];
                        let mut weighted = values;
                        weigh(&mut weighted, weights, 1);
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
