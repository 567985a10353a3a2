//! The modes: which [plan](super::plan) each mode chooses, and the inequalities behind the choice.

#![allow(private_interfaces)] // of functions that only this crate calls

use super::newton::{FRACTION, tangent};
use super::pixels::Span;
use super::plan::Plan;
use super::setup::{Planes, SHALLOW, Varying};
use crate::num::Scalar;
use crate::sealed::Sealed;
use crate::shade::{Lanes, Tolerance};

/// How varyings (colors, texture coordinates, and other numbers of a shader) are interpolated between a triangle's
/// corners. The modes differ in accuracy, speed and size of code.
///
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by the default mode"))]
/// [`DrawOptions::with_mode`](crate::DrawOptions::with_mode) chooses the mode of a draw call. A program links only the
/// modes that it names.
///
/// | mode | error in texels (256x256 texture, 320x240 frame) | work per pixel | for |
/// |---|---|---|---|
/// | [`Newton`], the default | 0.001; in small triangles, plus 1/32 | one Newton step of a reciprocal | all but the smallest cores |
/// | [`Newton::NARROW`] | 0.001 | the same | where 1/32 texel would show |
/// | [`Fast`] | its tolerance, plus 1/32 | additions | Cortex-M0+, large triangles |
/// | [`Fast::NARROW`] | 1/16 | additions | Cortex-M0+, where a larger error would show |
/// | [`Exact`] | 0.001, up to a depth ratio of 1,000 within a triangle | a 31-bit reciprocal | a reference to compare with; 64-bit computers |
/// | [`Affine`] | no bound | additions | surfaces that face the eye or are small |
/// | [`Compact`] | 0.001 | a 31-bit reciprocal | programs that must be small |
///
/// Under a parallel projection, varyings are linear on the screen, so every mode needs only additions. Each mode draws
/// the same pixels in bands and in whole frames, and on every target. All modes except `Compact` compute the same
/// depths.
///
/// A span is up to 64 consecutive pixels of a row. For each span, a mode chooses one of four loops over pixels (the
/// kernels): straight, pieces, Newton, divide.
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
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an interpolation mode",
    note = "a mode is `Newton`, `Fast`, `Exact`, `Affine` or `Compact`, from `fixel::mode`"
)]
pub trait Mode: Copy + Sealed {
    /// The plan for varyings that are not affine. Where this plan is not possible, the mode divides at each pixel. For
    /// varyings that are not affine, a program contains code for these two cases only.
    ///
    /// With [`Straight`](Plan::Straight), nothing is ever divided. With [`Divide`](Plan::Divide) or
    /// [`PerPixel`](Plan::PerPixel), all varyings are divided. With `Divide`, all triangles, even small ones, have wide
    /// planes (see [`Interpolant`](super::interpolant::Interpolant)) and are drawn in the same way.
    #[doc(hidden)]
    const KERNEL: Plan;

    /// The greatest error, in units of the varying, with which a small triangle and any other triangle may be drawn
    /// without divisions. 0 means that both always divide.
    #[doc(hidden)]
    #[inline]
    fn affine_within(self, _tolerance: Tolerance) -> [u32; 2] {
        [0; 2]
    }

    /// The plan for a triangle that is not affine.
    #[doc(hidden)]
    #[inline]
    fn of_triangle<L: Lanes>(self, _planes: &Planes<L>) -> Plan {
        Self::KERNEL
    }

    /// The plan for a span, if the plan of its triangle is [`KERNEL`](Self::KERNEL) or [`BySpan`](Plan::BySpan). This
    /// function may scale the span for its plan.
    #[doc(hidden)]
    #[inline(always)]
    fn of_span<L: Lanes>(
        self,
        of_triangle: Plan,
        _planes: &Planes<L>,
        _span: &mut Span<L>,
    ) -> Plan {
        of_triangle
    }
}

impl Sealed for Exact {}
impl Sealed for Compact {}
impl Sealed for Affine {}
impl Sealed for Newton {}
impl Sealed for Fast {}

/// [`Newton`] steps, and pieces chosen for a single span, require δ ≤ 2^-6. (For the meaning of the letters, see
/// [`plan`](super::plan).)
const STEEPEST: u32 = 6;

