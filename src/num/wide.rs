//! Everything that differs on cores that lack 64-bit products, a divider, or an instruction that counts leading zeros.
//!
//! No other file asks which core it runs on. Each function here gives the same bits on all cores.

/// Whether the core's products have only 32 bits, as on Armv6-M and the baseline of Armv8-M: Cortex-M0, M0+, M1 and
/// M23. `src/build.rs` derives this from the target's name.
///
/// On these cores the compiler calls a routine that multiplies 64 bits by 64. Four products of 16 bits take half as
/// long as this routine.
const IS_NARROW: bool = cfg!(narrow_core);

/// Whether the core divides fast. Armv6-M has no division, and Cortex-M23 takes up to 34 cycles, longer than the code
/// without a division.
pub(crate) const DIVIDES: bool = !IS_NARROW;

/// Whether the core has an instruction that counts leading zeros. Narrow cores and RISC-V without Zbb have no such
/// instruction.
const COUNTS_ZEROS: bool =
    !IS_NARROW && !cfg!(all(target_arch = "riscv32", not(target_feature = "zbb")));

/// Whether the core has an instruction, as Cortex-M4 and M7 have, that adds a product to a number times 2^32, and
/// returns the upper half of the sum. `src/build.rs` derives this from the target's name.
const HAS_DSP: bool = cfg!(dsp_core);

/// Whether the core has an instruction, as Cortex-M3 and above have, that limits a number to a given number of bits.
const SATURATES: bool = cfg!(target_arch = "arm") && !IS_NARROW;

/// Whether registers have 64 bits.
pub(crate) const IS_WIDE: bool = cfg!(target_pointer_width = "64");

/// The integer that fills a register. On a 64-bit core, numbers of 32 bits are widened to this type once, and not for
/// each product.
#[cfg(target_pointer_width = "64")]
pub(crate) type Word = i64;
#[cfg(not(target_pointer_width = "64"))]
pub(crate) type Word = i32;

/// Whether short positions are multiplied before they are shifted. Before the shift, they are small, and narrow cores
/// multiply small numbers faster.
pub(crate) const SHIFTS_LATER: bool = IS_NARROW;

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

/// Whether `a`, a number of 16 bits, is at least `b`.
#[inline]
pub(crate) const fn at_least(a: u32, b: u16) -> bool {
    // A 64-bit core compares 16 bits directly with a number in memory.
    if IS_WIDE {
        a as u16 >= b
    } else {
        a >= b as u32
    }
}

/// Clamps a number to the range from -2^`bits` to 0.
#[inline]
pub(crate) fn clamp_negative(value: i32, bits: u32) -> i32 {
    if SATURATES {
        saturate_negative(value, bits)
    } else {
        value.clamp(-1 << bits, 0)
    }
}

/// Does what [`clamp_negative`] does, in two instructions. The first instruction saturates to a signed number with one
/// bit more than `bits`. In the result, bit `bits` repeats the sign, so a shift by `bits` makes a mask that clears
/// positive numbers. (The compiler would turn a shift by 31 back into a comparison.)
#[inline]
fn saturate_negative(value: i32, bits: u32) -> i32 {
    let limited = value.clamp(-1 << bits, (1 << bits) - 1);
    limited & limited >> bits
}

/// Marks a branch that is seldom taken, so that the other branches need no jump around it.
#[cold]
#[inline]
pub(crate) const fn cold() {}

