//! How exact an interpolated value has to be in each mode, derived from the number formats.
//!
//! Everything is relative to a unit of the interpolants: 1/w is scaled so that the nearest corner's
//! has bit 30 set, so that at a pixel w ahead it is Q ≥ 2³⁰ · `w_min` / w units. An attribute's
//! numerator is a · Q · 2^-bits, where 2^(bits - 1) is more than 17/16 of any corner's |a| (and 32 the most).
//!
//! | source | units of 1/w | units of the numerator |
//! |---|---|---|
//! | a corner's 1/w: a distance of 31 bits, its reciprocal, one shift | 4 | half of that |
//! | a corner's numerator, to the nearest | | ½ |
//! | area and its reciprocal, 31 bits each, on 31 bits | 4 | 2 |
//! | the start of a run, to the nearest | ½ | ½ |
//! | 63 steps, each to the nearest | 31½ | 31½ |
//!
//! That makes 40 and 36½. As the numerator is at most Q/2, an error e of 1/w is one of e/2 of the
//! numerator: in all 56½ units, which are 2^bits / Q of the attribute each.
//!
//! Where the nearest corner's 1/w has all 31 bits set but for the last six, those 56½ are 113 units: room
//! enough for what it takes to keep such a corner's from passing 31 bits, such as taking it for 64 units less. That
//! moves an attribute by a quarter of 2⁻²⁵ of what it differs by between corners: 16 of those 113 units.

use crate::mode::Mode;

/// Units of the numerator by which a pixel may be off; see above.
const NUMERATOR: f64 = 56.5;
/// Units of 1/w by which a pixel may be off.
pub const INVERSE_W: f64 = 40.;
/// The least that 1/w of a corner is lifted to, if it is more than 2¹⁹ times as far as the nearest.
const LEAST: f64 = 2048.;
/// Bits that `Newton` gives an attribute at least.
const NEWTON_BITS: i32 = 28;
/// Bits that `Affine` gives an attribute at least.
const AFFINE_BITS: i32 = 30;
/// A texel, in units of an attribute.
const TEXEL: f64 = 65536.;

/// The least whole number of bits that attributes of these corners are shifted down by.
fn bits(corners: [i32; 3]) -> i32 {
    let size = size(corners);
    (33 - (size + (size >> 4)).leading_zeros().cast_signed()).min(32)
}

/// The largest magnitude at a corner.
fn size(corners: [i32; 3]) -> u32 {
    corners.into_iter().map(i32::unsigned_abs).fold(0, u32::max)
}

/// By how much a value may be off at a pixel `w` ahead, given the corners' own w and the `farthest` of
/// the pixels in its run.
pub fn perspective(
    mode: Mode,
    corners: [i32; 3],
    corners_w: [f64; 3],
    w: f64,
    farthest: f64,
) -> f64 {
    match mode {
        Mode::Exact => exact(corners, corners_w, w),
        Mode::Newton => stepped(corners, corners_w, w) + newton(corners, corners_w),
        Mode::Fast(_) => {
            stepped(corners, corners_w, farthest) + mode.tolerance() * TEXEL + fast(corners)
        }
        Mode::Affine => panic!("{mode:?} does not divide by w"),
    }
}

/// The same where every pixel is divided by the exact reciprocal.
fn exact(corners: [i32; 3], corners_w: [f64; 3], w: f64) -> f64 {
    if is_precise(corners_w) {
        anew(corners, corners_w, w)
    } else {
        stepped(corners, corners_w, w)
    }
}

/// Whether `Exact` finds interpolants anew at each pixel, for sure: with a corner below 2²³ units of 1/w, where the
/// nearest one has from 2³⁰ to 2³¹.
pub fn is_precise(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 256.001 * nearest
}

/// Whether it may.
fn may_be_precise(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 127.999 * nearest
}