/// A corner with a q below this number is more than 8 to 16 times as far away as the nearest corner, because the
/// nearest corner has a q from 2^30 to 2^31. In the scale of the nearest corner, interpolants are rounded to half a
/// unit, and the steps of a span add an error of up to 32 units. In all, a varying has an error of up to 56½ units. A
/// coordinate of up to 256 texels has a [`Scale`](super::scale::Scale) of 26 bits, so a unit at the nearest corner is
/// at most 2^-4 · 2^-16 texel. A unit grows with the distance: at 16 times the distance, the error is at most 56½ ·
/// 2^-16 texel. (0.001 texel is 65½ · 2^-16 texel.)
const DEEP: u32 = 1 << 27;

/// The left shift of a span's interpolants that brings q between 2^29 and 2^31 at all pixels of the span; `None` if δ
/// exceeds 2^-6 at the least q of the span, or if q has 32 bits. A span has at most 64 pixels, so with such a δ, q
/// changes less than twofold along the span.
#[inline(never)]
fn room(q: u32, step: i32, count: usize) -> Option<u32> {
    let others = (count as u32).cast_signed().wrapping_sub(1);
    let last = q.wrapping_add_signed(step.wrapping_mul(others));
    let (least, most) = (q.min(last), q.max(last));
    let is_gentle = step.unsigned_abs() <= least >> STEEPEST && most >> 31 == 0;
    is_gentle.then(|| most.leading_zeros().wrapping_sub(1) & 31)
}

/// Perspective-correct: each pixel divides by its 1/w, exact to 31 bits.
///
/// Each pixel computes its varyings anew from the span's interpolants (1/w, and the varyings divided by w), and rounds
/// them down to their units. The reciprocal adds a relative error below 2⁻³⁰. If a triangle's farthest corner is more
/// than 8 to 16 times as far away as its nearest corner (the limit depends on the triangle), each pixel computes its
/// own interpolants, in 64 bits. So the error stays within a thousandth of a texel, for a texture of 256 texels and
/// depth ratios of up to 1,000 within a triangle.
///
/// ```
/// use fixel::{DrawOptions, mode::Exact};
/// let options = DrawOptions::new().with_mode(Exact);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exact;

impl Mode for Exact {
    const KERNEL: Plan = Plan::PerPixel;

    #[inline]
    fn of_triangle<L: Lanes>(self, planes: &Planes<L>) -> Plan {
        if planes.setup.least < DEEP {
            Plan::PerPixel
        } else {
            Plan::Divide
        }
    }
}

/// Perspective-correct: each pixel divides by its 1/w. The mode with the least code.
///
/// All triangles and all spans take one path. So a program contains no special paths for small triangles or linear
/// spans. On a Cortex-M4 at opt-level "s", drawing textured triangles with a depth buffer takes a fifth less code than
/// in mode [`Newton`], and 2 to 2.7 times the instructions. On a core without 64-bit products, it takes 3 to 5 times
/// the instructions of [`Fast`].
///
/// The error is at most as large as in [`Newton::NARROW`]. Stored depths may differ by a step from the depths of the
/// other modes, so do not use `Compact` and another mode with one depth buffer.
///
/// ```
/// use fixel::{DrawOptions, mode::Compact};
/// let options = DrawOptions::new().with_mode(Compact);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compact;

impl Mode for Compact {
    const KERNEL: Plan = Plan::Divide;
}

/// Varyings are linear on the screen. This is correct under a parallel projection.
///
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by the default mode"))]
/// Under perspective, `Affine` bends textures; no other mode does. Use it for surfaces that face the eye, are small, or
/// are far away relative to their size. Rounding adds an error of up to 37 units to a varying (for a texture
/// coordinate, a two-thousandth of a texel). If the varying exceeds 2²⁸ units (4096 texels) in the triangle, the
/// rounding error is up to four times as large.
///
/// ```
/// use fixel::{DrawOptions, mode::Affine};
/// let hud = DrawOptions::new().with_mode(Affine);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Affine;

impl Mode for Affine {
    const KERNEL: Plan = Plan::Straight;
}

