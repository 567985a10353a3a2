//! The length and the direction of vectors, by an integer reciprocal square root.

use crate::num::wide::{dot, product, product_to_31_bits, unsigned_product};

/// Seeds: ⌊256/√t⌋ − 256, where t is the middle of each interval of length 1/128 from 1/4 to 1.
static SEEDS: [u8; 96] = seeds();

const fn seeds() -> [u8; 96] {
    let mut table = [0; 96];
    let mut i = 0_u32;
    while i < 96 {
        // t = (2(i + 32) + 1)/256, so 256/√t = √(2^24 / (2(i + 32) + 1)), from 256.5 to 508.
        table[i as usize] = (((1_u32 << 24) / (2 * (i + 32) + 1)).isqrt() - 256) as u8;
        i += 1;
    }
    table
}

/// Returns the reciprocal square root of t = `value` / 2^32 in units of 2^-30, for a `value` of at least
/// 2^30.
///
/// The result is from 2^30 to 2^31, and its relative error is at most 2^-30 (for every value, found by trying all). The
/// seed has an error of 1.2e-2. A Newton step reduces the error to 2.1e-4, and a step of the third order reduces it to
/// 2e-11. Rounding adds the rest of the error.
const fn reciprocal_root(value: u32) -> u32 {
    debug_assert!(value >= 1 << 30);
    // The top seven bits of t are 32 to 127. The comparison below proves this to the compiler.
    let index = (value >> 25).saturating_sub(32) as usize;
    let seed = 256 + if index < 96 { SEEDS[index] as u32 } else { 0 };
    // This step computes y(3 − ty²)/2. The seed has 8 fraction bits, t·y² has 30 (32 + 16 − 18), and the new y has 30.
    // Except for rounding, a Newton step ends below the root. So y is below 2^31: for roots near 2^31, the step ends
    // 9e-5 below the root.
    let ty2 = (unsigned_product(value, seed * seed) >> 18) as u32;
    let y = (unsigned_product(seed, (3 << 30) - ty2) >> 9) as i32;
    // This step computes y(1 + h/2 + 3h²/8) with h = 1 − ty². h is below 2^-11, and is negative only by rounding. y²
    // has 30 fraction bits, t·y² has 62, and h has 42.
    let square = (product(y, y) >> 30).cast_unsigned() as u32;
    let h = (((1 << 62) - unsigned_product(value, square).cast_signed()) >> 20) as i32;
    // The upper half of h² is below 2^30.
    let triple = 3 * (product(h, h) >> 32).cast_unsigned() as u32;
    let gain = (h >> 1) + (triple >> 13).cast_signed();
    let y = y
        .cast_unsigned()
        .wrapping_add_signed(((product(y, gain) + (1 << 41)) >> 42) as i32);
    // Callers rely on the bound of 2^31, which rounding could exceed.
    if y > 1 << 31 { 1 << 31 } else { y }
}

/// Lines that approximate 1/√t, one for each 256th of t from 1/16 to 1. An entry is the value at the line's start, in
/// units of 2^-29. The lower half of the entry is also the slope of the line, a signed number: the change for each
/// 2^-23 of t. Each line is lowered by half of the distance between the chord to the next entry and the curve, so that
/// lines lie on both sides of the curve, and raised by half a unit of 2^-13. Entries below 1/16 and above 3/4 are never
/// read. These entries exist so that no index needs a check.
static ROOTS: [u32; 256] = roots();

const fn roots() -> [u32; 256] {
    // Returns 1/√t, where t is `part` / 2^9, in units of 2^-29.
    const fn root(part: u128) -> i64 {
        ((1_u128 << 67) / part).isqrt().cast_signed() as i64
    }
    let mut table = [0; 256];
    let mut i = 16;
    while i < table.len() {
        let at = 2 * i as u128;
        let (from, to) = (root(at), root(at + 2));
        let above = i64::midpoint(from, to) - root(at + 1);
        let gain = (to - from - (1 << 14)) / (1 << 15);
        let slope = (gain as i16).cast_unsigned();
        // The upper half is the value less the slope, rounded to nearest.
        let start = from - above / 2 + (1 << 15) - slope as i64;
        let upper = ((start + (1 << 15)) >> 16).cast_unsigned() as u32;
        table[i] = upper << 16 | slope as u32;
        i += 1;
    }
    table
}

