//! Which kernel draws a span: each mode's choice, and the inequalities behind it.
//!
//! Notation, for values along a row of pixels: f is an attribute, q is 1/w, and p is f · q. f′, q′ and p′ are their
//! changes from one pixel to the next, and δ = |q′| / q. q is scaled so that its greatest value in a triangle has bit
//! 30 set.
//!
//! The [`interpolator`](super::interpolator) asks in this order:
//!
//! 1. Under a parallel projection and in [`Affine`], nothing is divided: the kernel is straight.
//! 2. If a triangle's attributes are affine within the mode's tolerance ([`Policy::affine_within`]), the kernel is
//!    straight, too. The set-up tells; its inequality stands at `Attribute::affine_range` in setup.rs.
//! 3. In [`Exact`], a deep triangle ([`DEEP`]) divides anew at each pixel.
//! 4. [`Policy::of_triangle`] may choose for all spans of a triangle, and
//! 5. [`Policy::of_span`] for a single one.

use super::newton::FRACTION;
use super::pixels::Span;
use super::scale::Scale;
use super::setup::SHALLOW;
use crate::Scalar;
use crate::shade::{Lanes, Tolerance};

/// How attributes are interpolated between a triangle's corners, which trades accuracy for speed.
///
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by the default mode"))]
/// [`DrawOptions::with_mode`](crate::DrawOptions::with_mode) chooses the mode of a draw call. A program links only the
/// modes that it names.
///
/// | mode | error in texels (256x256 texture, 320x240 frame) | work per pixel | for |
/// |---|---|---|---|
/// | [`Newton`], the default | 0.001 | one Newton step of a reciprocal | all but the smallest cores |
/// | [`Fast`] | its tolerance, plus 1/32 | additions | Cortex-M0+, large triangles |
/// | [`Fast::NARROW`] | 1/16 | additions | Cortex-M0+, where a larger error would show |
/// | [`Exact`] | 0.001, up to a depth ratio of 1,000 within a triangle | a 31-bit reciprocal | a reference to compare with; 64-bit computers |
/// | [`Affine`] | no bound | additions | surfaces that face the eye or are small |
/// | [`Compact`] | 0.001 | a 31-bit reciprocal | programs that must be small |
///
/// Under a parallel projection, attributes are linear on the screen, so every mode only adds. Each mode draws the same
/// pixels in bands and in whole frames, and on every target. Depths are the same in all modes but `Compact`.
///
/// A span is a piece of a row, of up to 64 pixels. For each span, a mode chooses among four loops over pixels, the
/// kernels: straight, pieces, Newton, divide.
///
/// ```
/// use fixel::{DrawOptions, mode::{Exact, Mode}};
///
/// /// Options for any mode.
/// fn options<M: Mode>(mode: M) -> DrawOptions<M> {
///     DrawOptions::new().with_mode(mode)
/// }
/// let exact = options(Exact);
/// ```
#[allow(private_bounds)] // so that it is sealed
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an interpolation mode",
    note = "a mode is `Newton`, `Fast`, `Exact`, `Affine` or `Compact`, from `fixel::mode`"
)]
pub trait Mode: Policy {}

#[diagnostic::do_not_recommend]
impl<M: Policy> Mode for M {}

/// The code that draws a span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kernel {
    /// Attributes are linear along the span, and stored multiplied by 4.
    Straight,
    /// Attributes are not divided by w and have a scale, which each pixel restores.
    Scaled,
    /// Attributes are replaced by the line that touches them in the middle of the span.
    Tangent,
    /// Straight pieces; their length is 2 to this power pixels.
    Pieces(u32),
    /// One Newton step per pixel.
    Newton,
    /// One division per pixel.
    Divide,
    /// The same, with interpolants that each pixel computes anew.
    DivideAnew,
}

/// The changes of a triangle's interpolants along a row, and their scales.
pub(crate) struct Derivatives<L: Lanes> {
    /// q′.
    pub q: i32,
    /// p′ of each attribute; its unit is 2^(bits − 30) units of the attribute.
    pub p: L::Of<i32>,
    pub scales: L::Of<Scale>,
    /// The least q at a corner.
    pub least: u32,
}

/// The decisions of a mode.
pub(crate) trait Policy: Copy {
    /// Whether attributes are divided by w at all.
    const DIVIDES: bool = true;