/// The default mode: perspective-correct, with one Newton step per pixel. The step starts from a guess that extends the
/// line through the reciprocals at the two pixels before.
///
/// Let δ be the relative change of 1/w from one pixel to the next. The guess has a relative error of 2δ², and the
/// Newton step squares it. With δ ≤ 2⁻⁶, the reciprocal has a relative error of at most 2⁻²¹. A span with a greater δ
/// is drawn with a reciprocal at every pixel, as in [`Compact`]. To the error of a varying in [`Compact`], rounding adds
/// up to 50 units (for a texture coordinate, 0.0008 texels).
///
/// Where division makes no visible difference, this mode does not divide:
///
/// - A row in which 1/w hardly changes, such as a row of a floor under a camera that does not roll, is drawn linearly
///   if the error is at most 16 units.
/// - A triangle that hardly changes in depth is drawn linearly if the error is within a tolerance. For a color, the
///   shader allows an eighth of a step ([`Varyings`](crate::shade::Varyings)). For a texture coordinate, the tolerance
///   is 1/4096 texel, or 1/32 texel in a small triangle, whose width and height add up to at most 43 pixels. Nearly all
///   triangles of a model are that small. [`Newton::NARROW`] allows only 1/4096 texel in small triangles, too.
///
/// Each span begins with the exact reciprocal. In a row, spans begin at the edge of a triangle, and every 64 pixels
/// after the edge. These places do not depend on bands, so a frame drawn in bands has the same pixels as a frame drawn at
/// once.
///
/// On a core without 64-bit products, such as Cortex-M0+ and M23, use [`Fast`]. On such a core, `Newton` takes more
/// than five times the instructions of `Fast` for a pixel with a Newton step, and about twice as many for a frame of
/// the measured cube.
///
/// ```
/// use fixel::{DrawOptions, mode::Newton};
/// let default: DrawOptions<Newton> = DrawOptions::new();
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Newton {
    /// The greatest error of a texture coordinate in a small triangle that is drawn linearly, in units of 2^-16 texel.
    tolerance: u32,
}

impl Newton {
    /// A tolerance of 1/4096 texel in small triangles, too, so that the total error is at most 0.001 texel everywhere.
    /// Compared with the default, a model of many small textured triangles takes longer.
    ///
    /// ```
    /// use fixel::{DrawOptions, mode::Newton};
    /// let options = DrawOptions::new().with_mode(Newton::NARROW);
    /// ```
    pub const NARROW: Self = Self { tolerance: 1 << 4 };

    /// The default, for constants: a tolerance of 1/32 texel in small triangles.
    pub(crate) const DEFAULT: Self = Self { tolerance: 1 << 11 };
}

impl Default for Newton {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The most bits that |q′| may have in a row along which 1/w hardly changes.
const LEVEL: u32 = 8;

/// Whether 1/w changes so little along a row that varyings are linear to within 2^-12 texel, which is 2^4 units.
///
/// Take the tangent to f in the middle of 64 pixels. At the ends, 32 pixels away, f deviates from the tangent by |f′| ·
/// δ · 32². As a fraction of 2^28 units, |f| is at most half, so f′ = (p′ − f · q′) / q is at most (|p′| + |q′|) / q.
/// With δ = |q′| / q and q ≥ 2^29, the deviation is at most 2^28 · (|p′| + |q′|) · |q′| · 2^10 / 2^58 units. It is
/// below 2^4 units if (|p′| + |q′|) · |q′| is below 2^(4 + 58 − 28 − 10) = 2^24.
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

impl Mode for Newton {
    const KERNEL: Plan = Plan::Newton;

    #[inline]
    fn affine_within(self, tolerance: Tolerance) -> [u32; 2] {
        match tolerance {
            Tolerance::Texels => [self.tolerance, Self::NARROW.tolerance],
            Tolerance::Units(units) => [units; 2],
        }
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, planes: &Planes<L>) -> Plan {
        let Planes { setup, varyings } = planes;
        if !L::all(varyings, |p: &Varying| p.scale.bits() <= FRACTION) {
            return Plan::Divide;
        }
        let is_gentle = setup.least > SHALLOW
            && setup.q.step.unsigned_abs() <= setup.least >> STEEPEST
            && L::all(varyings, |p: &Varying| p.scale.bits() == FRACTION);
        if is_gentle {
            Plan::Newton
        } else {
            Plan::BySpan
        }
    }

