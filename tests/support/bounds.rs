//! Bounds of an interpolated value's error in each mode, derived from the number formats.
//!
//! All errors are in units of the interpolants. 1/w is scaled so that bit 30 is set at the nearest corner. At a pixel
//! with distance w, it is Q ≥ 2³⁰ · `w_min` / w units. The numerator of an attribute a is a · Q · 2^-bits. Here, bits
//! is the least number, at most 32, with 2^(bits - 1) above 17/16 of |a| at every corner.
//!
//! | source | units of 1/w | units of the numerator |
//! |---|---|---|
//! | a corner's 1/w: a distance of 31 bits, its reciprocal, one shift | 4 | 2 |
//! | a corner's numerator, rounded to nearest | | ½ |
//! | area and its reciprocal, 31 bits each, on 31 bits | 4 | 2 |
//! | the start of a span, rounded to nearest | ½ | ½ |
//! | 63 steps, each rounded to nearest | 31½ | 31½ |
//!
//! The sums are 40 and 36½. In a small triangle, other errors replace the last three rows: 43 steps of ¾ unit,
//! including ¼ from the rounding of the corners' weights; ½ from the rounding of the sum of the weights; and less than
//! 1 from the reciprocal of the area, because values differ by less than 2³⁰. Together, these errors are 33¾ units. The
//! replaced rows add up to 36 and 34 units.
//!
//! The numerator is at most Q/2, so an error e of 1/w counts as much as an error e/2 of the numerator. Together, the
//! two errors are 56½ units of the numerator. Each unit is 2^bits / Q of the attribute.
//!
//! The bounds assume that Q is only 2³⁰ at the nearest corner. If all 31 bits of this Q are set except the last six,
//! units are half as large, so the bounds allow 113 units. This leaves room to keep Q within 31 bits, for example by
//! lowering it by 64 units. Such a change would move an attribute by a quarter of 2⁻²⁵ of its range over the corners,
//! which is 16 of the 113 units.

use crate::mode::Mode;

/// The largest error of a pixel, in units of the numerator, as derived above.
const NUMERATOR: f64 = 56.5;
/// The largest error of a pixel, in units of 1/w.
pub const INVERSE_W: f64 = 40.;
/// The 1/w of a corner is lifted to this value if the corner is more than 2¹⁹ times as far as the nearest corner.
const LEAST: f64 = 2048.;
/// The fewest bits of an attribute in `Newton`.
const NEWTON_BITS: i32 = 28;
/// The fewest bits of an attribute in `Affine`.
const AFFINE_BITS: i32 = 30;
/// A texel, in units of an attribute.
const TEXEL: f64 = 65536.;

/// The number of bits by which an attribute is shifted down, given its values at the corners.
fn bits(corners: [i32; 3]) -> i32 {
    let size = size(corners);
    (33 - (size + (size >> 4)).leading_zeros().cast_signed()).min(32)
}

/// The largest absolute value at a corner.
fn size([a, b, c]: [i32; 3]) -> u32 {
    a.unsigned_abs().max(b.unsigned_abs()).max(c.unsigned_abs())
}

/// The bound of a value's error in a triangle. The bound at a pixel depends only on the pixel's 1/w.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// 1/w at the distance 1.
    nearer: f64,
    /// The largest amount by which 1/w may be too small.
    lost: f64,
    /// The part of the bound that is inversely proportional to 1/w.
    inverse: f64,
    /// The part of the bound that is the same at all distances.
    constant: f64,
    /// Whether the farthest pixel of a row determines the bound of all pixels of the row.
    in_rows: bool,
}

impl Bound {
    /// The bound in a mode that divides by w, given the values and the distances w of the corners.
    pub fn perspective(mode: Mode, corners: [i32; 3], corners_w: [f64; 3]) -> Self {
        let stepped = || stepped(corners, corners_w);
        match mode {
            Mode::Exact if is_precise(corners_w) => anew(corners, corners_w),
            Mode::Exact | Mode::Compact => stepped(),
            Mode::Newton | Mode::NewtonNarrow => {
                stepped().plus(mode.tolerance() * TEXEL + newton(corners, corners_w))
            }
            Mode::Fast(_) => Self {
                in_rows: true,
                ..stepped().plus(mode.tolerance() * TEXEL + fast(corners))
            },
            Mode::Affine => panic!("{mode:?} does not divide by w"),
        }
    }

    /// The bound in a mode that does not divide, and the bound under a parallel projection. In both cases, the
    /// numerator is a · 2^(30 - bits).
    pub fn parallel(mode: Mode, corners: [i32; 3]) -> Self {
        let bits = bits(corners);
        let numerator = NUMERATOR - INVERSE_W / 2.;
        // The unit of `Affine` is the attribute's unit, so nothing is rounded.
        let constant = if mode.in_parallel() == Mode::Affine && bits <= AFFINE_BITS {
            numerator
        } else {
            let ends = if bits < 32 { 0. } else { 128. };
            2_f64.powi(bits - 30) * (numerator + ends) + 1.
        };
        Self {
            nearer: 0.,
            lost: 0.,
            inverse: 0.,
            constant,
            in_rows: false,
        }
    }

