//! Length and direction of vectors: an integer reciprocal square root.

use core::ops::Mul;

use super::{Vec3, block};
use crate::Scalar;

/// The reciprocal square root of `value / 2^32`, `value` being at least 2^30, in units of 2^-30.
///
/// Between 2^30 and 2^31; the relative error is at most 2^-29.
fn reciprocal_root(value: u32) -> u32 {
    debug_assert!(value >= 1 << 30);
    let x = u64::from(value);
    // A line through 1/√x on [1/4, 1], within 11 %.
    let mut y = (2_359_296_000 - ((x * 1_374_389_535) >> 32)).min(1 << 31);
    // Each Newton step y ← y·(3 − x·y²)/2 takes a relative error e to 3e²/2: 1e-1, 2e-2, 5e-4,
    // 4e-7, 2e-13.
    for _ in 0..4 {
        let squared = (y * y) >> 30;
        let product = (x * squared) >> 32;
        y = (y * ((3 << 30) - product) + (1 << 30)) >> 31;
    }
    #[allow(clippy::cast_possible_truncation)] // at most 2^31
    {
        y.clamp(1 << 30, 1 << 31) as u32
    }
}

/// A vector as 30-bit mantissas, their exponent, and the sum of their squares with its reciprocal
/// root.
struct Measured {
    mantissas: [i32; 3],
    exp: i32,
    /// The upper bits of the sum of squares · 2^up: at least 2^30.
    square: u32,
    /// See [`reciprocal_root`].
    root: u32,
    /// Even.
    up: u32,
}

/// `None` for a vector of no length.
fn measure(vector: [i64; 3], exp: i32) -> Option<Measured> {
    let (mantissas, exp) = block::normalise(vector, exp);
    let squared = mantissas
        .iter()
        .map(|m| u64::from(m.unsigned_abs()).pow(2))
        .sum::<u64>();
    if squared == 0 {
        return None;
    }
    // An even shift, so that its root is one of whole bits: between 2^62 and 2^64.
    let up = squared.leading_zeros() & !1;
    #[allow(clippy::cast_possible_truncation)] // the upper half
    let square = ((squared << up) >> 32) as u32;
    Some(Measured {
        mantissas,
        exp,
        square,
        root: reciprocal_root(square),
        up,
    })
}

/// The vector of length one in the direction of `vector`, in units of 2^-30; `None` for no
/// direction.
///
/// Each component is within 2^-28 of its value.
pub(crate) fn unit(vector: [i64; 3]) -> Option<[i32; 3]> {
    let of = measure(vector, 0)?;
    // m / √squared = m · (root / 2^30) / 2^((64 − up) / 2), in units of 2^-30.
    #[allow(clippy::cast_possible_wrap)] // at most 32
    let down = (32 - of.up / 2) as i32;
    #[allow(clippy::cast_possible_truncation)] // at most 1 + 2^-28
    Some(
        of.mantissas
            .map(|m| block::shift(i64::from(m) * i64::from(of.root), -down) as i32),
    )
}

/// The cross product of two triples of at most 31 bits.
pub(crate) fn cross(a: [i32; 3], b: [i32; 3]) -> [i64; 3] {
    let [a, b] = [a, b].map(|v| v.map(i64::from));
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

impl Vec3 {
    /// The dot product, rounded to nearest; saturates.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(1, 2, 3).dot(vec3!(4, 0.5, -1)), fx!(2));
    /// ```
    #[must_use]
    pub fn dot(self, other: Self) -> Scalar {
        let [a, b] = [self, other].map(|v| v.to_bits().map(i64::from));
        // Products reach 2^62; a sum that saturates is beyond the format anyway.
        let sum = (a[0] * b[0])
            .saturating_add(a[1] * b[1])
            .saturating_add(a[2] * b[2]);
        Scalar::from_bits(block::fixed(sum, 32, 16))
    }

    /// The cross product, rounded to nearest; saturates.
    ///
    /// ```
    /// use fixel::Vec3;
    /// assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
    /// ```
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        let [a, b] = [self, other].map(|v| v.to_bits().map(i64::from));
        let part =
            |i: usize, j: usize| block::fixed((a[i] * b[j]).saturating_sub(a[j] * b[i]), 32, 16);
        Self::from_bits([part(1, 2), part(2, 0), part(0, 1)])
    }

    /// The length, to 2⁻²⁹ of itself and rounded; saturates.
    ///
    /// ```
    /// use fixel::{fx, vec3};
    /// assert_eq!(vec3!(3, 0, -4).length(), fx!(5));
    /// ```
    #[must_use]
    pub fn length(self) -> Scalar {
        let Some(of) = measure(self.to_bits().map(i64::from), 16) else {
            return Scalar::ZERO;
        };
        // √x = x · 1/√x, in units of 2^-62: below 2^63.
        let length = (u64::from(of.square) * u64::from(of.root)).cast_signed();
        #[allow(clippy::cast_possible_wrap)] // at most 32
        let exp = of.exp + 30 + (of.up / 2) as i32;
        Scalar::from_bits(block::fixed(length, exp, 16))
    }

    /// The vector of length one in this direction, however short or long this is; `None` for zero.
    ///
    /// Components are rounded to 2⁻¹⁶, so that the length is within 2⁻¹⁶ of one.
    ///
    /// ```
    /// use fixel::{vec3, Vec3};
    /// assert_eq!(vec3!(0, 0.001, 0).normalised(), Some(Vec3::Y));
    /// assert_eq!(Vec3::ZERO.normalised(), None);
    /// ```
    #[must_use]
    pub fn normalised(self) -> Option<Self> {
        let unit = unit(self.to_bits().map(i64::from))?;
        Some(Self::from_bits(
            unit.map(|v| block::fixed(v.into(), 30, 16)),
        ))
    }
}