    #[inline(always)]
    fn of_span<L: Lanes>(self, of_triangle: Plan, planes: &Planes<L>, span: &mut Span<L>) -> Plan {
        if of_triangle == Plan::BySpan {
            let Some(up) = room(span.q, span.dq, span.count) else {
                return Plan::Divide;
            };
            (span.q, span.dq) = (span.q << up, span.dq << up);
            span.down = span.down.saturating_add(up);
            let scaled = |p: &i32, varying: &Varying| {
                let (left, right) = varying.scale.to(FRACTION, up);
                nearest(*p << left, right)
            };
            span.p = L::zip(&span.p, &planes.varyings, scaled);
            span.dp = L::zip(&span.dp, &planes.varyings, scaled);
        }
        if is_level(span) {
            tangent(span);
            Plan::Straight
        } else if of_triangle != Plan::SmallOverW
            || span.dq.unsigned_abs() <= planes.setup.least >> STEEPEST
        {
            Plan::Newton
        } else {
            Plan::Divide
        }
    }
}

/// Perspective-correct at the ends of straight pieces, and linear in between. Pieces are as long as your tolerance
/// allows.
///
/// In a piece of L pixels, let f′ be the change of a varying per pixel, and δ the relative change of 1/w per pixel. The
/// straight line has an error of |f′| · δ · L² / 4. Pieces have 64, 32, 16, 8, 4 or 2 pixels: the greatest length that
/// keeps this error within the tolerance everywhere in the triangle, and δ · L at or below 1/16.
///
/// The reciprocals at the ends have 16 bits, and two Newton steps compute each reciprocal from the one before. So a
/// piece needs no division and no 64-bit product. This makes `Fast` the mode for cores on which these operations are
/// slow, such as Cortex-M0+; it is fast on all cores. A span is drawn as in [`Compact`] if even pieces of two pixels
/// would break one of these limits, or if 1/w changes by more than 1/64 of itself from one pixel to the next. In a
/// triangle in which 1/w changes less than fourfold, the limit of 1/64 can rise to 1/32.
///
/// For a texture coordinate, the tolerance is in texels, for a texture of any size. For a color, the tolerance is in
/// steps of a channel (a channel of an [`Rgb565`](embedded_graphics::pixelcolor::Rgb565) has 32 or 64 values). For
/// other varyings, the tolerance is in multiples of 2^16. In addition, a varying has an error of up to 2^-13 of its
/// greatest value in the triangle: 1/32 texel if a texture of 256 texels is seen once, more if it repeats.
///
/// A triangle that hardly changes in depth is a single piece if two conditions hold: the error of texture coordinates
/// is within the tolerance, and the error of other varyings is within the shader's own tolerance
/// ([`Varyings`](crate::shade::Varyings)).
///
/// Pieces end within the triangle, so only rounding moves a varying beyond the values at the corners.
///
/// ```
/// use fixel::mode::Fast;
/// use fixel::{DrawOptions, fx};
/// let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fast {
    /// The tolerance in units of 2^-16.
    tolerance: u32,
}

/// The most bits of a varying's scale in pieces.
const MOST_BITS: u32 = 28;

impl Fast {
    /// A tolerance of 1/32 texel, for cores without 64-bit products, where a larger error would show. For a texture of
    /// 256 texels, the total error is up to 1/16 texel.
    pub const NARROW: Self = Self::within(crate::fx!(0.031_25));

    /// Pieces with an error of at most this many texels, to which the rounding error is added. With 0 or less, every
    /// pixel divides.
    #[must_use]
    pub const fn within(texels: Scalar) -> Self {
        let bits = texels.to_bits();
        Self {
            tolerance: if bits > 0 { bits.cast_unsigned() } else { 0 },
        }
    }