    /// The least number of bits of a [`Scale`] in triangles in which q changes less than fourfold. With b bits, an
    /// interpolant's unit is 2^(b − 30) units of the attribute. More bits than the attribute has cost accuracy, but
    /// save scaling.
    const LEAST_BITS: u32 = 1;

    /// The same under a parallel projection. With [`WHOLE`] bits, an interpolant's unit is the attribute's unit.
    const LEAST_PARALLEL_BITS: u32 = WHOLE;

    /// Whether it chooses [`Kernel::Newton`].
    const REFINES: bool = false;

    /// Whether it chooses [`Kernel::Pieces`].
    const HAS_PIECES: bool = false;

    /// Whether triangles that have a corner with q below [`DEEP`] compute their interpolants anew at each pixel.
    const IS_PRECISE: bool = false;

    /// Whether all triangles have wide planes, and all spans are divided; then the items below are not used.
    const IS_COMPACT: bool = false;

    /// The kernel of a mode that has only one.
    const KERNEL: Kernel = Kernel::Divide;

    /// The greatest error that an attribute may have, in its units, if that saves all divisions; with 0, none are
    /// saved.
    #[inline]
    fn affine_within(self, _tolerance: Tolerance) -> u32 {
        0
    }

    /// The kernel for all spans of a triangle that is not affine; `None` if it is chosen span by span.
    #[inline]
    fn of_triangle<L: Lanes>(self, _derivatives: &Derivatives<L>) -> Option<Kernel> {
        Some(Self::KERNEL)
    }

    /// The kernel for a span; it may scale the span for that kernel.
    #[inline(always)]
    fn of_span<L: Lanes>(
        self,
        _of_triangle: Option<Kernel>,
        _span: &mut Span<L>,
        _derivatives: &Derivatives<L>,
    ) -> Kernel {
        Self::KERNEL
    }
}

/// The number of bits of a scale at which an interpolant's unit is the attribute's unit.
pub(super) const WHOLE: u32 = 30;

/// Kernels that compute a reciprocal from earlier ones require δ ≤ 2^-6.
const STEEPEST: u32 = 6;

/// A corner whose q is below this is more than 8 to 16 times as far away as the nearest corner, whose q is from 2^30 to
/// 2^31. Interpolants are rounded to half a unit at the nearest corner's scale, and a span's steps add up to 32 units.
/// A unit is 2^-6 of 2^-16 texel at the nearest corner, if 256 texels span the triangle, and grows with the distance:
/// at 16 times the distance, 56½ units of 4¼ · 2^-6 are 60 of 2^-16 texel, and 0.001 texel is 65½.
pub(super) const DEEP: u32 = 1 << 27;

/// The left shift of a span's interpolants that brings q to 2^29 to 2^31 at all its pixels; `None` if q changes
/// twofold along the span, or if δ exceeds 2^-6.
#[inline(never)]
fn room(q: u32, step: i32, count: usize) -> Option<u32> {
    let others = (count as u32).cast_signed().wrapping_sub(1);
    let last = q.wrapping_add_signed(step.wrapping_mul(others));
    let (least, most) = (q.min(last), q.max(last));
    let is_gentle =
        step.unsigned_abs() <= least >> STEEPEST && least > most >> 1 && most >> 31 == 0;
    is_gentle.then(|| most.leading_zeros().wrapping_sub(1) & 31)
}

/// Perspective-correct, with the exact [`reciprocal`](crate::num::reciprocal) of 1/w at every pixel.
///
/// No pixel depends on the pixels before it. An attribute is computed from the span's interpolants and rounded down
/// to its unit; the reciprocal adds a relative error below 2⁻³⁰. In a triangle with a corner more than 8 to 16
/// times as far away as its nearest corner, each pixel computes its interpolants anew in 64 bits. So the error stays
/// within a thousandth of a texel, for a texture of 256 texels and depth ratios of up to 1,000 within a triangle.
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
}

/// Perspective-correct, with a reciprocal of 1/w at every pixel and nothing else: the least code.
///
/// All triangles and all spans take one path. So a program contains neither the paths for small triangles and for
/// linear spans, nor the choice among them. On a Cortex-M4 at opt-level "s", drawing textured triangles with a depth
/// buffer takes 10.1 KB of code in place of 12.6 KB in mode [`Newton`], and 2 to 2.5 times the instructions. On a core
/// without 64-bit products, it takes 3 to 5 times the instructions of [`Fast`].
///
/// The error is at most as large as in [`Newton`]. Stored depths may differ by a step from those of the other modes, so
/// do not use `Compact` and another mode with one depth buffer.
///
/// ```
/// use fixel::{DrawOptions, mode::Compact};
/// let options = DrawOptions::new().with_mode(Compact);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compact;

