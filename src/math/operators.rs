//! The operators and conversions of vectors: component by component, like the operators of numbers.

use core::fmt;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{Vec2, Vec3};
use crate::error::Error;
use crate::num::number::operators;
use crate::num::{Scalar, TexCoord, block};

/// `from + (to − from) · t`, rounded to nearest (half up) once; saturates.
fn interpolate(from: i32, to: i32, t: Scalar) -> i32 {
    let [from, to] = [from, to].map(i64::from);
    // The product is at most (2^32 − 1) · 2^31, which fits. A sum that saturates is far beyond the 32 bits of the
    // result.
    let sum = ((to - from) * i64::from(t.to_bits())).saturating_add(from << 16);
    block::fixed(sum, 16, 0)
}

macro_rules! vector {
    ($Vector:ident of $len:literal $Number:ident { $($part:ident),+ }, $format:literal) => {
        impl fmt::Display for $Vector {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, $format, $(self.$part),+)
            }
        }

        impl From<[$Number; $len]> for $Vector {
            fn from([$($part),+]: [$Number; $len]) -> Self {
                Self::new($($part),+)
            }
        }

        impl From<$Vector> for [$Number; $len] {
            fn from(v: $Vector) -> Self {
                [$(v.$part),+]
            }
        }

        vector!(@from $Vector [$($part),+]: [f64; $len] [f32; $len] [i32; $len]);

        impl $Vector {
            /// Makes a vector from its components.
            #[must_use]
            pub const fn new($($part: $Number),+) -> Self {
                Self { $($part),+ }
            }

            /// Makes a vector from the bits of its components.
            #[must_use]
            pub const fn from_bits([$($part),+]: [i32; $len]) -> Self {
                Self::new($($Number::from_bits($part)),+)
            }

            /// Returns the bits of the components.
            #[must_use]
            pub const fn to_bits(self) -> [i32; $len] {
                [$(self.$part.to_bits()),+]
            }

            /// Makes a vector of equal components.
            #[must_use]
            pub const fn splat(component: $Number) -> Self {
                Self { $($part: component),+ }
            }

            /// Returns the component-wise minimum of two vectors.
            #[must_use]
            pub fn min(self, other: Self) -> Self {
                Self::new($(self.$part.min(other.$part)),+)
            }

            /// Returns the component-wise maximum of two vectors.
            #[must_use]
            pub fn max(self, other: Self) -> Self {
                Self::new($(self.$part.max(other.$part)),+)
            }

            /// Interpolates linearly: the result is `self` at `t` = 0 and `other` at `t` = 1. If `t` is below 0 or
            /// above 1, the result is extrapolated.
            ///
            /// Each component is rounded to nearest once, halves up, and saturates.
            #[must_use]
            pub fn lerp(self, other: Self, t: Scalar) -> Self {
                Self::from_bits([$(interpolate(self.$part.to_bits(), other.$part.to_bits(), t)),+])
            }
        }

        impl Neg for $Vector {
            type Output = Self;

            /// Negates; the lowest number becomes the highest.
            fn neg(self) -> Self {
                Self::new($(-self.$part),+)
            }
        }

        operators! {
            /// Adds; each component saturates.
            Add add, AddAssign add_assign: |a: $Vector, b: $Vector| Self::new($(a.$part + b.$part),+);
            /// Subtracts; each component saturates.
            Sub sub, SubAssign sub_assign: |a: $Vector, b: $Vector| Self::new($(a.$part - b.$part),+);
            /// Multiplies each component, rounds to nearest (half up) and saturates.
            Mul mul, MulAssign mul_assign: |a: $Vector, k: Scalar| Self::new($(a.$part * k),+);
            /// Divides each component, rounds to nearest (half away from zero) and saturates.
            ///
            /// A component divided by zero saturates by its sign; 0/0 is 0.
            Div div, DivAssign div_assign: |a: $Vector, k: Scalar| Self::new($(a.$part / k),+);
            /// Multiplies each component; each component saturates.
            Mul mul, MulAssign mul_assign: |a: $Vector, k: i32| Self::new($(a.$part * k),+);
            /// Divides each component, rounds to nearest (half away from zero) and saturates.
            ///
            /// A component divided by zero saturates by its sign; 0/0 is 0.
            Div div, DivAssign div_assign: |a: $Vector, k: i32| Self::new($(a.$part / k),+);
        }

        operators!(Scalar * $Vector, i32 * $Vector);

        impl Sum for $Vector {
            /// Adds all vectors; each partial sum saturates.
            fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
                vectors.fold(Self::ZERO, Add::add)
            }
        }

        impl<'a> Sum<&'a Self> for $Vector {
            /// Adds all vectors; each partial sum saturates.
            fn sum<I: Iterator<Item = &'a Self>>(vectors: I) -> Self {
                vectors.copied().sum()
            }
        }
    };
    (@from $Vector:ident $parts:tt: $($Array:ty)+) => {$(
        impl TryFrom<$Array> for $Vector {
            type Error = Error;

            /// Converts each component to the nearest number.
            ///
            /// # Errors
            ///
            /// [`Error::NotRepresentable`] if a component is out of range; [`Error::NotFinite`] if it is infinite or
            /// not a number.
            fn try_from(array: $Array) -> Result<Self, Error> {
                vector!(@new $parts array)
            }
        }
    )+};
    (@new [$($part:ident),+] $array:ident) => {{
        let [$($part),+] = $array;
        Ok(Self::new($($part.try_into()?),+))
    }};
}