    /// The plan for the longest pieces that the tolerance allows; `None` if even two pixels are too many, or if
    /// varyings have too many bits. `least` is the least q. It is given before the shift by `up` that the caller will
    /// apply to all values.
    #[inline]
    fn pieces<L: Lanes>(self, least: u32, planes: &Planes<L>, up: u32) -> Option<Plan> {
        let Planes { setup, varyings } = planes;
        if self.tolerance == 0 || !L::all(varyings, |p: &Varying| p.scale.bits() <= MOST_BITS) {
            return None;
        }
        let step = setup.q.step.unsigned_abs();
        let mut most = 0;
        L::map(varyings, |p: &Varying| {
            // |f′| = |p′ − f · q′| / q. As a fraction of 2^bits units, |f| is at most half, so |f′| is at most `gain` /
            // q. `most` is the greatest |f′| of all varyings, in units of 2^28 / q.
            let gain = p.interpolant.step.unsigned_abs().saturating_add(step >> 1);
            most = most.max((gain >> (MOST_BITS.wrapping_sub(p.scale.bits()) & 31)) + 1);
        });
        let shifted = |value: u32| value << up.min(value.leading_zeros());
        self.length_at(least << up, shifted(step), shifted(most))
            .map(Plan::Pieces)
    }

    /// The length of pieces as the exponent of a power of two, 1 to 6; `None` if even two pixels are too many.
    #[inline(never)]
    fn length_at(self, least: u32, step: u32, gain: u32) -> Option<u32> {
        // `slope` is δ in units of 2^-16, and `gain` is f′ in units of the varying; both are rounded up. `least` has 30
        // or 31 bits.
        let divisor = (least >> 15).max(1 << 14);
        let slope = u64::from(step.div_ceil(divisor >> 1));
        let gain = u64::from(gain / divisor + 1) << (MOST_BITS - 15);
        // For L = 64, the error f′ · δ · L² / 4 is 2^(12 − 2 − 16) · `error`, which must be within the tolerance. Each
        // halving of L allows an `error` four times as large. The other condition is δ · L ≤ 1/16.
        let (error, mut allowed) = (gain * slope, u64::from(self.tolerance) << 6);
        (1..=6).rev().find(|length| {
            let fits = error <= allowed && slope << length <= 1 << 12;
            allowed <<= 2;
            fits
        })
    }
}

impl Mode for Fast {
    const KERNEL: Plan = Plan::Pieces(0);

    #[inline]
    fn affine_within(self, tolerance: Tolerance) -> [u32; 2] {
        match tolerance {
            Tolerance::Units(units) if self.tolerance > 0 => [units; 2],
            _ => [self.tolerance; 2],
        }
    }

    #[inline]
    fn of_triangle<L: Lanes>(self, planes: &Planes<L>) -> Plan {
        let least = planes.setup.least;
        let pieces = if least > SHALLOW {
            self.pieces(least, planes, 0)
        } else {
            None
        };
        pieces.unwrap_or(Plan::BySpan)
    }

    #[inline(always)]
    fn of_span<L: Lanes>(self, of_triangle: Plan, planes: &Planes<L>, span: &mut Span<L>) -> Plan {
        if of_triangle != Plan::BySpan {
            return of_triangle;
        }
        let up = room(span.q, span.dq, span.count);
        let pieces = up.and_then(|up| {
            let others = (span.count as u32).wrapping_sub(1).cast_signed();
            let last = span.dq.wrapping_mul(others);
            let least = span.q.min(span.q.wrapping_add_signed(last));
            self.pieces(least, planes, up)
        });
        let (Some(up), Some(pieces)) = (up, pieces) else {
            return Plan::Divide;
        };
        (span.q, span.dq) = (span.q << up, span.dq << up);
        span.down = span.down.saturating_add(up);
        span.p = L::map(&span.p, |p| p << up);
        span.dp = L::map(&span.dp, |p| p << up);
        pieces
    }
}

#[cfg(test)]
mod tests {
    use super::super::scale::{ONE, Scale, weigh};
    use super::super::setup::Setup;
    use super::*;
    use crate::fx;