impl Policy for Compact {
    const LEAST_PARALLEL_BITS: u32 = 1;
    const IS_COMPACT: bool = true;
}

/// Linear on the screen, which is correct under a parallel projection.
///
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by the default mode"))]
/// Under perspective, it bends textures, which no other mode does. Use it for surfaces that face the eye, are small, or
/// are far away relative to their size. In addition, rounding adds an error of up to 37 units to an attribute (a
/// two-thousandth of a texel to a texture coordinate), and up to four times that if it exceeds 2²⁸ units (4096 texels)
/// in the triangle.
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
    const KERNEL: Kernel = Kernel::Straight;
}

/// Perspective-correct, with one Newton step per pixel from the two pixels before it: the default.
///
/// Let δ be the relative change of 1/w from one pixel to the next. Linear extrapolation from the reciprocals of 1/w
/// at two pixels has a relative error of 2δ² at the third; one Newton step squares it. δ is at most 2⁻⁶, so the
/// reciprocal has a relative error of at most 2⁻²¹. If 1/w changes faster, or by a factor of two along a span, the
/// span is drawn as in [`Exact`]. In addition, rounding adds an error of up to 57 units to an attribute (less than
/// 0.0008 texels to a texture coordinate), on top of the error of [`Exact`].
///
/// Nothing is divided where division makes no visible difference:
///
/// - A row in which 1/w hardly changes, such as a row of a floor under a camera that does not roll, is drawn linearly
///   if the error is at most 16 units.
/// - A triangle that hardly changes in depth is drawn linearly if the error is within the shader's tolerance
///   ([`Varyings`](crate::shade::Varyings)): 16 units of a texture coordinate, an eighth of a step of a color. This
///   covers nearly all triangles of a model with vertex colors.
///
/// Each span begins with the exact reciprocal, at every triangle's edge and every 64 pixels, so that bands equal
/// frames.
///
/// On a core without 64-bit products, such as Cortex-M0+ and M23, use [`Fast`]
/// ([`DrawOptions::fast`](crate::DrawOptions::fast)): there, a pixel that takes a Newton step costs 138 instructions in
/// place of 25, and a frame of the measured cube 3.6 million in place of 1.8.
///
/// ```
/// use fixel::{DrawOptions, mode::Newton};
/// let default: DrawOptions<Newton> = DrawOptions::new();
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Newton;

/// The error that a texture coordinate may have where no division takes place: 1/4096 texel.
const TEXEL_TOLERANCE: u32 = 16;

/// Most bits of |q′| in a row along which 1/w hardly changes.
const LEVEL: u32 = 8;

/// Whether 1/w changes so little along a row that attributes are linear to within 2^-12 texel, which is 2^4 units.
///
/// In the middle of 64 pixels, take the line that touches f. At the ends, 32 pixels away, f deviates from it by
/// |f′| · δ · 32². As a fraction of 2^28 units, |f| is at most half, so f′ = (p′ − f · q′) / q is at most
/// (|p′| + |q′|) / q. With δ = |q′| / q and q ≥ 2^29, the deviation is at most
/// 2^28 · (|p′| + |q′|) · |q′| · 2^10 / 2^58 units. It is below 2^4 units if (|p′| + |q′|) · |q′| is below
/// 2^(4 + 58 − 28 − 10) = 2^24.
#[inline]
pub(super) fn is_level<L: Lanes>(span: &Span<L>) -> bool {
    let step = span.dq.unsigned_abs();
    step >> LEVEL == 0
        && L::all(&span.dp, |p| {
            let gain = p.unsigned_abs().saturating_add(step);
            gain >> (32 - LEVEL) == 0 && gain.wrapping_mul(step) < 1 << 24
        })
}

/// `value` / 2^`down`, rounded to nearest.
#[inline]
fn nearest(value: i32, down: u32) -> i32 {
    value.wrapping_add(1 << down >> 1) >> down
}

impl Policy for Newton {
    const REFINES: bool = true;
    const LEAST_BITS: u32 = FRACTION;

