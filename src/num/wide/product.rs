//! Products, and the cross products of the sides of triangles.

use super::{HAS_DSP, IS_NARROW, IS_WIDE, Word};

/// Returns the exact product.
#[inline]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    if IS_NARROW {
        narrow_product(a, b)
    } else {
        a as i64 * b as i64
    }
}

/// Returns the exact product.
#[inline]
pub(crate) const fn unsigned_product(a: u32, b: u32) -> u64 {
    if IS_NARROW {
        by_signed_product(a, b)
    } else {
        a as u64 * b as u64
    }
}

/// Returns [`unsigned_product`] by a signed product.
#[inline]
const fn by_signed_product(a: u32, b: u32) -> u64 {
    let product = product(a.cast_signed(), b.cast_signed()).cast_unsigned();
    // If a factor's top bit is set, the signed factor is 2^32 too small.
    let [a_top, b_top] = [
        (a.cast_signed() >> 31).cast_unsigned(),
        (b.cast_signed() >> 31).cast_unsigned(),
    ];
    let missing = (b & a_top).wrapping_add(a & b_top);
    product.wrapping_add((missing as u64) << 32)
}

/// Returns the exact product; `b` must be at most 2^31.
#[inline]
pub(crate) const fn product_to_31_bits(a: i32, b: u32) -> i64 {
    if IS_NARROW {
        // As an `i32`, 2^31 fits only with a minus sign.
        -narrow_product(a, b.wrapping_neg().cast_signed())
    } else {
        a as i64 * b as i64
    }
}

/// Returns the upper half of the product of two numbers of 32 bits, rounded down.
#[inline]
#[allow(clippy::unnecessary_cast)] // necessary if a word has 32 bits
pub(crate) const fn high(a: Word, b: Word) -> Word {
    if IS_WIDE {
        ((a as i64 * b as i64) >> 32) as Word
    } else {
        (product(a as i32, b as i32) >> 32) as Word
    }
}

/// Returns a · b / 2^30, rounded to nearest, for an `a` within ±2^30 and a `b` from 2^30 to 2^31 − 1.
#[inline]
pub(crate) const fn times_30(a: i32, b: u32) -> i32 {
    if HAS_DSP {
        dsp_times_30(a, b)
    } else {
        ((product(a, b.cast_signed()) + (1 << 29)) >> 30) as i32
    }
}

/// Returns [`times_30`], as 2a · 2b / 2^32, by the instruction `smmulr`, which rounds the upper half of a product. As a
/// signed number, 2b is 2^32 too small, so 2a is added to the quotient.
#[inline]
const fn dsp_times_30(a: i32, b: u32) -> i32 {
    let (a, b) = (a << 1, (b << 1).cast_signed());
    a.wrapping_add(((product(a, b) + (1 << 31)) >> 32) as i32)
}

/// Multiplies by a number of 16 bits; wraps.
#[inline]
pub(crate) const fn times_short(a: i64, b: i32) -> i64 {
    if IS_NARROW {
        by_halves(a, b)
    } else {
        a.wrapping_mul(b as i64)
    }
}

/// Returns [`times_short`] by products of 32 bits.
#[inline]
const fn by_halves(a: i64, b: i32) -> i64 {
    let (high, low) = ((a >> 32) as i32, a.cast_unsigned() as u32);
    let [first, second] = [(low & 0xffff).cast_signed(), (low >> 16).cast_signed()];
    let low = first.wrapping_mul(b) as i64 + ((second.wrapping_mul(b) as i64) << 16);
    let high = high.wrapping_mul(b).cast_unsigned();
    low.wrapping_add(((high as u64) << 32).cast_signed())
}

/// Returns a · b / 2^14, rounded down, for a `b` of up to 17 bits and a product of up to 45 bits.
#[inline]
pub(crate) fn times_17_bits(a: i32, b: u32) -> i32 {
    let b = b.cast_signed();
    if IS_NARROW {
        narrow_times_17_bits(a, b)
    } else {
        ((i64::from(a) * i64::from(b)) >> 14) as i32
    }
}

/// Returns [`times_17_bits`] by products of 32 bits.
#[inline]
fn narrow_times_17_bits(a: i32, b: i32) -> i32 {
    (a >> 14)
        .wrapping_mul(b)
        .wrapping_add((a & 0x3fff).wrapping_mul(b) >> 14)
}

/// Returns a · b / 2^16, rounded down, for a `b` of 16 bits with its sign; wraps.
#[inline]
pub(crate) const fn times_half(a: i32, b: i32) -> i32 {
    if IS_NARROW {
        narrow_times_half(a, b)
    } else {
        ((a as i64 * b as i64) >> 16) as i32
    }
}

/// Returns [`times_half`] by products of 32 bits.
#[inline]
const fn narrow_times_half(a: i32, b: i32) -> i32 {
    (a >> 16)
        .wrapping_mul(b)
        .wrapping_add((a & 0xffff).wrapping_mul(b) >> 16)
}

