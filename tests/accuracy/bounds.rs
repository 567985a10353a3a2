//! The bound of an interpolated value's error in each mode, derived from the number formats.
//!
//! All errors are in units of the interpolants. 1/w is scaled so that bit 30 is set at the nearest corner; at a pixel
//! with distance w it is Q ≥ 2³⁰ · `w_min` / w units. An attribute a has the numerator a · Q · 2^-bits, where bits is
//! the least number with 2^(bits - 1) above 17/16 of |a| at every corner, and at most 32.
//!
//! | source | units of 1/w | units of the numerator |
//! |---|---|---|
//! | a corner's 1/w: a distance of 31 bits, its reciprocal, one shift | 4 | half of that |
//! | a corner's numerator, rounded to nearest | | ½ |
//! | area and its reciprocal, 31 bits each, on 31 bits | 4 | 2 |
//! | the start of a span, rounded to nearest | ½ | ½ |
//! | 63 steps, each rounded to nearest | 31½ | 31½ |
//!
//! The sums are 40 and 36½. In a small triangle, other errors replace the last three: 43 steps of ¾ unit, of which
//! ¼ comes from the rounding of the corners' weights; ½ from the rounding of their sum; and less than 1 from the
//! reciprocal of the area, because values differ by less than 2³⁰. Together these are 33¾, instead of 36 and 34.
//!
//! Because the numerator is at most Q/2, an error e of 1/w counts as much as an error e/2 of the numerator. Together
//! they make 56½ units, and each unit is 2^bits / Q of the attribute.
//!
//! If the nearest corner's 1/w has all 31 bits set except the last six, these 56½ units count as 113. That leaves room
//! to keep such a corner from exceeding 31 bits, for example by lowering it by 64 units: this moves an attribute by a
//! quarter of 2⁻²⁵ of its range over the corners, which is 16 of the 113 units.

use crate::mode::Mode;

/// Largest error of a pixel, in units of the numerator; see above.
const NUMERATOR: f64 = 56.5;
/// Largest error of a pixel, in units of 1/w.
pub const INVERSE_W: f64 = 40.;
/// A corner more than 2¹⁹ times as far as the nearest one is lifted to this 1/w.
const LEAST: f64 = 2048.;
/// The fewest bits of an attribute in `Newton`.
const NEWTON_BITS: i32 = 28;
/// The fewest bits of an attribute in `Affine`.
const AFFINE_BITS: i32 = 30;
/// A texel, in units of an attribute.
const TEXEL: f64 = 65536.;

/// The number of bits by which attributes with these values at the corners are shifted down.
fn bits(corners: [i32; 3]) -> i32 {
    let size = size(corners);
    (33 - (size + (size >> 4)).leading_zeros().cast_signed()).min(32)
}

/// The largest magnitude at a corner.
fn size([a, b, c]: [i32; 3]) -> u32 {
    a.unsigned_abs().max(b.unsigned_abs()).max(c.unsigned_abs())
}

/// The bound of a value's error in a triangle. It depends on a pixel's distance only through its 1/w.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// 1/w at the distance 1.
    nearer: f64,
    /// How much less 1/w may be than it should.
    lost: f64,
    /// The part of the bound that is inversely proportional to 1/w.
    inverse: f64,
    /// The other part.
    constant: f64,
    /// Whether the farthest pixel of a row decides for all its pixels.
    in_rows: bool,
}

impl Bound {
    /// The bound in a mode that divides by w, given the values and w at the corners.
    pub fn perspective(mode: Mode, corners: [i32; 3], corners_w: [f64; 3]) -> Self {
        let stepped = || stepped(corners, corners_w);
        match mode {
            Mode::Exact if is_precise(corners_w) => anew(corners, corners_w),
            Mode::Exact | Mode::Compact => stepped(),
            Mode::Newton => stepped().plus(newton(corners, corners_w)),
            Mode::Fast(_) => Self {
                in_rows: true,
                ..stepped().plus(mode.tolerance() * TEXEL + fast(corners))
            },
            Mode::Affine => panic!("{mode:?} does not divide by w"),
        }
    }

