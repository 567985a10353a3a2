//! What a texture shows beyond its edges: it begins again or, if it is clamped, continues with the texels of its edge.

use crate::num::TexCoord;

/// The number of fraction bits that a texture coordinate has beyond the 16 of a position in texels.
const FINER: u32 = TexCoord::FRAC_BITS - 16;

/// Converts a primitive's texture coordinates, in units of 2⁻²⁰ repeat, to texels with 16 fraction bits: rounded to
/// nearest, saturated.
///
/// If `moves`, the coordinates are first moved by whole repeats, so that the middle between the least and the greatest
/// of them is in the first repeat. Coordinates then have the least magnitude: from about 1,900 texels on, a varying is
/// too large to be interpolated without divisions. A whole repeat is a whole number of texels, so coordinates that differ
/// by whole repeats round alike.
// Out of line, because all textured shaders share this code.
#[inline(never)]
pub(crate) fn texels(bits: [i32; 3], moves: bool, log2: u32) -> [i32; 3] {
    let [a, b, c] = bits;
    // Most coordinates are in the first repeat.
    let origin = if moves && (a | b | c) >> TexCoord::FRAC_BITS != 0 {
        let (least, greatest) = (a.min(b).min(c), a.max(b).max(c));
        let middle = (least >> 1) + (greatest >> 1);
        middle >> TexCoord::FRAC_BITS << TexCoord::FRAC_BITS
    } else {
        0
    };
    // A difference does not wrap to a positive number, because the origin is not above the middle.
    let [a, b, c] = bits.map(|bits| bits.wrapping_sub(origin));
    let up = log2.wrapping_sub(FINER);
    // Most coordinates need no rounding, and are far from the ends of the range.
    if up < (a | b | c).leading_zeros() {
        return [a << (up & 31), b << (up & 31), c << (up & 31)];
    }
    bits.map(|bits| {
        // The difference has at most 33 bits, and is shifted by at most 15, so it fits into 64 bits.
        let bits = i64::from(bits) - i64::from(origin);
        let texels = ((bits << log2) + (1 << (FINER - 1))) >> FINER;
        texels.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    })
}

/// The column or row of a texel that may lie beyond the edges. If the texture is clamped, the number is limited to the
/// edges. If it repeats, the number stays, because samplers already wrap.
#[inline]
pub(super) fn index<const CLAMPED: bool>(texel: i32, log2: u32) -> i32 {
    if CLAMPED {
        texel.max(0).min(1_i32.wrapping_shl(log2) - 1)
    } else {
        texel
    }
}

/// `texels` minus `little`, both with 16 fraction bits. If the texture repeats, the difference may wrap: then it is
/// wrong only by a whole number of repeats.
#[inline]
pub(super) fn back<const CLAMPED: bool>(texels: i32, little: i32) -> i32 {
    if CLAMPED {
        texels.saturating_sub(little)
    } else {
        texels.wrapping_sub(little)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With few texels, coordinates are rounded; with many texels, they saturate.
    #[test]
    fn coordinates_round_or_saturate_for_any_size_of_texture() {
        let bits = [[-25, -24, -23], [-8, -7, 7], [8, 23, 24]];
        assert_eq!(
            bits.map(|bits| texels(bits, false, 0)),
            [[-2, -1, -1], [0, 0, 0], [1, 1, 2]]
        );
        assert_eq!(bits.map(|bits| texels(bits, false, 4)), bits);
        let (low, high) = (i32::MIN, i32::MAX);
        assert_eq!(texels([low, high, 0], false, 4), [low, high, 0]);
        // With 4096 columns, coordinates reach eight repeats in each direction, and not one unit more.
        let ends = [(-8 << 20) - 1, -8 << 20, (8 << 20) - 1];
        assert_eq!(texels(ends, false, 12), [low, low, high - 255]);
        assert_eq!(texels([8 << 20, 0, 0], false, 12), [high, 0, 0]);
        assert_eq!(texels([low, 0, high], true, 15), [low, high, high]);
        // The corners of this triangle are as far apart as possible.
        let repeated = |bits, log2| texels(bits, true, log2);
        assert_eq!(
            repeated([low, high, 0], 0),
            [(1 << 16) - (1 << 27), (1 << 16) + (1 << 27), 1 << 16]
        );
        // The middle of the first triangle is just before the start of a repeat, the middle of the second is there.
        let one = 1 << 18;
        let repeats = |bits: [i32; 3]| repeated(bits.map(|at| at << 20), 2);
        assert_eq!(repeats([0, 3, 1]), [-one, 2 * one, 0]);
        assert_eq!(repeats([31, 0, 7]), [16 * one, -15 * one, -8 * one]);
        assert_eq!(repeats([-2, 0, 0]), [-one, one, one]);
    }
}