/// Out of line, because a copy would be longer than the call.
#[inline(never)]
const fn narrow_product(a: i32, b: i32) -> i64 {
    of_halves(a, b)
}

/// Returns the product of two numbers, computed from the products of their halves.
#[inline]
pub(super) const fn of_halves(a: i32, b: i32) -> i64 {
    let ([a_high, a_low], [b_high, b_low]) = ([a >> 16, a & 0xffff], [b >> 16, b & 0xffff]);
    let low = a_low.cast_unsigned() * b_low.cast_unsigned();
    // A signed half times an unsigned half is at most 2^31 - 2^15 in magnitude: adding 16 bits does
    // not overflow.
    let cross = a_high * b_low + (low >> 16).cast_signed();
    let other = a_low * b_high + (cross & 0xffff);
    let high = a_high * b_high + (cross >> 16) + (other >> 16);
    let low = (other << 16).cast_unsigned() | (low & 0xffff);
    ((high as i64) << 32) | low as i64
}

/// Returns a · d − c · b, twice the area of the triangle with the sides (a, b) and (c, d). The numbers have 21 bits
/// each.
#[inline]
pub(crate) fn cross([a, b]: [i32; 2], [c, d]: [i32; 2]) -> i64 {
    if IS_NARROW && are_short([a, b], [c, d]) {
        return short_cross([a, b], [c, d]);
    }
    product(a, d) - product(c, b)
}

/// Whether both sides are shorter than 64 pixels, in x and in y, as most sides are. A pixel has 256 units.
#[inline]
fn are_short([a, b]: [i32; 2], [c, d]: [i32; 2]) -> bool {
    let raised = |side: i32| side.wrapping_add(1 << 14).cast_unsigned();
    raised(a) | raised(b) | raised(c) | raised(d) < 1 << 15
}

/// Returns [`cross`] of sides that [are short](are_short). These sides take 15 bits, so twice the area takes 31 bits.
#[inline]
fn short_cross([a, b]: [i32; 2], [c, d]: [i32; 2]) -> i64 {
    i64::from(a * d - c * b)
}

/// Returns the cross product, shifted so that its largest component has 31 bits, and rounded down. A cross product of
/// zero stays zero.
#[inline]
pub(crate) const fn scaled_cross(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    if IS_NARROW && are_small(a, b) {
        return small_scaled_cross(a, b);
    }
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    // These differences are below 2^63, except for components of -2^31, where they saturate.
    let [x, y, z] = [
        product(ay, bz).saturating_sub(product(az, by)),
        product(az, bx).saturating_sub(product(ax, bz)),
        product(ax, by).saturating_sub(product(ay, bx)),
    ];
    let bits = x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs();
    // One leading zero remains, for the sign.
    let up = bits.leading_zeros().saturating_sub(1);
    [
        ((x << up) >> 32) as i32,
        ((y << up) >> 32) as i32,
        ((z << up) >> 32) as i32,
    ]
}

/// Whether all components have 15 bits and a sign, so that their products have 30 bits.
#[inline]
const fn are_small([a, b, c]: [i32; 3], [d, e, f]: [i32; 3]) -> bool {
    const fn raised(x: i32) -> u32 {
        x.wrapping_add(1 << 15).cast_unsigned()
    }
    raised(a) | raised(b) | raised(c) | raised(d) | raised(e) | raised(f) < 1 << 16
}