/// Marks a branch that is seldom taken, but only where registers have 64 bits.
#[inline]
pub(crate) fn seldom() {
    if IS_WIDE {
        cold();
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

/// Returns guess · (2 − q · guess / 2^60): one Newton step from a guess toward r = 2^60 / q. Both `q` and `guess` are
/// from 2^29 to 2^31.
///
/// The guess must be within a quarter of r.
#[inline]
#[allow(clippy::unnecessary_cast)] // necessary if a word has 32 bits
pub(crate) const fn newton_step(q: Word, guess: Word) -> Word {
    if IS_WIDE {
        wide_newton_step(q as i64, guess as i64) as Word
    } else if HAS_DSP {
        dsp_newton_step(q as i32, guess as i32) as Word
    } else {
        short_newton_step(q as i32, guess as i32) as Word
    }
}

#[inline]
const fn short_newton_step(q: i32, guess: i32) -> i32 {
    let residual = (1 << 28) - ((product(q, guess) >> 32) as i32);
    guess.wrapping_add((product(guess, residual << 4) >> 32) as i32)
}

/// Returns [`newton_step`] by the instruction `smmls`, which subtracts a product from a number times 2^32, and returns
/// the upper half of the difference.
#[inline]
#[allow(clippy::cast_lossless, clippy::cast_sign_loss)] // `u64::from` is not const
const fn dsp_newton_step(q: i32, guess: i32) -> i32 {
    let excess = ((product(q, guess) >> 32) as i32) << 4;
    // The guess is widened without its sign, which is shifted out anyway. If the guess were widened as in the product,
    // the compiler would make the guess a common factor.
    let raised = (guess.cast_unsigned() as u64) << 32;
    (raised.wrapping_sub(product(guess, excess).cast_unsigned()) >> 32) as i32
}

/// Returns [`newton_step`] in fewer instructions, for 64-bit cores. The shift discards less than a unit, so the guess
/// can be added before the shift.
#[inline]
const fn wide_newton_step(q: i64, guess: i64) -> i64 {
    let twice = (1_i64 << 29).wrapping_sub(q.wrapping_mul(guess) >> 32);
    guess.wrapping_mul(twice) >> 28
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

/// Returns the quotient, rounded down, and the remainder; the divisor must be above 0.
#[inline]
pub(crate) fn divide(numerator: i32, divisor: i32) -> (i32, i32) {
    if IS_NARROW {
        return narrow_divide(numerator, divisor);
    }
    let divisor = divisor.max(1);
    let (quotient, remainder) = (numerator / divisor, numerator % divisor);
    // So far, the quotient is rounded toward zero.
    let below = remainder >> 31;
    (quotient + below, remainder + (divisor & below))
}

/// Returns [`divide`] by subtraction if the quotient is small: a division takes as long as twenty subtractions.
#[inline]
fn narrow_divide(numerator: i32, divisor: i32) -> (i32, i32) {
    let (mut quotient, mut remainder) = (0, numerator);
    for _ in 0..16 {
        if remainder < 0 {
            remainder += divisor;
            quotient -= 1;
        } else if remainder >= divisor {
            remainder -= divisor;
            quotient += 1;
        } else {
            return (quotient, remainder);
        }
    }
    let (more, remainder) = (
        remainder.div_euclid(divisor.max(1)),
        remainder.rem_euclid(divisor.max(1)),
    );
    (quotient + more, remainder)
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

/// Returns the dot product, which must fit in 64 bits: mantissas of 30 bits times numbers of 31 bits do.
#[inline]
pub(crate) fn dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    if IS_NARROW {
        narrow_dot(a, b)
    } else {
        product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2])
    }
}

/// A row of coefficients of at most 2^29, for dot products with many positions.
#[cfg(not(narrow_core))]
pub(crate) type Row = WholeRow;
#[cfg(narrow_core)]
pub(crate) type Row = CutRow;

/// A row of coefficients, without any preparation.
#[cfg(any(test, not(narrow_core)))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct WholeRow([i32; 3]);

#[cfg(any(test, not(narrow_core)))]
impl WholeRow {
    #[inline]
    pub(crate) const fn new(row: [i32; 3]) -> Self {
        Self(row)
    }

    /// The coefficients.
    #[inline]
    pub(crate) const fn whole(&self) -> [i32; 3] {
        self.0
    }

    /// Returns the dot products of three rows with a position, added to `sums`.
    #[inline]
    pub(crate) fn add_dots(
        [a, b, c]: &[Self; 3],
        position: &[i32; 3],
        [x, y, z]: [i64; 3],
    ) -> [i64; 3] {
        [
            x + dot(&a.0, position),
            y + dot(&b.0, position),
            z + dot(&c.0, position),
        ]
    }
}

/// A row that also stores each coefficient as the sum of three parts, in units of 2^20, 2^10 and 1. A part is at most
/// 2^9.
///
/// The product of a part and a number of at most 2^20 takes 30 bits, and the sum of three of these products takes 31.
/// So a dot product takes nine short products in place of twelve, without carries between them.
#[cfg(any(test, narrow_core))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct CutRow {
    whole: [i32; 3],
    parts: [[i32; 3]; 3],
}

/// The greatest coordinate that a [`CutRow`] multiplies by its parts: 16 in model space.
#[cfg(any(test, narrow_core))]
const SMALL: i32 = 1 << 20;

#[cfg(any(test, narrow_core))]
impl CutRow {
    #[inline]
    pub(crate) fn new(whole: [i32; 3]) -> Self {
        let rounded = |a: i32, bits: u32| (a + (1 << bits >> 1)) >> bits;
        let upper = whole.map(|a| rounded(a, 20));
        let middle = whole.map(|a| rounded(a - (rounded(a, 20) << 20), 10));
        let lower = whole.map(|a| a - (rounded(a, 10) << 10));
        Self {
            whole,
            parts: [upper, middle, lower],
        }
    }

    /// The coefficients.
    #[cfg(narrow_core)]
    #[inline]
    pub(crate) const fn whole(&self) -> [i32; 3] {
        self.whole
    }

