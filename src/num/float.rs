//! Floats of 32 bits, taken apart and put together by integers: no float routine is linked.

use crate::error::Error;

/// A finite float: ± `mantissa` · 2^(`exponent` − 150).
pub(crate) struct Parts {
    pub(crate) is_negative: bool,
    /// The mantissa has 24 bits; its top bit, 2^23, is missing only if the exponent is 1.
    pub(crate) mantissa: u32,
    /// The exponent is from 1 to 254.
    pub(crate) exponent: i32,
}

impl Parts {
    /// Takes a float apart.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] if the float is infinite or not a number.
    #[inline]
    pub(crate) const fn of(value: f32) -> Result<Self, Error> {
        let bits = value.to_bits();
        let exponent = (bits >> 23 & 0xff).cast_signed();
        if exponent == 0xff {
            return Err(Error::NotFinite);
        }
        // The least exponent counts as 1, and has no top bit.
        let is_normal = exponent > 0;
        Ok(Self {
            is_negative: bits >> 31 != 0,
            mantissa: bits & 0x7f_ffff | (is_normal as u32) << 23,
            exponent: exponent + !is_normal as i32,
        })
    }

    /// Returns the bits of the nearest number with `fraction` fraction bits, from 8 to 30; halves are rounded away from
    /// zero. Returns `None` if the number does not fit.
    #[inline]
    pub(crate) const fn nearest(&self, fraction: u32) -> Option<i32> {
        // The magnitude is top / 2^(down + 1) units.
        let top = self.mantissa << 8;
        let down = 157 - fraction.cast_signed() - self.exponent;
        if down < 0 {
            // Of the numbers of 2^31 units and more, only the lowest number fits.
            let is_lowest = self.is_negative && down == -1 && top == 1 << 31;
            return if is_lowest { Some(i32::MIN) } else { None };
        }
        let units = if down < 32 {
            ((top >> down) + 1) >> 1
        } else {
            0
        };
        let units = units.cast_signed();
        Some(if self.is_negative { -units } else { units })
    }

    /// Returns the number in thousandths, rounded toward zero; saturates.
    #[cold]
    #[inline(never)]
    pub(crate) const fn thousandths(&self) -> i64 {
        let product = self.mantissa as u64 * 1000; // of 34 bits
        let magnitude = match self.exponent - 150 {
            31.. => u64::MAX,
            up @ 0.. => product << up,
            up => product >> if up > -63 { -up } else { 63 },
        };
        if self.is_negative {
            0_i64.saturating_sub_unsigned(magnitude)
        } else {
            0_i64.saturating_add_unsigned(magnitude)
        }
    }
}

