//! How exact an interpolated value has to be, derived from the number formats.
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

/// Units of the numerator by which a pixel may be off; see above.
const NUMERATOR: f64 = 56.5;
/// Units of 1/w by which a pixel may be off.
pub const INVERSE_W: f64 = 40.;
/// The least that 1/w of a corner is lifted to, if it is more than 2¹⁹ times as far as the nearest.
const LEAST: f64 = 2048.;

/// The least whole number of bits that attributes of these corners are shifted down by.
fn bits(corners: [i32; 3]) -> i32 {
    let size = corners.iter().map(|a| a.unsigned_abs()).max().unwrap();
    (33 - (size + (size >> 4)).leading_zeros().cast_signed()).min(32)
}

/// By how much a value may be off at a pixel `w` ahead, given the corners' own w.
pub fn perspective(corners: [i32; 3], corners_w: [f64; 3], w: f64) -> f64 {
    let nearest = corners_w.into_iter().fold(f64::MAX, f64::min);
    let farthest = corners_w.into_iter().fold(0., f64::max);
    let q = 2_f64.powi(30) * nearest / w;
    let lifted = if farthest / nearest > 2_f64.powi(19) {
        LEAST
    } else {
        0.
    };
    // Every pixel's 1/w is at least that of a lifted corner.
    let relative = (NUMERATOR + lifted) / (q.max(LEAST) - INVERSE_W);
    // Values at the ends of the format are drawn in by 64 units of the least 1/w, or up to twice that.
    let least = (2_f64.powi(30) * nearest / farthest).max(LEAST);
    let ends = if bits(corners) < 32 { 0. } else { 128. / least };
    // The quotient has 30 bits like the reciprocal, and is rounded down to a unit.
    2_f64.powi(bits(corners)) * (relative + ends + 2_f64.powi(-29)) + 1.
}

/// The same under a parallel projection: the numerator is a · 2^(30 - bits).
pub fn parallel(corners: [i32; 3]) -> f64 {
    let ends = if bits(corners) < 32 { 0. } else { 128. };
    2_f64.powi(bits(corners) - 30) * (NUMERATOR - INVERSE_W / 2. + ends) + 1.
}

/// By how many steps a 16-bit depth may be off before it is rounded down: the error of 1/w where
/// 2³⁰ is 65,536 steps at most, and 2⁻²⁹ for the reciprocal of the near plane's distance.
pub const DEPTH: f64 = (INVERSE_W + 3.) / 16384.;
