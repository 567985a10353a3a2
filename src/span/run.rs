//! A run of pixels: the values at its start, and the steps.

use core::hint::black_box;

use crate::num::wide::product;

/// Pixels that are stepped over before the values are found afresh.
///
/// A step is rounded to half a unit of 2⁻³⁰, so a run adds at most 32 units. The same in all modes, so that
/// depths are alike.
pub(crate) const RUN: u32 = 64;

/// A corner whose 1/w is this or less, where that of the nearest is from 2^30 to 2^31, is far off: 1/w may
/// change fourfold within the triangle. (2^29 with what rounding may take from it at a pixel.)
pub(crate) const FAR: u32 = (1 << 29) + 64;

/// Interpolants at a pixel of a run.
///
/// `q` is 1/w (or, under a parallel projection, depth), scaled so that its largest value in the
/// triangle has bit 30 set. `p[i]` is attribute · q · 2^-bits (see [`Scale`]), so that
/// |p| ≤ q/2 but for rounding.
///
/// See [`Interpolate`](super::Interpolate) for what takes one, [`Scale`] for what makes attributes of it.
///
/// ```
/// use fixel::mode::Run;
/// // Far away a 1/w is small beside the triangle's largest; its fractions are too.
/// let run: Run<1> = Run { q: 1 << 20, p: [1 << 18] };
/// assert_eq!(run.p[0] as u32 * 4, run.q);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Run<const N: usize> {
    /// 1/w or depth.
    pub q: u32,
    /// Attributes over w.
    pub p: [i32; N],
}

/// What the interpolants of a run gain from one pixel to the next, and what they are worth.
///
/// ```
/// use fixel::mode::{Run, Steps};
/// let mut run: Run<0> = Run { q: 1000, p: [] };
/// run.step(&Steps { q: -3, p: [], scale: [], depth: 16, least: 900, is_affine: true });
/// assert_eq!(run.q, 997);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Steps<const N: usize> {
    /// What [`Run::q`] gains per pixel.
    pub q: i32,
    /// What [`Run::p`] gains.
    pub p: [i32; N],
    /// How each attribute is scaled.
    pub scale: [Scale; N],
    /// A pixel's depth of 16 bits is its [`Run::q`] shifted down by this: 15 to 47, and 0 from 31 on.
    pub depth: u32,
    /// The least [`Run::q`] of the triangle's corners; the largest has bit 30 set.
    pub least: u32,
    /// Whether a mode that divides need not do so in this triangle: [`Run::p`] has attributes, times 4, that were not
    /// divided by w. See [`Interpolate::affine_within`](super::Interpolate::affine_within).
    pub is_affine: bool,
}

/// The power of two between an attribute and a fraction of it: 2^bits, 1 to 32 bits.
///
/// |attribute| · 17/16 < 2^(bits − 1), so the fraction attribute · 2^-bits is below half, and stays so
/// with what interpolation rounds.
///
/// ```
/// use fixel::mode::{Pixels, Run, Steps};
/// /// What a mode that does not divide makes of a run.
/// fn affine(run: &Run<1>, steps: &Steps<1>) -> i32 {
///     steps.scale[0].restore(run.p[0])
/// }
/// ```
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
    pub const fn bits(self) -> u32 {
        self.bits
    }

    /// By how much an interpolant is shifted left, and then right, to be one of so many `bits` of a 1/w
    /// that is shifted `up`.
    #[inline]
    pub(super) const fn to(self, bits: u32, up: u32) -> (u32, u32) {
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
    pub const fn restore(self, fraction: i32) -> i32 {
        let (down, up) = (
            30u32.saturating_sub(self.bits),
            self.bits.saturating_sub(30),
        );
        (fraction >> (down & 31)) << (up & 31)
    }
}

impl<const N: usize> Run<N> {
    /// Goes on to the next pixel.
    ///
    /// Values wrap: a step beyond `i32` belongs to a sliver one pixel wide, whose next pixel is
    /// never looked at.
    #[inline]
    pub fn step(&mut self, steps: &Steps<N>) {
        self.q = self.q.wrapping_add_signed(steps.q);
        for (p, step) in self.p.iter_mut().zip(steps.p) {
            *p = p.wrapping_add(step);
        }
    }
}

/// The pixels of a run in memory, each of which is a `T`, in order.
///
/// The rasterizer implements it; a mode takes them. See [`Interpolate`](super::Interpolate).
pub trait Cells<T> {
    /// How many are left.
    fn count(&self) -> usize;

    /// Takes the first `count`, or all that are left.
    fn first(&mut self, count: usize) -> impl Iterator<Item = T>;
}

/// Keeps the compiler from unrolling the loop that it is called in; it takes no instruction.
///
/// A loop over pixels takes all registers of a small core. Unrolled it would take more, and the steps it would
/// then load from the stack cost more than the branches that it saves.
#[inline]
pub(super) fn rolled() {
    black_box(());
}

/// What is to be done with the pixels of a run, each of which is a `T`.
///
/// The rasterizer implements it; a mode calls it. See [`Interpolate`](super::Interpolate).
pub trait Pixels<T, const N: usize> {
    /// Whether the next pixel is visible where [`Run::q`] is `q`, which shifted `down` is its depth of 16
    /// bits; called once per pixel, in order.
    fn visible(&mut self, pixel: &T, q: u32, down: u32) -> bool;

    /// Colours the pixel that was last found visible.
    fn shade(&mut self, pixel: T, varyings: [i32; N]);
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
