//! Straight pieces.

use super::affine::{Affine, straight};
use super::mode::{Exact, Interpolate};
use super::newton::room;
use super::run::{Cells, FAR, Pixels, Run, Steps, rolled};
use super::tolerance::Tolerance;
use crate::Scalar;
use crate::num::short_reciprocal;
use crate::num::wide::{IS_NARROW, product};

/// Perspective by straight pieces between pixels that are right, as long as a tolerance allows.
///
/// Along a piece of L pixels, where an attribute changes by f′ a pixel and 1/w by δ of itself, the straight line is
/// off by |f′| · δ · L² / 4. Pieces have 64, 32, 16, 8, 4 or 2 pixels: the most that keeps this below the tolerance
/// wherever in the triangle, and δ · L below 1/16. The ends' reciprocals have 16 bits, each found by two
/// Newton steps from the last, so that a piece takes no division and no product of 64 bits: the mode
/// for cores that are slow at those, such as Cortex-M0+, and fast on all. Where 1/w changes by 1/64 of itself
/// a pixel or to less than half along a run, the run is [`Exact`].
///
/// A tolerance is in texels, of whatever size the texture is. Besides, an attribute is off by up to 2^-13 of its
/// greatest in the triangle: 1/32 of a texel where a texture of 256 is seen once, and so on for more or less of it.
/// Pieces hold colours to the same number in steps of their channels (32 or 64 of an
/// [`Rgb565`](embedded_graphics::pixelcolor::Rgb565)), and other varyings in units of 2^16. A triangle that hardly changes in depth
/// is one piece, where its texture coordinates may be off by the tolerance and what else varies by what its shader allows
/// ([`TOLERANCES`](crate::Shader::TOLERANCES)).
///
/// Pieces end within the triangle, so that no attribute exceeds those of the corners but by rounding.
///
/// ```
/// use fixel::mode::Fast;
/// use fixel::{DrawOptions, fx};
/// let pass = DrawOptions::new().mode(Fast::within(fx!(0.25)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fast {
    /// In units of 2^-16.
    tolerance: u32,
}

impl Fast {
    /// The counterpart of [`Newton`](super::Newton) in products of 16 bits, for cores without longer ones: off by up to 1/32 of a texel
    /// and, of a texture of 256, by 1/16 in all.
    pub const NARROW: Self = Self::within(crate::fx!(0.031_25));

    /// Pieces that are off by this many texels at most, besides rounding; 0 and less are exact at every pixel.
    #[must_use]
    pub const fn within(texels: Scalar) -> Self {
        let bits = texels.to_bits();
        Self {
            tolerance: if bits > 0 { bits.cast_unsigned() } else { 0 },
        }
    }
}

/// Most bits of an attribute.
const MOST_BITS: u32 = 28;

/// How long pieces are.
#[derive(Clone, Copy, Debug, Default)]
pub enum Plan {
    /// Each run has its own length.
    #[default]
    Runs,
    /// Two to this power, in all of a triangle, where 1/w changes less than fourfold.
    Pieces(u32),
    /// There are none: the triangle is straight all over.
    Affine,
}

impl Interpolate for Fast {
    const PERSPECTIVE: bool = true;
    type Parallel = Affine;
    type Plan = Plan;

    #[inline]
    fn parallel(self) -> Affine {
        Affine
    }

    #[inline]
    fn affine_within(&self, tolerance: Tolerance) -> u32 {
        match tolerance {
            Tolerance::Units(units) if self.tolerance > 0 => units,
            _ => self.tolerance,
        }
    }

    #[inline]
    fn plan<const N: usize>(&self, steps: &Steps<N>) -> Plan {
        if steps.is_affine {
            return Plan::Affine;
        }
        let length = if steps.least > FAR {
            self.length(steps.least, steps, 0)
        } else {
            None
        };
        length.map_or(Plan::Runs, Plan::Pieces)
    }