/// The same where interpolants are found anew at each pixel, in as many bits as there are: no step, no start and no
/// area adds to what corners are rounded by.
///
/// - A corner's numerator is rounded to the nearest: half a unit, of 2^bits / Q.
/// - A corner's 1/w is cut by less than a unit, and by up to 4 units of 2⁻³⁰ of itself before. Its numerator has the same
///   1/w, so that only its weight among the corners is off: a value moves by that part of what the corners differ by.
/// - Area and reciprocal are one error for all interpolants. What is shifted out of a plane's numerator is below 2⁻²² of a
///   unit, and a raised interpolant is rounded to half of a raised unit: 0.01 unit is plenty for both.
/// - The quotient is as above.
fn anew(corners: [i32; 3], corners_w: [f64; 3], w: f64) -> f64 {
    let [nearest, farthest] = ends(corners_w);
    let q = (2_f64.powi(30) * nearest / w).max(LEAST) - 1.;
    let least = (2_f64.powi(30) * nearest / farthest).max(LEAST);
    let ends = if bits(corners) < 32 { 0. } else { 128. / least };
    let [a, b, c] = corners.map(f64::from);
    let spread = a.max(b).max(c) - a.min(b).min(c);
    let weights = spread * ((1. + lifted(corners_w)) / q + 2_f64.powi(-28));
    2_f64.powi(bits(corners)) * (0.51 / q + ends + 2_f64.powi(-29)) + weights + 1.
}

/// The same where interpolants are stepped along a span.
fn stepped(corners: [i32; 3], corners_w: [f64; 3], w: f64) -> f64 {
    let [nearest, farthest] = ends(corners_w);
    let q = 2_f64.powi(30) * nearest / w;
    let lifted = lifted(corners_w);
    // Every pixel's 1/w is at least that of a lifted corner.
    let relative = (NUMERATOR + lifted) / (q.max(LEAST) - INVERSE_W);
    // Values at the ends of the format are drawn in by 64 units of the least 1/w, or up to twice that.
    let least = (2_f64.powi(30) * nearest / farthest).max(LEAST);
    let ends = if bits(corners) < 32 { 0. } else { 128. / least };
    // The quotient has 30 bits like the reciprocal, and is rounded down to a unit.
    2_f64.powi(bits(corners)) * (relative + ends + 2_f64.powi(-29)) + 1.
}

/// The nearest and the farthest corner.
fn ends(w: [f64; 3]) -> [f64; 2] {
    [
        w.into_iter().fold(f64::MAX, f64::min),
        w.into_iter().fold(0., f64::max),
    ]
}

/// Units of 1/w that a corner may be lifted by.
fn lifted(w: [f64; 3]) -> f64 {
    let [nearest, farthest] = ends(w);
    if farthest / nearest > 2_f64.powi(19) {
        LEAST
    } else {
        0.
    }
}

/// What `Newton` adds to that.
///
/// Interpolants have 28 bits, so that their unit is 2²⁸ / Q of the attribute, and Q is 2²⁹ at least:
/// half of the attribute's unit.
/// - They have those from the start where no corner's Q is 2²⁹ or less. Then the 56½ units that they are off by
///   are 28¼ of the attribute, 28.3 with what Q may be below that of the corners, instead of what they are in
///   the attribute's own bits.
/// - Elsewhere a run's are shifted, and start and 63 steps rounded to the nearest once more: 32 units are 16.
///
/// The reciprocal: 1/w changes by δ ≤ 2⁻⁶ of itself per pixel. Two reciprocals extended in a line are off at
/// the third by 2δ² + 6δ³ + … of it, and by three times what they are off themselves; a Newton step
/// squares that. 2⁻¹¹ · (1 + 2⁻⁴) squared is 1.13 · 2⁻²², and what the products of the step lose, 2⁻²⁷ of it at
/// most, is far from the other 0.87: 2⁻²¹ of the attribute. Its product with the numerator is rounded down
/// to a unit, as the exact quotient is.
///
/// Where it is next to nothing, no pixel divides:
/// - A triangle that hardly changes in depth is affine: what its shader allows, 16 units unless it says otherwise, what
///   numerators are off by, which have 30 bits (a quarter of 36½ units), and a unit of rounding. That is less than the sum of the
///   following.
/// - A run along which 1/w hardly changes is straight, in units of a quarter: the line that touches it in the middle, 16 whole
///   units away at the ends. Where Q is least, a reciprocal below 2³¹ has 31 bits: of a value below 2²⁹ it may take ½, and rounding
///   as much: 1. A gain's dividend is rounded to half of its unit, which the reciprocal makes 1, and its product once more to ½; of
///   a gain below 2²⁵ the reciprocal may take 2⁻⁵. So 32 gains make 49, and all is 50: 12½ units. (Where Q is 2³⁰ and more, a gain's 1
///   is ½.)
///
/// An attribute of more bits, and one beside it, is divided exactly.
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

