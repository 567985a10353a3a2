//! Which kernel draws a span: each mode's choice, and the inequalities behind it.
//!
//! Notation: f is an attribute, q is 1/w and p is f · q, all along a row of pixels; f′, q′ and p′ are their gains from a
//! pixel to the next, δ = |q′| / q. q is scaled so that its greatest value in a triangle has bit 30 set.

use super::newton::FRACTION;
use super::pixels::Span;
use crate::Scalar;
use crate::raster::{FAR, Scale};
use crate::shade::{Lanes, Tolerance};

/// How the attributes of a pixel are found between a triangle's corners: where speed is traded for accuracy.
///
/// Chosen for each draw call by [`DrawOptions::with_mode`](crate::DrawOptions::with_mode). What a program does not
/// name it does not link.
///
/// | mode | error in texels, of 256x256 at 320x240 | work at each pixel | for |
/// |---|---|---|---|
/// | [`Newton`], the default | 0.001 | a step towards the reciprocal | all but the smallest cores |
/// | [`Fast`] | a tolerance, and 1/32 | additions | Cortex-M0+, large triangles |
/// | [`Fast::NARROW`] | 1/16 | additions | Cortex-M0+, where that is to be seen |
/// | [`Exact`] | 0.001, in triangles of any depth | a reciprocal of 31 bits | a standard to compare with; 64-bit computers |
/// | [`Affine`] | without a bound | additions | what faces the eye, or is small |
///
/// Under a parallel projection attributes are linear on the screen, and every mode adds. All modes draw the same in bands
/// as in frames, and the same on every target; depths are the same in all of them.
///
/// A mode chooses among four kernels for each span of up to 64 pixels: straight, pieces, Newton, divide.
pub trait Mode: Policy {}

impl<M: Policy> Mode for M {}

/// What draws a span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// Attributes that are linear along the span, in parts of 4.
    Straight,
    /// The line that touches attributes in the middle of the span.
    Chord,
    /// Pieces of 2 to this power pixels.
    Pieces(u32),
    /// A Newton step at each pixel.
    Newton,
    /// A division at each pixel.
    Divide,
}

/// What set-up knows of a triangle: the gains of its interpolants along a row, and their scales.
pub struct Slopes<L: Lanes> {
    /// q′.
    pub q: i32,
    /// p′ of each attribute, in units of 2^(bits − 30) of it.
    pub p: L::Of<i32>,
    pub scales: L::Of<Scale>,
    /// The least q of a corner.
    pub least: u32,
}

/// What a mode decides.
pub trait Policy: Copy {
    /// Whether attributes are divided by w at all.
    const DIVIDES: bool = true;

    /// The fewest bits of a [`Scale`] in triangles in which q changes less than fourfold. With b bits an interpolant's
    /// unit is 2^(b − 30) of the attribute's; more bits than an attribute has lose accuracy, and spare scaling.
    const LEAST_BITS: u32 = 1;

    /// The same under a parallel projection. With [`WHOLE`] bits an interpolant's unit is the attribute's.
    const LEAST_PARALLEL_BITS: u32 = WHOLE;

    /// Whether interpolants are found anew at each pixel of triangles with a corner of a q below [`STEEP`].
    const IS_PRECISE: bool = false;

    /// How far an attribute may be from exact, in its units, where that spares all division. 0 is never.
    fn affine_within(self, tolerance: Tolerance) -> u32;

    /// The kernel of all spans of a triangle that is not affine; `None` if each span has its own.
    fn of_triangle<L: Lanes>(self, slopes: &Slopes<L>) -> Option<Kernel>;

    /// The kernel of a span, which may be scaled for it.
    fn of_span<L: Lanes>(
        self,
        of_triangle: Option<Kernel>,
        span: &mut Span<L>,
        slopes: &Slopes<L>,
    ) -> Kernel;
}

/// Bits at which an interpolant's unit is an attribute's.
pub(super) const WHOLE: u32 = 30;