    #[inline]
    fn run<T, const N: usize>(
        &self,
        plan: Plan,
        mut run: Run<N>,
        steps: &Steps<N>,
        mut cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        if N == 0 || matches!(plan, Plan::Affine) {
            return straight(run, steps.q, steps.p, steps.depth, cells, pixels);
        }
        let mut left = cells.count() as u32;
        let mut own = *steps;
        let length = if let Plan::Pieces(length) = plan {
            length
        } else {
            let up = room(run.q, steps.q, cells.count());
            let length = up.and_then(|up| {
                let last = steps.q.wrapping_mul(left.wrapping_sub(1).cast_signed());
                let least = run.q.min(run.q.wrapping_add_signed(last));
                self.length(least, steps, up)
            });
            let (Some(up), Some(length)) = (up, length) else {
                return Exact.run((), run, steps, cells, pixels);
            };
            run.q <<= up;
            own.q <<= up;
            own.depth = own.depth.saturating_add(up).min(31);
            run.p = run.p.map(|p| p << up);
            own.p = own.p.map(|p| p << up);
            length
        };
        // For a reciprocal of up to 17 bits.
        run.p = run.p.map(|p| p >> 2);
        own.p = own.p.map(|p| p >> 2);
        // 1/w is from 2^29 to 2^31 from here on.
        let mut inverse = short_reciprocal(run.q >> 15);
        let mut values = values(&run, &own, inverse);
        loop {
            // A piece ends where the next begins, or with the run's last pixel: beyond that attributes might be any.
            let count = 1 << length;
            let is_last = left <= count;
            let pixels_on = if is_last { left.wrapping_sub(1) } else { count };
            let end = run.after(&own, pixels_on);
            inverse = refined(end.q, inverse);
            let at_end = self::values(&end, &own, inverse);
            let mut gains = at_end;
            for (gain, value) in gains.iter_mut().zip(values) {
                let change = gain.wrapping_sub(value);
                *gain = if is_last {
                    part_of(change, pixels_on)
                } else {
                    change >> length
                };
            }
            let first = if is_last { left } else { count };
            for cell in cells.first(first as usize) {
                rolled();
                if pixels.visible(&cell, run.q, own.depth) {
                    pixels.shade(cell, values);
                }
                run.q = run.q.wrapping_add_signed(own.q);
                for (value, gain) in values.iter_mut().zip(gains) {
                    *value = value.wrapping_add(gain);
                }
            }
            if is_last {
                return;
            }
            left -= count;
            (run, values) = (end, at_end);
        }
    }
}

impl Fast {
    /// How many pixels a piece may have, a power of two and that is its exponent, where 1/w is `least` or more and
    /// all is to be shifted `up`. `None` if even two are too many, or attributes have too many bits.
    #[inline]
    fn length<const N: usize>(self, least: u32, steps: &Steps<N>, up: u32) -> Option<u32> {
        if self.tolerance == 0 {
            return None;
        }
        let step = steps.q.unsigned_abs();
        let mut most = 0;
        for (p, scale) in steps.p.iter().zip(steps.scale) {
            if scale.bits() > MOST_BITS {
                return None;
            }
            // f′ = (p′ − f · q′) / q, where |f| is at most half in units of 2^bits; in units of 2^28 / q.
            let gain = p.unsigned_abs().saturating_add(step >> 1);
            most = most.max((gain >> (MOST_BITS - scale.bits())) + 1);
        }
        let shifted = |value: u32| value << up.min(value.leading_zeros());
        self.length_at(least << up, shifted(step), shifted(most))
    }

    #[inline(never)]
    fn length_at(self, least: u32, step: u32, gain: u32) -> Option<u32> {
        // δ and f′ in units of 2^-16 and of the attribute, rounded up; `least` has 30 or 31 bits.
        let divisor = (least >> 15).max(1 << 14);
        let slope = u64::from(step.div_ceil(divisor >> 1));
        let gain = u64::from(gain / divisor + 1) << (MOST_BITS - 15);
        // For 64 pixels that is times 2^10 for a tolerance of 2^-16 units.
        let (error, mut allowed) = (gain * slope, u64::from(self.tolerance) << 6);
        (1..=6).rev().find(|length| {
            let fits = error <= allowed && slope << length <= 1 << 12;
            allowed <<= 2;
            fits
        })
    }
}

impl<const N: usize> Run<N> {
    /// The interpolants `pixels` further on.
    #[inline]
    fn after(&self, steps: &Steps<N>, pixels: u32) -> Self {
        let pixels = pixels.cast_signed();
        let mut end = *self;
        end.q = end.q.wrapping_add_signed(steps.q.wrapping_mul(pixels));
        for (p, step) in end.p.iter_mut().zip(steps.p) {
            *p = p.wrapping_add(step.wrapping_mul(pixels));
        }
        end
    }
}