/// Returns a number with an upper half that is the reciprocal square root of t = `value` / 2^32, in units of 2^-13.
/// `value` must be from 2^28 to 3 · 2^30.
///
/// The relative error of the upper half is at most 2.3e-4. The chord contributes 1.9e-4 near t = 1/16, and less
/// elsewhere. Rounding contributes half a unit in the table, a quarter in the slope and half in the result: at most
/// 1.4e-4, near t = 3/4, and 3.9e-5 near 1/16.
#[inline]
pub(crate) fn short_root(value: u32) -> i32 {
    let line = ROOTS[(value >> 24) as usize].cast_signed();
    // The place on the line, in 15 bits without a sign.
    let on = (value >> 9 & 0x7fff).cast_signed();
    line.wrapping_add(i32::from(line as i16) * on)
}

/// A vector as mantissas of 31 bits, with the sum of the mantissas' squares, and the reciprocal root of this sum.
pub(crate) struct Measured {
    /// The vector · 2^`up`, rounded down.
    pub(crate) mantissas: [i32; 3],
    pub(crate) up: i32,
    /// The upper 32 bits of the sum of squares · 4^`half`: at least 2^30.
    pub(crate) square: u32,
    /// The reciprocal root of `square`; see [`reciprocal_root`].
    pub(crate) root: u32,
    /// Half the shift that normalizes the sum of squares: 0 or 1.
    pub(crate) half: u32,
}

impl Measured {
    /// The vector of length one, in units of 2^-30.
    pub(crate) const fn unit(&self) -> [i32; 3] {
        // m / √squared = m · (root / 2^30) / 2^(32 − half), in units of 2^-30.
        let [x, y, z] = self.mantissas;
        [self.component(x), self.component(y), self.component(z)]
    }

    /// A mantissa times the root, in units of 2^-30.
    const fn component(&self, mantissa: i32) -> i32 {
        let product = product_to_31_bits(mantissa, self.root);
        // The component is at most 1, so the doubled product does not overflow.
        let product = if self.half == 0 { product } else { 2 * product };
        ((product + (1 << 31)) >> 32) as i32
    }

    /// The component of the unit vector along a direction of length one. The direction and the result are in units of
    /// 2^-30.
    pub(crate) fn along(&self, direction: &[i32; 3]) -> i32 {
        // The vector of mantissas is shorter than 2^32, so `part` is below 2^31, and the result is at most 2^30.
        let part = dot(direction, &self.mantissas) >> 31;
        2 * self.component(part as i32)
    }

    /// The length · 2^`up`, rounded down. The vector's components, shifted left by `up`, must have at most 31 bits.
    pub(crate) const fn length(&self, up: u32) -> u64 {
        // √x = x · 1/√x, in units of 2^-62.
        (self.square as u64 * self.root as u64) >> (self.up.cast_unsigned() + 30 + self.half - up)
    }
}

/// Measures a vector; `None` for zero.
pub(crate) const fn measure([x, y, z]: [i64; 3]) -> Option<Measured> {
    let size = x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs();
    if size == 0 {
        return None;
    }
    // The mantissas are the upper halves of the components, after a left shift that leaves one bit for the sign. (No
    // caller has a component of -2^63.)
    let left = size.leading_zeros().saturating_sub(1);
    let mantissas = [
        (x << left >> 32) as i32,
        (y << left >> 32) as i32,
        (z << left >> 32) as i32,
    ];
    let up = left.cast_signed() - 32;
    // Each square is at most 2^62, and their sum is from 2^60 to 3 · 2^62.
    let [x, y, z] = mantissas;
    let squared = product(x, x).cast_unsigned()
        + product(y, y).cast_unsigned()
        + product(z, z).cast_unsigned();
    // The sum of squares is shifted by an even number of bits, so that its root is shifted by whole bits.
    let half = (squared < 1 << 62) as u32;
    let square = ((squared << (2 * half)) >> 32) as u32;
    Some(Measured {
        mantissas,
        up,
        square,
        root: reciprocal_root(square),
        half,
    })
}