/// δ is at most 2^-6 where a reciprocal is found from those before it.
const STEEPEST: u32 = 6;

/// A corner's q below this is over 128 times as far as the nearest one, or over 256 times, as that one's q is from 2^30 to
/// 2^31. Interpolants are rounded to half a unit at the nearest corner's scale, and a span's steps add up to 32 units.
pub(super) const STEEP: u32 = 1 << 23;

/// By how many bits a span's interpolants can be shifted up so that q is from 2^29 to 2^31 in all its pixels; `None` if
/// q changes twofold along the span, or δ exceeds 2^-6.
#[inline(never)]
fn room(q: u32, step: i32, count: usize) -> Option<u32> {
    let others = (count as u32).cast_signed().wrapping_sub(1);
    let last = q.wrapping_add_signed(step.wrapping_mul(others));
    let (least, most) = (q.min(last), q.max(last));
    let is_gentle =
        step.unsigned_abs() <= least >> STEEPEST && least > most >> 1 && most >> 31 == 0;
    is_gentle.then(|| (most | 1).leading_zeros().wrapping_sub(1) & 31)
}

/// Perspective-correct at every pixel, by the exact [`reciprocal`](crate::num::reciprocal) of 1/w.
///
/// No pixel depends on one before it. From the span's interpolants an attribute is rounded down to its unit; the
/// reciprocal adds less than 2⁻³⁰ of it. In a triangle with a corner over 128 to 256 times as far as its nearest one, each
/// pixel's interpolants are found anew in 64 bits: the mode stays within a thousandth of a texel of 256 to a depth ratio
/// of 1,000 in a triangle.
///
/// ```
/// use fixel::{DrawOptions, mode::Exact};
/// let options = DrawOptions::new().with_mode(Exact);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exact;

impl Policy for Exact {
    const LEAST_PARALLEL_BITS: u32 = 1;
    const IS_PRECISE: bool = true;

    #[inline]
    fn affine_within(self, _: Tolerance) -> u32 {
        0
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, _: &Slopes<L>) -> Option<Kernel> {
        Some(Kernel::Divide)
    }

    #[inline(always)]
    fn of_span<L: Lanes>(self, _: Option<Kernel>, _: &mut Span<L>, _: &Slopes<L>) -> Kernel {
        Kernel::Divide
    }
}

/// Linear on the screen, which is right under a parallel projection.
///
/// Under perspective it bends textures, as no other mode does: right for surfaces that face the eye, are small, or are
/// far for their size. An attribute is off by up to 37 of its units besides (a texture coordinate by a two-thousandth of
/// a texel).
///
/// ```
/// use fixel::{DrawOptions, mode::Affine};
/// let hud = DrawOptions::new().with_mode(Affine);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Affine;

impl Policy for Affine {
    const DIVIDES: bool = false;

    #[inline]
    fn affine_within(self, _: Tolerance) -> u32 {
        0
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, _: &Slopes<L>) -> Option<Kernel> {
        Some(Kernel::Straight)
    }

    #[inline(always)]
    fn of_span<L: Lanes>(self, _: Option<Kernel>, _: &mut Span<L>, _: &Slopes<L>) -> Kernel {
        Kernel::Straight
    }
}