/// Returns [`scaled_cross`] of [small](are_small) vectors by products of 32 bits. The difference of two products has 31
/// bits.
#[inline]
const fn small_scaled_cross([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i32; 3] {
    let [x, y, z] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    let bits = x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs();
    let up = (bits | 1).leading_zeros().wrapping_sub(1) & 31;
    [x << up, y << up, z << up]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn products_of_halves_are_exact_at_the_ends() {
        let ends = [
            0,
            1,
            -1,
            0x7fff,
            0x8000,
            0xffff,
            0x1_0000,
            -0x8000,
            -0xffff,
            -0x1_0000,
            0x7fff_0000,
            i32::MAX,
            i32::MIN,
            i32::MIN + 0xffff,
        ];
        for a in ends {
            for b in ends {
                assert_eq!(of_halves(a, b), i64::from(a) * i64::from(b), "{a} · {b}");
                let (a, b) = (a.cast_unsigned(), b.cast_unsigned());
                assert_eq!(
                    by_signed_product(a, b),
                    u64::from(a) * u64::from(b),
                    "{a} · {b}"
                );
            }
        }
    }

    #[test]
    fn products_of_halves_are_exact() {
        cases(256, |random| {
            let a = random.random::<i32>();
            let b = random.random::<i32>();
            assert_eq!(of_halves(a, b), i64::from(a) * i64::from(b));
            let (a, b) = (a.cast_unsigned(), b.cast_unsigned());
            assert_eq!(by_signed_product(a, b), u64::from(a) * u64::from(b));
        });
    }

    #[test]
    fn products_to_31_bits_are_exact() {
        cases(256, |random| {
            let a = random.random::<i32>();
            let b = if random.random() {
                1 << 31
            } else {
                random.random_range(0..=1_u32 << 31)
            };
            let exact = i64::from(a) * i64::from(b);
            assert_eq!(product_to_31_bits(a, b), exact);
            assert_eq!(-narrow_product(a, b.wrapping_neg().cast_signed()), exact);
        });
    }

    #[test]
    fn products_with_short_numbers_are_exact() {
        cases(256, |random| {
            let a = random.random::<i64>();
            let b = random.random::<i16>();
            let b = i32::from(b);
            assert_eq!(by_halves(a, b), a.wrapping_mul(b.into()));
        });
    }

    #[test]
    fn narrow_products_with_17_bits_are_exact() {
        cases(256, |random| {
            let a = random.random::<i32>();
            let b = random.random_range(0_u32..=1 << 17);
            let cut = random.random_range(0_u32..17);
            let b = b >> cut;
            // The product has 45 bits, including its sign.
            let a = (i64::from(a) % ((1 << 44) / i64::from(b.max(1)))) as i32;
            let exact = (i64::from(a) * i64::from(b)) >> 14;
            assert_eq!(i64::from(times_17_bits(a, b)), exact);
            assert_eq!(i64::from(narrow_times_17_bits(a, b.cast_signed())), exact);
        });
    }

    #[test]
    fn narrow_products_with_16_bits_are_exact() {
        cases(256, |random| {
            let a = random.random::<i32>();
            let b = random.random::<i16>();
            let b = i32::from(b);
            let exact = (i64::from(a) * i64::from(b)) >> 16;
            assert_eq!(i64::from(times_half(a, b)), exact);
            assert_eq!(i64::from(narrow_times_half(a, b)), exact);
        });
    }

    #[test]
    fn products_of_30_bits_are_rounded_alike() {
        cases(256, |random| {
            let a = random.random_range(-(1_i32 << 30)..1 << 30) >> random.random_range(0..30);
            let b = random.random_range(1_u32 << 30..1 << 31);
            for (a, b) in [
                (a, b),
                (a, 1 << 30),
                (-(1 << 30), b),
                ((1 << 30) - 1, (1 << 30) + 1),
            ] {
                let exact = (i64::from(a) * i64::from(b) + (1 << 29)) >> 30;
                assert_eq!(i64::from(times_30(a, b)), exact, "{a} · {b}");
                assert_eq!(i64::from(dsp_times_30(a, b)), exact, "{a} · {b}");
            }
        });
    }

    /// Tests sides at both ends of the range of short sides, and one unit beyond these ends.
    #[test]
    fn short_sides_have_15_bits() {
        let (least, most) = (-(1 << 14), (1 << 14) - 1);
        let ends = [least, -1, 0, 1, most];
        for a in ends {
            for b in ends {
                for c in ends {
                    for d in ends {
                        assert!(are_short([a, b], [c, d]));
                        let exact = i64::from(a) * i64::from(d) - i64::from(c) * i64::from(b);
                        assert_eq!(short_cross([a, b], [c, d]), exact);
                        assert_eq!(cross([a, b], [c, d]), exact);
                    }
                }
            }
        }
        for beyond in [least - 1, most + 1, i32::MIN, i32::MAX] {
            for at in 0..4 {
                let mut sides = [0; 4];
                sides[at] = beyond;
                let [a, b, c, d] = sides;
                assert!(!are_short([a, b], [c, d]), "{sides:?}");
            }
        }
    }

    /// Tests vectors with components at the ends of 15 bits, equal vectors, and zeros.
    #[test]
    fn small_cross_products_are_scaled_alike() {
        let (least, most) = (-(1 << 15), (1 << 15) - 1);
        cases(4096, |random| {
            let mut component = || match random.random_range(0..6) {
                0 => 0,
                1 => least,
                2 => most,
                3 => random.random_range(-3..3),
                _ => random.random_range(least..=most),
            };
            let (a, b) = ([(); 3].map(|()| component()), [(); 3].map(|()| component()));
            assert!(are_small(a, b));
            for b in [a, b] {
                // The host's products are not narrow.
                let wide = scaled_cross(a, b);
                assert_eq!(small_scaled_cross(a, b), wide, "{a:?} x {b:?}");
            }
        });
        for beyond in [least - 1, most + 1, i32::MIN, i32::MAX] {
            for at in 0..6 {
                let mut sides = [0; 6];
                sides[at] = beyond;
                let [a, b, c, d, e, f] = sides;
                assert!(!are_small([a, b, c], [d, e, f]), "{sides:?}");
            }
        }
    }
}