/// 2^31 / (q / 2^15), from that of a `q` which is off by up to 1/16: two Newton steps, which make that 2^-16.
#[inline]
fn refined(q: u32, mut inverse: u32) -> u32 {
    let q = q >> 15;
    for _ in 0..2 {
        // The product is near 2^31, and what it lacks has 28 bits.
        let lacks = (1_u32 << 31)
            .wrapping_sub(q.wrapping_mul(inverse))
            .cast_signed();
        let more = inverse.cast_signed().wrapping_mul(lacks >> 13) >> 18;
        inverse = inverse.wrapping_add_signed(more);
    }
    inverse
}

/// 2^30 / n; the first one is of a piece of no length.
const PARTS: [i32; 64] = {
    let mut parts = [0; 64];
    let (mut at, mut n) = (1, 1);
    while at < parts.len() {
        parts[at] = (1 << 30) / n;
        (at, n) = (at + 1, n + 1);
    }
    parts
};

/// An n-th of a change, rounded down, for an n below 64.
#[inline]
fn part_of(change: i32, n: u32) -> i32 {
    (product(change, PARTS[(n & 63) as usize]) >> 30) as i32
}

/// The attributes where the reciprocal of 1/w is `inverse`.
#[inline]
fn values<const N: usize>(run: &Run<N>, steps: &Steps<N>, inverse: u32) -> [i32; N] {
    let mut values = run.p;
    for (value, scale) in values.iter_mut().zip(steps.scale) {
        // With 2^31 / (q / 2^15) the product of p / 4 is p / q in units of 2^-44.
        *value = part(*value, inverse) >> (30u32.wrapping_sub(scale.bits()) & 31);
    }
    values
}

/// a · b / 2^14, rounded down, for a `b` of up to 17 bits and a product of up to 45.
#[inline]
fn part(a: i32, b: u32) -> i32 {
    let b = b.cast_signed();
    if IS_NARROW {
        (a >> 14)
            .wrapping_mul(b)
            .wrapping_add((a & 0x3fff).wrapping_mul(b) >> 14)
    } else {
        ((i64::from(a) * i64::from(b)) >> 14) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fx;

    #[test]
    fn pieces_are_as_long_as_the_tolerance_allows() {
        let quarter = Fast::within(fx!(0.25));
        // f′ a texel a pixel, and δ as many of 2^-16: 2^16 · δ · L² / 4 is to be a quarter of 2^16.
        let texel = |delta: u32| quarter.length_at(1 << 30, delta << 14, 1 << 18);
        // Rounded up, both are a little more than that, so that a power of two less is found.
        assert_eq!(
            [16, 63, 255, 1023].map(texel),
            [Some(5), Some(4), Some(3), Some(2)]
        );
        // Where 1/w does not change a piece has all 64.
        assert_eq!(quarter.length_at(1 << 30, 0, 1 << 18), Some(6));
        // No step of a sliver, however steep, is taken for a small one.
        assert_eq!(quarter.length_at(1 << 30, 1 << 31, 1 << 18), None);
    }

    /// Every divisor there is, from every guess that is off by a sixteenth at most.
    ///
    /// The first step leaves 2^-8 and what its products cut, a unit and 2^-18; the second the square of that, 1.02 of
    /// 2^-16, and cuts as much itself. A step never goes beyond what is exact, so that no guess has more than 17 bits.
    #[test]
    fn every_reciprocal() {
        for q in 1_u32 << 14..1 << 16 {
            let exact = 2_f64.powi(31) / f64::from(q);
            let allowed = exact * (1.02 * 2_f64.powi(-16) + 2_f64.powi(-18)) + 1.;
            let least = (15_u32 << 27).div_ceil(q);
            let most = ((17 << 27) / q).min(1 << 17);
            // Off by most at one of the ends, but for roundings: those are every eighth one's.
            for guess in (least..=most).step_by(8).chain([most]) {
                let lacks = exact - f64::from(refined(q << 15 | q & 0x7fff, guess));
                assert!(
                    (0. ..=allowed).contains(&lacks),
                    "{q} from {guess}: {lacks}"
                );
            }
        }
    }
}
