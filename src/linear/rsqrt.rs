//! The reciprocal square root in integers, and unit vectors by it.

/// Seeds: 256/√t rounded down, less 256, for t in steps of 1/128 from 1/4 to 1, at the steps' middles.
static SEEDS: [u8; 96] = seeds();

const fn seeds() -> [u8; 96] {
    let mut table = [0; 96];
    let mut i = 0_u32;
    while i < 96 {
        // t = (2(i + 32) + 1)/256, so 256/√t = √(2^24 / (2(i + 32) + 1)): from 256.5 to 508.
        let root = ((1_u32 << 24) / (2 * (i + 32) + 1)).isqrt();
        #[allow(clippy::cast_possible_truncation)] // 0 to 252
        let seed = (root - 256) as u8;
        table[i as usize] = seed;
        i += 1;
    }
    table
}

/// 1/√`x` as a mantissa and an exponent: mantissa · 2^−exponent.
///
/// The mantissa lies in 2^30 to 2^31, the exponent between 31 and 62; relative error at most 1e-7
/// (a seed of 8 bits and two Newton steps, y ← y(3 − ty²)/2). Zero counts as one.
#[allow(clippy::cast_possible_truncation)] // widths are stated at each step
pub(crate) const fn rsqrt(x: u64) -> (u32, u32) {
    let x = if x == 0 { 1 } else { x };
    // An even shift, so that its half comes out of the root: t = x·2^(shift − 64) is in 1/4 to 1.
    let shift = x.leading_zeros() & !1;
    let t = ((x << shift) >> 32) as u32;
    // The top seven bits of t are 32 to 127; the mask shows it to the compiler.
    let index = (t >> 25).saturating_sub(32) as usize;
    let seed = 256 + if index < 96 { SEEDS[index] as u64 } else { 0 };
    // First step, seed in Q8: t·y² in Q30 (32 + 16 − 18), 3 − ty² in Q30, halved product in Q30.
    let square = (t as u64 * (seed * seed)) >> 18;
    let y = (seed * ((3 << 30) - square)) >> 9;
    // Second step, y in Q30 and below 2^31: y² in Q29, t·y² in Q30 (32 + 29 − 31).
    let square = (t as u64 * ((y * y) >> 31)) >> 31;
    let y = (y * ((3 << 30) - square)) >> 31;
    (y as u32, 62 - shift / 2)
}

/// The direction of `v`, as a unit vector in units of 2⁻³⁰; `None` for zero.
///
/// Each component is within 1e-7 (and its last bit) of the exact one.
#[allow(clippy::cast_possible_truncation)] // mantissas have 30 bits, unit components at most 31
pub(crate) const fn unit(v: [i64; 3]) -> Option<[i32; 3]> {
    let size = v[0].unsigned_abs() | v[1].unsigned_abs() | v[2].unsigned_abs();
    if size == 0 {
        return None;
    }
    // To 30 bits, so that the sum of squares, below 3·2^60, fits.
    let zeros = size.leading_zeros();
    let [x, y, z] = if zeros < 34 {
        let down = 34 - zeros;
        [v[0] >> down, v[1] >> down, v[2] >> down]
    } else {
        let up = zeros - 34;
        [v[0] << up, v[1] << up, v[2] << up]
    };
    let (mantissa, exponent) = rsqrt((x * x + y * y + z * z).unsigned_abs());
    // The sum has 59 to 62 bits, so the exponent is 60 or 61.
    let shift = exponent - 30;
    let (mantissa, half) = (mantissa as i64, 1_i64 << (shift - 1));
    Some([
        ((x * mantissa + half) >> shift) as i32,
        ((y * mantissa + half) >> shift) as i32,
        ((z * mantissa + half) >> shift) as i32,
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[allow(clippy::cast_precision_loss)]
    fn error(x: u64) -> f64 {
        let (mantissa, exponent) = rsqrt(x);
        let got = f64::from(mantissa) * 2_f64.powi(-i32::try_from(exponent).unwrap());
        (got * (x as f64).sqrt() - 1.0).abs()
    }

    #[test]
    fn reciprocal_square_root_is_within_1e_7() {
        // Two periods of the seed table, densely, then every magnitude.
        for i in (1 << 20)..(1 << 22) {
            assert!(error(i << 40) < 1e-7, "{i}: {}", error(i << 40));
        }
        for shift in 0..64 {
            for x in [1, 3, 5, u64::MAX >> 1, u64::MAX] {
                let x = (x >> shift).max(1);
                assert!(error(x) < 1e-7, "{x}: {}", error(x));
            }
        }
        assert_eq!(rsqrt(0), rsqrt(1));
    }

    #[test]
    fn units_have_length_one_and_the_direction() {
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
                assert!(error < 1.1e-7, "{v:?}: {error}");
            }
        }
        assert_eq!(unit([0; 3]), None);
        assert_eq!(
            unit([0, 0, i64::MIN]).map(|v| v[2] < -(1 << 30) + 200),
            Some(true)
        );
    }
}
