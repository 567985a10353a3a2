//! The operators of numbers, compared with their rule in 128 bits.

use super::{Fraction, Scalar, Subpixel, TexCoord};
use crate::random::{Random, cases, number};
use rand::Rng;
use std::format;

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

/// Returns `top` / `bottom`, rounded to nearest, half away from zero. If `bottom` is zero, the quotient saturates by
/// the sign of `top`.
fn quotient(top: i128, bottom: i128) -> i32 {
    if bottom == 0 {
        return saturated(top.signum() << 40);
    }
    let magnitude = (top.abs() + bottom.abs() / 2) / bottom.abs();
    saturated(magnitude * top.signum() * bottom.signum())
}

macro_rules! check {
    ($Number:ident, $fraction:literal, $random:ident) => {
        let [a, b] = [(); 2].map(|()| numbers($random));
        let (x, y) = ($Number::from_bits(a), $Number::from_bits(b));
        let (wide_a, wide_b) = (i128::from(a), i128::from(b));
        assert_eq!((x + y).to_bits(), saturated(wide_a + wide_b));
        assert_eq!((x - y).to_bits(), saturated(wide_a - wide_b));
        assert_eq!((-x).to_bits(), saturated(-wide_a));
        assert_eq!(x.abs().to_bits(), saturated(wide_a.abs()));
        let product = (wide_a * wide_b + (1 << ($fraction - 1))) >> $fraction;
        assert_eq!((x * y).to_bits(), saturated(product));
        assert_eq!((x / y).to_bits(), quotient(wide_a << $fraction, wide_b));
        assert_eq!((x * b).to_bits(), saturated(wide_a * wide_b));
        assert_eq!(b * x, x * b);
        assert_eq!((x / b).to_bits(), quotient(wide_a, wide_b));
        assert_eq!([x, y].into_iter().sum::<$Number>(), x + y);
        assert_eq!(i128::from(x.floor()), wide_a >> $fraction);
        let half = 1 << ($fraction - 1);
        assert_eq!(i128::from(x.round()), (wide_a + half) >> $fraction);
        let mut assigned = [x; 6];
        assigned[0] += y;
        assigned[1] -= y;
        assigned[2] *= y;
        assigned[3] /= y;
        assigned[4] *= b;
        assigned[5] /= b;
        assert_eq!(assigned, [x + y, x - y, x * y, x / y, x * b, x / b]);
        assert_eq!(x < y, a < b);
        assert_eq!($Number::try_from(f64::from(x)), Ok(x));
    };
}

#[test]
fn operators_round_and_saturate() {
    cases(1024, |random| {
        check!(Scalar, 16, random);
        check!(TexCoord, 20, random);
        check!(Subpixel, 8, random);
        check!(Fraction, 30, random);
    });
}

#[test]
fn a_fraction_scales() {
    cases(256, |random| {
        let [a, b] = [(); 2].map(|()| numbers(random));
        let (product, rounded) = (i128::from(a) * i128::from(b), |bits: u32| 1 << (bits - 1));
        assert_eq!(
            (Scalar::from_bits(a) * Fraction::from_bits(b)).to_bits(),
            saturated((product + rounded(30)) >> 30)
        );
        assert_eq!(
            (TexCoord::from_bits(a) * Scalar::from_bits(b)).to_bits(),
            saturated((product + rounded(16)) >> 16)
        );
        assert_eq!(
            (TexCoord::from_bits(a) / Scalar::from_bits(b)).to_bits(),
            quotient(i128::from(a) << 16, b.into())
        );
        let (number, factor) = (Scalar::from_bits(a), Fraction::from_bits(b));
        assert_eq!(factor * number, number * factor);
        let (number, factor) = (TexCoord::from_bits(a), Scalar::from_bits(b));
        assert_eq!(factor * number, number * factor);
    });
}

/// Numbers are written as the crate `fixed` writes them.
#[test]
fn numbers_are_written_in_decimals() {
    assert_eq!(
        format!("{} {:?}", Scalar::from_bits(-1 << 15), Scalar::ONE),
        "-0.5 1"
    );
    assert_eq!(
        format!("{:.2} {:5}", Scalar::ONE / 3, TexCoord::ONE / 4),
        "0.33  0.25"
    );
}