    /// Tests spans just inside and just outside of each limit.
    #[test]
    fn room_is_for_gentle_spans() {
        // A span is shifted until its greatest q has 31 bits.
        assert_eq!(room(1 << 30, 0, 64), Some(0));
        assert_eq!(room((1 << 31) - 1, 0, 64), Some(0));
        assert_eq!(room(1 << 20, 0, 64), Some(10));
        assert_eq!(room(1 << 31, 0, 64), None);
        // The step is at most 2^-6 of the least q, at either end of the span.
        assert_eq!(room(1 << 30, 1 << 24, 2), Some(0));
        assert_eq!(room(1 << 30, (1 << 24) + 1, 2), None);
        assert_eq!(room((1 << 30) + (1 << 24), -(1 << 24), 2), Some(0));
        assert_eq!(room(1 << 30, -(1 << 24), 2), None);
        // With steps up to this limit, q changes less than twofold over 64 pixels. A step of 1/63 is above the limit.
        let step = (1 << 30) / 63;
        assert_eq!(room(1 << 30, step - 1, 64), None);
        assert_eq!(room((1 << 30) + 64, step, 64), None);
        assert_eq!(room(1 << 30, (1 << 24) - (1 << 18), 64), Some(0));
        assert_eq!(room(1 << 20, -(1 << 13), 64), Some(10));
    }

    #[test]
    fn pieces_are_as_long_as_the_tolerance_allows() {
        let quarter = Fast::within(fx!(0.25));
        // f′ is a texel per pixel and δ is `delta` · 2^-16; f′ · δ · L² / 4 may be at most a quarter of a texel.
        let texel = |delta: u32| quarter.length_at(1 << 30, delta << 14, 1 << 18);
        // δ and f′ are rounded up, so the error is a little greater than it seems, and the length is the next lower
        // power of two.
        assert_eq!(
            [16, 63, 255, 1023].map(texel),
            [Some(5), Some(4), Some(3), Some(2)]
        );
        // If 1/w does not change, a piece has all 64 pixels.
        assert_eq!(quarter.length_at(1 << 30, 0, 1 << 18), Some(6));
        // The step of a sliver, however steep, must not wrap to a small step.
        assert_eq!(quarter.length_at(1 << 30, 1 << 31, 1 << 18), None);
    }
    fn span<L: Lanes>(dq: i32, dp: L::Of<i32>) -> Span<L> {
        Span {
            q: 1 << 29,
            p: L::splat(1 << 28),
            dq,
            dp,
            down: 15,
            count: 64,
        }
    }

    /// Tests rows just inside and just outside of each limit.
    #[test]
    fn level_rows_hardly_change() {
        let one = |dq: i32, dp: i32| {
            let level = is_level(&span::<[(); 1]>(dq, [dp]));
            let same = [[dq, -dp], [-dq, dp], [-dq, -dp]]
                .map(|[dq, dp]| is_level(&span::<[(); 1]>(dq, [dp])));
            assert_eq!(same, [level; 3], "{dq} {dp}");
            // Every varying counts.
            let two = [[dp, 0], [0, dp]].map(|dp| is_level(&span::<[(); 2]>(dq, dp)));
            assert_eq!(two, [level; 2], "{dq} {dp}");
            level
        };
        // (|p′| + |q′|) · |q′| is below 2^24.
        for (dq, most) in [
            (255, 65_793),
            (254, 66_052),
            (2, (1 << 23) - 1),
            (1, (1 << 24) - 1),
        ] {
            assert!(one(dq, most - dq) && !one(dq, most - dq + 1), "{dq}");
        }
        assert!(one(0, 0) && one(0, (1 << 24) - 1) && one(255, 0));
        assert!(is_level(&span::<[(); 0]>(255, [])));
        // |q′| has at most 8 bits.
        assert!(!one(256, 0) && !one(1 << 24, 0) && !one(i32::MAX, 0));
        assert!(!is_level(&span::<[(); 0]>(256, [])));
        // In 32 bits, these products would wrap to 0, and then be below the limit.
        for (dq, dp) in [
            (1 << 16, 0),
            (1 << 20, 1 << 20),
            (2, i32::MAX - 1),
            (128, (1 << 25) - 128),
        ] {
            assert_eq!(dp.wrapping_add(dq).wrapping_mul(dq), 0);
            assert!(!one(dq, dp), "{dq} {dp}");
        }
        assert!(!is_level(&span::<[(); 1]>(i32::MIN, [i32::MIN])));
        assert!(!is_level(&span::<[(); 1]>(0, [i32::MIN])));
    }