    #[inline]
    fn affine_within(self, tolerance: Tolerance) -> u32 {
        match tolerance {
            Tolerance::Texels => TEXEL_TOLERANCE,
            Tolerance::Units(units) => units,
        }
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, derivatives: &Derivatives<L>) -> Option<Kernel> {
        if !L::all(&derivatives.scales, |scale| scale.bits() <= FRACTION) {
            return Some(Kernel::Divide);
        }
        let is_gentle = derivatives.least > SHALLOW
            && derivatives.q.unsigned_abs() <= derivatives.least >> STEEPEST
            && L::all(&derivatives.scales, |scale| scale.bits() == FRACTION);
        is_gentle.then_some(Kernel::Newton)
    }

    #[inline(always)]
    fn of_span<L: Lanes>(
        self,
        of_triangle: Option<Kernel>,
        span: &mut Span<L>,
        derivatives: &Derivatives<L>,
    ) -> Kernel {
        if of_triangle.is_none() {
            let Some(up) = room(span.q, span.dq, span.count) else {
                return Kernel::Divide;
            };
            (span.q, span.dq) = (span.q << up, span.dq << up);
            span.down = span.down.saturating_add(up);
            let scaled = |p: &i32, scale: &Scale| {
                let (left, right) = scale.to(FRACTION, up);
                nearest(*p << left, right)
            };
            span.p = L::zip(&span.p, &derivatives.scales, scaled);
            span.dp = L::zip(&span.dp, &derivatives.scales, scaled);
        }
        if is_level(span) {
            Kernel::Tangent
        } else {
            Kernel::Newton
        }
    }
}

/// Perspective-correct at the ends of straight pieces, which are as long as a tolerance allows.
///
/// In a piece of L pixels, let f′ be the change of an attribute per pixel, and δ the relative change of 1/w per
/// pixel. The straight line has an error of |f′| · δ · L² / 4. Pieces have 64, 32, 16, 8, 4 or 2 pixels: the greatest
/// length that keeps this error below the tolerance everywhere in the triangle, and δ · L below 1/16.
///
/// The reciprocals at the ends have 16 bits, and two Newton steps compute each from the last one. So a piece takes no
/// division and no 64-bit product. This makes it the mode for cores on which these are slow, such as Cortex-M0+; it is
/// fast on all cores. If 1/w changes by 1/64 of itself per pixel, or by a factor of two along a span, the span is
/// drawn as in [`Exact`].
///
/// The tolerance is in texels, whatever the texture's size. For a color, it counts steps of its channels (a channel of
/// an [`Rgb565`](embedded_graphics::pixelcolor::Rgb565) has 32 or 64 values); for other varyings, it counts multiples
/// of 2^16. In addition, an attribute has an error of up to 2^-13 of its greatest value in the triangle: 1/32 texel if
/// a texture of 256 texels is seen once, more if it repeats.
///
/// A triangle that hardly changes in depth is a single piece, if the error of texture coordinates is within the
/// tolerance and the error of other varyings is within what the shader allows ([`Varyings`](crate::shade::Varyings)).
///
/// Pieces end within the triangle, so only rounding takes an attribute beyond the values at the corners.
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
    /// A tolerance of 1/32 texel: the counterpart of [`Newton`] with 16-bit products, for cores without longer ones.
    /// For a texture of 256 texels, the total error is up to 1/16 texel.
    pub const NARROW: Self = Self::within(crate::fx!(0.031_25));

    /// Pieces with an error of at most this many texels, in addition to rounding. With 0 or less, there is a division
    /// at every pixel.
    #[must_use]
    pub const fn within(texels: Scalar) -> Self {
        let bits = texels.to_bits();
        Self {
            tolerance: if bits > 0 { bits.cast_unsigned() } else { 0 },
        }
    }

    /// The exponent of the most pixels that a piece may have, where q is at least `least` and all values will be
    /// shifted left by `up`; `None` if even two pixels are too many, or if attributes have too many bits.
    #[inline]
    fn length<L: Lanes>(self, least: u32, derivatives: &Derivatives<L>, up: u32) -> Option<u32> {
        if self.tolerance == 0 || !L::all(&derivatives.scales, |scale| scale.bits() <= MOST_BITS) {
            return None;
        }
        let step = derivatives.q.unsigned_abs();
        let mut most = 0;
        L::zip(&derivatives.p, &derivatives.scales, |p, scale| {
            // |f′| = |p′ − f · q′| / q, where |f| is at most half as a fraction of 2^bits units: at most gain / q.
            // `most` is in units of 2^28 / q.
            let gain = p.unsigned_abs().saturating_add(step >> 1);
            most = most.max((gain >> (MOST_BITS.wrapping_sub(scale.bits()) & 31)) + 1);
        });
        let shifted = |value: u32| value << up.min(value.leading_zeros());
        self.length_at(least << up, shifted(step), shifted(most))
    }

    #[inline(never)]
    fn length_at(self, least: u32, step: u32, gain: u32) -> Option<u32> {
        // δ in units of 2^-16, and f′ in units of the attribute, both rounded up; `least` has 30 or 31 bits.
        let divisor = (least >> 15).max(1 << 14);
        let slope = u64::from(step.div_ceil(divisor >> 1));
        let gain = u64::from(gain / divisor + 1) << (MOST_BITS - 15);
        // For L = 64, the error f′ · δ · L² / 4 is 2^(12 − 2 − 16) · `error`, which must be within the tolerance.
        // Every halving of L allows four times as much. The other condition is δ · L ≤ 1/16.
        let (error, mut allowed) = (gain * slope, u64::from(self.tolerance) << 6);
        (1..=6).rev().find(|length| {
            let fits = error <= allowed && slope << length <= 1 << 12;
            allowed <<= 2;
            fits
        })
    }
}