/// Perspective-correct at every pixel, by one Newton step from the two pixels before it: the default.
///
/// The line through two pixels' reciprocals of 1/w has a relative error of 2δ² at the third, where 1/w changes by δ of
/// itself from pixel to pixel. A Newton step squares that, and δ is at most 2⁻⁶, so the reciprocal is right to 2⁻²¹ of
/// itself. Where 1/w changes faster, or to less than half along a span, the span is divided at each pixel. An attribute
/// is off by up to 57 of its units besides (a texture coordinate by less than 0.0008 texels), and by what [`Exact`] may be.
///
/// Where division makes no difference, nothing is divided. A row in which 1/w hardly changes, such as of a floor under a
/// camera that does not roll, is drawn straight where that is off by 16 units at most. A triangle that hardly changes in
/// depth is drawn straight where that is off by what its shader allows ([`Varyings`](crate::shade::Varyings)): 16 units
/// of a texture coordinate, an eighth of a step of colors. So are nearly all triangles of a model with a color at each vertex.
///
/// A span begins with the exact reciprocal, every 64 pixels and at every triangle's edge, so that bands and frames are
/// alike.
///
/// On a core without 64-bit products and without a divider, such as Cortex-M0+, take [`Fast`].
///
/// ```
/// use fixel::{DrawOptions, mode::Newton};
/// let default: DrawOptions<Newton> = DrawOptions::new();
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Newton;

/// What a texture coordinate may be off by where nothing is divided: 1/4096 of a texel.
const TEXEL_TOLERANCE: u32 = 16;

/// Bits of the step of a 1/w that hardly changes along a row.
const LEVEL: u32 = 8;

/// Whether 1/w changes so little along a row that attributes are straight to 2^-12 of a texel.
///
/// From the line that touches them in the middle of 64 pixels they deviate by |f′| · δ · 32² at the ends. With f′ =
/// (p′ − f · q′) / q, |f| at most half in units of 2^28, and q at least 2^29, the product of the dividends is to be below
/// 2^4 · 2^(58 − 28 − 10).
#[inline]
pub(super) fn is_level<L: Lanes>(span: &Span<L>) -> bool {
    let step = span.dq.unsigned_abs();
    step >> LEVEL == 0
        && L::all(&span.dp, |p| {
            let gain = p.unsigned_abs().saturating_add(step);
            gain >> (32 - LEVEL) == 0 && gain.wrapping_mul(step) < 1 << 24
        })
}

/// `value` / 2^`down`, to the nearest.
#[inline]
fn nearest(value: i32, down: u32) -> i32 {
    value.wrapping_add(1 << down >> 1) >> down
}

impl Policy for Newton {
    const LEAST_BITS: u32 = FRACTION;

    #[inline]
    fn affine_within(self, tolerance: Tolerance) -> u32 {
        match tolerance {
            Tolerance::Texels => TEXEL_TOLERANCE,
            Tolerance::Units(units) => units,
        }
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, slopes: &Slopes<L>) -> Option<Kernel> {
        let is_gentle = slopes.least > FAR
            && slopes.q.unsigned_abs() <= slopes.least >> STEEPEST
            && L::all(&slopes.scales, |scale| scale.bits() == FRACTION);
        is_gentle.then_some(Kernel::Newton)
    }

    #[inline(always)]
    fn of_span<L: Lanes>(
        self,
        of_triangle: Option<Kernel>,
        span: &mut Span<L>,
        slopes: &Slopes<L>,
    ) -> Kernel {
        if of_triangle.is_none() {
            let is_fine = L::all(&slopes.scales, |scale| scale.bits() <= FRACTION);
            let Some(up) = room(span.q, span.dq, span.count).filter(|_| is_fine) else {
                return Kernel::Divide;
            };
            (span.q, span.dq) = (span.q << up, span.dq << up);
            span.down = span.down.saturating_add(up);
            let scaled = |p: &i32, scale: &Scale| {
                let (left, right) = scale.to(FRACTION, up);
                nearest(*p << left, right)
            };
            span.p = L::zip(&span.p, &slopes.scales, scaled);
            span.dp = L::zip(&span.dp, &slopes.scales, scaled);
        }
        if is_level(span) {
            Kernel::Chord
        } else {
            Kernel::Newton
        }
    }
}