    /// The bound in modes that do not divide, and under a parallel projection, where the numerator is
    /// a · 2^(30 - bits).
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

    /// A bound that is larger by this at every pixel.
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

/// Whether `Exact` is certain to compute interpolants anew at each pixel: if a corner is below 2²⁷ units of 1/w, where
/// the nearest one has 2³⁰ to 2³¹.
pub fn is_precise(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 16.001 * nearest
}

/// Whether `Exact` may compute interpolants anew at each pixel.
fn may_be_precise(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 7.999 * nearest
}

/// The bound if interpolants are computed anew at each pixel, with all their bits: only the rounding of the corners
/// counts, and the rounding of steps, starts and areas does not.
///
/// - A corner's numerator is rounded to nearest: half a unit of 2^bits / Q.
/// - A corner's 1/w is truncated by less than a unit, after an error of up to 4 units of 2⁻³⁰ of itself. Its numerator
///   uses the same 1/w, so only its barycentric weight is wrong: a value moves by that part of its range over the
///   corners.
/// - Area and reciprocal have the same relative error for all interpolants, which cancels. The bits shifted out of a
///   gradient's numerator are below 2⁻²² of a unit, and a raised interpolant is rounded to half of a raised unit:
///   0.01 unit covers both.
/// - The quotient has the errors given above.
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
        // No pixel's 1/w is less than a lifted corner's.
        inverse: scale * (NUMERATOR + lifted(corners_w)),
        // The quotient has 30 bits, like the reciprocal, and is rounded down to a unit.
        constant: scale * (inwards(corners, corners_w) + 2_f64.powi(-29)) + 1.,
        in_rows: false,
    }
}

/// How far values at the ends of the format are moved inwards, relative to 2^bits: by 64 to 128 units of the least 1/w.
fn inwards(corners: [i32; 3], corners_w: [f64; 3]) -> f64 {
    if bits(corners) < 32 {
        return 0.;
    }
    let [nearest, farthest] = ends(corners_w);
    128. / (2_f64.powi(30) * nearest / farthest).max(LEAST)
}

/// The nearest and the farthest corner.
fn ends(w: [f64; 3]) -> [f64; 2] {
    [
        w.into_iter().fold(f64::MAX, f64::min),
        w.into_iter().fold(0., f64::max),
    ]
}

/// The units of 1/w by which a corner may be lifted.
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
/// Interpolants have 28 bits, so their unit is 2²⁸ / Q of the attribute. Because Q is at least 2²⁹, this is half of
/// the attribute's unit.
/// - If every corner's Q is above 2²⁹, interpolants have 28 bits from the start. Their error of 56½ units replaces the
///   error in the attribute's own bits. It is 28¼ units of the attribute, or 28.3, because a pixel's Q may be a little
///   below 2²⁹.
/// - Otherwise a span's interpolants are shifted. This rounds the start and 63 steps to nearest once more: 32 units,
///   which are 16 of the attribute.
///
/// The reciprocal: let δ ≤ 2⁻⁶ be the relative change of 1/w per pixel. The line through two reciprocals has, at the
/// third pixel, a relative error of 2δ² + 6δ³ + …, plus three times the error of the two reciprocals. A Newton step
/// squares this sum: (2⁻¹¹ · (1 + 2⁻⁴))² is 1.13 · 2⁻²². The products of the step lose at most 2⁻²⁷, far less than the
/// remaining 0.87 · 2⁻²². The total is 2⁻²¹ of the attribute. The product with the numerator is rounded down to a unit,
/// as the exact quotient is.
///
/// Where division makes almost no difference, no pixel is divided:
/// - A triangle that hardly changes in depth is affine. Its error is the one that its shader allows, 16 units by
///   default; plus the error of numerators, which have 30 bits (a quarter of 36½ units); plus a unit of rounding. That
///   is less than the sum of the following.
/// - A span along which 1/w hardly changes is straight, in quarter units of the attribute: the tangent at its middle
///   is 16 whole units away at the ends. Where Q is least, a reciprocal below 2³¹ has 31 bits: it contributes ½ to a
///   value below 2²⁹, and rounding contributes another ½: together 1. The dividend of a gain is rounded to half of its
///   unit, which the reciprocal turns into 1; the product is rounded once more, to ½; and to a gain below 2²⁵ the
///   reciprocal contributes 2⁻⁵. So 32 gains make 49, and everything together is 50: 12½ units. (Where Q is at least
///   2³⁰, the 1 of a gain is ½.)
///
/// An attribute with more bits, and any attribute beside it, is divided exactly.
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