    /// Returns the dot products of three rows with a position, added to `sums`.
    #[inline]
    pub(crate) fn add_dots([a, b, c]: &[Self; 3], position: &[i32; 3], sums: [i64; 3]) -> [i64; 3] {
        let raised = |x: i32| x.wrapping_add(SMALL).cast_unsigned();
        let [x, y, z] = *position;
        let dots = if raised(x) | raised(y) | raised(z) < 2 * SMALL.cast_unsigned() {
            [a, b, c].map(|row| row.small_dot(x, y, z))
        } else {
            // This case uses a copy, so that the other case does not need the position in memory.
            let position = [x, y, z];
            [a, b, c].map(|row| narrow_dot(&row.whole, &position))
        };
        [sums[0] + dots[0], sums[1] + dots[1], sums[2] + dots[2]]
    }

    /// This function is out of line, so that its numbers stay in registers.
    #[inline(never)]
    fn small_dot(&self, x: i32, y: i32, z: i32) -> i64 {
        let [upper, middle, lower] = &self.parts;
        let sum = |[a, b, c]: &[i32; 3]| i64::from(a * x + b * y + c * z);
        (sum(upper) << 20) + (sum(middle) << 10) + sum(lower)
    }
}

/// Shifts left by up to 16 bits. On a core without long shifts, this function shifts the two halves, because the
/// compiler would call a routine for a shift of 64 bits.
#[inline]
pub(crate) const fn up(value: i64, up: u32) -> i64 {
    if IS_NARROW {
        up_by_halves(value, up)
    } else {
        value << up
    }
}

#[inline]
const fn up_by_halves(value: i64, up: u32) -> i64 {
    let (upper, lower) = ((value >> 32) as i32, value.cast_unsigned() as u32);
    let upper =
        (upper << (up & 31)).cast_unsigned() | (lower >> 1 >> (31u32.wrapping_sub(up) & 31));
    ((upper as u64) << 32 | (lower << (up & 31)) as u64).cast_signed()
}

/// Shifts `q` left until its top bit is set, and lowers an exponent by the number of shifted bits less one. The
/// exponent is in the bits above the lowest `mantissa` bits.
#[inline]
pub(crate) fn normalize(q: u32, exponent: u32, mantissa: u32) -> (u32, u32) {
    if !COUNTS_ZEROS {
        return normalize_by_steps(q, exponent, mantissa);
    }
    // The lowest bit is set, so that a zero is shifted by at most 31.
    let zeros = (q | 1).leading_zeros();
    let exponent = exponent.wrapping_sub(zeros << mantissa);
    (q << zeros, exponent.wrapping_add(1 << mantissa))
}

/// Returns [`normalize`] on cores that cannot count zeros. Most `q` of a triangle have 30 or 31 bits, because each
/// triangle has its own scale, so shifting by single bits is fast.
#[inline]
fn normalize_by_steps(q: u32, mut exponent: u32, mantissa: u32) -> (u32, u32) {
    let mut normal = q << 1;
    if normal.cast_signed() >= 0 {
        normal |= 1;
        while normal >> 24 == 0 {
            normal <<= 8;
            exponent = exponent.wrapping_sub(8 << mantissa);
        }
        while normal.cast_signed() >= 0 {
            normal <<= 1;
            exponent = exponent.wrapping_sub(1 << mantissa);
        }
    }
    (normal, exponent)
}

// The next two functions are out of line, because a copy would be longer than the call.

#[inline(never)]
const fn narrow_product(a: i32, b: i32) -> i64 {
    of_halves(a, b)
}

#[inline(never)]
fn narrow_dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    a.iter().zip(b).map(|(&a, &b)| of_halves(a, b)).sum()
}