/// What a run of `Newton` that is straight is off by.
const STRAIGHT: f64 = 16. + 12.5;

/// What start and steps of a run of `Newton` are off by once they are rounded again.
const RUN_ROUNDING: f64 = 16.;

/// What `Fast` adds to that and to the tolerance, in parts of the largest attribute A, and in its units.
///
/// - 1/w is cut to its upper 15 to 17 bits, so that it is off by 2⁻¹⁴ of itself where it has 15 (from 2²⁹ to 2³⁰).
/// - The reciprocal at the start of a run is rounded down to 16 to 18 bits: 2⁻¹⁵. Others come of two Newton
///   steps from one that is off by 1/16: 2⁻¹⁶ · 1.02; and the last step's products cut 2⁻¹⁸ and a unit, which is 2⁻¹⁷ where
///   1/w has 15 bits, and 2⁻¹⁵ where it has 17 and is off by 2⁻¹⁶ instead of 2⁻¹⁴.
/// - A step of the interpolants is cut to 2⁻²⁸ of A's bits, and is taken 64 times: 2⁻²², where 1/w is 2²⁹ once more: 2⁻²¹.
/// - A value is rounded down to a unit, and the gains of 64 pixels are by up to a unit each: 65.
///
/// In all less than 2⁻¹³ · 0.95 of A, which the bits exceed by less than twice: they are for 17/16 of A.
fn fast(corners: [i32; 3]) -> f64 {
    f64::from(size(corners)) * 0.95 * 2_f64.powi(-13) + 65.
}

/// Whether a corner's Q is below 2²⁹, whatever that of the nearest one, below 2³¹, is.
fn is_far(corners_w: [f64; 3]) -> bool {
    let [nearest, farthest] = ends(corners_w);
    farthest > 4.001 * nearest
}

/// By how much `Newton` and `Exact` may differ where they have the same interpolants, which is where a corner
/// is far, but not so far that `Exact` finds them anew: both are rounded down to a unit, `Exact` by half of one more.
pub fn newton_from_exact(corners: [i32; 3], corners_w: [f64; 3]) -> Option<f64> {
    let is_alike = is_far(corners_w) && !may_be_precise(corners_w);
    is_alike.then(|| newton(corners, corners_w) + 1.5)
}

/// What a value may be off by under a parallel projection, where the numerator is a · 2^(30 - bits), and in
/// modes that do not divide.
pub fn parallel(mode: Mode, corners: [i32; 3]) -> f64 {
    let bits = bits(corners);
    let numerator = NUMERATOR - INVERSE_W / 2.;
    // `Affine`'s unit is the attribute's, to which nothing is rounded.
    if mode.in_parallel() == Mode::Affine && bits <= AFFINE_BITS {
        return numerator;
    }
    let ends = if bits < 32 { 0. } else { 128. };
    2_f64.powi(bits - 30) * (numerator + ends) + 1.
}

/// By how many steps a 16-bit depth may be off before it is rounded down: the error of 1/w where
/// 2³⁰ is 65,536 steps at most, and 2⁻²⁹ for the reciprocal of the near plane's distance.
pub const DEPTH: f64 = (INVERSE_W + 3.) / 16384.;

/// The same for a triangle of these corners, one of which may be lifted.
pub fn depth(corners_w: [f64; 3]) -> f64 {
    DEPTH + lifted(corners_w) / 16384.
}

/// By how much 1/w may be off, in parts of the nearest corner's.
pub fn inverse_w(corners_w: [f64; 3]) -> f64 {
    (INVERSE_W + 3. + lifted(corners_w)) * 2_f64.powi(-30)
}