    /// The bound plus `more` at every pixel.
    pub fn plus(self, more: f64) -> Self {
        Self {
            constant: self.constant + more,
            ..self
        }
    }

    /// The bound at a pixel with distance `w`, given the greatest distance in the pixel's row.
    pub fn at(&self, w: f64, farthest: f64) -> f64 {
        let w = if self.in_rows { farthest } else { w };
        self.inverse / ((self.nearer / w).max(LEAST) - self.lost) + self.constant
    }
}

/// Whether `Exact` is certain to recompute the interpolants at each pixel. `Exact` does this if a corner's 1/w is below
/// 2²⁷ units. The nearest corner's 1/w is 2³⁰ to 2³¹ units.
pub fn is_precise(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 16.001 * nearest
}

/// Whether `Exact` may recompute the interpolants at each pixel.
fn may_be_precise(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 7.999 * nearest
}

/// The bound if interpolants are recomputed at each pixel, with all their bits. In this case, only the rounding of the
/// corners counts, not the rounding of steps, starts and areas.
///
/// - A corner's numerator is rounded to nearest: half a unit of 2^bits / Q.
/// - The 1/w of a corner has a relative error of up to 4 units of 2⁻³⁰, and is then truncated by less than a unit. The
///   corner's numerator uses the same 1/w, so only the corner's barycentric weight is wrong: a value moves by this
///   relative error times the value's range over the corners.
/// - The area and its reciprocal have the same relative error in all interpolants, so this error cancels. The bits
///   shifted out of a gradient's numerator are below 2⁻²² of a unit. A raised interpolant is rounded to half of a
///   raised unit. An error of 0.01 unit covers both.
/// - The quotient has 30 bits, and is rounded down to a unit.
fn anew(corners: [i32; 3], corners_w: [f64; 3]) -> Bound {
    let [nearest, _] = ends(corners_w);
    let [a, b, c] = corners.map(f64::from);
    let spread = a.max(b).max(c) - a.min(b).min(c);
    let scale = 2_f64.powi(bits(corners));
    Bound {
        nearer: 2_f64.powi(30) * nearest,
        lost: 1.,
        inverse: scale * 0.51 + spread * (1. + lifted(corners_w)),
        constant: scale * (inwards(corners, corners_w) + 2_f64.powi(-29))
            + spread * 2_f64.powi(-28)
            + 1.,
        in_rows: false,
    }
}

/// The bound if interpolants are stepped along a span.
fn stepped(corners: [i32; 3], corners_w: [f64; 3]) -> Bound {
    let [nearest, _] = ends(corners_w);
    let scale = 2_f64.powi(bits(corners));
    Bound {
        nearer: 2_f64.powi(30) * nearest,
        lost: INVERSE_W,
        // No pixel has a smaller 1/w than the lifted corner.
        inverse: scale * (NUMERATOR + lifted(corners_w)),
        // The quotient has 30 bits, like the reciprocal, and is rounded down to a unit.
        constant: scale * (inwards(corners, corners_w) + 2_f64.powi(-29)) + 1.,
        in_rows: false,
    }
}

/// How far values at the ends of the format are moved inwards, relative to 2^bits: 64 to 128 units of the least 1/w.
fn inwards(corners: [i32; 3], corners_w: [f64; 3]) -> f64 {
    if bits(corners) < 32 {
        return 0.;
    }
    let [nearest, farthest] = ends(corners_w);
    128. / (2_f64.powi(30) * nearest / farthest).max(LEAST)
}

/// The distances of the nearest and of the farthest corner.
fn ends(w: [f64; 3]) -> [f64; 2] {
    [
        w.into_iter().fold(f64::MAX, f64::min),
        w.into_iter().fold(0., f64::max),
    ]
}

/// The largest number of units by which a corner's 1/w is lifted.
fn lifted(w: [f64; 3]) -> f64 {
    let [nearest, farthest] = ends(w);
    if farthest / nearest > 2_f64.powi(19) {
        LEAST
    } else {
        0.
    }
}