/// Returns the product of two numbers, computed from the products of their halves.
#[inline]
const fn of_halves(a: i32, b: i32) -> i64 {
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

    /// Tests coefficients and positions at the ends of the range that a cut row multiplies by its parts, and beyond
    /// this range.
    #[test]
    fn cut_rows_are_exact_at_the_ends() {
        let parts = [
            1,
            511,
            512,
            513,
            1 << 19,
            (1 << 19) - 1,
            (1 << 29) - 1,
            1 << 29,
        ];
        for a in parts.into_iter().flat_map(|a| [a, -a]) {
            let row = CutRow::new([a, -a, a]);
            assert!(
                row.parts
                    .as_flattened()
                    .iter()
                    .all(|part| part.abs() <= 1 << 9),
                "{a}"
            );
            for x in [
                SMALL - 1,
                SMALL,
                -SMALL,
                -SMALL - 1,
                i32::MAX,
                i32::MIN,
                0,
                1,
            ] {
                for position in [[x; 3], [x, !x, x]] {
                    let exact =
                        WholeRow::add_dots(&[WholeRow::new([a, -a, a]); 3], &position, [3, -4, 5]);
                    assert_eq!(
                        CutRow::add_dots(&[row; 3], &position, [3, -4, 5]),
                        exact,
                        "{a} · {position:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn numbers_are_clamped_to_negative_ones_alike() {
        for bits in 1..30 {
            let limit = 1 << bits;
            for value in [
                i32::MIN,
                -limit - 1,
                -limit,
                1 - limit,
                -1,
                0,
                1,
                limit - 1,
                limit,
                i32::MAX,
            ] {
                let limited = value.clamp(-limit, 0);
                assert_eq!(clamp_negative(value, bits), limited, "{value}");
                assert_eq!(saturate_negative(value, bits), limited, "{value}");
            }
        }
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

    #[test]
    fn narrow_dot_products_are_exact() {
        cases(256, |random| {
            let a = [(); 3].map(|()| random.random_range(-(1 << 29)..=1 << 29));
            let b = random.random::<[i32; 3]>();
            let exact: i64 = a
                .iter()
                .zip(b)
                .map(|(&a, b)| i64::from(a) * i64::from(b))
                .sum();
            assert_eq!(narrow_dot(&a, &b), exact);
            assert_eq!(dot(&a, &b), exact);
        });
    }

    #[test]
    fn newton_steps_are_alike() {
        cases(256, |random| {
            let q = random.random_range(1_i32 << 29..=i32::MAX);
            let part = random.random_range(-(1_i32 << 28)..=1 << 28);
            let cut = random.random_range(0..28);
            // The guess has a relative error of up to a quarter.
            let r = (1_i64 << 60) / i64::from(q);
            let guess = (r + ((r * i64::from(part >> cut)) >> 30)).min(i32::MAX.into());
            let short = short_newton_step(q, guess as i32);
            assert_eq!(dsp_newton_step(q, guess as i32), short);
            assert_eq!(wide_newton_step(q.into(), guess), i64::from(short));
        });
    }

    /// The residual is rounded by less than 2^-28, and this error is multiplied by 1 − e, which is at most 1.25. The
    /// result is rounded by less than a unit, which is at most 2^-29 of the result.
    #[test]
    fn a_newton_step_squares_the_error() {
        cases(256, |random| {
            let q = random.random_range(1_i32 << 29..=i32::MAX);
            let least = (3_i64 << 58) / i64::from(q);
            let most = ((5_i64 << 58) / i64::from(q)).min(i32::MAX.into());
            let guess = random.random_range(least..=most) as i32;
            let error = |r: i32| 1. - f64::from(q) * f64::from(r) / 2_f64.powi(60);
            let step = short_newton_step(q, guess);
            let off = error(step) - error(guess).powi(2);
            assert!(off.abs() <= 1.25 * 2_f64.powi(-28), "{q}, {guess}: {off}");
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
    fn dot_products_of_cut_rows_are_exact() {
        cases(256, |random| {
            let rows =
                [(); 3].map(|()| [(); 3].map(|()| random.random_range(-(1 << 29)..=1 << 29)));
            let position = random.random::<[i32; 3]>();
            let down = random.random_range(0..32);
            let up = random.random_range(0_u32..=16);
            let position = position.map(|x| x >> down);
            let exact = WholeRow::add_dots(&rows.map(WholeRow::new), &position, [0; 3]);
            assert_eq!(
                CutRow::add_dots(&rows.map(CutRow::new), &position, [0; 3]),
                exact
            );
            assert_eq!(
                exact.map(|dot| up_by_halves(dot, up)),
                exact.map(|dot| dot << up)
            );
        });
    }

    #[test]
    fn quotients_are_rounded_down() {
        cases(256, |random| {
            let numerator = random.random_range(-(1_i32 << 20)..=1 << 20);
            let divisor = random.random_range(1_i32..=1 << 20);
            let size = random.random_range(0_u32..20);
            let divisor = i32::max(divisor >> size, 1);
            let exact = (numerator.div_euclid(divisor), numerator.rem_euclid(divisor));
            assert_eq!(divide(numerator, divisor), exact);
            assert_eq!(narrow_divide(numerator, divisor), exact);
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
    fn normalizing_by_steps_agrees() {
        for bit in 0..31 {
            for q in [0, 1, 0x5555_5555, u32::MAX].map(|rest| 1 << bit | rest & ((1 << bit) - 1)) {
                for mantissa in [11, 12] {
                    let code = |(normal, exponent): (u32, u32)| {
                        (normal >> (31 - mantissa))
                            .wrapping_add(exponent)
                            .cast_signed()
                            .max(0)
                    };
                    for down in 15..64 {
                        let exponent = 29u32.wrapping_sub(down) << mantissa;
                        let [a, b] = [normalize, normalize_by_steps]
                            .map(|normalize| code(normalize(q, exponent, mantissa)));
                        assert_eq!(a, b, "{q} >> {down}, {mantissa} bits");
                    }
                }
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
}