/// Perspective by straight pieces between pixels that are right, as long as a tolerance allows.
///
/// Along a piece of L pixels, where an attribute changes by f′ a pixel and 1/w by δ of itself, the straight line is off by
/// |f′| · δ · L² / 4. Pieces have 64, 32, 16, 8, 4 or 2 pixels: the most that keeps this below the tolerance everywhere in
/// the triangle, and δ · L below 1/16. The ends' reciprocals have 16 bits, each found by two Newton steps from the last, so
/// that a piece takes no division and no product of 64 bits: the mode for cores that are slow at those, such as Cortex-M0+,
/// and fast on all. Where 1/w changes by 1/64 of itself a pixel or to less than half along a span, the span is divided at
/// each pixel.
///
/// A tolerance is in texels, whatever the texture's size. Besides, an attribute is off by up to 2^-13 of its greatest value
/// in the triangle: 1/32 of a texel where a texture of 256 is seen once, more where it repeats. Pieces hold colors
/// to the same number in steps of their channels (32 or 64 of an [`Rgb565`](embedded_graphics::pixelcolor::Rgb565)), and
/// other varyings in units of 2^16. A triangle that hardly changes in depth is one piece, where its texture coordinates may
/// be off by the tolerance and other varyings by what the shader allows ([`Varyings`](crate::shade::Varyings)).
///
/// Pieces end within the triangle, so that no attribute exceeds those of the corners but by rounding.
///
/// ```
/// use fixel::mode::Fast;
/// use fixel::{DrawOptions, fx};
/// let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fast {
    /// In units of 2^-16.
    tolerance: u32,
}

/// Most bits of an attribute in pieces.
const MOST_BITS: u32 = 28;

impl Fast {
    /// The counterpart of [`Newton`] in products of 16 bits, for cores without longer ones: off by up to 1/32 of a texel
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

    /// The exponent of the most pixels that a piece may have, where q is `least` or more and all is to be shifted `up`;
    /// `None` if even two are too many, or attributes have too many bits.
    #[inline]
    fn length<L: Lanes>(self, least: u32, slopes: &Slopes<L>, up: u32) -> Option<u32> {
        if self.tolerance == 0 || !L::all(&slopes.scales, |scale| scale.bits() <= MOST_BITS) {
            return None;
        }
        let step = slopes.q.unsigned_abs();
        let mut most = 0;
        L::zip(&slopes.p, &slopes.scales, |p, scale| {
            // f′ = (p′ − f · q′) / q, where |f| is at most half in units of 2^bits; in units of 2^28 / q.
            let gain = p.unsigned_abs().saturating_add(step >> 1);
            most = most.max((gain >> (MOST_BITS.wrapping_sub(scale.bits()) & 31)) + 1);
        });
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

impl Policy for Fast {
    #[inline]
    fn affine_within(self, tolerance: Tolerance) -> u32 {
        match tolerance {
            Tolerance::Units(units) if self.tolerance > 0 => units,
            _ => self.tolerance,
        }
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, slopes: &Slopes<L>) -> Option<Kernel> {
        let length = if slopes.least > FAR {
            self.length(slopes.least, slopes, 0)
        } else {
            None
        };
        length.map(Kernel::Pieces)
    }

    #[inline(always)]
    fn of_span<L: Lanes>(
        self,
        of_triangle: Option<Kernel>,
        span: &mut Span<L>,
        slopes: &Slopes<L>,
    ) -> Kernel {
        if let Some(Kernel::Pieces(length)) = of_triangle {
            return Kernel::Pieces(length);
        }
        let up = room(span.q, span.dq, span.count);
        let length = up.and_then(|up| {
            let others = (span.count as u32).wrapping_sub(1).cast_signed();
            let last = span.dq.wrapping_mul(others);
            let least = span.q.min(span.q.wrapping_add_signed(last));
            self.length(least, slopes, up)
        });
        let (Some(up), Some(length)) = (up, length) else {
            return Kernel::Divide;
        };
        (span.q, span.dq) = (span.q << up, span.dq << up);
        span.down = span.down.saturating_add(up);
        span.p = L::map(&span.p, |p| p << up);
        span.dp = L::map(&span.dp, |p| p << up);
        Kernel::Pieces(length)
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
}