vector!(Vec3 of 3 Scalar { x, y, z }, "({}, {}, {})");
vector!(Vec2 of 2 TexCoord { x, y }, "({}, {})");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, cases, number};
    use crate::{fx, vec2, vec3};
    use rand::Rng;

    /// The nearest value that 32 bits hold.
    fn saturated(value: i128) -> i32 {
        value.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }

    /// Returns a number of a random size, or 0, ±1 or an end of the format.
    fn numbers(random: &mut Random) -> i32 {
        let ends = [i32::MIN, i32::MAX, 0, 1, -1];
        if random.random() {
            number(random)
        } else {
            ends[random.random_range(0..5)]
        }
    }

    fn vectors(random: &mut Random) -> [i32; 3] {
        [(); 3].map(|()| numbers(random))
    }

    /// Returns value · 2^fraction / divisor, computed in integers and rounded to nearest, half away from zero.
    fn quotient(value: i32, divisor: i32, fraction: u32) -> i32 {
        let top = i128::from(value) << fraction;
        if divisor == 0 {
            return saturated(top.signum() << 40);
        }
        let bottom = i128::from(divisor);
        let magnitude = (top.abs() + bottom.abs() / 2) / bottom.abs();
        saturated(magnitude * top.signum() * bottom.signum())
    }

    #[test]
    fn sums_saturate() {
        cases(256, |random| {
            let a = vectors(random);
            let b = vectors(random);
            let (u, v) = (Vec3::from_bits(a), Vec3::from_bits(b));
            let [a, b] = [a, b].map(|v| v.map(i128::from));
            let (sum, difference) = ((u + v).to_bits(), (u - v).to_bits());
            for i in 0..3 {
                assert_eq!(sum[i], saturated(a[i] + b[i]));
                assert_eq!(difference[i], saturated(a[i] - b[i]));
                assert_eq!((-u).to_bits()[i], saturated(-a[i]));
                assert_eq!(u.min(v).to_bits()[i], saturated(a[i].min(b[i])));
                assert_eq!(u.max(v).to_bits()[i], saturated(a[i].max(b[i])));
            }
            assert_eq!([u, v].iter().sum::<Vec3>(), u + v);
            assert_eq!([u, v, u].into_iter().sum::<Vec3>(), u + v + u);
        });
    }

    #[test]
    fn products_round_half_up() {
        cases(256, |random| {
            let a = vectors(random);
            let k = numbers(random);
            let expected = a.map(|v| saturated((i128::from(v) * i128::from(k) + (1 << 15)) >> 16));
            let (v, k) = (Vec3::from_bits(a), Scalar::from_bits(k));
            assert_eq!((v * k).to_bits(), expected);
            assert_eq!(k * v, v * k);
            let uv = Vec2::from_bits([a[0], a[1]]);
            assert_eq!((uv * k).to_bits(), [expected[0], expected[1]]);
            assert_eq!(k * uv, uv * k);
            let n = numbers(random);
            let expected = a.map(|v| saturated(i128::from(v) * i128::from(n)));
            assert_eq!((v * n).to_bits(), expected);
            assert_eq!(n * v, v * n);
            assert_eq!((n * uv).to_bits(), [expected[0], expected[1]]);
        });
    }

    #[test]
    fn quotients_round_half_away_from_zero() {
        cases(256, |random| {
            let a = vectors(random);
            let k = numbers(random);
            let (expected, whole) = (a.map(|v| quotient(v, k, 16)), a.map(|v| quotient(v, k, 0)));
            let (v, uv) = (Vec3::from_bits(a), Vec2::from_bits([a[0], a[1]]));
            assert_eq!((v / k).to_bits(), whole);
            assert_eq!((uv / k).to_bits(), [whole[0], whole[1]]);
            let k = Scalar::from_bits(k);
            assert_eq!((v / k).to_bits(), expected);
            assert_eq!((uv / k).to_bits(), [expected[0], expected[1]]);
        });
    }

    #[test]
    fn interpolation_rounds_once() {
        cases(256, |random| {
            let a = vectors(random);
            let b = vectors(random);
            let t = numbers(random);
            let found = Vec3::from_bits(a)
                .lerp(Vec3::from_bits(b), Scalar::from_bits(t))
                .to_bits();
            for i in 0..3 {
                let [from, to] = [a[i], b[i]].map(i128::from);
                let exact = (from << 16) + (to - from) * i128::from(t);
                assert_eq!(found[i], saturated((exact + (1 << 15)) >> 16));
            }
        });
    }

    #[test]
    fn assignments_are_the_operators() {
        cases(256, |random| {
            let a = vectors(random);
            let b = vectors(random);
            let k = numbers(random);
            let n = k;
            let (u, v, k) = (Vec3::from_bits(a), Vec3::from_bits(b), Scalar::from_bits(k));
            let [mut multiple, mut part] = [u; 2];
            multiple *= n;
            part /= n;
            assert_eq!([multiple, part], [u * n, u / n]);
            let [mut sum, mut difference, mut product, mut quotient] = [u; 4];
            sum += v;
            difference -= v;
            product *= k;
            quotient /= k;
            assert_eq!(
                [sum, difference, product, quotient],
                [u + v, u - v, u * k, u / k]
            );
        });
    }

    #[test]
    fn division_by_zero_saturates_by_sign() {
        let extremes = Vec3::new(Scalar::MAX, Scalar::MIN, Scalar::ZERO);
        assert_eq!(vec3!(1, -1, 0) / Scalar::ZERO, extremes);
        let extremes = Vec2::new(TexCoord::MIN, TexCoord::MAX);
        assert_eq!(vec2!(-1, 1) / Scalar::ZERO, extremes);
        assert_eq!(
            Vec3::new(Scalar::MIN, Scalar::MAX, Scalar::ZERO) / -Scalar::DELTA,
            Vec3::new(Scalar::MAX, Scalar::MIN, Scalar::ZERO)
        );
    }

    #[test]
    fn interpolation_meets_both_ends() {
        let (a, b) = (vec3!(-30000, 1, 0.1), vec3!(30000, -2, 7));
        assert_eq!(a.lerp(b, Scalar::ZERO), a);
        assert_eq!(a.lerp(b, Scalar::ONE), b);
        assert_eq!(vec2!(0, 1).lerp(vec2!(1, 0.5), fx!(0.5)), vec2!(0.5, 0.75));
    }

    #[test]
    fn vectors_are_arrays_and_back() {
        let parts = [Scalar::MIN, Scalar::ZERO, Scalar::MAX];
        assert_eq!(<[Scalar; 3]>::from(Vec3::from(parts)), parts);
        let parts = [TexCoord::MIN, TexCoord::MAX];
        assert_eq!(<[TexCoord; 2]>::from(Vec2::from(parts)), parts);
    }
}
