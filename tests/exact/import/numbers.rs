//! How numbers are rounded, and their range.

use fixel::prelude::*;
use rand::Rng;

use super::reading::{SQUARE, fails, read};
use crate::common::random::cases;

/// Reads a position whose x is this number, and returns x.
fn number(text: &str) -> Result<Scalar, Error> {
    read(&format!("v {text} 0 0")).map(|mesh| mesh.positions[0].x)
}

/// Reads a texture coordinate with this u and v, and returns the bits of u and 1 − v.
fn tex_coord(u: &str, v: &str) -> Result<[i32; 2], Error> {
    // A face uses the value, because the reader drops values that no corner uses.
    read(&format!("{SQUARE}vt {u} {v}\nf 1/1 2/1 3/1")).map(|mesh| mesh.uvs[0].to_bits())
}

#[test]
fn numbers_are_rounded_to_the_nearest() {
    for (text, bits) in [
        ("1", 65536),
        ("+1.", 65536),
        ("-.5", -32768),
        ("2.5e-1", 16384),
        ("25E-2", 16384),
        ("0.0025e+2", 16384),
        ("0000000000000000000000000000000000000001.5", 98304),
        ("1000000000000000000000000000000e-30", 65536),
        ("0.00000000000000000000000000000000000001e38", 65536),
        ("1e-400", 0),
        ("-1e-99999999999999999999999", 0),
        ("0e99999999999999999999999", 0),
        // Half a unit is rounded away from zero; a value smaller by 10^-30 is not.
        ("0.00000762939453125", 1),
        ("-0.00000762939453125", -1),
        ("0.000007629394531249999999999999", 0),
        ("12345.00000762939453125", 12345 * 65536 + 1),
        ("32767.99999", i32::MAX),
        ("-32768", i32::MIN),
        ("-32768.000007", i32::MIN),
    ] {
        assert_eq!(number(text), Ok(Scalar::from_bits(bits)), "{text}");
    }
}

#[test]
fn numbers_out_of_range_are_refused() {
    for text in [
        "32767.999993",
        "32768",
        "-32768.00001",
        "1e5",
        "1e300",
        "123456789012345678901234567890",
        "1e99999999999999999999",
    ] {
        fails(&format!("#\nv {text} 0 0"), 2, "out of range");
    }
}

#[test]
fn texture_coordinates_are_rounded_to_the_nearest() {
    const ONE: i32 = 1 << 20;
    for (text, bits) in [
        ("1", ONE),
        ("-.5", -ONE / 2),
        ("2.5e-1", ONE / 4),
        ("25E-2", ONE / 4),
        ("2046.5", 2046 * ONE + ONE / 2),
        // Half a unit is rounded away from zero; a value smaller by 10^-21 or 10^-30 is not.
        ("0.000000476837158203125", 1),
        ("-0.000000476837158203125", -1),
        ("0.000000476837158203124", 0),
        ("0.000000476837158203124999999999", 0),
        ("476837158203125e-21", 1),
        ("476837158203124e-21", 0),
        ("7.00000143051147460937500", 7 * ONE + 2),
        ("7.00000143051147460937499", 7 * ONE + 1),
        ("0.99999952316284179687", ONE - 1),
        ("0.99999952316284179688", ONE),
    ] {
        assert_eq!(tex_coord(text, text), Ok([bits, ONE - bits]), "{text}");
    }
    assert_eq!(tex_coord("2047.9999995", "0"), Ok([i32::MAX, ONE]));
    assert_eq!(tex_coord("-2048.0000004", "0"), Ok([i32::MIN, ONE]));
    let last = Ok([0, i32::MAX]);
    assert_eq!(tex_coord("0", "-2046.999999046325684"), last);
}

#[test]
fn texture_coordinates_out_of_range_are_refused() {
    for text in [
        "2047.9999996 0",
        "2048 0",
        "-2048.000001 0",
        "40000 0",
        "1e300 0",
        "0 2048",
        // 1 − v is out of range.
        "0 -2047",
        "0 -2048",
    ] {
        fails(
            &format!("#\nvt {text}"),
            2,
            "texture coordinate is out of range: u, v and 1 - v must lie between -2048 and 2047.99999",
        );
    }
}

/// Numbers are rounded to the nearest unit, with halves away from zero. The expected value is computed exactly.
#[test]
fn numbers_round_exactly() {
    cases(256, |random| {
        let value = random.random_range(-327_670_000_000_000_i64..327_670_000_000_000);
        let point = random.random_range(0..12);
        // f64 cannot hold value · 10^-10 exactly; 128-bit integers can.
        let scaled = i128::from(value) << 17;
        let quotient = scaled.abs() / 10_000_000_000;
        let nearest = (quotient + 1) / 2 * scaled.signum();
        let digits = 10_i64.pow(10);
        let sign = if value < 0 { "-" } else { "" };
        let (whole, rest) = (value.abs() / digits, value.abs() % digits);
        for text in [
            format!("{sign}{whole}.{rest:010}"),
            format!("{value}e-10"),
            format!("{value}{:0<point$}E-{}", "", 10 + point),
        ] {
            let bits = number(&text).unwrap().to_bits();
            assert_eq!(i128::from(bits), nearest, "{text}");
        }
    });
}

/// The same for the bits of a texture coordinate.
#[test]
fn texture_coordinates_round_exactly() {
    cases(256, |random| {
        let value = random.random_range(-204_600_000_000_000_000_i64..204_600_000_000_000_000);
        let fine = random.random_range(0..10_u128.pow(21));
        let point = random.random_range(0..12);
        let scaled = i128::from(value) << 21;
        let nearest = (scaled.abs() / 10_i128.pow(14) + 1) / 2 * scaled.signum();
        let digits = 10_i64.pow(14);
        let sign = if value < 0 { "-" } else { "" };
        let (whole, rest) = (value.abs() / digits, value.abs() % digits);
        for text in [
            format!("{sign}{whole}.{rest:014}"),
            format!("{value}{:0<point$}E-{}", "", 14 + point),
        ] {
            let [u, _] = tex_coord(&text, "0").unwrap();
            assert_eq!(i128::from(u), nearest, "{text}");
        }
        // This number needs all of its digits to decide the rounding.
        let nearest = ((fine << 21) / 10_u128.pow(21)).div_ceil(2) as i32;
        for text in [
            format!("0.{fine:021}"),
            format!("{fine}e-21"),
            format!("0.{fine:021}9e0"),
        ] {
            assert_eq!(tex_coord(&text, "0").unwrap()[0], nearest, "{text}");
        }
    });
}