impl Policy for Fast {
    const HAS_PIECES: bool = true;

    #[inline]
    fn affine_within(self, tolerance: Tolerance) -> u32 {
        match tolerance {
            Tolerance::Units(units) if self.tolerance > 0 => units,
            _ => self.tolerance,
        }
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, derivatives: &Derivatives<L>) -> Option<Kernel> {
        let length = if derivatives.least > SHALLOW {
            self.length(derivatives.least, derivatives, 0)
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
        derivatives: &Derivatives<L>,
    ) -> Kernel {
        if let Some(Kernel::Pieces(length)) = of_triangle {
            return Kernel::Pieces(length);
        }
        let up = room(span.q, span.dq, span.count);
        let length = up.and_then(|up| {
            let others = (span.count as u32).wrapping_sub(1).cast_signed();
            let last = span.dq.wrapping_mul(others);
            let least = span.q.min(span.q.wrapping_add_signed(last));
            self.length(least, derivatives, up)
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

    /// The limits of spans that need no division, from both sides.
    #[test]
    fn room_is_for_gentle_spans_that_lose_less_than_half() {
        // A span may be shifted to 31 bits at its greatest q.
        assert_eq!(room(1 << 30, 0, 64), Some(0));
        assert_eq!(room((1 << 31) - 1, 0, 64), Some(0));
        assert_eq!(room(1 << 20, 0, 64), Some(10));
        assert_eq!(room(1 << 31, 0, 64), None);
        // δ is at most 2^-6 of the least q, at either end of the span.
        assert_eq!(room(1 << 30, 1 << 24, 2), Some(0));
        assert_eq!(room(1 << 30, (1 << 24) + 1, 2), None);
        assert_eq!(room((1 << 30) + (1 << 24), -(1 << 24), 2), Some(0));
        assert_eq!(room(1 << 30, -(1 << 24), 2), None);
        // Over 64 pixels, q must change less than twofold.
        let step = (1 << 30) / 63;
        assert_eq!(room(1 << 30, step - 1, 64), None);
        assert_eq!(room((1 << 30) + 64, step, 64), None);
        assert_eq!(room(1 << 30, (1 << 24) - (1 << 18), 64), Some(0));
        assert_eq!(room(1 << 20, -(1 << 13), 64), Some(10));
        assert_eq!(room(1 << 20, -(1 << 13), 65), None);
    }

    #[test]
    fn pieces_are_as_long_as_the_tolerance_allows() {
        let quarter = Fast::within(fx!(0.25));
        // f′ is a texel per pixel and δ is `delta` · 2^-16; f′ · δ · L² / 4 may be at most a quarter of a texel.
        let texel = |delta: u32| quarter.length_at(1 << 30, delta << 14, 1 << 18);
        // Both are rounded up to a little more than that, so the result is the next power of two below.
        assert_eq!(
            [16, 63, 255, 1023].map(texel),
            [Some(5), Some(4), Some(3), Some(2)]
        );
        // If 1/w does not change, a piece has all 64 pixels.
        assert_eq!(quarter.length_at(1 << 30, 0, 1 << 18), Some(6));
        // The step of a sliver, however steep, must not wrap to a small one.
        assert_eq!(quarter.length_at(1 << 30, 1 << 31, 1 << 18), None);
    }
}