    /// A scale of this many bits.
    fn scale(bits: u32) -> Scale {
        let scale = weigh(&mut [1 << 30 >> (32 - bits); 3], &[ONE; 3], 1);
        assert_eq!(scale.bits(), bits);
        scale
    }

    /// A triangle with this least 1/w and this change of 1/w per pixel, and varyings with scales of these bits.
    fn triangle(least: u32, step: i32, bits: [u32; 2]) -> Planes<[(); 2]> {
        let mut setup = Setup::new([false; 2], 28);
        (setup.least, setup.q.step) = (least, step);
        let varyings = bits.map(|bits| Varying {
            scale: scale(bits),
            ..Varying::UNSET
        });
        Planes { setup, varyings }
    }

    #[test]
    fn triangles_beyond_a_limit_take_another_plan() {
        let newton =
            |least, step, bits| Newton::default().of_triangle(&triangle(least, step, bits));
        let shallow = SHALLOW + 1;
        let step = (shallow >> 6).cast_signed();
        assert_eq!(newton(shallow, step, [28, 28]), Plan::Newton);
        assert_eq!(newton(shallow, -step, [28, 28]), Plan::Newton);
        assert_eq!(newton(shallow, step + 1, [28, 28]), Plan::BySpan);
        assert_eq!(newton(shallow, -step - 1, [28, 28]), Plan::BySpan);
        assert_eq!(newton(SHALLOW, 0, [28, 28]), Plan::BySpan);
        for (less, more) in [([27, 28], [29, 28]), ([28, 27], [28, 29])] {
            assert_eq!(newton(shallow, 0, less), Plan::BySpan);
            assert_eq!(newton(shallow, 0, more), Plan::Divide);
        }

        let exact = |least| Exact.of_triangle(&triangle(least, 0, [28, 28]));
        assert_eq!([DEEP - 1, DEEP].map(exact), [Plan::PerPixel, Plan::Divide]);

        let fast = |within, least, step, bits| {
            Fast::within(within).of_triangle(&triangle(least, step, bits))
        };
        assert_eq!(fast(fx!(1), shallow, 0, [28, 28]), Plan::Pieces(6));
        // δ times the number of pixels is at most 1/16.
        let steep = |step| fast(fx!(32767), shallow, step, [28, 28]);
        assert_eq!(
            [1 << 19, (1 << 19) + 1].map(steep),
            [6, 5].map(Plan::Pieces)
        );
        assert_eq!(
            [1 << 24, (1 << 24) + 1].map(steep),
            [Plan::Pieces(1), Plan::BySpan]
        );
        assert_eq!(fast(fx!(1), SHALLOW, 0, [28, 28]), Plan::BySpan);
        assert_eq!(fast(fx!(0), shallow, 0, [28, 28]), Plan::BySpan);
        for bits in [[29, 28], [28, 29]] {
            assert_eq!(fast(fx!(1), shallow, 0, bits), Plan::BySpan);
        }
    }

    /// Newton and Fast draw a triangle affinely within a tolerance; the other modes never do. Only Newton has a wider
    /// tolerance in small triangles, and only for texels.
    #[test]
    fn only_modes_with_a_tolerance_leave_out_divisions() {
        fn within<M: Mode>(mode: M) -> [[u32; 2]; 2] {
            [Tolerance::Texels, Tolerance::Units(5)].map(|of| mode.affine_within(of))
        }
        assert_eq!(within(Newton::default()), [[1 << 11, 1 << 4], [5; 2]]);
        assert_eq!(within(Newton::NARROW), [[1 << 4; 2], [5; 2]]);
        assert_eq!(within(Fast::within(fx!(0.25))), [[1 << 14; 2], [5; 2]]);
        for mode in [Fast::within(fx!(0)), Fast::within(fx!(-1))] {
            assert_eq!(within(mode), [[0; 2]; 2]);
        }
        assert_eq!(within(Exact), [[0; 2]; 2]);
        assert_eq!(within(Compact), [[0; 2]; 2]);
    }
}