/// The error of a straight span of `Newton`.
const STRAIGHT: f64 = 16. + 12.5;

/// The error from rounding the start and the steps of a span of `Newton` again.
const RUN_ROUNDING: f64 = 16.;

/// The error that `Fast` adds to the stepped interpolants' error and to the tolerance: in part relative to the largest
/// attribute A, in part in units of the attribute.
///
/// - 1/w is truncated to its upper 15 to 17 bits: a relative error of 2⁻¹⁴ where it has 15 (from 2²⁹ to 2³⁰).
/// - The reciprocal at the start of a span is rounded down to 16 to 18 bits: 2⁻¹⁵. Each later one results from two
///   Newton steps that start with an error of 1/16: 2⁻¹⁶ · 1.02. The products of the last step lose 2⁻¹⁸ and a unit.
///   The unit is 2⁻¹⁷ where 1/w has 15 bits; it is 2⁻¹⁵ where 1/w has 17 bits, with an error of 2⁻¹⁶ instead of 2⁻¹⁴.
/// - A step of the interpolants is truncated to 2⁻²⁸ of A's bits, and is taken 64 times: 2⁻²², or 2⁻²¹ where 1/w is
///   only 2²⁹.
/// - A value is rounded down by up to a unit, and so is the gain of each of 64 pixels: 65 units.
///
/// The total is less than 2⁻¹³ · 0.95 of A. A's bits hold 17/16 of A, which they exceed by less than a factor of two.
fn fast(corners: [i32; 3]) -> f64 {
    f64::from(size(corners)) * 0.95 * 2_f64.powi(-13) + 65.
}

/// Whether a corner's Q is below 2²⁹ even if the nearest one's is 2³¹.
fn is_far(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 4.001 * nearest
}

/// The largest difference between `Newton` and `Exact` if both have the same interpolants: if a corner is far, but not
/// so far that `Exact` computes interpolants anew. Both are rounded down to a unit, and `Exact` by half a unit more.
pub fn newton_from_exact(corners: [i32; 3], corners_w: [f64; 3]) -> Option<f64> {
    let is_alike = is_far(corners_w) && !may_be_precise(corners_w);
    is_alike.then(|| newton(corners, corners_w) + 1.5)
}

/// The bound of a 16-bit depth's error, in steps, before it is rounded down: the error of 1/w, of which 2³⁰ units are
/// at most 65,536 steps, and 2⁻²⁹ for the reciprocal of the near plane's distance.
pub const DEPTH: f64 = (INVERSE_W + 3.) / 16384.;

/// The bound of a depth's error in a triangle with these corners, one of which may be lifted.
pub fn depth(corners_w: [f64; 3]) -> f64 {
    DEPTH + lifted(corners_w) / 16384.
}

/// The bound of the error of 1/w, relative to the nearest corner's 1/w.
pub fn inverse_w(corners_w: [f64; 3]) -> f64 {
    (INVERSE_W + 3. + lifted(corners_w)) * 2_f64.powi(-30)
}