/// Returns the vector of length one in the direction of `vector`, in units of 2^-30; `None` for zero.
///
/// Each component is accurate to 2^-28.
pub(crate) const fn unit(vector: [i64; 3]) -> Option<[i32; 3]> {
    match measure(vector) {
        Some(of) => Some(of.unit()),
        None => None,
    }
}

/// Returns the cross product of two vectors of at most 31 bits and a sign; exact.
#[inline(never)]
pub(crate) fn cross([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i64; 3] {
    [
        product(ay, bz) - product(az, by),
        product(az, bx) - product(ax, bz),
        product(ax, by) - product(ay, bx),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{cases, number};

    #[test]
    fn reciprocal_root_has_30_bits() {
        let mut worst = 0_f64;
        for x in (1_u32 << 30..=u32::MAX).step_by(9973).chain([u32::MAX]) {
            let expected = (f64::from(x) / 4_294_967_296.0).sqrt().recip();
            let found = f64::from(reciprocal_root(x)) / 1_073_741_824.0;
            worst = worst.max((found / expected - 1.0).abs());
        }
        assert!(worst <= f64::from(-30).exp2(), "{worst:e}");
    }

    #[test]
    fn a_short_root_has_12_bits() {
        let mut worst = 0_f64;
        for x in (1_u32 << 28..=3 << 30).step_by(997).chain([3 << 30]) {
            let expected = (f64::from(x) / 4_294_967_296.).sqrt().recip() * 8192.;
            worst = worst.max((f64::from(short_root(x) >> 16) / expected - 1.).abs());
        }
        assert!(worst <= 2.3e-4, "{worst:e}");
    }

    /// Tests long vectors, too, and vectors on an axis, which stay exactly on the axis.
    #[test]
    fn units_of_all_sizes_have_28_bits() {
        let mut state = 1_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            state.cast_signed() >> (state >> 58)
        };
        for _ in 0..100_000 {
            let v = [random(), random(), random()];
            let Some(got) = unit(v) else {
                assert_eq!(v, [0; 3]);
                continue;
            };
            #[allow(clippy::cast_precision_loss)]
            let exact = v.map(|x| x as f64);
            let length = exact.iter().map(|x| x * x).sum::<f64>().sqrt();
            for (got, exact) in got.iter().zip(exact) {
                let error = (f64::from(*got) / f64::from(1 << 30) - exact / length).abs();
                assert!(error < f64::from(-28).exp2(), "{v:?}: {error:e}");
            }
        }
        assert_eq!(unit([0; 3]), None);
        assert_eq!(unit([0, 0, i64::MIN]), Some([0, 0, -(1 << 30)]));
        for axis in (0..63).map(|bits| 1_i64 << bits) {
            assert_eq!(unit([0, axis, 0]), Some([0, 1 << 30, 0]));
            assert_eq!(unit([-axis, 0, 0]), Some([-(1 << 30), 0, 0]));
        }
    }

    #[test]
    fn units_point_the_same_way() {
        cases(256, |random| {
            let v = [(); 3].map(|()| number(random));
            let real = v.map(f64::from);
            let length = real.iter().map(|x| x * x).sum::<f64>().sqrt();
            match unit(v.map(i64::from)) {
                None => assert_eq!(v, [0; 3]),
                Some(unit) => {
                    for (u, x) in unit.into_iter().zip(real) {
                        // The error comes from mantissas of 31 bits, a root of 30 bits, and rounding.
                        let error = f64::from(u) / 1_073_741_824.0 - x / length;
                        assert!(error.abs() <= f64::from(-28).exp2(), "{error:e}");
                    }
                }
            }
        });
    }
}