impl Mul<Scalar> for Vec3 {
    type Output = Self;

    /// The vector so many times as long, rounded to nearest; saturates.
    fn mul(self, times: Scalar) -> Self {
        let times = i64::from(times.to_bits());
        Self::from_bits(
            self.to_bits()
                .map(|v| block::fixed(i64::from(v) * times, 32, 16)),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn reciprocal_root_has_29_bits() {
        let mut worst = 0_f64;
        for x in (1_u32 << 30..=u32::MAX).step_by(9973).chain([u32::MAX]) {
            let expected = (f64::from(x) / 4_294_967_296.0).sqrt().recip();
            let found = f64::from(reciprocal_root(x)) / 1_073_741_824.0;
            worst = worst.max((found / expected - 1.0).abs());
        }
        assert!(worst <= f64::from(-29).exp2(), "{worst:e}");
    }

    fn vectors() -> impl Strategy<Value = [i32; 3]> {
        (any::<[i32; 3]>(), [0_u32..32, 0..32, 0..32])
            .prop_map(|(v, cut)| core::array::from_fn(|i| v[i] >> cut[i]))
    }

    proptest! {
        #[test]
        fn units_point_the_same_way(v in vectors()) {
            let real = v.map(f64::from);
            let length = real.iter().map(|x| x * x).sum::<f64>().sqrt();
            match unit(v.map(i64::from)) {
                None => prop_assert_eq!(v, [0; 3]),
                Some(unit) => for (u, x) in unit.into_iter().zip(real) {
                    // Mantissas of 30 bits, a root of 29, and rounding.
                    let error = f64::from(u) / 1_073_741_824.0 - x / length;
                    prop_assert!(error.abs() <= f64::from(-28).exp2(), "{:e}", error);
                },
            }
        }

        #[test]
        fn lengths_are_right(v in vectors()) {
            let real = v.map(f64::from);
            // In units of 2^-16.
            let length = real.iter().map(|x| x * x).sum::<f64>().sqrt().min(i32::MAX.into());
            let found = f64::from(Vec3::from_bits(v).length().to_bits());
            prop_assert!((found - length).abs() <= 0.5 + length * f64::from(-29).exp2());
        }

        #[test]
        fn products_are_right(a in vectors(), b in vectors(), s in any::<i32>()) {
            let (u, v) = (Vec3::from_bits(a), Vec3::from_bits(b));
            let [x, y] = [a, b].map(|v| v.map(i128::from));
            // Rounded half up and saturated, in integers wide enough.
            let fixed = |p: i128| i32::try_from((p + (1 << 15)) >> 16)
                .unwrap_or(if p < 0 { i32::MIN } else { i32::MAX });
            prop_assert_eq!(u.dot(v).to_bits(), fixed(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]));
            let cross = |i: usize, j: usize| fixed(x[i] * y[j] - x[j] * y[i]);
            prop_assert_eq!(u.cross(v).to_bits(), [cross(1, 2), cross(2, 0), cross(0, 1)]);
            let scaled = (u * Scalar::from_bits(s)).to_bits();
            prop_assert_eq!(scaled, x.map(|x| fixed(x * i128::from(s))));
        }
    }
}