/// The error that `Newton` adds.
///
/// Interpolants have 28 bits, so a unit is 2²⁸ / Q of the attribute. Because Q is at least 2²⁹, this is half of the
/// attribute's unit.
/// - If every corner's Q is above 2²⁹, interpolants have 28 bits from the start. The error of such interpolants, 56½
///   units or 28¼ units of the attribute, replaces the error in the attribute's own bits. The bound is 28.3, because a
///   pixel's Q can be a little below 2²⁹.
/// - Otherwise, the interpolants of a span are shifted. The shift rounds the start and 63 steps to nearest once more:
///   32 units, or 16 units of the attribute.
///
/// The reciprocal has its own error. Let δ ≤ 2⁻⁶ be the relative change of 1/w per pixel. The line through two
/// reciprocals has, at the third pixel, a relative error of 2δ² + 6δ³ + …, plus three times the error of the two
/// reciprocals. A Newton step squares this sum: (2⁻¹¹ · (1 + 2⁻⁴))² is 1.13 · 2⁻²². The products of the step lose at
/// most 2⁻²⁷, far less than the remaining 0.87 · 2⁻²². The total is 2⁻²¹ of the attribute. The product with the
/// numerator is rounded down to a unit, like the exact quotient.
///
/// Where division would make almost no difference, `Newton` does not divide:
/// - A triangle that hardly changes in depth is drawn affinely. The triangle's error is the error that is allowed, plus
///   the error of numerators with 30 bits (a quarter of 36½ units), plus a unit of rounding. For a texture coordinate,
///   `Newton::NARROW` allows 16 units. This sum is less than the sum of the next item. The default allows 1/32 texel in
///   small triangles: this tolerance is added to the bound.
/// - A span along which 1/w hardly changes is drawn straight, in quarter units of the attribute. The tangent at the
///   middle of the span has an error of 16 whole units at the span's ends. Where Q is least, a reciprocal below 2³¹ has
///   31 bits. The reciprocal contributes ½ to the error of a value below 2²⁹, and rounding contributes another ½:
///   together 1. The dividend of a gain has a rounding error of half of its unit, and the product with the reciprocal
///   turns this error into 1. The product is rounded once more, to ½. The reciprocal contributes 2⁻⁵ to a gain below
///   2²⁵. So 32 gains make 49, and the total is 50 quarter units, that is, 12½ units. (Where Q is at least 2³⁰, the 1
///   of a gain is ½.)
///
/// An attribute with more than 28 bits is divided exactly, and so is every other attribute of the same shader.
fn newton(corners: [i32; 3], corners_w: [f64; 3]) -> f64 {
    let lacks = NEWTON_BITS - bits(corners);
    if lacks < 0 {
        return 0.;
    }
    let from_the_start = 28.3 * (1. - 2_f64.powi(-lacks));
    let units = if is_far(corners_w) {
        RUN_ROUNDING
    } else {
        from_the_start.max(RUN_ROUNDING)
    };
    let reciprocal = f64::from(size(corners)) * 2_f64.powi(-21);
    units + reciprocal.max(STRAIGHT)
}

/// The error of a span that `Newton` draws straight.
const STRAIGHT: f64 = 16. + 12.5;

/// The error from rounding the start and the steps of a span of `Newton` again.
const RUN_ROUNDING: f64 = 16.;

/// The error that `Fast` adds to the stepped interpolants' error and to the tolerance. One part of the error is
/// relative to A, the largest absolute value at a corner. The other part is in units of the attribute.
///
/// - 1/w is truncated to its upper 15 to 17 bits. This is a relative error of 2⁻¹⁴ where 15 bits are left (1/w from 2²⁹
///   to 2³⁰).
/// - The reciprocal at the start of a span is rounded down to 16 to 18 bits: 2⁻¹⁵. Each later reciprocal results from
///   two Newton steps that start with an error of 1/16: 2⁻¹⁶ · 1.02. The products of the last step lose 2⁻¹⁸ and a
///   unit. The reciprocal's unit is 2⁻¹⁷ where 1/w has 15 bits. Where 1/w has 17 bits, the unit is 2⁻¹⁵, but there the
///   error of 1/w is only 2⁻¹⁶.
/// - A step of the interpolants is truncated to 2⁻²⁸ of A's bits. 64 steps add up to 2⁻²², or 2⁻²¹ where 1/w is only
///   2²⁹.
/// - A value is rounded down by up to a unit, and so is the gain of each of 64 pixels: 65 units.
///
/// The total is less than 2⁻¹³ · 0.95 of A. The range of A's bits is at least 17/16 of A, and less than twice that.
fn fast(corners: [i32; 3]) -> f64 {
    f64::from(size(corners)) * 0.95 * 2_f64.powi(-13) + 65.
}

/// Whether a corner's Q is below 2²⁹ even if the nearest corner's Q is 2³¹.
fn is_far(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 4.001 * nearest
}

/// The largest difference between `Newton::NARROW` and `Exact` if both have the same interpolants. Both modes have the same
/// interpolants if a corner is far, but not so far that `Exact` recomputes the interpolants. Both modes round down to a
/// unit, and `Exact` loses half a unit more.
pub fn newton_from_exact(corners: [i32; 3], corners_w: [f64; 3]) -> Option<f64> {
    let is_alike = is_far(corners_w) && !may_be_precise(corners_w);
    is_alike.then(|| newton(corners, corners_w) + 1.5)
}

/// The bound of a 16-bit depth's error, in steps, before the depth is rounded down. The bound consists of the error of
/// 1/w, with 2³⁰ units for at most 65,536 steps, and of 2⁻²⁹ for the reciprocal of the near plane's distance.
pub const DEPTH: f64 = (INVERSE_W + 3.) / 16384.;

/// The bound of a depth's error in a triangle with these corners, including the error of a lifted corner.
pub fn depth(corners_w: [f64; 3]) -> f64 {
    DEPTH + lifted(corners_w) / 16384.
}

/// The bound of the error of 1/w, relative to the nearest corner's 1/w.
pub fn inverse_w(corners_w: [f64; 3]) -> f64 {
    (INVERSE_W + 3. + lifted(corners_w)) * 2_f64.powi(-30)
}