/// Returns the float nearest to `bits` / 2^`fraction`, for up to 30 fraction bits; halves are rounded to even, as float
/// arithmetic rounds.
pub(crate) fn float(bits: i32, fraction: u32) -> f32 {
    let magnitude = bits.unsigned_abs();
    if magnitude == 0 {
        return 0.0;
    }
    let zeros = magnitude.leading_zeros();
    let top = magnitude << zeros;
    // The float keeps 24 bits of `top`. The sum is above 128 if the 8 other bits are more than a half, or if they are a
    // half and the lowest bit that is kept is odd.
    let kept = top >> 8;
    let rest = (top & 0xff) + (kept & 1);
    let mantissa = kept + u32::from(rest > 0x80);
    // The mantissa's top bit adds 1 to the exponent; a mantissa that was rounded up to 2^24 adds 2.
    let exponent = 157 - zeros - fraction;
    let sign = bits.cast_unsigned() & 1 << 31;
    f32::from_bits(sign | ((exponent << 23) + mantissa))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::{Fraction, Scalar, Subpixel, TexCoord};
    use crate::random::cases;
    use rand::Rng;

    /// The nearest whole number, halves away from zero. All floats of 32 bits are exact here, and so are their products
    /// with powers of two: an `f64` has 29 bits more.
    fn rounded(value: f32, fraction: u32) -> f64 {
        let units = f64::from(value) * f64::from(1_u32 << fraction);
        let whole = units.trunc();
        let rest = (units - whole).abs();
        whole + if rest < 0.5 { 0.0 } else { units.signum() }
    }

    /// Compares all conversions of a float with `f64`.
    fn check(value: f32) {
        fn compare<N: TryFrom<f32, Error = Error> + PartialEq + core::fmt::Debug>(
            value: f32,
            fraction: u32,
            from_bits: fn(i32) -> N,
        ) {
            let expected = if value.is_finite() {
                let units = rounded(value, fraction);
                #[allow(clippy::cast_possible_truncation)] // saturates
                let thousandths = (f64::from(value) * 1000.0) as i64;
                let refused = Error::NotRepresentable {
                    thousandths,
                    limit: 1 << (31 - fraction),
                };
                let fits = (-2_147_483_648.0..=2_147_483_647.0).contains(&units);
                #[allow(clippy::cast_possible_truncation)] // a whole number
                let bits = units as i32;
                if fits {
                    Ok(from_bits(bits))
                } else {
                    Err(refused)
                }
            } else {
                Err(Error::NotFinite)
            };
            assert_eq!(N::try_from(value), expected, "{value:e}");
        }
        for value in [value, -value] {
            compare(value, 16, Scalar::from_bits);
            compare(value, 20, TexCoord::from_bits);
            compare(value, 8, Subpixel::from_bits);
            compare(value, 30, Fraction::from_bits);
        }
    }

    #[test]
    fn floats_of_every_exponent_are_rounded_to_nearest() {
        // The lowest exponent has zero and the subnormal floats; the highest has infinity and NaN.
        for exponent in 0..=0xff {
            let of = |mantissa: u32| f32::from_bits(exponent << 23 | mantissa);
            // A half and its neighbors, at every place of the binary point.
            for bit in 0..23 {
                let ones = (1 << bit) - 1;
                for mantissa in [0, 1, ones, 1 << bit, (1 << bit) + 1, 0x7f_ffff ^ ones] {
                    check(of(mantissa));
                }
            }
            check(of(0x7f_ffff));
            cases(16, |random| check(of(random.random_range(0..1 << 23))));
        }
    }

    #[test]
    fn halves_are_rounded_away_from_zero() {
        cases(256, |random| {
            let odd = random.random::<u16>() | 1;
            for fraction in [8_u8, 16, 20, 30] {
                check(f32::from(odd) * f32::exp2(-f32::from(fraction + 1)));
            }
        });
    }

    /// The hardware's conversion of an integer rounds to nearest, halves to even. A power of two changes no bit after
    /// that.
    #[test]
    #[allow(clippy::cast_precision_loss)]
    fn numbers_become_the_nearest_floats() {
        let check = |bits: i32| {
            let nearest = |fraction: u32| bits as f32 / (1_u32 << fraction) as f32;
            let found = [
                f32::from(Scalar::from_bits(bits)),
                f32::from(TexCoord::from_bits(bits)),
                f32::from(Subpixel::from_bits(bits)),
                f32::from(Fraction::from_bits(bits)),
            ];
            let expected = [16, 20, 8, 30].map(nearest);
            assert_eq!(
                found.map(f32::to_bits),
                expected.map(f32::to_bits),
                "{bits}"
            );
        };
        // Halves between two floats, with an even and with an odd number below, and their neighbors.
        for zeros in 0..8 {
            for below in [1 << 23, (1 << 23) + 1, (1 << 24) - 2, (1 << 24) - 1] {
                let half = ((below << 8 | 0x80_u32) >> 1).cast_signed() >> zeros;
                for bits in [half - 1, half, half + 1] {
                    check(bits);
                    check(-bits);
                }
            }
        }
        for bits in [0, 1, -1, i32::MAX, i32::MIN, i32::MIN + 1] {
            check(bits);
        }
        cases(1024, |random| {
            check(random.random::<i32>() >> random.random_range(0..31));
        });
    }

    #[test]
    #[ignore = "all 2^32 floats take two minutes"]
    fn every_float_is_rounded_to_nearest() {
        (0..=i32::MAX.cast_unsigned()).for_each(|bits| check(f32::from_bits(bits)));
    }
}
